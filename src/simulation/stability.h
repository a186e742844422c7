// How large a step is stable: the cloth linearised at a state, and every method's limit on it.
#pragma once

#include <string_view>
#include <vector>

#include "forces/linear_kernel.h"
#include "math/instruction_sets.h"
#include "math/vec3_array.h"

namespace weft {

/// A damped mode x'' = -omega^2 x - 2 zeta omega x'.
struct Mode {
    double omega = 0.0;         ///< [1/s]
    double damping_rate = 0.0;  ///< 2 zeta omega [1/s]
};

/// The modes that limit a step: the one of the largest frequency, the one most damped, and the
/// slowest under drag alone. `least_damped` bounds from below how much the highest mode is damped
/// (the smallest ratio c/k of any spring): it limits methods that need damping to be stable.
struct StabilityModes {
    std::vector<Mode> modes;
    Mode least_damped;

    /// Largest stable step of a method [s]; infinity where nothing limits it, 0 where none is.
    [[nodiscard]] double stable_step(std::string_view method) const;
};

/// Finds and follows the modes of one cloth.
template <typename Real>
class StabilityAnalysis {
public:
    /// @param cloth outlives the analysis.
    /// @param threads that loops may be shared by; does not change the results.
    StabilityAnalysis(const ClothModel& cloth, const ForcesDescription& forces,
                      InstructionSet set = chosen_instruction_set(), int threads = 1);

    /// Analyses the springs linearised at positions x [slot]. omega_max is never above the true
    /// value but for rounding, and below it by less than 5 parts in 100000.
    StabilityModes find(ConstVec3View<Real> x);

    /// Follows omega_max^2 while the cloth moves: so many products of power iteration from the
    /// last mode found. The result is never above the true value but for rounding [1/s2].
    double follow(ConstVec3View<Real> x, int products);

    /// The fastest mode that find() or follow() ended with [slot], in mass-scaled co-ordinates; of
    /// no particular length after follow().
    [[nodiscard]] const Vec3Array<Real>& fastest_mode() const { return fastest_mode_; }

    /// Products that the last find() took, with the stiffness and with the damping matrix.
    [[nodiscard]] int products() const { return products_; }

private:
    Mode find_fastest();
    Mode find_most_damped();
    double quotient(LinearMatrix matrix, const Vec3Array<Real>& unit);

    const ClothModel& cloth_;
    ForcesDescription forces_;
    InstructionSet set_;
    LinearKernel<Real> kernel_;
    Vec3Array<Real> fastest_mode_, image_;
    double length_ = 0.0;  // of fastest_mode_
    int products_ = 0;
};

extern template class StabilityAnalysis<float>;
extern template class StabilityAnalysis<double>;

}  // namespace weft
