#include "lab/work_precision/work_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/reference.h"
#include "lab/scene_stretch.h"
#include "lab/sensitivity/sensitivity.h"

namespace weft::lab {

namespace {

constexpr double softer = 0.1, stiffer = 100.0;
constexpr double damping_ratio = 0.1;     // of the fastest wave of the stiff scene
constexpr double reference_share = 1e-9;  // its tolerance, of the cloth's size
constexpr double least_share = 0.02;      // of the wanted length

std::array<SpringMaterial*, 3> springs_of(SceneDescription& scene) {
    return {&scene.material.structural, &scene.material.shear, &scene.material.bend};
}

WorkScene soft_scene(SceneDescription scene) {
    for (SpringMaterial* spring : springs_of(scene)) {
        spring->stiffness *= softer;
        spring->damping *= softer;
    }
    return {"soft", "Soft: the scene with a tenth of every stiffness and dashpot.",
            std::move(scene)};
}

WorkScene stiff_scene(SceneDescription scene) {
    for (SpringMaterial* spring : springs_of(scene)) {
        spring->stiffness *= stiffer;
        spring->damping = 0.0;
    }
    Specimen undamped(scene);
    const StabilityModes& modes = undamped.modes();
    const double omega = modes.modes.empty() ? 0.0 : modes.modes.front().omega;
    // A wave of damping c = beta k has zeta = beta omega / 2.
    const double beta = omega > 0.0 ? 2.0 * damping_ratio / omega : 0.0;
    for (SpringMaterial* spring : springs_of(scene)) spring->damping = beta * spring->stiffness;
    return {"stiff",
            fmt::format("Stiff: the scene with a hundred times every stiffness k, and with "
                        "dashpots of {:.2g} s x k, which damp the fastest wave ({:.3g}/s) to a "
                        "tenth of what is critical.",
                        beta, omega),
            std::move(scene)};
}

WorkScene windy_scene(SceneDescription scene) {
    const bool windy = scene.wind.has_value();
    if (!windy) {
        scene.wind = WindDescription{};
        scene.wind->gust.model = GustModel::none;
    }
    const Vec3d v = scene.wind->velocity;
    const std::string velocity = fmt::format("({:g}, {:g}, {:g}) m/s", v.x, v.y, v.z);
    return {"windy",
            windy ? fmt::format("Windy: the scene as it is, in its own wind of {}.", velocity)
                  : fmt::format("Windy: the scene in the wind of the shipped flag, {}.", velocity),
            std::move(scene)};
}

double wanted_length(const Specimen& specimen, double limit, bool quick) {
    const double particles = static_cast<double>(specimen.particle_count());
    const double steps = std::min(quick ? 400.0 : 3000.0, (quick ? 8e5 : 4e6) / particles);
    return std::min({specimen.scene().output.duration / 2.0, quick ? 0.5 : 2.0, steps * limit});
}

}  // namespace

std::vector<WorkScene> work_scenes(const SceneDescription& scene) {
    SceneDescription steady = scene;
    if (steady.wind) steady.wind->gust.model = GustModel::none;
    std::vector<WorkScene> scenes;
    scenes.push_back(soft_scene(steady));
    scenes.push_back(stiff_scene(steady));
    scenes.push_back(windy_scene(steady));
    return scenes;
}

WorkStretch find_work_stretch(Specimen& specimen, bool quick, const Watch& watch) {
    WorkStretch stretch;
    stretch.start = stretch.end = specimen.start();
    stretch.limit = scene_limit(specimen);
    stretch.wanted = wanted_length(specimen, stretch.limit, quick);
    const double disturbance = 1e-9 * cell_size(specimen.cloth());
    const double length =
        std::max(meaningful_time(specimen.scene(), disturbance, most_growth * disturbance,
                                 stretch.wanted, watch),
                 least_share * stretch.wanted);
    const Reference reference = reference_solution(
        specimen, stretch.start, length, reference_share * specimen.cloth().rest_diagonal(), watch);
    stretch.end = reference.state;
    stretch.reference_error = reference.error;
    stretch.motion = motion_between(specimen.cloth(), stretch.start, stretch.end);
    if (!reference.converged) stretch.failure = "the reference solution did not converge";
    return stretch;
}

nlohmann::json work_stretch_to_json(const ClothModel& cloth, const WorkStretch& stretch) {
    if (!stretch.failure.empty()) return {{"failure", stretch.failure}};
    return {{"start", state_to_json(cloth, stretch.start)},
            {"end", state_to_json(cloth, stretch.end)},
            {"wanted", stretch.wanted},
            {"limit", stretch.limit},
            {"motion", stretch.motion},
            {"reference_error", stretch.reference_error}};
}

WorkStretch work_stretch_from_json(const ClothModel& cloth, const nlohmann::json& json) {
    WorkStretch stretch;
    stretch.failure = json.value("failure", "");
    if (!stretch.failure.empty()) return stretch;
    stretch.start = state_from_json(cloth, json.at("start"));
    stretch.end = state_from_json(cloth, json.at("end"));
    stretch.wanted = json.at("wanted").get<double>();
    stretch.limit = json.at("limit").get<double>();
    stretch.motion = json.at("motion").get<double>();
    stretch.reference_error = json.at("reference_error").get<double>();
    return stretch;
}

}  // namespace weft::lab
