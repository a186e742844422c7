// The one sheet that weft and its peers are timed on: a square grid with the three usual kinds of
// spring, a dashpot on each, gravity, air drag, and its two upper corners held.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "weft/vec3.h"

namespace weft::bench {

/// Particle (column i, row j) has number j * columns + i, starts at rest at (i cell, -j cell, 0),
/// and does not move where it is (0, 0) or (columns - 1, 0).
struct PlainSheet {
    struct Kind {
        double stiffness;  ///< of each spring [N/m]
        double damping;    ///< of its dashpot [N s/m]
    };
    int columns = 40, rows = 40;  ///< at least 3
    double cell = 0.025;          ///< [m]
    double mass = 1e-4;           ///< of each particle [kg]
    /// Damping is one time constant everywhere, c = 1e-4 s * k: so every method, forward Euler too,
    /// is stable at a step below that.
    Kind structural{200.0, 0.02}, shear{100.0, 0.01}, bend{20.0, 0.002};
    Vec3d gravity{0.0, -9.81, 0.0};  ///< [m/s2]
    double drag = 1e-5;              ///< f = -drag v [kg/s]

    [[nodiscard]] std::size_t particle_count() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    [[nodiscard]] Vec3d rest_position(int column, int row) const {
        return {column * cell, -row * cell, 0.0};
    }
    [[nodiscard]] bool is_pinned(int column, int row) const {
        return row == 0 && (column == 0 || column == columns - 1);
    }
};

struct PlainSpring {
    int a, b;            ///< particles
    double k, c;         ///< [N/m], [N s/m]
    double rest_length;  ///< [m]
};

/// All springs, kind after kind (structural, shear, bend), as the textbooks build them.
std::vector<PlainSpring> plain_springs(const PlainSheet& sheet);

/// Their number.
std::size_t plain_spring_count(const PlainSheet& sheet);

/// What someone else would use to step the sheet.
class SteppedPeer {
public:
    virtual ~SteppedPeer() = default;
    /// @param dt [s]
    virtual void step(double dt, int count) = 0;
    /// @param positions [particle], overwritten [m].
    virtual void copy_positions(std::span<Vec3d> positions) const = 0;
};

}  // namespace weft::bench
