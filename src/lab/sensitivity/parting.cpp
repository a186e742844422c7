#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/sensitivity/sensitivity.h"
#include "math/random.h"

namespace weft::lab {

namespace {

// Three numbers in [-1, 1).
Vec3d noise(std::size_t particle) {
    const auto part = [&](std::uint64_t n) { return 2.0 * random_uniform(5, n, particle) - 1.0; };
    return {part(0), part(1), part(2)};
}

// The free particle nearest to the middle of the numbering.
std::size_t middle_particle(const ClothModel& cloth) {
    std::size_t particle = cloth.particle_count / 2;
    for (const Pin& pin : cloth.pins) {
        if (pin.particle == particle) ++particle;  // pins stand by rising number
    }
    if (particle < cloth.particle_count) return particle;
    particle = cloth.particle_count / 2;
    for (auto pin = cloth.pins.rbegin(); pin != cloth.pins.rend(); ++pin) {
        if (pin->particle == particle && particle > 0) --particle;
    }
    return particle;
}

ParticleState<double> nudged_start(const Specimen& specimen, const PartingPlan& plan) {
    const ClothModel& cloth = specimen.cloth();
    ParticleState<double> state = specimen.start();
    const auto move = [&](std::size_t p, const Vec3d& by) {
        state.x.set(cloth.slot(p), state.x[cloth.slot(p)] + by);
    };
    if (plan.one_particle) {
        const double part = plan.nudge / std::sqrt(3.0);
        move(middle_particle(cloth), {part, part, part});
    } else {
        // The root mean square of noise() is 1.
        for (std::size_t p = 0; p < cloth.particle_count; ++p) move(p, plan.nudge * noise(p));
    }
    return state;
}

// One of the two: fly() keeps its states to itself, these are looked at side by side.
class Flyer {
public:
    Flyer(const SceneDescription& scene, std::string_view method)
        : specimen_(scene), integrator_(make_integrator<double>(method)) {
        integrator_->prepare(specimen_.system());
    }

    void begin(ParticleState<double> state) {
        state_ = std::move(state);
        specimen_.system().constrain(0.0, state_.x.view(), state_.v.view());
    }
    // @return why it failed, or nothing.
    std::string step(double time_step, std::size_t n) {
        StepReport report = integrator_->step(specimen_.system(), time_step, state_);
        state_.time = static_cast<double>(n) * time_step;
        return report.ok() ? std::string() : std::move(report.failure->reason);
    }
    [[nodiscard]] const Specimen& specimen() const { return specimen_; }
    [[nodiscard]] const ParticleState<double>& state() const { return state_; }

private:
    Specimen specimen_;
    std::unique_ptr<Integrator<double>> integrator_;
    ParticleState<double> state_;
};

}  // namespace

std::optional<double> Parting::reaches(double distance) const {
    const auto found =
        std::ranges::find_if(points, [&](const auto& point) { return point[1] >= distance; });
    if (found == points.end()) return std::nullopt;
    return (*found)[0];
}

Parting part(const SceneDescription& scene, const PartingPlan& plan, const Watch& watch) {
    constexpr std::size_t samples = 400;
    Flyer first(scene, plan.method), second(scene, plan.method);
    first.begin(first.specimen().start());
    second.begin(nudged_start(second.specimen(), plan));
    const std::size_t interval = std::max<std::size_t>(1, plan.steps / samples);
    Parting parting;
    for (std::size_t n = 0; n <= plan.steps; ++n) {
        watch();
        if (n > 0) {
            parting.failure = first.step(plan.time_step, n);
            if (parting.failure.empty()) parting.failure = second.step(plan.time_step, n);
        }
        if (!parting.failure.empty()) break;
        if (n % interval != 0) continue;
        const double distance =
            rms_distance(first.specimen().cloth(), first.state(), second.state());
        if (!std::isfinite(distance)) {
            parting.failure = "the flights diverged";
            break;
        }
        parting.points.push_back({first.state().time, distance});
        if (plan.enough > 0.0 && distance > plan.enough) break;
    }
    return parting;
}

std::optional<PartingRate> parting_rate(const Parting& parting, double low, double high) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    PartingRate found;
    bool begun = false;
    double first = 0.0, last = 0.0;
    for (const auto& [time, distance] : parting.points) {
        if (!begun && distance < low) continue;
        if (!(distance > 0.0)) continue;
        if (!begun) found.from = time, first = distance;
        begun = true;
        found.to = time, last = distance;
        const double y = std::log(distance);
        n += 1, sx += time, sy += y, sxx += time * time, sxy += time * y;
        if (distance >= high) break;
    }
    const double spread = n * sxx - sx * sx;
    if (n < 4 || !(spread > 0.0) || !(last > 10.0 * first)) return std::nullopt;
    found.rate = (n * sxy - sx * sy) / spread;
    return found;
}

double meaningful_time(const SceneDescription& scene, double error, double bound, double longest,
                       const Watch& watch) {
    const double limit = Specimen(scene).modes().stable_step("velocity-verlet");
    PartingPlan plan;
    plan.time_step = std::min(0.5 * limit, longest / 100.0);
    plan.steps = static_cast<std::size_t>(std::ceil(longest / plan.time_step));
    plan.nudge = error, plan.one_particle = false, plan.enough = bound;
    return std::min(part(scene, plan, watch).reaches(bound).value_or(longest), longest);
}

double cell_size(const ClothModel& cloth) {
    double sum = 0.0;
    std::size_t count = 0;
    cloth.for_each_spring([&](const Spring& spring, const SpringConstants&) {
        if (spring.kind != SpringKind::structural) return;
        sum += spring.rest_length;
        ++count;
    });
    return count > 0 ? sum / static_cast<double>(count) : cloth.rest_diagonal();
}

}  // namespace weft::lab
