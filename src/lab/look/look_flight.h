// A flight kept for pictures: the cloth's shape at chosen times, and how it ended.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lab/shape_text.h"
#include "lab/trajectory.h"

namespace weft::lab {

/// What to fly. Shapes are kept at whole numbers of frames.
struct LookPlan {
    std::string method;               ///< of the catalogue
    double frame_length = 0.04;       ///< [s]
    std::size_t steps_per_frame = 1;  ///< adaptive methods: 1
    std::vector<std::size_t> frames;  ///< to keep; rising; the first is 0 where the start is wanted

    [[nodiscard]] double time_step() const {
        return frame_length / static_cast<double>(steps_per_frame);
    }
};

/// LookFlight::failure of a flight whose cloth was torn apart by its numbers.
inline constexpr const char* blown_up = "blown up";

/// What came of it.
struct LookFlight {
    std::vector<Shape> shapes;     ///< [n] at LookPlan::frames[n]; fewer where it failed before
    std::vector<double> wrinkles;  ///< [n] Wrinkles::angle() of the shape [degrees]
    std::optional<double> failed;  ///< when it ended early [s]
    std::string failure;           ///< why, in a line
    Shape last;                    ///< of a flight that failed: the last that still was a cloth
};

/// Flies the scene; implicit methods solve to a millionth of the cloth's size, so that what is seen
/// is the method, not its solver. A flight ends where a co-ordinate is not finite or a spring is
/// strained beyond Divergence::max_strain; the last shape that still was a cloth is one that fits a
/// box three times as large as the cloth at rest.
LookFlight fly_for_look(Specimen& specimen, const LookPlan& plan, const Watch& watch);

/// Distance of the shapes' particles, root mean square [m].  @pre a and b are of one cloth.
double rms_distance(const Shape& a, const Shape& b);

nlohmann::json to_json(const LookFlight& flight);
LookFlight look_flight_from_json(const nlohmann::json& json);

}  // namespace weft::lab
