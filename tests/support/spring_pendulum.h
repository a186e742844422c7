// A particle on a spring that hangs from a point: a small nonlinear system for measuring
// integrators. Nonlinear on purpose: linear problems test only some of the order conditions.
#pragma once

#include <Eigen/Dense>
#include <array>

#include "integrators/integrator.h"

namespace weft::test {

enum class Pendulum {
    free,    ///< spring and gravity
    damped,  ///< with a dashpot along the spring, linear and quadratic drag
    forced,  ///< undamped, hung from a point that moves
};

/// a = -(k/m) (|d| - L) d/|d| + g - damping, with d = x - anchor(t); k/m = 25 /s2, L = 1 m. The
/// same numbers stand in tools/reference_solutions.py.
class SpringPendulum final : public DynamicsSystem<double>, private ImplicitSystem {
public:
    explicit SpringPendulum(Pendulum kind) : kind_(kind) {}

    [[nodiscard]] ImplicitSystem* implicit_system() override { return this; }

    [[nodiscard]] std::size_t slot_count() const override { return 1; }
    void acceleration(double t, ConstVec3View<double> x, ConstVec3View<double> v,
                      Vec3View<double> a) override {
        ++evaluations;
        a.set(0, acceleration(t, x[0], v[0]));
    }
    void constrain(double, Vec3View<double>, Vec3View<double>) const override {}

    [[nodiscard]] Vec3d acceleration(double t, Vec3d x, Vec3d v) const {
        const Vec3d d = kind_ == Pendulum::forced ? x - anchor(t) : x;
        const double r = length(d);
        Vec3d a = (-25.0 * (r - 1.0) / r) * d + Vec3d{0.0, -9.81, 0.0};
        if (kind_ == Pendulum::damped) {
            a += (-0.8 * dot(v, d) / (r * r)) * d - (0.3 + 0.1 * length(v)) * v;
        }
        return a;
    }

    int evaluations = 0;

private:
    [[nodiscard]] std::span<const double> inverse_masses() const override { return mass_; }

    // 1 / tau^2 + K + C / tau with K >= 0, as forces/newton_matrix.h has it.
    void linearise(double t, double inverse_tau, ConstVec3View<double> x,
                   ConstVec3View<double> v) override {
        const Vec3d d = kind_ == Pendulum::forced ? x[0] - anchor(t) : x[0];
        const double r = length(d), across = std::max(0.0, 1.0 - 1.0 / r);
        const Eigen::Vector3d n = Eigen::Vector3d(d.x, d.y, d.z) / r;
        const Eigen::Matrix3d along = n * n.transpose();
        const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
        matrix_ = inverse_tau * inverse_tau * one + 25.0 * (along + across * (one - along));
        if (kind_ != Pendulum::damped) return;
        const double speed = length(v[0]);
        const Eigen::Vector3d u(v[0].x, v[0].y, v[0].z);
        matrix_ += inverse_tau * (0.8 * along + (0.3 + 0.1 * speed) * one);
        if (speed > 0.0) matrix_ += (0.1 * inverse_tau / speed) * u * u.transpose();
    }
    LinearReport solve(ConstVec3View<double> r, double, Vec3View<double> d) override {
        const Vec3d right = r[0];
        const Eigen::Vector3d found =
            matrix_.llt().solve(Eigen::Vector3d(right.x, right.y, right.z));
        d.set(0, {found.x(), found.y(), found.z()});
        return {1, 0.0, true};
    }

    std::array<double, 1> mass_{1.0};
    Eigen::Matrix3d matrix_;

    static Vec3d anchor(double t) { return {0.4 / (1.0 + t * t), 0.0, 0.3 * t / (1.0 + t)}; }

    Pendulum kind_;
};

struct PointState {
    Vec3d x, v;
};

inline constexpr PointState pendulum_start{{1.2, 0.1, -0.2}, {0.0, 0.5, 0.3}};
inline constexpr double pendulum_end_time = 1.3;  // [s]; no multiple of any period

/// States at pendulum_end_time, exact to the last digit: extrapolation in 60-digit arithmetic
/// (tools/reference_solutions.py). Not one of our integrators: a shared fault would hide itself.
inline constexpr std::array<PointState, 3> pendulum_end{{
    {{-0.76967006168159234705, -1.06925242352868691622, 0.02759424914964178124},
     {-0.49778881052793106990, 4.63936441805308853565, -0.44988613794053955757}},
    {{-0.63113331048613523503, -1.33081531057437757972, 0.04503925088161912941},
     {-0.74861283087952512153, 2.46161441965197246697, -0.21926829357545765401}},
    {{-0.85533510167517824452, -1.21440287965927771405, 0.38773612470690852582},
     {-2.39121786786364064850, 3.74794200370159231033, 0.29639134256472553566}},
}};

inline ParticleState<double> state_of(PointState point, double time = 0.0) {
    ParticleState<double> state{Vec3Array<double>(1), Vec3Array<double>(1), time};
    state.x.set(0, point.x);
    state.v.set(0, point.v);
    return state;
}

inline double distance(const ParticleState<double>& state, PointState point) {
    return length(state.x[0] - point.x) + length(state.v[0] - point.v);
}

}  // namespace weft::test
