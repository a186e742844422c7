#include "lab/settle/rest_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "forces/measure_cloth.h"
#include "lab/settle/seed_steppers.h"
#include "lab/wrinkles.h"
#include "weft/simulation.h"

namespace weft::lab {

namespace {

// Watches a run step by step.
class RestWatch {
public:
    RestWatch(Specimen& specimen, const RestPlan& plan)
        : specimen_(specimen),
          plan_(plan),
          measures_(specimen.cloth(), specimen.scene().forces, chosen_instruction_set()),
          wrinkles_(specimen.cloth().surface) {}

    // false: it has blown up.
    bool look(const ParticleState<double>& state) {
        const StrainCheck check = measures_.check(state.x.view(), state.v.view());
        if (!check.finite || check.strain > Divergence::max_strain) {
            run_.blow_up = state.time;
            return false;
        }
        const Energy energy = measures_.energy(state.x.view(), state.v.view());
        if (kinetic_.empty()) first_ = energy.total();
        const double gained = energy.total() - first_;
        kinetic_.push_back({state.time, energy.kinetic});
        if (plan_.released && !run_.gain && gained > *plan_.released) run_.gain = state.time;
        if (state.time >= next_look_ - 1e-9) {
            run_.samples.push_back({state.time, energy.kinetic, gained,
                                    wrinkles_.angle(specimen_.cloth(), state), check.strain});
            next_look_ += plan_.look_every;
        }
        return true;
    }

    RestRun finish() {
        if (!run_.blow_up && run_.failure.empty()) find_rest();
        return std::move(run_);
    }
    void fail(std::string reason) { run_.failure = std::move(reason); }

private:
    void find_rest() {
        double whole = plan_.released.value_or(0.0);
        if (!plan_.released) {
            for (const auto& [time, kinetic] : kinetic_) whole = std::max(whole, kinetic);
        }
        std::size_t from = kinetic_.size();
        while (from > 0 && kinetic_[from - 1].second < rest_fraction * whole) --from;
        if (from == kinetic_.size() || whole == 0.0) return;
        const double time = kinetic_[from].first, end = kinetic_.back().first;
        if (end - time >= rest_share * end) run_.rest = time;
    }

    Specimen& specimen_;
    const RestPlan& plan_;
    ClothMeasures<double> measures_;
    Wrinkles wrinkles_;
    RestRun run_;
    std::vector<std::pair<double, double>> kinetic_;  // time, kinetic energy
    double first_ = 0.0, next_look_ = 0.0;
};

std::unique_ptr<Integrator<double>> integrator_of(const RestPlan& plan) {
    if (find_seed_update(plan.method) != nullptr) {
        return make_seed_update(plan.method, plan.drag_rate);
    }
    return make_integrator<double>(plan.method);
}

nlohmann::json optional_json(const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
}

std::optional<double> optional_from(const nlohmann::json& json) {
    return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

}  // namespace

std::optional<double> RestRun::wrecked() const {
    std::optional<double> first = blow_up;
    if (gain && (!first || *gain < *first)) first = gain;
    if (!first && !failure.empty() && !samples.empty()) first = samples.back().time;
    return first;
}

RestSample RestRun::at(double time) const {
    RestSample nearest;
    double distance = std::numeric_limits<double>::infinity();
    for (const RestSample& sample : samples) {
        if (std::abs(sample.time - time) >= distance) continue;
        distance = std::abs(sample.time - time);
        nearest = sample;
    }
    const double spacing =
        samples.size() < 2 ? 0.0 : samples[1].time - samples[0].time;  // of looks
    if (distance <= spacing) return nearest;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {time, none, none, none, none};
}

RestRun run_to_rest(Specimen& specimen, const RestPlan& plan, const Watch& watch) {
    const auto integrator = integrator_of(plan);
    integrator->prepare(specimen.system());
    ParticleState<double> state = specimen.start();
    RestWatch look(specimen, plan);
    const auto steps = static_cast<std::size_t>(std::ceil(plan.duration / plan.time_step - 1e-9));
    look.look(state);
    for (std::size_t step = 1; step <= steps; ++step) {
        watch();
        const StepReport report = integrator->step(specimen.system(), plan.time_step, state);
        if (!report.ok()) {
            look.fail(report.failure->reason);
            break;
        }
        state.time = static_cast<double>(step) * plan.time_step;
        if (!look.look(state)) break;
    }
    return look.finish();
}

nlohmann::json to_json(const RestRun& run) {
    nlohmann::json samples = nlohmann::json::array();
    for (const RestSample& s : run.samples) {
        samples.push_back({s.time, s.kinetic, s.gained, s.wrinkles, s.strain});
    }
    return {{"rest", optional_json(run.rest)},
            {"gain", optional_json(run.gain)},
            {"blow_up", optional_json(run.blow_up)},
            {"failure", run.failure},
            {"samples", std::move(samples)}};
}

RestRun rest_run_from_json(const nlohmann::json& json) {
    RestRun run;
    run.rest = optional_from(json.at("rest"));
    run.gain = optional_from(json.at("gain"));
    run.blow_up = optional_from(json.at("blow_up"));
    run.failure = json.at("failure").get<std::string>();
    for (const nlohmann::json& row : json.at("samples")) {
        const auto s = row.get<std::array<double, 5>>();
        run.samples.push_back({s[0], s[1], s[2], s[3], s[4]});
    }
    return run;
}

}  // namespace weft::lab
