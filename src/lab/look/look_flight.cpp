#include "lab/look/look_flight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "forces/measure_cloth.h"
#include "lab/wrinkles.h"
#include "simulation/method_choice.h"
#include "weft/integrators.h"
#include "weft/simulation.h"

namespace weft::lab {

namespace {

constexpr double much_larger = 3.0;          // than at rest: no cloth any more
constexpr std::size_t checks_per_frame = 8;  // where a frame has that many steps
constexpr double solved_to = 1e-6;           // of the cloth's size

double diagonal(const Shape& shape) {
    constexpr double most = std::numeric_limits<double>::max();
    Vec3d low{most, most, most}, high{-most, -most, -most};
    for (const Vec3d& x : shape) {
        low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
        high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
    }
    return length(high - low);
}

// Takes what is to be kept of a flight while it goes.
class Keeper {
public:
    Keeper(const Specimen& specimen, const LookPlan& plan)
        : cloth_(specimen.cloth()),
          plan_(plan),
          measures_(cloth_, specimen.scene().forces, chosen_instruction_set()),
          wrinkles_(cloth_.surface),
          check_every_(std::max<std::size_t>(1, plan.steps_per_frame / checks_per_frame)) {}

    // false: the flight ends here.
    bool look(std::size_t step, const ParticleState<double>& state) {
        const bool at_frame = step % plan_.steps_per_frame == 0;
        if (!at_frame && step % check_every_ != 0) return true;
        if (is_blown_up(state)) {
            flight_.failed = state.time;
            flight_.failure = blown_up;
            return false;
        }
        Shape shape = positions_of(cloth_, state);
        if (at_frame && next_ < plan_.frames.size() &&
            step / plan_.steps_per_frame == plan_.frames[next_]) {
            flight_.wrinkles.push_back(wrinkles_.angle(shape));
            flight_.shapes.push_back(shape);
            ++next_;
        }
        if (last_.empty()) rest_diagonal_ = diagonal(shape);
        if (diagonal(shape) <= much_larger * rest_diagonal_) last_ = std::move(shape);
        return true;
    }

    LookFlight finish(const Flight& flight) {
        if (!flight.ok() && !flight_.failed) {
            flight_.failed = flight.state.time;
            flight_.failure = is_blown_up(flight.state) ? blown_up : flight.failure;
        }
        if (flight_.failed) flight_.last = std::move(last_);
        return std::move(flight_);
    }

private:
    bool is_blown_up(const ParticleState<double>& state) {
        const StrainCheck check = measures_.check(state.x.view(), state.v.view());
        return !check.finite || check.strain > Divergence::max_strain;
    }

    const ClothModel& cloth_;
    const LookPlan& plan_;
    ClothMeasures<double> measures_;
    Wrinkles wrinkles_;
    std::size_t check_every_, next_ = 0;
    double rest_diagonal_ = 0.0;
    Shape last_;
    LookFlight flight_;
};

}  // namespace

LookFlight fly_for_look(Specimen& specimen, const LookPlan& plan, const Watch& watch) {
    FlightPlan flight;
    flight.method = plan.method;
    flight.time_step = plan.time_step();
    flight.steps = plan.frames.back() * plan.steps_per_frame;
    flight.tolerance = solver_tolerance(specimen.scene(), specimen.cloth(), plan.method);
    if (flight.tolerance) {
        flight.tolerance =
            std::min(*flight.tolerance, solved_to * specimen.cloth().rest_diagonal());
    }
    const ParticleState<double> start = std::as_const(specimen).start();
    Keeper keeper(specimen, plan);
    keeper.look(0, start);
    const Flight flown =
        fly(specimen, flight, start, watch,
            [&](std::size_t step, const auto& state) { return keeper.look(step, state); });
    return keeper.finish(flown);
}

double rms_distance(const Shape& a, const Shape& b) {
    double squared = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p) squared += dot(a[p] - b[p], a[p] - b[p]);
    return a.empty() ? 0.0 : std::sqrt(squared / static_cast<double>(a.size()));
}

nlohmann::json to_json(const LookFlight& flight) {
    nlohmann::json shapes = nlohmann::json::array();
    for (const Shape& shape : flight.shapes) shapes.push_back(shape_to_text(shape));
    nlohmann::json json{{"shapes", std::move(shapes)}, {"wrinkles", flight.wrinkles}};
    if (flight.failed) {
        json["failed"] = *flight.failed;
        json["failure"] = flight.failure;
        json["last"] = shape_to_text(flight.last);
    }
    return json;
}

LookFlight look_flight_from_json(const nlohmann::json& json) {
    LookFlight flight;
    for (const nlohmann::json& text : json.at("shapes")) {
        flight.shapes.push_back(shape_from_text(text.get<std::string>()));
    }
    flight.wrinkles = json.at("wrinkles").get<std::vector<double>>();
    if (json.contains("failed")) {
        flight.failed = json.at("failed").get<double>();
        flight.failure = json.at("failure").get<std::string>();
        flight.last = shape_from_text(json.at("last").get<std::string>());
    }
    return flight;
}

}  // namespace weft::lab
