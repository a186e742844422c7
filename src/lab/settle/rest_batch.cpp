#include "lab/settle/rest_batch.h"

#include <fmt/format.h>

#include <algorithm>

#include "lab/settle/seed_steppers.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

// Evaluations of the forces a second of the run, roughly.
double work_of(const RestPlan& plan) {
    const IntegratorInfo* const info = find_integrator(plan.method);
    int evaluations = info == nullptr ? 2 : std::max(info->evaluations, 1);
    if (plan.method == "rk3 K2 implicit") evaluations = 80;
    return plan.duration / plan.time_step * evaluations;
}

}  // namespace

std::size_t RestBatch::add(const std::string& setting, const SceneDescription& scene,
                           const RestPlan& plan) {
    Trial trial;
    trial.name =
        fmt::format("{}: {} dt={} T={}", setting, plan.method, plan.time_step, plan.duration);
    const auto found = std::ranges::find(trials_, trial.name, &Trial::name);
    if (found != trials_.end()) return static_cast<std::size_t>(found - trials_.begin());
    trial.measure = [scene, plan](const Watch& watch) {
        Specimen specimen(scene);
        return to_json(run_to_rest(specimen, plan, watch));
    };
    trial.work = work_of(plan);
    trials_.push_back(std::move(trial));
    return trials_.size() - 1;
}

void RestBatch::run(Laboratory& laboratory) {
    runs_.clear();
    for (const nlohmann::json& result : laboratory.run(trials_)) {
        runs_.push_back(rest_run_from_json(result));
    }
}

}  // namespace weft::lab
