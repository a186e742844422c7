#include "integrators/vbd.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "integrators/array_loop.h"
#include "math/parallel.h"

namespace weft {

namespace {

constexpr std::size_t particle_grain = 256;  // below, waking a thread costs more than it saves

template <typename Real>
struct SymmetricBlock {
    Real xx{}, xy{}, xz{}, yy{}, yz{}, zz{};

    void add_outer(Real weight, Vec3<Real> n) {
        xx += weight * n.x * n.x;
        xy += weight * n.x * n.y;
        xz += weight * n.x * n.z;
        yy += weight * n.y * n.y;
        yz += weight * n.y * n.z;
        zz += weight * n.z * n.z;
    }
    void add_diagonal(Real value) {
        xx += value;
        yy += value;
        zz += value;
    }
    // By L D L^T: definite blocks stay so in single precision, where a determinant might not.
    [[nodiscard]] Vec3<Real> solve(Vec3<Real> r) const {
        const Real l_yx = xy / xx, l_zx = xz / xx;
        const Real d_y = yy - l_yx * xy;
        const Real e = yz - l_yx * xz, l_zy = e / d_y;
        const Real d_z = zz - l_zx * xz - l_zy * e;
        const Real y = r.y - l_yx * r.x;
        const Real z = (r.z - l_zx * r.x - l_zy * y) / d_z;
        const Real v = y / d_y - l_zy * z;
        return {r.x / xx - l_yx * v - l_zx * z, v, z};
    }
};

}  // namespace

template <typename Real>
VertexBlockDescent<Real>::VertexBlockDescent(int iterations, double rho)
    : iterations_(iterations),
      // T_n(1 / rho) = cosh(n acosh(1 / rho)) >= 20
      rho_(std::min(rho, 1 / std::cosh(std::acosh(20.0) / iterations))) {}

template <typename Real>
void VertexBlockDescent<Real>::prepare(DynamicsSystem<Real>& system) {
    position_step_.prepare(system);
    ColouredParticles coloured = colour_particles(position_step_.network());
    first_ = std::move(coloured.first);
    rows_ = SpringRows<Real>(position_step_.network(), std::move(coloured.slots));
    acceleration_ = Vec3Array<Real>(system.slot_count());
    const std::size_t kept = rho_ > 0.0 ? system.slot_count() : 0;
    last_ = Vec3Array<Real>(kept);
    before_last_ = Vec3Array<Real>(kept);
    started_ = false;
    counts_ = {};
}

template <typename Real>
void VertexBlockDescent<Real>::restore(const History& history) {
    acceleration_ = history.arrays[0];
    started_ = history.last_step != 0.0;
}

template <typename Real>
StepReport VertexBlockDescent<Real>::step(DynamicsSystem<Real>& system, double dt,
                                          ParticleState<Real>& state) {
    const Real h = static_cast<Real>(dt);
    position_step_.begin(system, dt, state);
    guess(h, state);
    if (rho_ > 0.0) last_ = state.x;
    for (int n = 1; n <= iterations_; ++n) {
        sweep(h, state.x.view());
        if (rho_ > 0.0) extrapolate(n, state.x);
    }
    keep_acceleration(h, state);
    position_step_.end(system, dt, state);
    ++counts_.evaluations;
    counts_.newton_iterations += static_cast<std::size_t>(iterations_);
    return {};
}

template <typename Real>
void VertexBlockDescent<Real>::guess(Real h, ParticleState<Real>& state) const {
    state.x = position_step_.target();
    if (!started_) return;
    parallel_for(rows_.slots.size(), particle_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const std::size_t i = rows_.slots[row];
            const Vec3<Real> external = position_step_.external()[i];
            const Real square = dot(external, external);
            // The share of the external acceleration that the last step showed.
            const Real share =
                square > 0 ? std::clamp(dot(acceleration_[i], external) / square, Real{0}, Real{1})
                           : Real{0};
            state.x.set(i, position_step_.start()[i] + h * state.v[i] + (h * h * share) * external);
        }
    });
}

template <typename Real>
void VertexBlockDescent<Real>::sweep(Real h, Vec3View<Real> x) const {
    for (std::size_t colour = 0; colour + 1 < first_.size(); ++colour) {
        const std::size_t from = first_[colour];
        parallel_for(first_[colour + 1] - from, particle_grain,
                     [&](std::size_t begin, std::size_t end) {
                         for (std::size_t n = begin; n < end; ++n) descend(h, from + n, x);
                     });
    }
}

template <typename Real>
void VertexBlockDescent<Real>::descend(Real h, std::size_t row, Vec3View<Real> x) const {
    const std::size_t i = rows_.slots[row];
    const ConstVec3View<Real> start = position_step_.start().view();
    const Vec3<Real> x_i = x[i], start_i = start[i];
    const Real inertia = 1 / (position_step_.inverse_masses()[i] * h * h);
    Vec3<Real> f = inertia * (position_step_.target()[i] - x_i);
    SymmetricBlock<Real> hessian;
    Real diagonal = inertia;
    for (std::uint32_t e = rows_.first[row]; e < rows_.first[row + 1]; ++e) {
        const auto& spring = rows_.entries[e];
        const Vec3<Real> d = x[spring.other] - x_i;
        const Real l = length(d);
        if (l == 0) continue;  // no direction, no force
        const Real inverse_l = 1 / l;
        const Vec3<Real> n = inverse_l * d;
        const Real across =
            spring.stiffness * std::max(Real{0}, 1 - spring.rest_length * inverse_l);
        Real force = spring.stiffness * (l - spring.rest_length);
        Real along = spring.stiffness;
        if (spring.damping > 0) {
            const Real c = spring.damping / h;
            force += c * dot(n, d - (start[spring.other] - start_i));
            along += c;
        }
        f += force * n;
        hessian.add_outer(along - across, n);
        diagonal += across;
    }
    hessian.add_diagonal(diagonal);
    x.set(i, x_i + hessian.solve(f));
}

template <typename Real>
void VertexBlockDescent<Real>::extrapolate(int iteration, Vec3Array<Real>& x) {
    // Pins and padding are the same in all three, and stay: x - x^(n-2) is zero.
    if (iteration > 1) {
        const double rho2 = rho_ * rho_;
        weight_ = iteration == 2 ? 2 / (2 - rho2) : 4 / (4 - rho2 * weight_);
        const Real weight = static_cast<Real>(weight_);
        for_components(x, [&](std::size_t begin, std::size_t end) {
            const Real* old = before_last_.data();
            Real* now = x.data();
            for (std::size_t n = begin; n < end; ++n) now[n] = weight * (now[n] - old[n]) + old[n];
        });
    }
    std::swap(before_last_, last_);
    last_ = x;
}

template <typename Real>
void VertexBlockDescent<Real>::keep_acceleration(Real h, const ParticleState<Real>& state) {
    const Real inverse = 1 / h;
    for_components(acceleration_, [&](std::size_t begin, std::size_t end) {
        const Real *x = state.x.data(), *start = position_step_.start().data();
        const Real* v = state.v.data();
        Real* a = acceleration_.data();
        for (std::size_t n = begin; n < end; ++n) {
            a[n] = ((x[n] - start[n]) * inverse - v[n]) * inverse;
        }
    });
    started_ = true;
}

template class VertexBlockDescent<float>;
template class VertexBlockDescent<double>;

}  // namespace weft
