// A first guess at a cloth's fastest mode, from which the search for it starts.
#pragma once

#include <vector>

#include "cloth/cloth_model.h"
#include "math/vec3_array.h"

namespace weft {

/// A plane wave on an endless grid: particle (i, j) moves along `direction` by
/// cos(along_row i + along_column j).
struct PlaneWave {
    double along_row = 0.0, along_column = 0.0;  ///< phase from one particle to the next, [0, pi]
    Vec3d direction{};                           ///< a unit vector
};

/// The wave of the largest frequency on a grid at rest that went on endlessly like its inner part.
PlaneWave fastest_wave(const ClothModel& grid);

/// On a grid, the fastest wave under an envelope that is zero outside, so that it hardly feels the
/// border; and noise, for the modes that the border has of its own: as strong at the corners and
/// edges together as elsewhere. On a mesh, noise. Each number is a function of the particle.
/// @param root_inverse_masses [slot]; zero: the particle is pinned, and so is its vector.
/// @param vector [slot], in mass-scaled co-ordinates; padding is not touched.
template <typename Real>
void guess_fastest_mode(const ClothModel& cloth, const std::vector<Real>& root_inverse_masses,
                        Vec3Array<Real>& vector);

/// Turns a unit vector a little: adds noise to it. A search from a mode of one matrix for one of
/// another would never find what is orthogonal to it.
template <typename Real>
void disturb_mode(const ClothModel& cloth, const std::vector<Real>& root_inverse_masses,
                  Vec3Array<Real>& vector);

}  // namespace weft
