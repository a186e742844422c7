// Products with the stiffness and damping matrices in mass-scaled co-ordinates, M^-1/2 A M^-1/2,
// by the fast passes of forces/linear_pass.h, or by their readable twins (forces/linearised.h).
#pragma once

#include <memory>
#include <vector>

#include "cloth/cloth_model.h"
#include "forces/linear_pass.h"
#include "math/vec3_array.h"

namespace weft {

template <typename Real>
class LinearKernel {
public:
    /// @param cloth outlives the kernel.
    /// @param set scalar: the twins.
    /// @param threads that a product may be shared by; does not change the results.
    LinearKernel(const ClothModel& cloth, const ForcesDescription& forces, InstructionSet set,
                 int threads);
    ~LinearKernel();
    LinearKernel(LinearKernel&&) noexcept;
    LinearKernel& operator=(LinearKernel&&) noexcept;

    /// Linearises at positions x [slot], which products then read: x must stay as it is.
    void linearise_at(ConstVec3View<Real> x);

    /// out = scale M^-1/2 A M^-1/2 u, all [slot]: zero in padding and for pinned particles, whose u
    /// counts as zero. Of a mesh, the cache line behind u's last slot is read.
    /// @return u.out and out.out.
    LinearSums multiply(LinearMatrix matrix, double scale, ConstVec3View<Real> u,
                        Vec3View<Real> out);

    /// M^-1/2 [slot], zero for pinned particles and padding [kg^-1/2].
    [[nodiscard]] const std::vector<Real>& root_inverse_masses() const;

    class Products;  // one for each way: twins, a grid's sweep, a mesh's slices

private:
    std::unique_ptr<Products> products_;
};

extern template class LinearKernel<float>;
extern template class LinearKernel<double>;

}  // namespace weft
