// The ways to the products of LinearKernel: the readable twins, a grid's sweep, a mesh's slices.
#pragma once

#include "forces/linear_kernel.h"

namespace weft {

template <typename Real>
class LinearKernel<Real>::Products {
public:
    explicit Products(std::vector<Real> root_inverse_masses)
        : root_inverse_masses_(std::move(root_inverse_masses)) {}
    virtual ~Products() = default;

    /// As those of LinearKernel.
    virtual void linearise_at(ConstVec3View<Real> x) = 0;
    virtual LinearSums multiply(LinearMatrix matrix, Real scale, ConstVec3View<Real> u,
                                Vec3View<Real> out) = 0;

    [[nodiscard]] const std::vector<Real>& root_inverse_masses() const {
        return root_inverse_masses_;
    }

private:
    std::vector<Real> root_inverse_masses_;
};

/// @param set not scalar.
template <typename Real>
std::unique_ptr<typename LinearKernel<Real>::Products> make_grid_products(
    const ClothModel& cloth, const ForcesDescription& forces, std::vector<Real> root_inverse_masses,
    InstructionSet set, int threads);

/// @param set not scalar.
template <typename Real>
std::unique_ptr<typename LinearKernel<Real>::Products> make_mesh_products(
    const ClothModel& cloth, const ForcesDescription& forces, std::vector<Real> root_inverse_masses,
    InstructionSet set);

/// The constants of a spring, scaled as the passes want them.
template <typename Real>
LinearSpring<Real> linear_spring(double stiffness, double damping, double rest_length);

}  // namespace weft
