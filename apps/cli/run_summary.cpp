#include "cli/run_summary.h"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cmath>
#include <thread>

#include "io/scene_json.h"
#include "math/processor_name.h"
#include "weft/integrators.h"

namespace weft {

namespace {

using Json = nlohmann::ordered_json;

Json machine_json() {
    utsname names{};
    uname(&names);
    const double bytes =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
    return {{"system", fmt::format("{} {} {}", names.sysname, names.release, names.machine)},
            {"processor", processor_name()},
            {"hardware_threads", std::thread::hardware_concurrency()},
            {"memory_gib", std::round(bytes / 1073741824.0 * 10.0) / 10.0}};
}

Json energy_json(const Energy& energy) {
    return {
        {"kinetic", energy.kinetic}, {"gravity", energy.gravity}, {"structural", energy.structural},
        {"shear", energy.shear},     {"bend", energy.bend},       {"total", energy.total()}};
}

Json strain_json(const SpringStrain& strain) {
    return {{"strain", strain.strain}, {"kind", strain.kind}, {"particles", {strain.p, strain.q}}};
}

Json divergence_json(const Divergence& divergence) {
    Json json{{"step", divergence.step}, {"time", divergence.time}};
    if (divergence.particle) json["particle"] = *divergence.particle;
    if (divergence.spring) json["spring"] = strain_json(*divergence.spring);
    json["time_step"] = divergence.time_step;
    json["stable_step"] = divergence.stable_step;
    json["message"] = divergence.message;
    json["advice"] = divergence.advice;
    return json;
}

Json solver_json(const SolverCounts& counts) {
    return {{"steps", counts.steps},
            {"rejected", counts.rejected},
            {"evaluations", counts.evaluations},
            {"newton_iterations", counts.newton_iterations},
            {"linear_iterations", counts.linear_iterations}};
}

Json settle_json(const SettleReport& report) {
    return {{"converged", report.converged},
            {"newton_iterations", report.newton_iterations},
            {"linear_iterations", report.linear_iterations},
            {"residual", report.residual},
            {"relative_residual", report.relative_residual}};
}

Json energy_balance_json(const Energy& start, const Energy& end, const Work& work) {
    return {{"change_of_energy", end.total() - start.total()},
            {"work_of_dashpots", work.dashpots},
            {"work_of_drag", work.drag},
            {"work_of_air", work.air},
            {"work_of_pins", work.pins},
            {"unaccounted", end.total() - start.total() - work.total()}};
}

}  // namespace

Json stable_steps_json(const Simulation& simulation) {
    Json steps;
    for (const IntegratorInfo& info : integrator_catalogue()) {
        const double step = simulation.stable_step(info.name);
        steps[std::string(info.name)] = std::isinf(step) ? Json("any")
                                        : step > 0.0     ? Json(step)
                                                         : Json(nullptr);
    }
    return steps;
}

Json run_summary(const Simulation& simulation, const RunRecord& record) {
    const SceneDescription& scene = simulation.scene();
    const double particle_steps = static_cast<double>(simulation.particle_count()) *
                                  static_cast<double>(simulation.step_count());
    Json json;
    json["weft"] = version();
    json["status"] = record.status;
    json["scene_file"] = scene.file;
    json["scene"] = scene_to_json(scene);
    json["machine"] = machine_json();
    json["threads"] = simulation.threads();
    json["kernel"] =
        fmt::format("{}, {}", scene.cloth.mesh ? "mesh" : "grid", simulation.instruction_set());
    json["particles"] = simulation.particle_count();
    const auto springs = simulation.spring_counts();
    json["springs"] = {{"structural", springs[0]}, {"shear", springs[1]}, {"bend", springs[2]}};
    json["mass"] = simulation.total_mass();
    json["frames"] = simulation.frame();
    json["steps"] = simulation.step_count();
    json["simulated_time"] = simulation.time();
    json["time_step"] = simulation.time_step();
    json["method"] = simulation.method();
    json["method_reason"] = simulation.method_reason();
    if (!simulation.linear_solver().empty()) json["linear_solver"] = simulation.linear_solver();
    json["solver"] = solver_json(simulation.solver_counts());
    if (simulation.settle_report()) json["settle"] = settle_json(*simulation.settle_report());
    const double stable = simulation.stable_step(simulation.method());
    json["stable_step"] = std::isinf(stable) ? Json("any") : Json(stable);
    json["omega_max"] = simulation.linear_analysis().omega_max;
    json["halvings"] = record.halvings;
    json["wall_seconds"] = {{"building", record.building_seconds},
                            {"stepping", record.stepping_seconds},
                            {"waiting_for_recorders", record.waiting_seconds},
                            {"recording_beside", record.recording_seconds},
                            {"total", record.total_seconds}};
    json["particle_steps_per_second"] =
        record.stepping_seconds > 0.0 ? particle_steps / record.stepping_seconds : 0.0;
    const Energy end = simulation.energy();
    json["energy"] = {{"start", energy_json(record.start_energy)}, {"end", energy_json(end)}};
    if (scene.output.energy_balance) {
        json["energy_balance"] = energy_balance_json(record.start_energy, end, simulation.work());
    }
    json["largest_strain"] = strain_json(record.largest_strain);
    json["largest_strain"]["frame"] = record.largest_strain_frame;
    json["state_hash"] = fmt::format("{:016x}", simulation.state_hash());
    if (record.divergence) json["divergence"] = divergence_json(*record.divergence);
    json["warnings"] = record.warnings;
    json["mesh_findings"] = simulation.mesh_findings();
    json["files"] = Json::array();
    for (const std::filesystem::path& file : record.files) json["files"].push_back(file.string());
    return json;
}

}  // namespace weft
