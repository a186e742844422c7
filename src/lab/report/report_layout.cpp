#include "lab/report/report_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace weft::lab {

namespace {

bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
}

// Names that were not given out before.
class Names {
public:
    std::string take(const std::string& wanted) {
        std::string name = wanted;
        for (int n = 2; !taken_.insert(name).second; ++n) name = fmt::format("{}-{}", wanted, n);
        return name;
    }

private:
    std::set<std::string> taken_;
};

struct Counts {
    int figures = 0, tables = 0;
};

std::string anchor_of(std::string_view text) {
    std::string name = file_name(text);
    std::ranges::replace(name, '.', '-');
    return name;
}

PlacedBlock place_block(const Block& block, const std::filesystem::path& directory,
                        const std::string& folder, Names& ids, Counts& counts) {
    PlacedBlock placed{&block, {}, {}, 0, {}};
    if (const auto* plot = std::get_if<Plot>(&block)) {
        const std::string id = ids.take(file_name(plot->id));
        placed.files = folder + "/" + id;
        placed.number = ++counts.figures;
    } else if (const auto* table = std::get_if<Table>(&block)) {
        const std::string id = ids.take(file_name(table->id));
        placed.files = folder + "/" + id;
        placed.number = ++counts.tables;
    } else if (const auto* media = std::get_if<Media>(&block)) {
        ids.take(file_name(media->id));
        placed.files = std::filesystem::proximate(media->file, directory).generic_string();
        placed.number = ++counts.figures;
    }
    return placed;
}

std::string id_of(const Block& block) {
    if (const auto* plot = std::get_if<Plot>(&block)) return plot->id;
    if (const auto* table = std::get_if<Table>(&block)) return table->id;
    if (const auto* media = std::get_if<Media>(&block)) return media->id;
    return {};
}

PlacedExperiment& experiment_of(std::vector<PlacedExperiment>& experiments, const Section& section,
                                Names& anchors) {
    const auto found = std::ranges::find_if(experiments, [&](const PlacedExperiment& experiment) {
        return experiment.sections.front().section->experiment == section.experiment;
    });
    if (found != experiments.end()) return *found;
    experiments.push_back({anchors.take(anchor_of(section.experiment)), {}});
    return experiments.back();
}

// Blocks are numbered in the order of the page.
void place_blocks(PlacedSection& placed, const std::filesystem::path& directory, Names& anchors,
                  Counts& counts) {
    Names ids;
    for (const Block& block : placed.section->blocks) {
        PlacedBlock made = place_block(block, directory, placed.folder, ids, counts);
        if (made.number > 0) {
            made.anchor = anchors.take(anchor_of(placed.anchor + "-" + id_of(block)));
        }
        placed.blocks.push_back(std::move(made));
    }
}

}  // namespace

std::string file_name(std::string_view text) {
    std::string name;
    for (const char c : text) name += is_plain(c) ? c : '-';
    if (name.empty() || name.front() == '.') name.insert(0, "-");
    return name;
}

std::vector<PlacedExperiment> place_report(const std::filesystem::path& directory,
                                           const std::vector<SceneSections>& scenes) {
    Names anchors, folders;
    for (const char* own : {"top", "contents", "summary", "findings"}) anchors.take(own);
    std::vector<PlacedExperiment> experiments;
    for (const SceneSections& scene : scenes) {
        const std::string folder =
            scenes.size() == 1 ? std::string() : folders.take(file_name(scene.scene)) + "/";
        for (const Section& section : scene.sections) {
            PlacedExperiment& experiment = experiment_of(experiments, section, anchors);
            const std::string own = folder + file_name(section.experiment);
            const std::string anchor =
                folder.empty() ? experiment.anchor : anchors.take(anchor_of(own));
            experiment.sections.push_back({&section, scene.scene, own, anchor, {}});
        }
    }
    Counts counts;
    for (PlacedExperiment& experiment : experiments) {
        for (PlacedSection& section : experiment.sections) {
            place_blocks(section, directory, anchors, counts);
        }
    }
    return experiments;
}

}  // namespace weft::lab
