#include "lab/study.h"

#include <fmt/format.h>

#include <cmath>

#include "lab/trajectory.h"
#include "weft/error.h"
#include "weft/instruction_set.h"
#include "weft/simulation.h"

namespace weft::lab {

namespace {

std::vector<const Experiment*> experiments_of(const StudyPlan& plan) {
    if (!plan.experiments.empty()) return plan.experiments;
    std::vector<const Experiment*> all;
    for (const Experiment& experiment : experiment_catalogue()) all.push_back(&experiment);
    return all;
}

// Names of the scenes' directories and headings, each its own.
std::vector<std::string> stems_of(const std::vector<SceneDescription>& scenes) {
    std::vector<std::string> stems;
    for (const SceneDescription& scene : scenes) {
        const bool taken = !stems.empty() && stems.front() == scene.stem;
        stems.push_back(taken ? scene.stem + "-2" : scene.stem);
    }
    return stems;
}

// What the scene is, in a line each.
std::vector<std::string> facts_of(const SceneDescription& scene, const std::string& stem) {
    Specimen specimen(scene);
    const Mode& fastest = specimen.modes().modes.front();
    const double ratio = fastest.omega > 0.0 ? fastest.damping_rate / (2.0 * fastest.omega) : 0.0;
    const ClothModel& cloth = specimen.cloth();
    const auto [structural, shear, bend] = cloth.spring_counts();
    return {fmt::format("{} ({}): {} particles, {} of them held; springs: {} structural, {} shear, "
                        "{} bend; {:.4g} kg",
                        scene.name, stem, cloth.particle_count, cloth.pins.size(), structural,
                        shear, bend, cloth.total_mass()),
            fmt::format("{}: fastest mode {:.4g} rad/s with damping ratio {:.3g}; {}", stem,
                        fastest.omega, ratio, scene.wind ? "in wind" : "no air")};
}

// Experiments ask how well a method solves a smooth problem, from rest.
void check_measurable(const SceneDescription& scene) {
    if (!scene.obstacles.empty()) {
        throw scene_error("obstacles", fmt::format("a list of {}", scene.obstacles.size()),
                          "none in the laboratory, which measures methods without contact");
    }
    if (scene.start.state || scene.start.time != 0.0) {
        throw scene_error(scene.start.state ? "start.state" : "start.time", "a start of its own",
                          "none in the laboratory, whose runs begin at rest at time 0");
    }
}

LabOptions options_of_part(const LabOptions& options, double begin, double length) {
    LabOptions part = options;
    if (options.progress) {
        part.progress = [tell = options.progress, begin, length](LabProgress progress) {
            progress.fraction = begin + length * progress.fraction;
            tell(progress);
        };
    }
    return part;
}

// `share` of the whole: shares of the experiments chosen, that add up to 1.
std::vector<Section> measure(const StudyPlan& plan, Laboratory& laboratory) {
    const std::vector<const Experiment*> experiments = experiments_of(plan);
    double sum = 0.0;
    for (const Experiment* experiment : experiments) sum += experiment->share;
    std::vector<Section> sections;
    for (const Experiment* experiment : experiments) {
        laboratory.check_interrupt();
        laboratory.begin_experiment(experiment->name, experiment->share / sum, experiment->batches);
        Section section = experiment->run(laboratory);
        section.experiment = experiment->name;
        section.title = experiment->title;
        section.question = experiment->question;
        section.command = fmt::format("weft lab {} {}", experiment->name, plan.arguments);
        sections.push_back(std::move(section));
    }
    return sections;
}

std::string title_of(const StudyPlan& plan) {
    if (plan.scenes.size() == 1) return plan.scenes.front().name;
    return fmt::format("{} beside {}", plan.scenes.front().name, plan.scenes.back().name);
}

}  // namespace

std::vector<std::filesystem::path> run_study(const StudyPlan& plan) {
    for (const SceneDescription& scene : plan.scenes) check_measurable(scene);
    check_plotting();
    const std::vector<std::string> stems = stems_of(plan.scenes);
    ReportHead head;
    for (std::size_t n = 0; n < stems.size(); ++n) {
        for (std::string& fact : facts_of(plan.scenes[n], stems[n])) {
            head.facts.push_back(std::move(fact));
        }
    }
    std::vector<SceneSections> scenes;
    const double part = 1.0 / static_cast<double>(stems.size());
    for (std::size_t n = 0; n < stems.size(); ++n) {
        Laboratory laboratory(plan.scenes[n],
                              stems.size() == 1 ? plan.directory : plan.directory / stems[n],
                              options_of_part(plan.options, part * static_cast<double>(n), part));
        scenes.push_back({stems[n], measure(plan, laboratory)});
    }
    std::string names;
    for (const Experiment* experiment : plan.experiments) {
        names += std::string(experiment->name) + " ";
    }
    head.title = title_of(plan);
    head.scene = stems.size() == 1 ? stems.front() : stems.front() + ", " + stems.back();
    head.command =
        fmt::format("weft lab {}{}{}", stems.size() == 2 ? "compare " : "", names, plan.arguments);
    head.quick = plan.options.quick;
    head.facts.push_back(fmt::format("weft {}, double precision, {} instructions, one thread a run",
                                     version(), instruction_set()));
    return write_report(plan.directory, head, scenes);
}

}  // namespace weft::lab
