#include "lab/settle/seed_steppers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace weft::lab {

namespace {

constexpr std::array<SeedUpdate, 10> updates{{
    {"verlet a dt^3", "x+ = 2 x - x_prev + a dt^3", "C, sum of eq. 3 and 4 as printed"},
    {"verlet P + P_prev", "x+ = x + (x + x_prev) + a dt^2", "F, section 1.3.2 as printed"},
    {"verlet v of eq. 6", "x+ = x + v dt + a dt^2/2, v = (x - x_prevprev)/(2 dt)",
     "C, eq. 6 and \"velocity is needed for calculating displacement\": v is a step old"},
    {"verlet v = (x - x_prev)/dt", "x+ = x + v dt + a dt^2/2, v = (x - x_prev)/dt",
     "C, section 2.3, second paragraph"},
    {"verlet v+ = v + a dt", "x+ = x + v dt + a dt^2/2, v+ = v + a dt",
     "a slip: eq. 3 moves x, Forward Euler makes v"},
    {"verlet (1 - d)(x - x_prev)", "x+ = x + (1 - d)(x - x_prev) + a dt^2",
     "damping as games put it into eq. 5"},
    {"verlet damped by eq. 6", "x+ = 2 x - x_prev + a dt^2, damping by (x - x_prevprev)/(2 dt)",
     "C, eq. 5, with the velocity of eq. 6 in the damping: a step old"},
    {"euler v+ moves x", "v+ = v + a dt, x+ = x + v+ dt",
     "a slip in C, eq. 2, or F, section 1.3.1: the new v moves x"},
    {"rk3 K2 of the step before", "K2 = f(t + dt/2, y + dt/2 K2_before)",
     "C, eq. 12 as printed, as a program would run it"},
    {"rk3 K2 implicit", "K2 = f(t + dt/2, y + dt/2 K2)", "C, eq. 12 as printed, solved for K2"},
}};

/// x+ = sum c_i x_i + a (w2 dt^2 + w3 dt^3), from x, x_prev, x_prevprev; forces take the velocity
/// (sum p_i x_i) / dt.
struct PositionWeights {
    std::array<double, 3> c;
    double w2, w3;
    std::array<double, 3> p{1.0, -1.0, 0.0};
};

class PositionUpdate final : public Integrator<double> {
public:
    explicit PositionUpdate(const PositionWeights& weights, double drag_rate)
        : weights_(weights), drag_rate_(drag_rate) {}

    void prepare(DynamicsSystem<double>& system) override {
        a_ = previous_ = before_ = Vec3Array<double>(system.slot_count());
        started_ = false;
    }
    void restart() override { started_ = false; }

    StepReport step(DynamicsSystem<double>& system, double dt,
                    ParticleState<double>& state) override {
        if (!started_) start(dt, state);
        double *const x = state.x.data(), *const v = state.v.data();
        double *const previous = previous_.data(), *const before = before_.data();
        const double* const a = a_.data();
        const std::size_t size = state.x.data_size();
        const auto& p = weights_.p;
        for (std::size_t n = 0; n < size; ++n) {
            v[n] = (p[0] * x[n] + p[1] * previous[n] + p[2] * before[n]) / dt;
        }
        system.constrain(state.time, state.x.view(), state.v.view());
        system.acceleration(state.time, state.x.view(), state.v.view(), a_.view());
        const double kept = 1.0 - drag_rate_ * dt;
        const double weight = dt * dt * (weights_.w2 + weights_.w3 * dt);
        const auto& c = weights_.c;
        for (std::size_t n = 0; n < size; ++n) {
            const double next =
                x[n] + kept * ((c[0] - 1.0) * x[n] + c[1] * previous[n] + c[2] * before[n]) +
                weight * a[n];
            before[n] = previous[n];
            previous[n] = x[n];
            v[n] = (next - x[n]) / dt;
            x[n] = next;
        }
        state.time += dt;
        system.constrain(state.time, state.x.view(), state.v.view());
        return {};
    }

private:
    void start(double dt, const ParticleState<double>& state) {
        const double *const x = state.x.data(), *const v = state.v.data();
        for (std::size_t n = 0; n < state.x.data_size(); ++n) {
            previous_.data()[n] = x[n] - dt * v[n];
            before_.data()[n] = x[n] - 2.0 * dt * v[n];
        }
        started_ = true;
    }

    PositionWeights weights_;
    double drag_rate_;
    bool started_ = false;
    Vec3Array<double> a_, previous_, before_;
};

/// x+ = x + dt v + dt^2/2 a, v+ = v + dt a.
class TaylorEulerUpdate final : public Integrator<double> {
public:
    void prepare(DynamicsSystem<double>& system) override {
        a_ = Vec3Array<double>(system.slot_count());
    }
    StepReport step(DynamicsSystem<double>& system, double dt,
                    ParticleState<double>& state) override {
        system.acceleration(state.time, state.x.view(), state.v.view(), a_.view());
        double *const x = state.x.data(), *const v = state.v.data();
        const double* const a = a_.data();
        for (std::size_t n = 0; n < state.x.data_size(); ++n) {
            x[n] += dt * v[n] + 0.5 * dt * dt * a[n];
            v[n] += dt * a[n];
        }
        state.time += dt;
        system.constrain(state.time, state.x.view(), state.v.view());
        return {};
    }

private:
    Vec3Array<double> a_;
};

/// Kutta's third-order method with K2 on the right of its own definition. K = (velocity,
/// acceleration); K2 is kept from step to step, and begins as K1.
class SelfReferringKutta final : public Integrator<double> {
public:
    /// @param implicit the definition is iterated until K2 stays; else used once.
    explicit SelfReferringKutta(bool implicit) : implicit_(implicit) {}

    void prepare(DynamicsSystem<double>& system) override {
        for (Slope* k : {&k1_, &k2_, &k3_, &stage_}) *k = Slope(system.slot_count());
        started_ = false;
    }
    void restart() override { started_ = false; }

    StepReport step(DynamicsSystem<double>& system, double dt,
                    ParticleState<double>& state) override {
        slope(system, state, 0.0, {}, k1_);
        if (!started_) k2_ = k1_;
        started_ = true;
        const int most = implicit_ ? most_iterations : 1;
        bool settled = !implicit_;
        for (int n = 0; n < most; ++n) {
            const double changed = refine_k2(system, dt, state);
            settled = settled || changed <= settled_to;
            if (settled || !std::isfinite(changed)) break;
        }
        if (!settled) return {StepFailure{"K2 on its own right side is not found", {}}};
        slope(system, state, dt, {{&k1_, -dt}, {&k2_, 2.0 * dt}}, k3_);
        for (int part = 0; part < 2; ++part) {
            double* const y = part == 0 ? state.x.data() : state.v.data();
            for (std::size_t n = 0; n < state.x.data_size(); ++n) {
                y[n] +=
                    dt / 6.0 * (k1_.part(part)[n] + 4.0 * k2_.part(part)[n] + k3_.part(part)[n]);
            }
        }
        state.time += dt;
        system.constrain(state.time, state.x.view(), state.v.view());
        return {};
    }

private:
    static constexpr int most_iterations = 200;
    static constexpr double settled_to =
        1e-9;  // of x' [m/s] and v' [m/s2] from one turn to the next

    struct Slope {
        Vec3Array<double> x, v;
        Slope() = default;
        explicit Slope(std::size_t size) : x(size), v(size) {}
        [[nodiscard]] const double* part(int n) const { return n == 0 ? x.data() : v.data(); }
        double* part(int n) { return n == 0 ? x.data() : v.data(); }
    };
    struct Term {
        const Slope* slope = nullptr;
        double weight = 0.0;
    };

    // out = f(t + dt, y + the terms)
    void slope(DynamicsSystem<double>& system, const ParticleState<double>& state, double dt,
               std::initializer_list<Term> terms, Slope& out) {
        stage_.x = state.x;
        stage_.v = state.v;
        for (const Term& term : terms) {
            for (int part = 0; part < 2; ++part) {
                for (std::size_t n = 0; n < state.x.data_size(); ++n) {
                    stage_.part(part)[n] += term.weight * term.slope->part(part)[n];
                }
            }
        }
        system.constrain(state.time + dt, stage_.x.view(), stage_.v.view());
        system.acceleration(state.time + dt, stage_.x.view(), stage_.v.view(), out.v.view());
        out.x = stage_.v;
    }

    // By how much K2 changed.
    double refine_k2(DynamicsSystem<double>& system, double dt,
                     const ParticleState<double>& state) {
        slope(system, state, dt / 2.0, {{&k2_, dt / 2.0}}, k3_);
        double changed = 0.0;
        for (int part = 0; part < 2; ++part) {
            for (std::size_t n = 0; n < state.x.data_size(); ++n) {
                const double difference = std::abs(k3_.part(part)[n] - k2_.part(part)[n]);
                if (!(difference <= changed)) changed = difference;  // not a number is kept
            }
        }
        std::swap(k2_, k3_);
        return changed;
    }

    bool implicit_;
    bool started_ = false;
    Slope k1_, k2_, k3_, stage_;
};

PositionWeights position_weights_of(std::string_view name) {
    if (name == "verlet a dt^3") return {{2.0, -1.0, 0.0}, 0.0, 1.0};
    if (name == "verlet P + P_prev") return {{2.0, 1.0, 0.0}, 1.0, 0.0};
    if (name == "verlet v of eq. 6") return {{1.5, 0.0, -0.5}, 0.5, 0.0, {0.5, 0.0, -0.5}};
    if (name == "verlet v = (x - x_prev)/dt") return {{2.0, -1.0, 0.0}, 0.5, 0.0};
    if (name == "verlet damped by eq. 6") {
        return {{2.0, -1.0, 0.0}, 1.0, 0.0, {0.5, 0.0, -0.5}};
    }
    return {{2.0, -1.0, 0.0}, 1.0, 0.0};
}

}  // namespace

std::span<const SeedUpdate> seed_updates() {
    return updates;
}

const SeedUpdate* find_seed_update(std::string_view name) {
    const auto* const found = std::ranges::find(updates, name, &SeedUpdate::name);
    return found == updates.end() ? nullptr : &*found;
}

std::unique_ptr<Integrator<double>> make_seed_update(std::string_view name, double drag_rate) {
    if (name == "verlet v+ = v + a dt") return std::make_unique<TaylorEulerUpdate>();
    if (name == "euler v+ moves x") return make_integrator<double>("symplectic-euler");
    if (name == "rk3 K2 of the step before") return std::make_unique<SelfReferringKutta>(false);
    if (name == "rk3 K2 implicit") return std::make_unique<SelfReferringKutta>(true);
    const bool scaled = name == "verlet (1 - d)(x - x_prev)";
    return std::make_unique<PositionUpdate>(position_weights_of(name), scaled ? drag_rate : 0.0);
}

}  // namespace weft::lab
