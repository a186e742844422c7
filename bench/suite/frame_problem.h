// One frame of implicit Euler on the falling sheet: the equations that solvers are timed on, and
// their solution.
#pragma once

#include <functional>

#include "cloth/cloth_model.h"
#include "cloth/particle_state.h"
#include "weft/scene.h"

namespace weft::bench {

class FrameProblem {
public:
    static constexpr double step = 1.0 / 60.0;  ///< [s]

    /// Lets a sheet of size x size fall for half a second in frames of implicit Euler, so that it
    /// moves and wrinkles, and solves the next frame as well as it can be: until no particle moves
    /// by a nanometre in an iteration of Newton's method, or all together (rms) by less than a
    /// micrometre in fifty.
    /// @param stop asked now and then; where it says so, the problem is left unfinished.
    /// @throws Error (diverged) where that does not come about.
    explicit FrameProblem(
        int size, const std::function<bool()>& stop = [] { return false; });

    [[nodiscard]] const SceneDescription& scene() const { return scene_; }
    [[nodiscard]] const ClothModel& cloth() const { return cloth_; }
    [[nodiscard]] std::size_t slot_count() const { return cloth_.layout.slot_count(); }

    /// The state that the frame starts from.
    [[nodiscard]] const ParticleState<double>& start() const { return start_; }

    /// Root of the mean square distance of particles from the solution [m].
    [[nodiscard]] double error(ConstVec3View<double> x) const;

    /// Where solvers start: x0 + h v0.
    [[nodiscard]] const Vec3Array<double>& guess() const { return guess_; }

    /// Length of the unbalanced force at the solution, over that at the guess.
    [[nodiscard]] double residual() const { return residual_; }

private:
    void march(const std::function<bool()>& stop);
    void solve(const std::function<bool()>& stop);

    SceneDescription scene_;
    ClothModel cloth_;
    ParticleState<double> start_;
    Vec3Array<double> guess_, solution_;
    double residual_ = 0.0;
};

}  // namespace weft::bench
