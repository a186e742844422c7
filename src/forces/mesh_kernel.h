// A mesh's forces and fused updates by the fast pass: its tables, its copy of the state and its
// threads.
#pragma once

#include <optional>
#include <span>

#include "cloth/cloth_model.h"
#include "forces/mesh_pass.h"
#include "forces/mesh_pass_schedule.h"
#include "forces/mesh_pass_tables.h"
#include "math/vec3_array.h"

namespace weft {

template <typename Real>
class MeshKernel {
public:
    /// @param inverse_masses [slot], 0: pinned [1/kg]; copied.
    /// @param set any but scalar.
    /// @param threads how many parts the slots may be cut into; does not change the results.
    MeshKernel(const ClothModel& cloth, const ForcesDescription& forces,
               const std::optional<WindDescription>& wind, std::span<const Real> inverse_masses,
               InstructionSet set, int threads);
    MeshKernel(MeshKernel&&) noexcept = default;

    /// a = g + (springs + dashpots + air - drag v) / m, zero for pinned particles.
    /// @param wind [m/s]; of no meaning without air.
    /// @param x, v, a views of a Vec3Array: their padding is read, and zero.
    void accelerate(Vec3<Real> wind, ConstVec3View<Real> x, ConstVec3View<Real> v,
                    Vec3View<Real> a);

    /// v += kick a(x, v), then x += drift v.
    void kick_drift(Vec3<Real> wind, double kick, double drift, Vec3View<Real> x, Vec3View<Real> v);

private:
    void set_constants(const ClothModel& cloth, const ForcesDescription& forces,
                       const std::optional<WindDescription>& wind);
    void set_tables();
    void run(Vec3<Real> wind, Vec3View<Real> x, Vec3View<Real> v);
    void run_part(MeshPassFunction<Real> function, std::size_t begin, std::size_t end) const;

    MeshPassFunctions<Real> functions_;
    std::size_t lanes_ = 0, parts_ = 1;
    MeshSpringTables<Real> springs_;
    MeshTriangleTables triangles_;
    MeshSchedule schedule_;
    LineAligned<Real> rows_, thirds_, inverse_masses_;
    MeshPass<Real> pass_;
};

extern template class MeshKernel<float>;
extern template class MeshKernel<double>;

}  // namespace weft
