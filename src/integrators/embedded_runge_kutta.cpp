#include "integrators/embedded_runge_kutta.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "math/linear_combination.h"
#include "math/vector_maximum.h"

namespace weft {

const EmbeddedTable dopri5_table{
    .method = {7,
               {{{0.0},
                 {1.0 / 5},
                 {3.0 / 40, 9.0 / 40},
                 {44.0 / 45, -56.0 / 15, 32.0 / 9},
                 {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                 {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                 {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}},
               {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
               {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0}},
    .error = {71.0 / 57600, 0.0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525,
              -1.0 / 40},
    .dense = {-12715105075.0 / 11282082432, 0.0, 87487479700.0 / 32700410799,
              -10690763975.0 / 1880347072, 701980252875.0 / 199316789632, -1453857185.0 / 822651844,
              69997945.0 / 29380423},
    .error_order = 5,
    .previous_weight = 0.04};

const EmbeddedTable bosh3_table{
    .method = {4,
               {{{0.0}, {1.0 / 2}, {0.0, 3.0 / 4}, {2.0 / 9, 1.0 / 3, 4.0 / 9}}},
               {2.0 / 9, 1.0 / 3, 4.0 / 9},
               {0.0, 1.0 / 2, 3.0 / 4, 1.0}},
    .error = {-5.0 / 72, 1.0 / 12, 1.0 / 9, -1.0 / 8},
    .dense = {},
    .error_order = 3,
    .previous_weight = 0.4 / 3};

namespace {

constexpr double safety = 0.9;  // of the length that the error seems to allow
constexpr double most_shrinking = 0.2, most_growth = 10.0;
constexpr double first_error = 1e-4;  // in tolerances; also the least that control remembers

// The continuous extension's weights of accelerations in v; their sum is theta.
ButcherTable::Weights dense_weights(const EmbeddedTable& table, double theta) {
    const double rest = 1.0 - theta;
    ButcherTable::Weights weights{};
    for (std::size_t i = 0; i < weights.size(); ++i) {
        weights[i] = theta * theta * (3.0 - 2.0 * theta) * table.method.b[i] +
                     theta * theta * rest * rest * table.dense[i];
    }
    weights[0] += theta * rest * rest;
    weights[static_cast<std::size_t>(table.method.stages) - 1] -= theta * theta * rest;
    return weights;
}

}  // namespace

template <typename Real>
EmbeddedRungeKutta<Real>::EmbeddedRungeKutta(const EmbeddedTable& table,
                                             const ErrorControl& control,
                                             InstructionSet instruction_set)
    : table_(table), control_(control), instruction_set_(instruction_set) {
    assert(control.tolerance > 0.0 && control.largest_step > 0.0);
    for (std::size_t i = 0; i <= last(); ++i) {
        a_squared_[i] = position_weights(table_.method, table_.method.a[i]);
    }
}

template <typename Real>
void EmbeddedRungeKutta<Real>::prepare(DynamicsSystem<Real>& system) {
    const std::size_t slots = system.slot_count();
    for (ParticleState<Real>* state : {&begin_, &end_}) {
        state->x = Vec3Array<Real>(slots);
        state->v = Vec3Array<Real>(slots);
    }
    for (std::size_t i = 0; i <= last(); ++i) slopes_[i] = Vec3Array<Real>(slots);
    block_maxima_.assign(VectorMaximum<Real>::block_count(slots), 0.0);
    started_ = false;
    counts_ = {};
}

// out_x = x + h c v + h^2 sum xw_j a_j,  out_v = v + h sum vw_j a_j, from begin_.
template <typename Real>
void EmbeddedRungeKutta<Real>::combine(double h, double c, const Weights& x_weights,
                                       const Weights& v_weights, Vec3Array<Real>& out_x,
                                       Vec3Array<Real>& out_v) const {
    LinearCombination<Real> sums(out_x, out_v);
    sums.add(begin_.x, 1.0).add(begin_.v, h * c, 1.0);
    for (std::size_t j = 0; j <= last(); ++j) {
        sums.add(slopes_[j], h * h * x_weights[j], h * v_weights[j]);
    }
    sums.compute(instruction_set_);
}

// The acceleration at end_, with pins where they are at t.
template <typename Real>
void EmbeddedRungeKutta<Real>::evaluate(DynamicsSystem<Real>& system, double t, std::size_t stage) {
    system.constrain(t, end_.x.view(), end_.v.view());
    system.acceleration(t, std::as_const(end_.x).view(), std::as_const(end_.v).view(),
                        slopes_[stage].view());
    ++counts_.evaluations;
}

// Puts the state where the first step will begin, as if a step had ended there.
// @return false where its acceleration is not finite.
template <typename Real>
bool EmbeddedRungeKutta<Real>::start(DynamicsSystem<Real>& system, double longest,
                                     const ParticleState<Real>& state) {
    begin_.x = state.x;
    begin_.v = state.v;
    begin_.time = state.time;
    end_.x = state.x;
    end_.v = state.v;
    evaluate(system, state.time, 0);
    next_length_ = first_length(system, longest);
    previous_error_ = first_error;
    end_.x = state.x;
    end_.v = state.v;
    end_.time = state.time;
    std::swap(slopes_[0], slopes_[last()]);
    length_ = 0.0;
    retake_ = false;
    started_ = std::isfinite(next_length_);
    return started_;
}

// The starting step of Hairer, Norsett, Wanner II.4: derivatives are guessed from two evaluations,
// and the error from derivatives. Theirs compares with |y|; places have no size, so the first trial
// is the step in which the acceleration A moves a particle by half the tolerance, and derivatives
// of x are taken to grow as A r^(n-2), with r = |A'| / A.
// @return not finite where an acceleration is not.
template <typename Real>
double EmbeddedRungeKutta<Real>::first_length(DynamicsSystem<Real>& system, double longest) {
    constexpr double still = 1e-6;  // [s], where nothing accelerates
    const auto length_of = [&](const VectorMaximum<Real>& vectors) {
        return std::sqrt(vectors.compute(instruction_set_, block_maxima_));
    };
    const double size = length_of(VectorMaximum<Real>().add(slopes_[0], 1.0));
    if (!std::isfinite(size)) return size;
    if (size == 0.0) return std::min(still, longest);
    const double trial = std::min(std::sqrt(control_.tolerance / size), longest);
    combine(trial, 1.0, {0.5}, {1.0}, end_.x, end_.v);
    evaluate(system, begin_.time + trial, 1);
    const double change =
        length_of(VectorMaximum<Real>().add(slopes_[1], 1.0).add(slopes_[0], -1.0));
    const double rate = change / (trial * size);
    const double q = table_.error_order;
    const double guess =
        std::pow(0.01 * control_.tolerance / (size * std::pow(rate, q - 2.0)), 1.0 / q);
    return std::max(std::min({guess, 100.0 * trial, longest}), smallest_step);
}

template <typename Real>
void EmbeddedRungeKutta<Real>::take_step(DynamicsSystem<Real>& system) {
    const ButcherTable& method = table_.method;
    for (std::size_t i = 1; i <= last(); ++i) {
        combine(length_, method.c[i], a_squared_[i], method.a[i], end_.x, end_.v);
        evaluate(system, begin_.time + method.c[i] * length_, i);
    }
    end_.time = begin_.time + length_;
}

// Of the step from begin_ to end_, in tolerances.
template <typename Real>
double EmbeddedRungeKutta<Real>::error() {
    const double h = length_, unit = h * h / control_.tolerance;
    const double floor = 4.0 * std::numeric_limits<Real>::epsilon() / control_.tolerance;
    const Weights x_weights = position_weights(table_.method, table_.error);
    VectorMaximum<Real> errors;
    for (std::size_t j = 0; j <= last(); ++j) {
        errors.add(slopes_[j], unit * x_weights[j], unit * table_.error[j]);
    }
    errors.over(end_.x, floor, end_.v, floor * h);
    return std::sqrt(errors.compute(instruction_set_, block_maxima_));
}

// The next step, as long as the error allows.
template <typename Real>
std::optional<StepFailure> EmbeddedRungeKutta<Real>::advance(DynamicsSystem<Real>& system,
                                                             double longest) {
    std::swap(begin_, end_);
    std::swap(slopes_[0], slopes_[last()]);
    length_ = std::min(next_length_, longest);
    const double order = table_.error_order, beta = table_.previous_weight;
    const double resolved = 16.0 * std::numeric_limits<double>::epsilon() * std::abs(begin_.time);
    double growth = most_growth, error_now = 0.0;
    while (true) {
        take_step(system);
        error_now = error();
        if (error_now <= 1.0) break;
        ++counts_.rejected;
        growth = 1.0;
        length_ *= std::max(most_shrinking, safety * std::pow(error_now, -1.0 / order));
        if (length_ < std::max(smallest_step, resolved)) {
            return StepFailure{
                fmt::format("at {:.6g} s the error stays above the tolerance of {:g} m in steps "
                            "down to {:.2g} s",
                            begin_.time, control_.tolerance, length_),
                "a larger integrator.tolerance, or look for what jumps: stiffness, wind, pins"};
        }
    }
    ++counts_.steps;
    const double factor =
        safety * std::pow(error_now, 0.75 * beta - 1.0 / order) * std::pow(previous_error_, beta);
    next_length_ = length_ * std::clamp(factor, most_shrinking, growth);
    previous_error_ = std::max(error_now, first_error);
    return {};
}

template <typename Real>
void EmbeddedRungeKutta<Real>::interpolate(double t, ParticleState<Real>& state) const {
    const double theta = (t - begin_.time) / length_;
    const Weights weights = dense_weights(table_, theta);
    combine(length_, theta, position_weights(table_.method, weights), weights, state.x, state.v);
}

template <typename Real>
StepReport EmbeddedRungeKutta<Real>::step(DynamicsSystem<Real>& system, double dt,
                                          ParticleState<Real>& state) {
    const double target = state.time + dt;
    const double longest = std::min(control_.largest_step, dt);
    if (started_ && target < begin_.time) restart();  // time was set back
    if (!started_ && !start(system, longest, state)) {
        return {StepFailure{fmt::format("accelerations at {:.6g} s are not finite", state.time),
                            "look for particles in one place, or for a state that is not finite"}};
    }
    if (retake_) take_step(system);
    retake_ = false;
    while (end_.time < target) {
        if (auto failure = advance(system, longest)) {
            restart();
            return {std::move(failure)};
        }
    }
    interpolate(target, state);
    state.time = target;
    system.constrain(target, state.x.view(), state.v.view());
    return {};
}

// A step can be made again from where it began: a third of the memory that all of it takes.
template <typename Real>
void EmbeddedRungeKutta<Real>::save(History& history) const {
    history.arrays.resize(3);  // copied into the same memory frame after frame
    history.arrays[0] = begin_.x;
    history.arrays[1] = begin_.v;
    history.arrays[2] = slopes_[0];
    history.last_step = started_ ? length_ : 0.0;
    history.control = {begin_.time, next_length_, previous_error_};
}

template <typename Real>
void EmbeddedRungeKutta<Real>::restore(const History& history) {
    begin_.x = history.arrays[0];
    begin_.v = history.arrays[1];
    slopes_[0] = history.arrays[2];
    length_ = history.last_step;
    begin_.time = history.control[0];
    next_length_ = history.control[1];
    previous_error_ = history.control[2];
    started_ = retake_ = length_ > 0.0;
    end_.time = begin_.time + length_;
}

template class EmbeddedRungeKutta<float>;
template class EmbeddedRungeKutta<double>;

}  // namespace weft
