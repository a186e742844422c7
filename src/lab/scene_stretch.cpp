#include "lab/scene_stretch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "forces/wind.h"
#include "lab/kinks.h"
#include "lab/reference.h"

namespace weft::lab {

namespace {

constexpr double limits_long = 8.0;
constexpr double limit_of_slack = 0.01;    // where no spring limits a step [s]
constexpr double reference_share = 1e-13;  // its tolerance, of the cloth's size
constexpr double rounding_share = 2e-15;   // what rounding makes of a position, likewise

// On which side the air meets each triangle: at the first call it is noted, later calls find who
// has changed.
class EdgeOnWatch {
public:
    explicit EdgeOnWatch(const Specimen& specimen) : specimen_(specimen) {}

    void look(const ParticleState<double>& state) {
        const auto& wind = specimen_.scene().wind;
        if (!wind) return;
        const Vec3d air = wind_velocity(*wind, state.time);
        const Surface& surface = specimen_.cloth().surface;
        sides_.resize(surface.triangles.size(), Side::unknown);
        for (std::size_t n = 0; n < surface.triangles.size(); ++n) {
            if (sides_[n] == Side::changed) continue;
            const Side side = side_of(surface.triangles[n], air, state);
            sides_[n] = sides_[n] == Side::unknown || sides_[n] == side ? side : Side::changed;
        }
    }

    [[nodiscard]] std::size_t changed() const {
        return static_cast<std::size_t>(std::ranges::count(sides_, Side::changed));
    }

private:
    enum class Side { unknown, front, back, changed };

    [[nodiscard]] Side side_of(const std::array<std::uint32_t, 3>& triangle, Vec3d air,
                               const ParticleState<double>& state) const {
        std::array<Vec3d, 3> x;
        Vec3d v{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::size_t slot =
                specimen_.cloth().slot(specimen_.cloth().surface.particle(triangle[corner]));
            x[corner] = state.x[slot];
            v += state.v[slot] / 3.0;
        }
        const Vec3d normal = cross(x[1] - x[0], x[2] - x[0]);
        return dot(air - v, normal) >= 0.0 ? Side::front : Side::back;
    }

    const Specimen& specimen_;
    std::vector<Side> sides_;
};

// The state soonest after `aim`, and after any kink, by steps of half the limit.
Flight fly_to_start(Specimen& specimen, const Stretch& stretch, double limit, const Watch& watch) {
    const auto steps = static_cast<std::size_t>(std::ceil(2.0 * stretch.begin / limit));
    const double step = steps > 0 ? stretch.begin / static_cast<double>(steps) : 0.0;
    return fly(specimen, {"rk4", step, steps, {}, {}}, specimen.start(), watch);
}

std::size_t count_edge_on(Specimen& specimen, const SceneStretch& stretch, const Watch& watch) {
    constexpr std::size_t steps = 64;
    EdgeOnWatch edges(specimen);
    edges.look(stretch.start);
    fly(specimen, {"rk4", stretch.length() / steps, steps, {}, {}}, stretch.start, watch,
        [&](std::size_t, const ParticleState<double>& state) {
            edges.look(state);
            return true;
        });
    return edges.changed();
}

double aimed_start(const Specimen& specimen, double limit, bool quick) {
    const double particles = static_cast<double>(specimen.particle_count());
    const double steps = std::min(4000.0, (quick ? 1.5e7 : 6e7) / particles);
    return std::min({specimen.scene().output.duration / 2.0, quick ? 0.25 : 1.0,
                     std::floor(steps) * limit / 2.0});
}

}  // namespace

double scene_limit(Specimen& specimen) {
    const StabilityModes& modes = specimen.modes();
    const double limit =
        std::min(modes.stable_step("velocity-verlet"), modes.stable_step("yoshida4"));
    return std::isfinite(limit) && limit > 0.0 ? limit : limit_of_slack;
}

double motion_between(const ClothModel& cloth, const ParticleState<double>& start,
                      const ParticleState<double>& end) {
    constexpr double rounding = 1e-9;  // and its growth, of the cloth's size
    const double motion = rms_distance(cloth, start, end);
    return motion > rounding * cloth.rest_diagonal() ? motion : 0.0;
}

SceneStretch find_scene_stretch(Specimen& specimen, bool quick, const Watch& watch) {
    SceneStretch found;
    found.limit = scene_limit(specimen);
    const Stretch stretch = smooth_stretch(
        specimen.scene(), aimed_start(specimen, found.limit, quick), limits_long * found.limit);
    Flight flight = fly_to_start(specimen, stretch, found.limit, watch);
    found.start = std::move(flight.state);
    found.end = found.start;
    found.failure = std::move(flight.failure);
    if (!found.failure.empty()) return found;
    const double size = specimen.cloth().rest_diagonal();
    const Reference reference = reference_solution(
        specimen, found.start, found.start.time + stretch.length(), reference_share * size, watch);
    found.end = reference.state;
    found.reference_error = std::max(reference.error, rounding_share * size);
    if (!reference.converged) found.failure = "the reference solution did not converge";
    found.motion = motion_between(specimen.cloth(), found.start, found.end);
    if (found.motion == 0.0) found.failure = "nothing moves in it";
    found.triangles = specimen.cloth().surface.triangles.size();
    found.edge_on = count_edge_on(specimen, found, watch);
    return found;
}

nlohmann::json stretch_to_json(const ClothModel& cloth, const SceneStretch& stretch) {
    if (!stretch.failure.empty()) return {{"failure", stretch.failure}};
    return {{"start", state_to_json(cloth, stretch.start)},
            {"end", state_to_json(cloth, stretch.end)},
            {"limit", stretch.limit},
            {"reference_error", stretch.reference_error},
            {"triangles", stretch.triangles},
            {"edge_on", stretch.edge_on},
            {"motion", stretch.motion}};
}

SceneStretch stretch_from_json(const ClothModel& cloth, const nlohmann::json& json) {
    SceneStretch stretch;
    stretch.failure = json.value("failure", "");
    if (!stretch.failure.empty()) return stretch;
    stretch.start = state_from_json(cloth, json.at("start"));
    stretch.end = state_from_json(cloth, json.at("end"));
    stretch.limit = json.at("limit").get<double>();
    stretch.reference_error = json.at("reference_error").get<double>();
    stretch.triangles = json.at("triangles").get<std::size_t>();
    stretch.edge_on = json.at("edge_on").get<std::size_t>();
    stretch.motion = json.at("motion").get<double>();
    return stretch;
}

std::string stretch_text(const SceneStretch& stretch) {
    return fmt::format("{:.3g} s from {:.4g} s on", stretch.length(), stretch.start.time);
}

}  // namespace weft::lab
