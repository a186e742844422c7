#include "lab/report/report.h"

#include <system_error>
#include <utility>

#include "io/output_file.h"
#include "lab/report/plot_file.h"
#include "lab/report/report_files.h"
#include "lab/report/report_findings.h"
#include "lab/report/report_layout.h"
#include "lab/report/report_page.h"
#include "weft/error.h"

namespace weft::lab {

namespace {

// Files under temporary names until all are whole.
class Files {
public:
    explicit Files(std::filesystem::path directory) : directory_(std::move(directory)) {}

    void write(const std::string& name, std::string_view text) {
        const std::filesystem::path path = directory_ / name;
        std::error_code error;
        std::filesystem::create_directories(path.parent_path(), error);
        if (error) throw file_error(path.parent_path().string(), error.message());
        OutputFile& file = files_.emplace_back(path);
        file.write(text);
        file.close();
    }
    std::vector<std::filesystem::path> commit() {
        std::vector<std::filesystem::path> paths;
        for (OutputFile& file : files_) {
            file.commit();
            paths.push_back(file.path());
        }
        return paths;
    }

private:
    std::filesystem::path directory_;
    std::vector<OutputFile> files_;
};

std::vector<PlacedBlock*> blocks_of(std::vector<PlacedExperiment>& experiments) {
    std::vector<PlacedBlock*> blocks;
    for (PlacedExperiment& experiment : experiments) {
        for (PlacedSection& section : experiment.sections) {
            for (PlacedBlock& block : section.blocks) blocks.push_back(&block);
        }
    }
    return blocks;
}

void write_plots(std::vector<PlacedExperiment>& experiments, bool narrow, Files& files) {
    std::vector<PlotJob> jobs;
    std::vector<PlacedBlock*> places;
    for (PlacedBlock* placed : blocks_of(experiments)) {
        if (const auto* plot = std::get_if<Plot>(placed->block)) {
            jobs.push_back({plot, placed->anchor, narrow});
            places.push_back(placed);
        }
    }
    std::vector<DrawnPlot> drawings = draw_plots(jobs);
    for (std::size_t n = 0; n < jobs.size(); ++n) {
        files.write(places[n]->files + ".csv", plot_csv(*jobs[n].plot));
        files.write(places[n]->files + ".svg", drawings[n].svg);
        files.write(places[n]->files + ".png", drawings[n].png);
        places[n]->inline_svg = std::move(drawings[n].inline_svg);
    }
}

}  // namespace

std::vector<std::filesystem::path> write_report(const std::filesystem::path& directory,
                                                const ReportHead& head,
                                                const std::vector<SceneSections>& scenes) {
    std::vector<PlacedExperiment> experiments = place_report(directory, scenes);
    std::vector<std::string> names;
    for (const SceneSections& scene : scenes) names.push_back(scene.scene);
    Files files(directory);
    write_plots(experiments, scenes.size() > 1, files);
    for (const PlacedBlock* placed : blocks_of(experiments)) {
        if (const auto* table = std::get_if<Table>(placed->block)) {
            files.write(placed->files + ".csv", table_csv(*table));
        }
    }
    files.write("findings.csv", table_csv(findings_table(experiments, names)));
    files.write("lab.json", report_json(head, experiments)
                                    .dump(1, ' ', false, nlohmann::json::error_handler_t::replace) +
                                "\n");
    files.write("report.html", report_page(directory, head, experiments, names));
    return files.commit();
}

}  // namespace weft::lab
