#include "simulation/method_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "weft/error.h"
#include "weft/integrators.h"

namespace weft {

namespace {

constexpr double auto_fraction = 0.9;  // of the stable step
// The longest automatic steps among obstacles [s]. They act between steps: what the springs pull in
// a step is taken back from each particle that touches, on its own, so that cloth which hangs from
// a patch of contact is stretched there by about g h^2 times the ratio of their masses. At a ratio
// of 10 that is 0.4 mm with 1/480 s; with 1/120 s it would be 7 mm, and cloth passes small
// obstacles between its particles. An implicit method has the surface in its equations, which makes
// a tenth of it, but only those of one stage profit: a stage that starts from the pull of springs
// that contact has just stretched overshoots.
constexpr double longest_step_in_contact = 1.0 / 480, longest_of_one_stage = 1.0 / 240;
constexpr std::string_view explicit_method = "velocity-verlet", implicit_method = "tr-bdf2",
                           implicit_in_contact = "implicit-euler";

// What a step of 1/120 s by the implicit method costs, in explicit ones of the same cloth: measured
// on sheets of 20 to 257 squared in motion and on the shipped flag and cape (docs/performance.md).
// In wind Newton takes more iterations, since the air's force turns with the cloth, which its
// matrix leaves out; on a mesh explicit steps cost more.
double implicit_step_cost(const ClothModel& cloth, bool in_air) {
    if (cloth.is_grid()) return in_air ? 1500.0 : 400.0;
    return in_air ? 300.0 : 150.0;
}

double longest_in_contact(const IntegratorInfo& info, const StabilityModes& modes) {
    if (info.kind == IntegratorKind::implicit && info.order == 1) return longest_of_one_stage;
    // It makes steps of its own in between, about as long as an explicit method's.
    if (info.kind == IntegratorKind::adaptive) {
        return std::min(longest_step_in_contact, modes.stable_step(explicit_method));
    }
    return longest_step_in_contact;
}

}  // namespace

std::size_t steps_in_frame(double frame_length, double dt) {
    const double steps = std::ceil(frame_length / dt * (1.0 - 1e-12));
    return static_cast<std::size_t>(std::clamp(steps, 1.0, 1e12));
}

std::size_t automatic_steps(const SceneDescription& scene, std::string_view method,
                            const StabilityModes& modes) {
    const double frame_length = 1.0 / scene.output.frames_per_second;
    const IntegratorInfo& info = *find_integrator(method);
    double step = frame_length;
    if (info.kind == IntegratorKind::explicit_steps) {
        step = auto_fraction * modes.stable_step(method);
        if (step == 0.0) return 0;
    } else if (info.kind != IntegratorKind::adaptive) {
        step = info.auto_step;
    }
    if (!scene.obstacles.empty()) step = std::min(step, longest_in_contact(info, modes));
    return steps_in_frame(frame_length, step);
}

std::size_t steps_a_frame(const SceneDescription& scene, std::string_view method,
                          const StabilityModes& modes) {
    const bool own_steps = find_integrator(method)->kind == IntegratorKind::adaptive;
    if (scene.integrator.time_step && !own_steps) {
        return steps_in_frame(1.0 / scene.output.frames_per_second, *scene.integrator.time_step);
    }
    const std::size_t steps = automatic_steps(scene, method, modes);
    if (steps == 0) {
        throw scene_error("integrator.time_step", "\"auto\"",
                          fmt::format("{} is stable at no step on this undamped cloth: give a step "
                                      "in seconds, damping, or another method",
                                      method));
    }
    return steps;
}

std::optional<double> solver_tolerance(const SceneDescription& scene, const ClothModel& cloth,
                                       std::string_view method) {
    constexpr double of_diagonal = 5e-5;
    if (scene.integrator.tolerance) return scene.integrator.tolerance;
    if (find_integrator(method)->kind == IntegratorKind::adaptive) return std::nullopt;
    return of_diagonal * cloth.rest_diagonal();
}

MethodChoice choose_method(const SceneDescription& scene, const ClothModel& cloth,
                           const StabilityModes& modes) {
    const IntegratorDescription& integrator = scene.integrator;
    if (integrator.method != "auto") return {integrator.method, ""};
    const std::string_view implicit =
        scene.obstacles.empty() ? implicit_method : implicit_in_contact;
    const double limit = modes.stable_step(explicit_method), omega = modes.modes.front().omega;
    if (integrator.time_step) {
        const bool stable = *integrator.time_step <= limit;
        return {std::string(stable ? explicit_method : implicit),
                fmt::format("the step of {:.4g} s is {} the explicit limit of {:.4g} s (omega_max "
                            "{:.4g} 1/s)",
                            *integrator.time_step, stable ? "within" : "beyond", limit, omega)};
    }
    const auto explicit_steps = static_cast<double>(automatic_steps(scene, explicit_method, modes));
    const auto implicit_steps = static_cast<double>(automatic_steps(scene, implicit, modes));
    const double implicit_cost = implicit_steps * implicit_step_cost(cloth, scene.wind.has_value());
    const bool chosen_explicit = explicit_steps <= implicit_cost;
    return {std::string(chosen_explicit ? explicit_method : implicit),
            fmt::format("{} explicit steps a frame (omega_max {:.4g} 1/s) cost {} than {} implicit "
                        "ones, worth about {} on this {} of {} particles",
                        explicit_steps, omega, chosen_explicit ? "less" : "more", implicit_steps,
                        implicit_cost, cloth.is_grid() ? "grid" : "mesh", cloth.particle_count)};
}

}  // namespace weft
