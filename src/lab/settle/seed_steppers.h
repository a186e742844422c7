// The updates as the two seed papers print them, misprints and all, and as their words may be read
// or their formulas mistyped: for the experiment alone, that shows what each does to a cloth.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "integrators/integrator.h"

namespace weft::lab {

/// One update; "F" is the paper "Flag in the Wind", "C" the comparison of methods.
struct SeedUpdate {
    std::string_view name;     ///< "verlet a dt^3"
    std::string_view formula;  ///< what it computes
    std::string_view source;   ///< where it is printed, or who would write it
};

/// All of them, in the order of the table.
std::span<const SeedUpdate> seed_updates();

/// @return nullptr where no such update exists.
const SeedUpdate* find_seed_update(std::string_view name);

/// An integrator that makes steps by the update. Its first step takes every earlier position from
/// the velocity at the start alone, as programs do that do not think of it. The velocity it puts
/// out is the one it has; a Verlet's is (x+ - x) / dt.
/// @pre find_seed_update(name) is not null.
/// @param drag_rate of "verlet (1 - d)(x - x_prev)": d = drag_rate dt [1/s].
std::unique_ptr<Integrator<double>> make_seed_update(std::string_view name, double drag_rate = 0.0);

}  // namespace weft::lab
