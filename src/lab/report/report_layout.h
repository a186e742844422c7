// Where everything of a report goes: names of files and of places in the page.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lab/report/report.h"

namespace weft::lab {

/// A block with its names.
struct PlacedBlock {
    const Block* block;
    /// Its files less their ending, relative to the report: "order/errors". Of a Media the file
    /// itself, ending and all.
    std::string files;
    std::string anchor;      ///< its id in the page, unique and without dots: "order-errors"
    int number = 0;          ///< of the figure or the table, from 1; 0 for running text
    std::string inline_svg;  ///< of a Plot: drawn
};

struct PlacedSection {
    const Section* section;
    std::string scene;   ///< as SceneSections::scene
    std::string folder;  ///< of its files, relative to the report: "order", "sheet/order"
    std::string anchor;  ///< its id in the page: "order"; "sheet-order" of several scenes
    std::vector<PlacedBlock> blocks;
};

/// The sections of one experiment, one a scene, in the order of the scenes.
struct PlacedExperiment {
    std::string anchor;  ///< "order"
    std::vector<PlacedSection> sections;
};

/// `text` as a name of files: letters, digits, "-", "_" and "." stay, all else becomes "-".
std::string file_name(std::string_view text);

/// Experiments in the order in which they first come. With several scenes files stand in
/// SCENE/SECTION, else in SECTION. Nothing is drawn or read yet.
std::vector<PlacedExperiment> place_report(const std::filesystem::path& directory,
                                           const std::vector<SceneSections>& scenes);

}  // namespace weft::lab
