// Rest and blow-up on the study's own scene.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "io/scene_json.h"
#include "lab/settle/settle_parts.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

constexpr double most_work = 1e8, most_quick_work = 1e7;  // particles times steps of a run
constexpr double long_step = 0.9, short_step = 0.45;      // of velocity-verlet's limit

// What makes the motion: pictures, names and the way of computing left out.
bool same_cloth(const SceneDescription& a, const SceneDescription& b) {
    nlohmann::json one = scene_to_json(a), other = scene_to_json(b);
    for (nlohmann::json* scene : {&one, &other}) scene->at("material").erase("fabric");  // a name
    const auto part = [](const nlohmann::json& json, const char* key) {
        return json.contains(key) ? json.at(key) : nlohmann::json();
    };
    return std::ranges::all_of(
        std::array{"cloth", "material", "pins", "obstacles", "start", "forces", "wind"},
        [&](const char* key) { return part(one, key) == part(other, key); });
}

bool has_moving_pins(const SceneDescription& scene) {
    return std::ranges::any_of(scene.pins,
                               [](const PinDescription& pin) { return !pin.motion.empty(); });
}

std::vector<std::string_view> methods_of(const std::vector<std::string_view>& asked) {
    std::vector<std::string_view> methods{"forward-euler", "verlet", "rk3"};
    for (const std::string_view method : asked) {
        if (method == "velocity-verlet" || method == "rk4") methods.push_back(method);
    }
    return methods;
}

}  // namespace

SettleScene::SettleScene(RestBatch& batch, const SceneDescription& scene,
                         const std::vector<std::string_view>& methods, bool quick) {
    if (same_cloth(scene, seed_scene({}))) return;
    moved_ = scene.wind.has_value() || has_moving_pins(scene);
    Specimen specimen(scene);
    const double limit = specimen.modes().stable_step("velocity-verlet");
    // Springs that limit nothing (all particles held, or no stiffness): a frame is step enough.
    const double base = std::isfinite(limit) ? limit : 1.0 / scene.output.frames_per_second;
    const double particles = static_cast<double>(specimen.particle_count());
    asked_duration_ = std::max(scene.output.duration, settle_duration(quick));
    duration_ = std::min(asked_duration_,
                         (quick ? most_quick_work : most_work) / particles * short_step * base);
    // Whole tenths of a second where there are some: a name that people can read.
    if (duration_ > 1.0) duration_ = std::floor(10.0 * duration_) / 10.0;
    std::set<std::pair<std::string_view, double>> done;
    for (const double part : {long_step, short_step}) {
        for (const std::string_view method : methods_of(methods)) {
            RestPlan plan;
            plan.method = method;
            plan.time_step = part * base;
            plan.duration = duration_;
            plan.look_every = duration_ / 100.0;
            if (!done.insert({method, plan.time_step}).second) continue;
            runs_.push_back({method, plan.time_step, specimen.modes().stable_step(method),
                             batch.add("scene", scene, plan)});
        }
    }
}

void SettleScene::tell(const RestBatch& batch, Section& section) const {
    if (runs_.empty()) return;
    std::string text = fmt::format(
        "On the scene itself the runs last {:.4g} s with steps of 0.9 and 0.45 of what is stable "
        "for velocity-verlet. Rest is where the kinetic energy stays below a thousandth of the "
        "largest of the run.",
        duration_);
    if (duration_ < asked_duration_) {
        text += fmt::format(" They were cut from {:.4g} s, as steps are short and particles many.",
                            asked_duration_);
    }
    if (moved_) text += " Wind or pins move this cloth, so it may never rest.";
    section.blocks.emplace_back(Paragraph{std::move(text)});
    Table table;
    table.id = "scene";
    table.caption =
        "Rest and blow-up on the scene, a run a row. The limit is what theory gives the method "
        "where the cloth is at rest; 0: no step is stable.";
    table.columns = {{"method"},
                     {"dt [s]"},
                     {"limit of dt [s]"},
                     {"at rest from [s]"},
                     {"blown up [s]"},
                     {"largest strain last seen", 3},
                     {"note"}};
    for (const Run& run : runs_) {
        const RestRun& result = batch[run.place];
        const double strain = result.samples.back().strain;
        table.rows.push_back({std::string(run.method), run.time_step, run.limit,
                              time_cell(result.rest), time_cell(result.blow_up), strain,
                              run.time_step > run.limit ? "beyond its limit" : ""});
    }
    section.blocks.emplace_back(std::move(table));
}

std::string SettleScene::sentence(const RestBatch& batch) const {
    if (runs_.empty()) return {};
    std::size_t blown = 0, rested = 0;
    for (const Run& run : runs_) {
        if (batch[run.place].blow_up) ++blown;
        if (batch[run.place].rest) ++rested;
    }
    return fmt::format("on this scene {} of {} runs blow up and {} come to rest within {:.4g} s",
                       blown, runs_.size(), rested, duration_);
}

}  // namespace weft::lab
