#include "lab/stability/resting_cloth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "math/random.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

constexpr double noise_part = 0.3;         // beside the fastest mode
constexpr double enough = 1e4;             // growth that needs no more steps
constexpr std::size_t most_samples = 400;  // of the amplitude in a flight

double shortest_spring(const ClothModel& cloth) {
    double shortest = std::numeric_limits<double>::infinity();
    cloth.for_each_spring([&](const Spring& spring, const SpringConstants&) {
        if (spring.rest_length > 0.0) shortest = std::min(shortest, spring.rest_length);
    });
    return std::isfinite(shortest) ? shortest : cloth.rest_diagonal();
}

// Slope of the least-squares line through (x, y) from index `first` on.
double fitted_slope(const std::vector<std::pair<double, double>>& points, std::size_t first) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = first; i < points.size(); ++i) {
        const auto [x, y] = points[i];
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double spread = n * sxx - sx * sx;
    return spread > 0.0 ? (n * sxy - sx * sy) / spread : 0.0;
}

}  // namespace

SceneDescription calm_scene(SceneDescription scene) {
    scene.forces.gravity = {};
    scene.wind.reset();
    for (PinDescription& pin : scene.pins) pin.motion.clear();
    return scene;
}

RestingCloth::RestingCloth(const SceneDescription& scene, double nudge)
    : specimen_(calm_scene(scene)),
      measures_(specimen_.cloth(), specimen_.scene().forces, chosen_instruction_set()),
      nudged_(specimen_.start()),
      nudge_(nudge * shortest_spring(specimen_.cloth())) {
    const ClothModel& cloth = specimen_.cloth();
    StabilityAnalysis<double> analysis(cloth, specimen_.scene().forces);
    modes_ = analysis.find(std::as_const(nudged_).x.view());
    const Vec3Array<double>& mode = analysis.fastest_mode();  // times the root of mass
    Vec3Array<double> shape(nudged_.x.size());
    double largest = 0.0;
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        shape.set(slot, 1.0 / std::sqrt(cloth.masses[p]) * mode[slot]);
        largest = std::max(largest, length(shape[slot]));
    });
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        const auto noise = [&](std::uint64_t n) { return 2.0 * random_uniform(3, n, p) - 1.0; };
        Vec3d moved = noise_part * nudge_ * Vec3d{noise(0), noise(1), noise(2)};
        if (largest > 0.0) moved = moved + nudge_ / largest * shape[slot];
        nudged_.x.set(slot, nudged_.x[slot] + moved);
    });
    specimen_.system().constrain(0.0, nudged_.x.view(), nudged_.v.view());
}

double RestingCloth::amplitude(const ParticleState<double>& state) {
    const Energy energy = measures_.energy(state.x.view(), state.v.view());
    return std::sqrt(energy.kinetic + energy.springs());
}

Growth RestingCloth::fly(std::string_view method, double time_step, std::size_t steps,
                         const Watch& watch) {
    const double start = amplitude(nudged_);
    const std::size_t interval = std::max<std::size_t>(1, steps / most_samples);
    std::vector<std::pair<double, double>> samples;  // step, ln of the amplitude
    Growth growth;
    const auto look = [&](std::size_t step, const ParticleState<double>& state) {
        if (step % interval != 0) return true;
        const double now = amplitude(state);
        samples.emplace_back(static_cast<double>(step), std::log(std::max(now, 1e-300)));
        return now < enough * start;
    };
    const Flight flight =
        lab::fly(specimen_, {method, time_step, steps, 1e-3 * nudge_, {}}, nudged_, watch, look);
    growth.steps = flight.steps;
    growth.failure = flight.failure;
    growth.rate = fitted_slope(samples, samples.size() / 2);
    if (!samples.empty() && start > 0.0) growth.total = samples.back().second - std::log(start);
    return growth;
}

Search RestingCloth::plan_search(std::string_view method, double predicted,
                                 double most_evaluations) const {
    constexpr std::array beyond{0.002, 0.004, 0.007, 0.01, 0.02, 0.04};
    constexpr double least_steps = 400.0, ln_growth = 8.0;
    const int evaluations = std::max(find_integrator(method)->evaluations, 1);
    const double most_steps = std::clamp(most_evaluations / evaluations, least_steps, 6e4);
    const auto rate = [&](double part) {
        return std::max(predicted_rate(method, (1.0 + part) * predicted), 1e-12);
    };
    const double wanted = ln_growth / rate(beyond.front());
    const double steps = std::clamp(wanted, least_steps, most_steps);
    const double unstable = wanted <= most_steps ? 1.0 : 0.1;
    const auto* const seen = std::find_if(beyond.begin(), beyond.end() - 1, [&](double part) {
        return rate(part) * steps >= 3.0 * unstable;
    });
    return {static_cast<std::size_t>(steps), *seen, unstable};
}

ObservedLimit RestingCloth::observe(std::string_view method, double predicted, const Search& search,
                                    const Watch& watch) {
    constexpr double ratio = 1.05;
    constexpr int most_widenings = 24;
    ObservedLimit limit;
    const auto is_stable = [&](double step) {
        ++limit.flights;
        const Growth growth = fly(method, step, search.steps, watch);
        return growth.failure.empty() && growth.total < std::log(enough) &&
               growth.rate * static_cast<double>(growth.steps) / 2.0 < search.unstable;
    };
    const double power = std::floor(std::log(predicted) / std::log(ratio));
    limit.stable = std::pow(ratio, power), limit.unstable = ratio * limit.stable;
    bool low = is_stable(limit.stable), high = !is_stable(limit.unstable);
    for (int n = 1; n <= most_widenings && !low; ++n) {
        limit.unstable = std::exchange(limit.stable, limit.stable / std::pow(ratio, n));
        high = true;
        low = is_stable(limit.stable);
    }
    for (int n = 1; n <= most_widenings && !high; ++n) {
        limit.stable = std::exchange(limit.unstable, limit.unstable * std::pow(ratio, n));
        high = !is_stable(limit.unstable);
    }
    limit.found = low && high;
    while (limit.found && limit.unstable > (1.0 + 0.5 * search.resolution) * limit.stable) {
        (is_stable(limit.middle()) ? limit.stable : limit.unstable) = limit.middle();
    }
    return limit;
}

double RestingCloth::predicted_rate(std::string_view method, double time_step) const {
    double largest = 0.0;
    const auto look_at = [&](const Mode& mode) {
        if (!(mode.omega > 0.0)) return;
        const double zeta = mode.damping_rate / (2.0 * mode.omega);
        largest = std::max(largest, amplification(method, mode.omega * time_step, zeta));
    };
    for (const Mode& mode : modes_.modes) look_at(mode);
    if (find_integrator(method)->imaginary_limit == 0.0) look_at(modes_.least_damped);
    return largest > 0.0 ? std::log(largest) : 0.0;
}

}  // namespace weft::lab
