// A cloth as methods that treat springs one by one see it, and implicit Euler on it solved densely:
// what such methods are held against.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "cloth/cloth_model.h"
#include "cloth/particle_state.h"
#include "cloth/spring_network.h"
#include "integrators/dynamics_system.h"

namespace weft::test {

/// Springs, gravity and drag -c v, in plain loops; pins as the model has them.
template <typename Real>
class SpringSystem final : public DynamicsSystem<Real> {
public:
    SpringSystem(const ClothModel& cloth, Vec3d gravity, double drag = 0.0)
        : cloth_(cloth), network_(weft::spring_network(cloth)), gravity_(gravity), drag_(drag) {}

    [[nodiscard]] std::size_t slot_count() const override { return cloth_.layout.slot_count(); }
    void acceleration(double t, ConstVec3View<Real> x, ConstVec3View<Real> v,
                      Vec3View<Real> a) override {
        external_acceleration(t, x, v, a);
        for (const SpringNetwork::Spring& s : network_.springs) {
            const Vec3d d = vec3_cast<double>(x[s.q] - x[s.p]);
            const Vec3d u = d / length(d), w = vec3_cast<double>(v[s.q] - v[s.p]);
            const double tension =
                s.stiffness * (length(d) - s.rest_length) + s.damping * dot(w, u);
            a.add(s.p, vec3_cast<Real>((network_.inverse_masses[s.p] * tension) * u));
            a.add(s.q, vec3_cast<Real>((-network_.inverse_masses[s.q] * tension) * u));
        }
    }
    void constrain(double t, Vec3View<Real> x, Vec3View<Real> v) const override {
        for (const Pin& pin : cloth_.pins) {
            PinOffset offset;
            if (pin.motion != Pin::no_motion) offset = pin_offset(cloth_.motions[pin.motion], t);
            x.set(cloth_.slot(pin.particle), vec3_cast<Real>(pin.rest + offset.offset));
            v.set(cloth_.slot(pin.particle), vec3_cast<Real>(offset.velocity));
        }
    }
    [[nodiscard]] const SpringNetwork* spring_network() override { return &network_; }
    void external_acceleration(double, ConstVec3View<Real>, ConstVec3View<Real> v,
                               Vec3View<Real> a) override {
        for (std::size_t s = 0; s < a.size; ++s) {
            const double w = network_.inverse_masses[s];
            const Vec3d drag = (w * drag_) * vec3_cast<double>(v[s]);
            a.set(s, w > 0.0 ? vec3_cast<Real>(gravity_ - drag) : Vec3<Real>{});
        }
    }

private:
    const ClothModel& cloth_;
    SpringNetwork network_;
    Vec3d gravity_;
    double drag_;
};

/// Which way a dashpot pulls during a step.
enum class DashpotAlong { end, start };

/// Positions after one step of implicit Euler, gravity and drag taken at its start, by Newton's
/// method with a Jacobian by central differences, from the inertial positions.
class DenseImplicitEuler {
public:
    DenseImplicitEuler(SpringSystem<double>& system, double h, const ParticleState<double>& state,
                       DashpotAlong along)
        : network_(*system.spring_network()),
          h_(h),
          along_(along),
          start_(state.x),
          target_(state.x) {
        Vec3Array<double> a(state.x.size()), v(state.x.size());
        system.external_acceleration(state.time, state.x.view(), state.v.view(), a.view());
        for (std::size_t s = 0; s < a.size(); ++s) {
            target_.set(s, state.x[s] + h * state.v[s] + (h * h) * a[s]);
        }
        system.constrain(state.time + h, target_.view(), v.view());
        for (std::size_t s = 0; s < a.size(); ++s) {
            if (network_.inverse_masses[s] > 0.0) free_.push_back(s);
        }
    }

    /// @return largest component of the last Newton step [m], and the positions.
    [[nodiscard]] std::pair<double, Vec3Array<double>> solve(int iterations = 30) const {
        Vec3Array<double> x = target_;
        double moved = INFINITY;
        for (int n = 0; n < iterations; ++n) {
            const Eigen::VectorXd step = jacobian(x).partialPivLu().solve(-residual(x));
            add(step, x);
            moved = step.cwiseAbs().maxCoeff();
        }
        return {moved, x};
    }

    /// M (x - y) / h^2 - spring forces, of the free particles [N].
    [[nodiscard]] Eigen::VectorXd residual(const Vec3Array<double>& x) const {
        std::vector<Vec3d> f(x.size());
        for (const SpringNetwork::Spring& s : network_.springs) {
            const Vec3d d = x[s.q] - x[s.p], d_n = start_[s.q] - start_[s.p];
            const Vec3d u = d / length(d);
            const Vec3d n = along_ == DashpotAlong::end ? u : d_n / length(d_n);
            const Vec3d force = (s.stiffness * (length(d) - s.rest_length)) * u +
                                (s.damping / h_ * dot(d - d_n, n)) * n;
            f[s.p] += force;
            f[s.q] += -force;
        }
        Eigen::VectorXd r(3 * static_cast<Eigen::Index>(free_.size()));
        for (std::size_t n = 0; n < free_.size(); ++n) {
            const std::size_t i = free_[n];
            const double inertia = 1 / (network_.inverse_masses[i] * h_ * h_);
            const Vec3d g = inertia * (x[i] - target_[i]) - f[i];
            r.segment<3>(3 * static_cast<Eigen::Index>(n)) << g.x, g.y, g.z;
        }
        return r;
    }

private:
    [[nodiscard]] Eigen::MatrixXd jacobian(const Vec3Array<double>& x) const {
        const Eigen::Index size = 3 * static_cast<Eigen::Index>(free_.size());
        constexpr double shift = 1e-6;  // [m]
        Eigen::MatrixXd matrix(size, size);
        for (Eigen::Index n = 0; n < size; ++n) {
            Vec3Array<double> plus = x, minus = x;
            add(shift * Eigen::VectorXd::Unit(size, n), plus);
            add(-shift * Eigen::VectorXd::Unit(size, n), minus);
            matrix.col(n) = (residual(plus) - residual(minus)) / (2 * shift);
        }
        return matrix;
    }
    void add(const Eigen::VectorXd& step, Vec3Array<double>& x) const {
        for (std::size_t n = 0; n < free_.size(); ++n) {
            const auto at = 3 * static_cast<Eigen::Index>(n);
            x.set(free_[n], x[free_[n]] + Vec3d{step(at), step(at + 1), step(at + 2)});
        }
    }

    const SpringNetwork& network_;
    double h_;
    DashpotAlong along_;
    Vec3Array<double> start_, target_;
    std::vector<std::size_t> free_;
};

/// The largest distance of two particles of the same slot.
inline double largest_distance(const Vec3Array<double>& a, const Vec3Array<double>& b) {
    double largest = 0.0;
    for (std::size_t s = 0; s < a.size(); ++s) largest = std::max(largest, length(a[s] - b[s]));
    return largest;
}

}  // namespace weft::test
