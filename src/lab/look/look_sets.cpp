#include "lab/look/look_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/seed_sheet.h"
#include "simulation/method_choice.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

constexpr std::size_t own_frames = 50;  // of the study's own scene
constexpr std::size_t own_columns = 5;
constexpr double kept_points = 12000.0;  // of one column's share of the shapes, roughly
constexpr double exact_step = 0.001;     // of the sheet's exact motion [s]

std::string step_text(double time_step) {
    return fmt::format("dt = {:.3g} ms", 1e3 * time_step);
}

// A flight by half the step that is automatic: cloth that stretches stays stable.
LookSpec spec_of(Specimen& specimen, const std::string& setting, std::string_view method,
                 const LookSet& set, std::size_t finer) {
    const IntegratorInfo& info = *find_integrator(method);
    SceneDescription framed = specimen.scene();
    framed.integrator = {};
    framed.output.frames_per_second = 1.0 / set.frame_length;
    std::size_t steps = automatic_steps(framed, method, specimen.modes());
    LookSpec spec;
    if (steps == 0) {
        steps = automatic_steps(framed, "velocity-verlet", specimen.modes());
        spec.note = "stable at no step; flown at that of velocity-verlet";
    }
    if (info.kind == IntegratorKind::explicit_steps) steps *= finer;
    spec.plan = {std::string(method), set.frame_length, steps, set.frames};
    spec.title =
        fmt::format("{}, {}", method,
                    info.kind == IntegratorKind::adaptive ? "steps of its own"
                                                          : step_text(spec.plan.time_step()));
    spec.look = method;
    spec.setting = setting;
    spec.scene = framed;
    return spec;
}

void set_columns(LookSet& set, const std::vector<std::size_t>& shown) {
    for (const std::size_t frame : shown) {
        const auto place = std::ranges::find(set.frames, frame) - set.frames.begin();
        set.columns.push_back(
            {fmt::format("{:.3g} s", set.frame_length * static_cast<double>(frame)),
             static_cast<std::size_t>(place)});
    }
}

// Every frame up to the last, `every` apart.
std::vector<std::size_t> frames_up_to(std::size_t last, std::size_t every) {
    std::vector<std::size_t> frames;
    for (std::size_t frame = 0; frame <= last; frame += every) frames.push_back(frame);
    return frames;
}

// How long all methods together may take is bounded by particles times seconds, and by particles
// times steps.
double own_duration(Specimen& specimen, bool quick) {
    const double particles = static_cast<double>(specimen.particle_count());
    const double limit = specimen.modes().stable_step("velocity-verlet");
    double duration = std::min(specimen.scene().output.duration, quick ? 2.0 : 4.0);
    duration = std::min(duration, (quick ? 2400.0 : 6000.0) / particles);
    if (std::isfinite(limit)) {
        duration = std::min(duration, (quick ? 1e7 : 1e8) / particles * limit);
    }
    return duration;
}

}  // namespace

LookSet own_look(const SceneDescription& scene, const std::vector<std::string_view>& methods,
                 bool quick) {
    Specimen specimen(scene);
    LookSet set;
    set.id = "scene";
    set.name = scene.name;
    const double duration = own_duration(specimen, quick);
    const double wanted = std::min(scene.output.duration, quick ? 2.0 : 4.0);
    if (duration < wanted) {
        set.cut = fmt::format("The flights were cut from {:.3g} s to {:.3g} s to bound the work.",
                              wanted, duration);
    }
    set.frame_length = duration / static_cast<double>(own_frames);
    const double room = kept_points / static_cast<double>(specimen.particle_count());
    const auto share = static_cast<std::size_t>(std::clamp(room, 1.0, 5.0));
    set.frames = frames_up_to(own_frames, own_frames / own_columns / share);
    // The share may not divide the frames between two columns: columns are kept in any case.
    std::vector<std::size_t> shown;
    for (std::size_t n = 1; n <= own_columns; ++n) shown.push_back(n * own_frames / own_columns);
    set.frames.insert(set.frames.end(), shown.begin(), shown.end());
    std::ranges::sort(set.frames);
    const auto doubles = std::ranges::unique(set.frames);
    set.frames.erase(doubles.begin(), doubles.end());
    set_columns(set, shown);
    for (const std::string_view method : methods) {
        set.flights.push_back(spec_of(specimen, "scene", method, set, 2));
    }
    set.reference = spec_of(specimen, "scene", "rk4", set, 8);
    return set;
}

LookSet flag_look(bool quick) {
    Specimen specimen{SceneDescription{}};
    LookSet set;
    set.id = "flag";
    set.name = "the flag";
    set.frame_length = 0.04;
    const std::vector<std::size_t> shown = quick ? std::vector<std::size_t>{5, 10, 20, 35, 50}
                                                 : std::vector<std::size_t>{5, 20, 40, 70, 100};
    set.frames = frames_up_to(shown.back(), 5);
    set_columns(set, shown);
    LookSpec verlet = spec_of(specimen, "flag", "verlet", set, 1);
    LookSpec euler = spec_of(specimen, "flag", "forward-euler", set, 1);
    LookSpec same_step = euler;
    same_step.plan.steps_per_frame = verlet.plan.steps_per_frame;
    same_step.title = "forward-euler, Verlet's " + step_text(same_step.plan.time_step());
    same_step.note = "beyond its limit";
    set.reference = spec_of(specimen, "flag", "rk4", set, 4);
    set.flights = {std::move(same_step), std::move(euler), std::move(verlet)};
    return set;
}

LookSet sheet_look() {
    constexpr std::size_t steps = 10;  // of 16 ms in a frame
    LookSet set;
    set.id = "sheet";
    set.name = "the comparison's sheet";
    set.frame_length = static_cast<double>(steps) * seed_time_step;
    const std::vector<std::size_t> shown{3, 6, 19, 50, 94};  // near 0.5, 1, 3, 8 and 15 s
    set.frames = frames_up_to(shown.back(), 1);
    set_columns(set, shown);
    for (const SeedSheet& sheet : {SeedSheet{1.0, 0.0, 0.0}, SeedSheet{1.0, 0.0, seed_time_step}}) {
        const bool damped = sheet.dashpot_time > 0.0;
        for (const char* method : {"forward-euler", "verlet", "rk3"}) {
            LookSpec spec;
            spec.title = fmt::format("{}, {}, {}", method, step_text(seed_time_step),
                                     damped ? "dashpots c = k dt" : "undamped");
            spec.look = method;
            spec.setting = "seed sheet " + describe(sheet);
            spec.scene = seed_scene(sheet);
            spec.plan = {method, set.frame_length, steps, set.frames};
            spec.compared = !damped;
            set.flights.push_back(std::move(spec));
        }
        if (damped) continue;
        LookSpec exact = set.flights.front();
        exact.plan.method = "rk4";
        exact.plan.steps_per_frame =
            static_cast<std::size_t>(std::lround(set.frame_length / exact_step));
        exact.title = fmt::format("exact: rk4, {}, undamped", step_text(exact.plan.time_step()));
        exact.look = "neutral";
        set.reference = exact;
        set.flights.push_back(std::move(exact));
    }
    return set;
}

LookSet video_look(const std::vector<std::string_view>& methods, bool quick) {
    SceneDescription scene;  // the shipped flag
    scene.cloth.grid.resolution = quick ? std::array{21, 15} : std::array{31, 21};
    Specimen specimen(scene);
    LookSet set;
    set.id = "video";
    set.name = "the flag";
    set.frame_length = quick ? 1.0 / 8.0 : 1.0 / 20.0;
    set.frames = frames_up_to(quick ? 16 : 80, 1);
    for (const std::string_view method : methods) {
        LookSpec spec = spec_of(specimen, quick ? "flag 21x15" : "flag 31x21", method, set, 1);
        spec.title = method;
        set.flights.push_back(std::move(spec));
    }
    return set;
}

Trial look_trial(const LookSpec& spec) {
    std::string kept;
    for (const std::size_t frame : spec.plan.frames) kept += fmt::format(" {}", frame);
    Trial trial;
    trial.name = fmt::format("{}: {} frame={} steps={} keep{}", spec.setting, spec.plan.method,
                             spec.plan.frame_length, spec.plan.steps_per_frame, kept);
    trial.measure = [scene = spec.scene, plan = spec.plan](const Watch& watch) {
        Specimen specimen(scene);
        return to_json(fly_for_look(specimen, plan, watch));
    };
    const IntegratorInfo& info = *find_integrator(spec.plan.method);
    // Evaluations of the forces in a step, roughly, of methods that iterate.
    const double evaluations = info.kind == IntegratorKind::explicit_steps ? info.evaluations
                               : info.kind == IntegratorKind::adaptive     ? 300.0
                               : spec.plan.method == "vbd"                 ? 600.0
                                                                           : 100.0;
    trial.work = evaluations * static_cast<double>(spec.plan.steps_per_frame) *
                 static_cast<double>(spec.plan.frames.back());
    return trial;
}

}  // namespace weft::lab
