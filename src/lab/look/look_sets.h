// What the experiment on looks flies: sets of flights that are shown side by side.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/laboratory.h"
#include "lab/look/film_strip.h"
#include "lab/look/look_flight.h"

namespace weft::lab {

/// One flight of a set.
struct LookSpec {
    std::string title;       ///< above its pictures: "verlet, dt = 0.46 ms"
    std::string look;        ///< Series::look
    std::string setting;     ///< says all that determines the scene
    SceneDescription scene;  ///< of the set's cloth, maybe damped otherwise
    LookPlan plan;
    std::string note;      ///< on the step
    bool compared = true;  ///< with the reference: it flies the same forces
};

/// Flights of one cloth over the same time.
struct LookSet {
    std::string id;    ///< names its strip and table
    std::string name;  ///< in captions: "the flag"
    std::vector<LookSpec> flights;
    std::optional<LookSpec> reference;  ///< flown too, not shown unless it is among the flights
    std::vector<StripColumn> columns;   ///< the moments shown
    double frame_length = 0.0;          ///< [s]
    std::vector<std::size_t> frames;    ///< kept of every flight
    std::string cut;                    ///< what a bound on the work did; empty: nothing

    [[nodiscard]] double time(std::size_t shape) const {
        return frame_length * static_cast<double>(frames[shape]);
    }
    [[nodiscard]] double end() const { return time(frames.size() - 1); }
};

/// The study's scene by every method, each at a step of its own.
LookSet own_look(const SceneDescription& scene, const std::vector<std::string_view>& methods,
                 bool quick);

/// The first paper's figures 2.1 and 2.2: the shipped flag by Forward Euler and Verlet.
LookSet flag_look(bool quick);

/// The comparison's figures 3, 4 and 5: its sheet by Forward Euler, Verlet and Kutta's method.
LookSet sheet_look();

/// For a video: a coarser flag by every method.
LookSet video_look(const std::vector<std::string_view>& methods, bool quick);

/// The trial that makes a flight.
Trial look_trial(const LookSpec& spec);

}  // namespace weft::lab
