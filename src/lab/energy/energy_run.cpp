#include "lab/energy/energy_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "forces/measure_cloth.h"
#include "lab/flight_cost.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

bool has_dashpots(const MaterialDescription& material) {
    return material.structural.damping > 0.0 || material.shear.damping > 0.0 ||
           material.bend.damping > 0.0;
}

std::optional<double> tolerance_of(const EnergyPlan& plan, const ClothModel& cloth) {
    const bool is_adaptive = find_integrator(plan.method)->kind == IntegratorKind::adaptive;
    if (is_adaptive) return std::nullopt;
    return (plan.exact ? 1e-8 : 5e-5) * cloth.rest_diagonal();
}

// Watches a flight: energies now and then, work by the trapezoidal rule at every step.
class Account {
public:
    Account(Specimen& specimen, bool has_work, std::size_t interval)
        : specimen_(specimen),
          measures_(specimen.cloth(), specimen.scene().forces, chosen_instruction_set()),
          has_work_(has_work),
          interval_(interval) {}

    void begin(const ParticleState<double>& state) {
        if (has_work_) power_ = power(state);
        time_ = state.time;
        sample(state);
    }

    bool look(std::size_t step, const ParticleState<double>& state) {
        if (has_work_) {
            const double now = power(state);
            work_ += 0.5 * (state.time - time_) * (power_ + now);
            power_ = now;
        }
        time_ = state.time;
        if (step % interval_ == 0 || step <= dense_steps) sample(state);
        return true;
    }

    [[nodiscard]] nlohmann::json samples() const { return samples_; }

private:
    double power(const ParticleState<double>& state) {
        return specimen_.system().power(state.time, state.x.view(), state.v.view()).total();
    }

    void sample(const ParticleState<double>& state) {
        const Energy energy = measures_.energy(state.x.view(), state.v.view());
        const std::array numbers{state.time, energy.kinetic, energy.gravity, energy.springs(),
                                 work_};
        if (std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); })) {
            samples_.push_back(numbers);
        }
    }

    // What blows up does so in the first steps.
    static constexpr std::size_t dense_steps = 300;

    Specimen& specimen_;
    ClothMeasures<double> measures_;
    bool has_work_;
    std::size_t interval_;
    double power_ = 0.0, work_ = 0.0, time_ = 0.0;
    nlohmann::json samples_ = nlohmann::json::array();
};

struct Line {
    double slope = 0.0, error = 0.0;
};

// Least squares; the error from the scatter about the line.
Line fit(const std::vector<std::array<double, 2>>& points) {
    double n = 0, sx = 0, sy = 0;
    for (const auto& [x, y] : points) n += 1, sx += x, sy += y;
    double sxx = 0, sxy = 0, scatter = 0;
    for (const auto& [x, y] : points) {
        sxx += (x - sx / n) * (x - sx / n);
        sxy += (x - sx / n) * (y - sy / n);
    }
    if (n < 3 || !(sxx > 0.0)) return {};
    const double slope = sxy / sxx;
    for (const auto& [x, y] : points) {
        scatter += std::pow(y - sy / n - slope * (x - sx / n), 2);
    }
    return {slope, std::sqrt(scatter / (n - 2) / sxx)};
}

}  // namespace

SceneDescription conservative_scene(SceneDescription scene) {
    scene.wind.reset();
    scene.forces.damping = 0.0;
    for (SpringMaterial* spring :
         {&scene.material.structural, &scene.material.shear, &scene.material.bend}) {
        spring->damping = 0.0;
    }
    for (PinDescription& pin : scene.pins) pin.motion.clear();
    return scene;
}

bool is_conservative(const SceneDescription& scene) {
    const auto moves = [](const PinDescription& pin) { return !pin.motion.empty(); };
    return !scene.wind && scene.forces.damping == 0.0 && !has_dashpots(scene.material) &&
           std::ranges::none_of(scene.pins, moves);
}

Trial energy_trial(const SceneDescription& scene, const EnergyPlan& plan, std::string_view what) {
    const auto measure = [=](const Watch& watch) {
        Specimen specimen(scene);
        Account account(specimen, !is_conservative(scene),
                        std::max<std::size_t>(1, plan.steps / plan.samples));
        const ParticleState<double> start = specimen.start();
        account.begin(start);
        const Flight flight =
            fly(specimen,
                {plan.method, plan.time_step, plan.steps, tolerance_of(plan, specimen.cloth()), {}},
                start, watch,
                [&](std::size_t step, const auto& state) { return account.look(step, state); });
        return nlohmann::json{
            {"samples", account.samples()}, {"steps", flight.steps}, {"failure", flight.failure}};
    };
    return {fmt::format("{} by {} dt={:.8g} steps={} samples={}{}", what, plan.method,
                        plan.time_step, plan.steps, plan.samples, plan.exact ? " exact" : ""),
            measure, step_cost(plan.method, plan.exact) * static_cast<double>(plan.steps)};
}

EnergyRun energy_run_from_json(const nlohmann::json& json) {
    EnergyRun run;
    for (const nlohmann::json& row : json.at("samples")) {
        const auto n = row.get<std::array<double, 5>>();
        run.samples.push_back({n[0], n[1], n[2], n[3], n[4]});
    }
    run.steps = json.at("steps").get<std::size_t>();
    run.failure = json.at("failure").get<std::string>();
    return run;
}

bool EnergyTrend::is_sure() const {
    return std::abs(slope) > 3.0 * error;
}

EnergyTrend energy_trend(const EnergyRun& run, double from, double bound) {
    constexpr std::size_t stretches = 12;
    std::vector<std::array<double, 2>> points;
    for (const EnergySample& sample : run.samples) {
        const double account = sample.account();
        if (std::abs(account - run.samples.front().account()) > bound) break;
        if (sample.time >= from) points.push_back({sample.time, account});
    }
    if (points.size() < 2) return {};
    EnergyTrend trend;
    trend.from = points.front()[0], trend.to = points.back()[0];
    trend.slope = fit(points).slope;
    // Neighbouring samples are not independent, means of long stretches nearly are.
    const std::size_t length = std::max<std::size_t>(1, points.size() / stretches);
    std::vector<std::array<double, 2>> means;
    for (std::size_t first = 0; first + length <= points.size(); first += length) {
        std::array<double, 2> mean{};
        for (std::size_t n = first; n < first + length; ++n) {
            mean[0] += points[n][0] / static_cast<double>(length);
            mean[1] += points[n][1] / static_cast<double>(length);
        }
        means.push_back(mean);
    }
    trend.error = fit(means).error;
    return trend;
}

}  // namespace weft::lab
