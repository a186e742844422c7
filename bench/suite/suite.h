// Times a plan: in every repeat each contestant of a group once, one after the other, so that what
// slows the machine for a while slows them all.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/suite/plan.h"

namespace weft::bench {

/// Limits of one thread of this machine, and what was built with what.
struct Machine {
    struct Bandwidth {
        std::string where;      ///< "first-level cache", "memory"
        std::size_t bytes = 0;  ///< size of the array
        double gb_per_s = 0.0;  ///< read plus written
    };
    std::string processor;
    int threads = 1;  ///< all hardware threads
    std::string instruction_set;
    std::string compiler;
    double peak_single = 0.0, peak_double = 0.0;  ///< [GFLOP/s]
    std::vector<Bandwidth> bandwidths;
    std::string boost, bullet;  ///< versions of the peers; empty: not built in

    [[nodiscard]] double peak(Precision precision) const {
        return precision == Precision::f32 ? peak_single : peak_double;
    }
};

/// Measures for about two seconds.
Machine measure_machine();

/// A row of the table: medians over the repeats.
struct Row {
    Label label;
    std::optional<double> ns_per_particle_step;
    std::optional<double> ratio_to_textbook;  ///< its time over this one's
    std::optional<double> gflops, fraction_of_peak;
    std::optional<double> ms_per_frame;  ///< of 1/60 s
    std::optional<double> sag;           ///< after two seconds [m]
    std::string note;                    ///< why there are no numbers; empty: there are
    bool diverged = false;
};

/// @param stop asked between timings.
/// @return the group's rows; none where it was stopped.
std::vector<Row> time_group(const Group& group, const Machine& machine, double least_seconds,
                            const std::function<bool()>& stop);

}  // namespace weft::bench
