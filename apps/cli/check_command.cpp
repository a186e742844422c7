#include <fmt/format.h>

#include <cmath>

#include "cli/commands.h"
#include "cli/simulate.h"
#include "weft/integrators.h"

namespace weft {

namespace {

nlohmann::ordered_json check_json(const Simulation& simulation) {
    const auto springs = simulation.spring_counts();
    const LinearAnalysis linear = simulation.linear_analysis();
    nlohmann::ordered_json json;
    json["scene"] = simulation.scene().name;
    json["particles"] = simulation.particle_count();
    json["pinned"] = simulation.pinned_count();
    json["triangles"] = simulation.surface().triangles.size();
    json["springs"] = {{"structural", springs[0]}, {"shear", springs[1]}, {"bend", springs[2]}};
    json["mass"] = simulation.total_mass();
    json["omega_max"] = linear.omega_max;
    json["damping_ratio"] = linear.damping_ratio;
    json["method"] = simulation.method();
    json["method_reason"] = simulation.method_reason();
    json["time_step"] = simulation.time_step();
    json["steps_per_frame"] = simulation.steps_per_frame();
    json["stable_step"] = stable_steps_json(simulation);
    json["warnings"] = warnings_before(simulation);
    json["mesh_findings"] = simulation.mesh_findings();
    return json;
}

void print_stable_steps(const Simulation& simulation) {
    fmt::print("stable step of every integrator:\n");
    for (const IntegratorInfo& info : integrator_catalogue()) {
        const double step = simulation.stable_step(info.name);
        const std::string text = std::isinf(step) ? "any"
                                 : step > 0.0     ? fmt::format("{:.6g} s", step)
                                                  : "none: needs damping";
        const bool chosen = info.name == simulation.method();
        fmt::print("  {:<22} {}{}\n", info.name, text, chosen ? "   <- this scene's" : "");
    }
}

void print_check(const Simulation& simulation) {
    const auto springs = simulation.spring_counts();
    const LinearAnalysis linear = simulation.linear_analysis();
    const SceneDescription& scene = simulation.scene();
    fmt::print("{}: no errors\n", scene.name);
    fmt::print("particles     {} ({} pinned), {:.6g} kg\n", simulation.particle_count(),
               simulation.pinned_count(), simulation.total_mass());
    fmt::print("springs       {} structural, {} shear, {} bend\n", springs[0], springs[1],
               springs[2]);
    fmt::print("triangles     {}\n", simulation.surface().triangles.size());
    fmt::print("omega_max     {:.6g} 1/s, damping ratio {:.3g}\n", linear.omega_max,
               linear.damping_ratio);
    fmt::print("time step     {:.6g} s ({}), {} a frame, {} frames\n", simulation.time_step(),
               scene.integrator.time_step ? "given" : "auto", simulation.steps_per_frame(),
               scene.frame_count());
    if (!simulation.method_reason().empty()) {
        fmt::print("method        {}: {}\n", simulation.method(), simulation.method_reason());
    }
    print_stable_steps(simulation);
    for (const std::string& finding : simulation.mesh_findings()) {
        fmt::print("mesh          {}\n", finding);
    }
    for (const std::string& warning : warnings_before(simulation)) {
        fmt::print("warning: {}\n", warning);
    }
}

}  // namespace

int check_command(const SceneOptions& options) {
    const Simulation simulation(load_scene(options), options.threads);
    if (options.json) {
        fmt::print("{}\n", check_json(simulation).dump(2));
    } else {
        print_check(simulation);
    }
    return exit_done;
}

}  // namespace weft
