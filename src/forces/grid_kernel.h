// A grid's forces and fused updates by the fast pass: its constants, its threads and their scratch
// memory.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cloth/cloth_model.h"
#include "forces/grid_pass.h"
#include "forces/grid_strips.h"
#include "math/line_aligned.h"
#include "math/vec3_array.h"

namespace weft {

template <typename Real>
class GridKernel {
public:
    /// @param inverse_masses [slot], 0: pinned, or padding [1/kg]; outlives the kernel.
    /// @param set any but scalar.
    /// @param threads how many bands the rows may be cut into; does not change the results.
    GridKernel(const ClothModel& cloth, const ForcesDescription& forces,
               const std::optional<WindDescription>& wind, std::span<const Real> inverse_masses,
               InstructionSet set, int threads);

    /// a = g + (springs + dashpots + air - drag v) / m, zero for pinned particles and padding.
    /// @param wind [m/s]; of no meaning without air.
    void accelerate(Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v,
                    Vec3View<Real> a);

    /// v += kick a(x, v), then x += drift v, in one sweep.
    void kick_drift(Vec3<Real> wind, double kick, double drift, Vec3View<Real> x, Vec3View<Real> v);

    /// Takes a state into strips (GridStrips), if kick_drift() and verlet() are faster on these.
    /// From then on they move what was taken, whatever arrays they are given, until release()
    /// gives it back. The bits are those of steps on arrays. The first call allocates.
    /// @param a of verlet(); for kick_drift() it has no size.
    /// @param pins_rest nobody puts a particle meanwhile: then kick_drift() may wait for the next
    /// one, to do both in one sweep.
    void hold(ConstVec3View<Real> x, ConstVec3View<Real> v, ConstVec3View<Real> a, bool pins_rest);
    void release(Vec3View<Real> x, Vec3View<Real> v, Vec3View<Real> a);
    [[nodiscard]] bool holds() const { return strips_.strips().blocks != nullptr; }
    /// Puts a particle that is held.
    void put(std::size_t slot, Vec3<Real> x, Vec3<Real> v) const { strips_.put(slot, x, v); }

    /// One step h of velocity Verlet (integrators/verlet.h) in one sweep, where `a` holds the
    /// acceleration that the last step ended with.
    /// @param pins where moving pins are at the step's end, by rising slot.
    /// @param wind at the step's end.
    void verlet(Vec3<Real> wind, double h, std::span<const PinTarget<Real>> pins, Vec3View<Real> x,
                Vec3View<Real> v, Vec3View<Real> a);

private:
    struct Factors {
        std::vector<Real> column[grid_family_count], triangle;
    };

    void set_constants(const ClothModel& cloth);
    void cut_bands(int threads);
    void set_state(Vec3View<Real> x, Vec3View<Real> v);
    void run_in_place(std::size_t arrays);
    void follow_strips();
    void copy_halo(const GridBand<Real>& band, std::size_t arrays) const;

    GridPass<Real> pass_;
    GridPassFunction<Real> function_;
    Factors factors_, factors_in_strips_;
    std::vector<GridBand<Real>> bands_;
    LineAligned<Real> scratch_;  // lines and halos of all bands
    GridStripState<Real> strips_;
    GridPass<Real> second_;
    bool joins_ = false;  // two passes to one sweep
    bool waits_ = false;  // pass_, for a second
};

extern template class GridKernel<float>;
extern template class GridKernel<double>;

}  // namespace weft
