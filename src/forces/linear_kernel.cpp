#include "forces/linear_kernel.h"

#include <cmath>

#include "forces/linear_products.h"
#include "forces/linearised.h"
#include "math/simd_targets.h"

namespace weft {

namespace {

template <typename Real>
std::vector<Real> root_inverse_masses_of(const ClothModel& cloth) {
    std::vector<Real> masses(cloth.layout.slot_count(), Real{0});
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        masses[slot] = static_cast<Real>(1 / std::sqrt(cloth.masses[p]));
    });
    for (const Pin& pin : cloth.pins) masses[cloth.slot(pin.particle)] = 0;
    return masses;
}

// By the readable twins.
template <typename Real>
class TwinProducts final : public LinearKernel<Real>::Products {
public:
    TwinProducts(const ClothModel& cloth, const ForcesDescription& forces,
                 std::vector<Real> root_inverse_masses)
        : LinearKernel<Real>::Products(std::move(root_inverse_masses)),
          cloth_(cloth),
          forces_(forces),
          scaled_(cloth.layout.slot_count()) {}

    void linearise_at(ConstVec3View<Real> x) override { x_ = x; }

    LinearSums multiply(LinearMatrix matrix, Real scale, ConstVec3View<Real> u,
                        Vec3View<Real> out) override {
        const std::vector<Real>& masses = this->root_inverse_masses();
        const ConstVec3View<Real> scaled = std::as_const(scaled_).view();
        for (std::size_t s = 0; s < u.size; ++s) scaled_.set(s, (scale * masses[s]) * u[s]);
        if (matrix == LinearMatrix::stiffness) {
            stiffness_product(cloth_, x_, scaled, out);
        } else {
            damping_product(cloth_, forces_, x_, scaled, out);
        }
        LinearSums sums;
        for (std::size_t s = 0; s < out.size; ++s) {
            out.set(s, masses[s] * out[s]);
            const Vec3d product = vec3_cast<double>(out[s]);
            sums.in_out += dot(vec3_cast<double>(u[s]), product);
            sums.out_out += dot(product, product);
        }
        return sums;
    }

private:
    const ClothModel& cloth_;
    ForcesDescription forces_;
    Vec3Array<Real> scaled_;
    ConstVec3View<Real> x_;
};

}  // namespace

template <typename Real>
LinearSpring<Real> linear_spring(double stiffness, double damping, double rest_length) {
    constexpr double scale = root_scale<Real>, square = scale * scale;
    return {static_cast<Real>(stiffness), static_cast<Real>(stiffness / square),
            static_cast<Real>(stiffness * rest_length / (scale * square)),
            static_cast<Real>(damping / square)};
}

template <typename Real>
LinearKernel<Real>::LinearKernel(const ClothModel& cloth, const ForcesDescription& forces,
                                 InstructionSet set, int threads) {
    std::vector<Real> masses = root_inverse_masses_of<Real>(cloth);
    if (set == InstructionSet::scalar) {
        products_ = std::make_unique<TwinProducts<Real>>(cloth, forces, std::move(masses));
    } else if (cloth.is_grid()) {
        products_ = make_grid_products(cloth, forces, std::move(masses), set, threads);
    } else {
        products_ = make_mesh_products(cloth, forces, std::move(masses), set);
    }
}

template <typename Real>
LinearKernel<Real>::~LinearKernel() = default;
template <typename Real>
LinearKernel<Real>::LinearKernel(LinearKernel&&) noexcept = default;
template <typename Real>
LinearKernel<Real>& LinearKernel<Real>::operator=(LinearKernel&&) noexcept = default;

template <typename Real>
void LinearKernel<Real>::linearise_at(ConstVec3View<Real> x) {
    products_->linearise_at(x);
}

template <typename Real>
LinearSums LinearKernel<Real>::multiply(LinearMatrix matrix, double scale, ConstVec3View<Real> u,
                                        Vec3View<Real> out) {
    return products_->multiply(matrix, static_cast<Real>(scale), u, out);
}

template <typename Real>
const std::vector<Real>& LinearKernel<Real>::root_inverse_masses() const {
    return products_->root_inverse_masses();
}

template LinearSpring<float> linear_spring(double, double, double);
template LinearSpring<double> linear_spring(double, double, double);
template class LinearKernel<float>;
template class LinearKernel<double>;

}  // namespace weft
