#include "lab/trajectory.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "forces/measure_cloth.h"
#include "simulation/divergence.h"
#include "weft/integrators.h"

namespace weft::lab {

namespace {

constexpr std::size_t steps_between_checks = 16;
constexpr double solved_to = 1e-12;  // of implicit systems, where the plan says nothing [m]

IntegratorSettings settings_of(const FlightPlan& plan) {
    IntegratorSettings settings;
    settings.tolerance = plan.tolerance;
    settings.iterations = plan.iterations;
    if (!plan.tolerance && find_integrator(plan.method)->kind == IntegratorKind::implicit) {
        settings.tolerance = solved_to;
    }
    return settings;
}

// Why the state is not sound, or nothing.
std::string unsoundness(const Specimen& specimen, ClothMeasures<double>& measures,
                        const FlightPlan& plan, const Flight& flight) {
    const StrainCheck check = measures.check(flight.state.x.view(), flight.state.v.view());
    std::optional<Divergence> found = find_divergence(specimen.cloth(), flight.state, check);
    if (!found) return {};
    found->step = flight.steps;
    found->time = flight.state.time;
    describe_divergence(*found, specimen.cloth(), plan.method);
    return found->message;
}

}  // namespace

Specimen::Specimen(SceneDescription scene)
    : scene_(std::move(scene)), cloth_(build_cloth(scene_)), system_(cloth_, scene_) {}

ParticleState<double> Specimen::start() const {
    const std::size_t slots = cloth_.layout.slot_count();
    ParticleState<double> state{Vec3Array<double>(slots), Vec3Array<double>(slots), 0.0};
    cloth_.layout.for_each(
        [&](std::size_t p, std::size_t slot) { state.x.set(slot, cloth_.rest_position(p)); });
    system_.constrain(0.0, state.x.view(), state.v.view());
    return state;
}

Energy Specimen::energy(const ParticleState<double>& state) const {
    return ClothMeasures<double>(cloth_, scene_.forces, chosen_instruction_set())
        .energy(state.x.view(), state.v.view());
}

const StabilityModes& Specimen::modes() {
    if (!modes_) {
        modes_ = StabilityAnalysis<double>(cloth_, scene_.forces)
                     .find(std::as_const(*this).start().x.view());
    }
    return *modes_;
}

Flight fly(Specimen& specimen, const FlightPlan& plan, const ParticleState<double>& start,
           const Watch& watch, const Look& look) {
    const auto integrator = make_integrator<double>(plan.method, settings_of(plan));
    ClothMeasures<double> measures(specimen.cloth(), specimen.scene().forces,
                                   chosen_instruction_set());
    Flight flight;
    flight.state = start;
    integrator->prepare(specimen.system());
    const auto began = std::chrono::steady_clock::now();
    while (flight.steps < plan.steps && flight.ok()) {
        watch();
        const StepReport report = integrator->step(specimen.system(), plan.time_step, flight.state);
        if (!report.ok()) {
            flight.failure = fmt::format("{} cannot make step {}: {}", plan.method,
                                         flight.steps + 1, report.failure->reason);
            break;
        }
        ++flight.steps;
        // From the number of steps, so that rounding does not add up.
        flight.state.time = start.time + static_cast<double>(flight.steps) * plan.time_step;
        if (flight.steps % steps_between_checks == 0 || flight.steps == plan.steps) {
            flight.failure = unsoundness(specimen, measures, plan, flight);
        }
        if (look && flight.ok() && !look(flight.steps, flight.state)) break;
    }
    flight.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    flight.counts = integrator->counts();
    return flight;
}

double rms_difference(const ClothModel& cloth, ConstVec3View<double> a, ConstVec3View<double> b) {
    double squared = 0.0;
    cloth.layout.for_each([&](std::size_t, std::size_t slot) {
        const Vec3d apart = a[slot] - b[slot];
        squared += dot(apart, apart);
    });
    return std::sqrt(squared / static_cast<double>(cloth.particle_count));
}

double rms_distance(const ClothModel& cloth, const ParticleState<double>& a,
                    const ParticleState<double>& b) {
    return rms_difference(cloth, a.x.view(), b.x.view());
}

nlohmann::json state_to_json(const ClothModel& cloth, const ParticleState<double>& state) {
    nlohmann::json particles = nlohmann::json::array();
    cloth.layout.for_each([&](std::size_t, std::size_t slot) {
        const Vec3d x = state.x[slot], v = state.v[slot];
        particles.push_back({x.x, x.y, x.z, v.x, v.y, v.z});
    });
    return {{"time", state.time}, {"particles", std::move(particles)}};
}

ParticleState<double> state_from_json(const ClothModel& cloth, const nlohmann::json& json) {
    const std::size_t slots = cloth.layout.slot_count();
    ParticleState<double> state{Vec3Array<double>(slots), Vec3Array<double>(slots),
                                json.at("time").get<double>()};
    const nlohmann::json& particles = json.at("particles");
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        const auto n = particles.at(p).get<std::array<double, 6>>();
        state.x.set(slot, {n[0], n[1], n[2]});
        state.v.set(slot, {n[3], n[4], n[5]});
    });
    return state;
}

}  // namespace weft::lab
