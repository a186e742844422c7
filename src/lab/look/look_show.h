// Flights that were made, and how they are shown: film strips, a video, plots and tables.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "lab/look/look_sets.h"
#include "lab/section.h"

namespace weft::lab {

/// A set with what came of its flights.
struct Flown {
    LookSet set;
    std::vector<LookFlight> flights;  ///< [set.flights]
    std::optional<LookFlight> reference;

    [[nodiscard]] std::vector<StripRow> rows() const;
    /// Distance of a flight from the reference; not a number where either was over by then, or
    /// they are not to be compared [m].
    [[nodiscard]] double distance(std::size_t flight, std::size_t shape) const;
    [[nodiscard]] double last_distance(std::size_t flight) const {
        return distance(flight, set.frames.size() - 1);
    }
};

/// Makes the flights of all sets: one call of Laboratory::run().
std::vector<Flown> fly_all(Laboratory& laboratory, std::vector<LookSet> sets);

/// Draws the film strip into the laboratory's media directory.
/// @param tile size of a picture [pixels].  @throws Interrupted; Error (file).
Media film_strip(const Flown& flown, std::array<int, 2> tile, const Laboratory& laboratory);

/// The same for a video of all flights side by side.
Media flight_video(const Flown& flown, std::array<int, 2> tile, const Laboratory& laboratory);

/// @pre these have a reference.
Table flight_table(const Flown& flown);
Plot distance_plot(const Flown& flown);
Plot wrinkle_plot(const Flown& flown);

}  // namespace weft::lab
