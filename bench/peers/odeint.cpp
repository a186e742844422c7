// Compiled with -O3 -march=native, as textbook.cpp is.
#include "bench/peers/odeint.h"

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>
#include <boost/version.hpp>
#include <cmath>
#include <utility>

namespace weft::bench {

namespace {

namespace odeint = boost::numeric::odeint;

// The standard allocator under another name, so that vectors of this file are not those of others.
template <typename T>
struct Allocator : std::allocator<T> {
    template <typename U>
    struct rebind {
        using other = Allocator<U>;
    };
};
using State = std::vector<double, Allocator<double>>;  // x0 y0 z0 x1 y1 z1 ...

struct Spring {
    int a, b;
    double k, c, rest_length;
};

class Forces {
public:
    explicit Forces(const PlainSheet& sheet) : sheet_(sheet) {
        for (const PlainSpring& s : plain_springs(sheet)) {
            springs_.push_back({3 * s.a, 3 * s.b, s.k, s.c, s.rest_length});
        }
    }

    void accelerations(const double* x, const double* v, double* a) const {
        const double drag = sheet_.drag / sheet_.mass, inverse_mass = 1.0 / sheet_.mass;
        const std::size_t particles = sheet_.particle_count();
        for (std::size_t p = 0; p < particles; ++p) {
            a[3 * p] = sheet_.gravity.x - drag * v[3 * p];
            a[3 * p + 1] = sheet_.gravity.y - drag * v[3 * p + 1];
            a[3 * p + 2] = sheet_.gravity.z - drag * v[3 * p + 2];
        }
        for (const Spring& s : springs_) {
            const double dx = x[s.b] - x[s.a], dy = x[s.b + 1] - x[s.a + 1],
                         dz = x[s.b + 2] - x[s.a + 2];
            const double l = std::sqrt(dx * dx + dy * dy + dz * dz);
            const double rate = ((v[s.b] - v[s.a]) * dx + (v[s.b + 1] - v[s.a + 1]) * dy +
                                 (v[s.b + 2] - v[s.a + 2]) * dz) /
                                l;
            const double f = (s.k * (l - s.rest_length) + s.c * rate) / l * inverse_mass;
            a[s.a] += f * dx;
            a[s.a + 1] += f * dy;
            a[s.a + 2] += f * dz;
            a[s.b] -= f * dx;
            a[s.b + 1] -= f * dy;
            a[s.b + 2] -= f * dz;
        }
        for (const int pinned : {0, 3 * (sheet_.columns - 1)}) {
            a[pinned] = a[pinned + 1] = a[pinned + 2] = 0.0;
        }
    }

private:
    PlainSheet sheet_;
    std::vector<Spring> springs_;
};

void set_rest_positions(const PlainSheet& sheet, State& x) {
    std::size_t n = 0;
    for (int j = 0; j < sheet.rows; ++j) {
        for (int i = 0; i < sheet.columns; ++i, n += 3) {
            const Vec3d rest = sheet.rest_position(i, j);
            x[n] = rest.x;
            x[n + 1] = rest.y;
            x[n + 2] = rest.z;
        }
    }
}

void copy(const State& x, std::span<Vec3d> positions) {
    for (std::size_t p = 0; p < positions.size(); ++p) {
        positions[p] = {x[3 * p], x[3 * p + 1], x[3 * p + 2]};
    }
}

// First order: the state is all positions, then all velocities.
class RungeKutta4 final : public SteppedPeer {
public:
    explicit RungeKutta4(const PlainSheet& sheet)
        : forces_(sheet), half_(3 * sheet.particle_count()), state_(2 * half_, 0.0) {
        set_rest_positions(sheet, state_);
    }
    void step(double dt, int count) override {
        const auto system = [this](const State& y, State& dydt, double) {
            for (std::size_t n = 0; n < half_; ++n) dydt[n] = y[half_ + n];
            forces_.accelerations(y.data(), y.data() + half_, dydt.data() + half_);
        };
        for (int n = 0; n < count; ++n, time_ += dt) stepper_.do_step(system, state_, time_, dt);
    }
    void copy_positions(std::span<Vec3d> positions) const override { copy(state_, positions); }

private:
    Forces forces_;
    std::size_t half_;
    State state_;
    odeint::runge_kutta4<State> stepper_;
    double time_ = 0.0;
};

class VelocityVerlet final : public SteppedPeer {
public:
    explicit VelocityVerlet(const PlainSheet& sheet)
        : forces_(sheet), x_(3 * sheet.particle_count()), v_(3 * sheet.particle_count(), 0.0) {
        set_rest_positions(sheet, x_);
    }
    void step(double dt, int count) override {
        const auto system = [this](const State& x, const State& v, State& a, double) {
            forces_.accelerations(x.data(), v.data(), a.data());
        };
        for (int n = 0; n < count; ++n, time_ += dt) {
            stepper_.do_step(system, std::make_pair(std::ref(x_), std::ref(v_)), time_, dt);
        }
    }
    void copy_positions(std::span<Vec3d> positions) const override { copy(x_, positions); }

private:
    Forces forces_;
    State x_, v_;
    odeint::velocity_verlet<State> stepper_;
    double time_ = 0.0;
};

}  // namespace

std::unique_ptr<SteppedPeer> make_odeint(const PlainSheet& sheet, OdeintStepper stepper) {
    if (stepper == OdeintStepper::rk4) return std::make_unique<RungeKutta4>(sheet);
    return std::make_unique<VelocityVerlet>(sheet);
}

std::string odeint_version() {
    return std::to_string(BOOST_VERSION / 100000) + "." +
           std::to_string(BOOST_VERSION / 100 % 1000) + "." + std::to_string(BOOST_VERSION % 100);
}

}  // namespace weft::bench
