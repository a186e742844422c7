#include "lab/stability/stability_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "forces/energy.h"
#include "lab/stability/spectrum.h"
#include "simulation/method_choice.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

// What a calm cloth does under a step this much too long is seen in nudges of this size: so large
// that implicit systems can be solved to a thousandth of it, so small that springs are linear.
constexpr double implicit_nudge = 1e-6;

double work_of(const SceneDescription& scene, std::string_view method, double steps) {
    const double evaluations = std::max(find_integrator(method)->evaluations, 1);
    const auto& resolution = scene.cloth.grid.resolution;
    return steps * evaluations * (scene.cloth.mesh ? 1.0 : resolution[0] * resolution[1]);
}

// The scene as it is, gravity, wind, moving pins and all, by steps of this length.
nlohmann::json fly_scene(const SceneDescription& scene, std::string_view method, double time_step,
                         std::size_t steps, const Watch& watch) {
    Specimen specimen(scene);
    const FlightPlan plan{
        method, time_step, steps, solver_tolerance(scene, specimen.cloth(), method), {}};
    const Flight flight = fly(specimen, plan, specimen.start(), watch);
    nlohmann::json result{{"steps", flight.steps}, {"of", steps}, {"failure", flight.failure}};
    const double strain = largest_strain(specimen.cloth(), flight.state.x.view()).strain;
    if (std::isfinite(strain)) result["strain"] = strain;
    return result;
}

}  // namespace

Trial spectrum_trial(const SceneDescription& scene, std::size_t count) {
    const auto measure = [scene, count](const Watch& watch) {
        const Specimen specimen(calm_scene(scene));
        const Spectrum spectrum = ritz_spectrum(specimen, specimen.start(), count, watch);
        nlohmann::json modes = nlohmann::json::array();
        for (const Mode& mode : spectrum.modes) modes.push_back({mode.omega, mode.damping_rate});
        return nlohmann::json{{"modes", std::move(modes)}, {"complete", spectrum.complete}};
    };
    return {fmt::format("spectrum of {} values", count), measure,
            work_of(scene, "velocity-verlet", 10.0 * static_cast<double>(count))};
}

Trial limit_trial(const SceneDescription& scene, std::string_view method, double predicted,
                  const Search& search, const std::vector<double>& parts) {
    const auto measure = [=](const Watch& watch) {
        RestingCloth cloth(scene);
        const ObservedLimit limit = cloth.observe(method, predicted, search, watch);
        nlohmann::json curve = nlohmann::json::array();
        for (const double part : parts) {
            const Growth growth = cloth.fly(method, part * predicted, search.steps, watch);
            curve.push_back({part, growth.rate});
        }
        return nlohmann::json{{"stable", limit.stable},   {"unstable", limit.unstable},
                              {"found", limit.found},     {"flights", limit.flights},
                              {"steps", search.steps},    {"resolution", search.resolution},
                              {"curve", std::move(curve)}};
    };
    return {
        fmt::format("limit of {} near {:.6g} s, {} steps, within {}, growth {}, {} more", method,
                    predicted, search.steps, search.resolution, search.unstable, parts.size()),
        measure, work_of(scene, method, 10.0 * static_cast<double>(search.steps))};
}

Trial growth_trial(const SceneDescription& scene, std::string_view method, double time_step,
                   std::size_t steps) {
    const auto measure = [=](const Watch& watch) {
        RestingCloth cloth(scene);
        const Growth growth = cloth.fly(method, time_step, steps, watch);
        return nlohmann::json{{"rate", growth.rate}, {"steps", growth.steps}};
    };
    return {fmt::format("growth of {} dt={:.6g} steps={}", method, time_step, steps), measure,
            work_of(scene, method, static_cast<double>(steps))};
}

Trial beyond_trial(const SceneDescription& scene, std::string_view method, double time_step,
                   std::size_t steps) {
    const auto measure = [=](const Watch& watch) {
        RestingCloth cloth(scene, implicit_nudge);
        const Growth growth = cloth.fly(method, time_step, steps, watch);
        return nlohmann::json{{"total", growth.total},
                              {"steps", growth.steps},
                              {"failure", growth.failure},
                              {"scene", fly_scene(scene, method, time_step, steps, watch)}};
    };
    constexpr double evaluations_a_step = 300.0;  // what a solve costs, roughly
    return {fmt::format("beyond, by {} dt={:.6g} steps={}", method, time_step, steps), measure,
            work_of(scene, method, evaluations_a_step * static_cast<double>(steps))};
}

}  // namespace weft::lab
