#include "integrators/projective_dynamics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "integrators/array_loop.h"
#include "math/dot_product.h"
#include "math/parallel.h"

namespace weft {

namespace {

constexpr std::size_t block_rows = 256;  // of one partial sum of G
constexpr std::size_t block_grain = 2;   // below, waking a thread costs more than it saves

template <typename To, typename From>
void convert(const Vec3Array<From>& from, Vec3Array<To>& to) {
    const ConstVec3View<From> in = from.view();
    const Vec3View<To> out = to.view();
    for (std::size_t s = 0; s < in.size; ++s) out.set(s, vec3_cast<To>(in[s]));
}

// to = x + weight * step
void move(const Vec3Array<double>& x, double weight, const Vec3Array<double>& step,
          Vec3Array<double>& to) {
    for_components(to, [&](std::size_t begin, std::size_t end) {
        const double *from = x.data(), *by = step.data();
        double* out = to.data();
        for (std::size_t n = begin; n < end; ++n) out[n] = from[n] + weight * by[n];
    });
}

}  // namespace

template <typename Real>
void ProjectiveDynamics<Real>::prepare(DynamicsSystem<Real>& system) {
    position_step_.prepare(system);
    const SpringNetwork& network = position_step_.network();
    damped_ = has_dashpots(network);
    rows_ = SpringRows<double>(network, free_slots(network));
    matrix_.analyse(network);
    factored_step_ = 0.0;
    memory_ = LimitedMemory(system.slot_count(), static_cast<std::size_t>(settings_.memory));
    for (Vec3Array<double>* array :
         {&start_, &target_, &x_, &next_, &gradient_, &next_gradient_, &direction_}) {
        *array = Vec3Array<double>(system.slot_count());
    }
    block_sums_.assign((rows_.slots.size() + block_rows - 1) / block_rows, 0.0);
    counts_ = {};
}

template <typename Real>
StepReport ProjectiveDynamics<Real>::step(DynamicsSystem<Real>& system, double dt,
                                          ParticleState<Real>& state) {
    if (!factor(dt)) {
        return {StepFailure{"projective dynamics' matrix M/h^2 + L cannot be factored",
                            "a smaller stiffness or time step"}};
    }
    position_step_.begin(system, dt, state);
    convert(position_step_.start(), start_);
    convert(position_step_.target(), target_);
    x_ = target_;
    minimise(dt);
    convert(x_, state.x);
    position_step_.end(system, dt, state);
    return {};
}

template <typename Real>
bool ProjectiveDynamics<Real>::factor(double h) {
    // The minimum is G's, whatever A: a step that differs by rounding may keep its factors.
    if (std::abs(h - factored_step_) <= 1e-9 * h) return true;
    factored_step_ = matrix_.factor(position_step_.network(), h) ? h : 0.0;
    return factored_step_ != 0.0;
}

template <typename Real>
void ProjectiveDynamics<Real>::minimise(double h) {
    memory_.clear();
    double value = evaluate(h, x_, gradient_);
    for (int n = 0; n < settings_.iterations; ++n) {
        find_direction();
        const double next = advance(h, value);
        ++counts_.newton_iterations;
        if (!std::isfinite(next)) return;  // no step makes G fall: x is the minimum, to rounding
        value = next;
        const double moved = largest_move();
        memory_.add(next_, x_, next_gradient_, gradient_);
        std::swap(x_, next_);
        std::swap(gradient_, next_gradient_);
        if (moved <= settings_.tolerance) return;
    }
}

// direction = -H gradient.
template <typename Real>
void ProjectiveDynamics<Real>::find_direction() {
    direction_ = gradient_;
    memory_.before(direction_);
    matrix_.solve(direction_, direction_);
    memory_.after(direction_);
    ++counts_.linear_iterations;
}

// next = x - weight direction with G low enough; returns G there, infinity where there is none.
template <typename Real>
double ProjectiveDynamics<Real>::advance(double h, double value) {
    constexpr double sufficient = 1e-4, rounding = 1e-13;
    constexpr int most_halvings = 20;
    const double slope = -dot(gradient_, direction_);
    double weight = 1.0;
    for (int n = 0; n < most_halvings; ++n) {
        move(x_, -weight, direction_, next_);
        const double next = evaluate(h, next_, next_gradient_);
        if (settings_.memory == 0) return next;  // the local and global steps lead downhill
        if (next <= value + sufficient * weight * slope + rounding * value) return next;
        weight /= 2;
    }
    return INFINITY;
}

template <typename Real>
double ProjectiveDynamics<Real>::largest_move() const {
    double largest = 0.0;
    for (std::size_t n = 0; n < x_.data_size(); ++n) {
        largest = std::max(largest, std::abs(next_.data()[n] - x_.data()[n]));
    }
    return largest;
}

template <typename Real>
double ProjectiveDynamics<Real>::evaluate(double h, const Vec3Array<double>& x,
                                          Vec3Array<double>& gradient) {
    parallel_for(block_sums_.size(), block_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block) {
            const std::size_t last = std::min((block + 1) * block_rows, rows_.slots.size());
            double sum = 0.0;
            for (std::size_t row = block * block_rows; row < last; ++row) {
                sum += evaluate_row(h, row, x, gradient);
            }
            block_sums_[block] = sum;
        }
    });
    ++counts_.evaluations;
    return std::accumulate(block_sums_.begin(), block_sums_.end(), 0.0);
}

// A particle's gradient, and its part of G: all of its inertia, half of each spring to a free one.
template <typename Real>
double ProjectiveDynamics<Real>::evaluate_row(double h, std::size_t row, const Vec3Array<double>& x,
                                              Vec3Array<double>& gradient) const {
    const std::size_t i = rows_.slots[row];
    const auto positions = x.view();
    const auto start = start_.view();
    const std::vector<double>& inverse_masses = position_step_.network().inverse_masses;
    const double inertia = 1 / (inverse_masses[i] * h * h);
    const Vec3d x_i = positions[i], start_i = start[i], off = x_i - target_[i];
    Vec3d g = inertia * off;
    double energy = inertia / 2 * dot(off, off);
    for (std::uint32_t e = rows_.first[row]; e < rows_.first[row + 1]; ++e) {
        const auto& spring = rows_.entries[e];
        const Vec3d d = positions[spring.other] - x_i;
        const double l = length(d), stretch = l - spring.rest_length;
        const double share = inverse_masses[spring.other] > 0.0 ? 0.5 : 1.0;
        if (l > 0.0) g += (-spring.stiffness * stretch / l) * d;
        energy += share * spring.stiffness / 2 * stretch * stretch;
        if (!damped_) continue;
        const Vec3d d_n = start[spring.other] - start_i;
        const double l_n = length(d_n);
        if (l_n == 0.0) continue;
        const double moved = dot(d_n, d - d_n) / l_n, c = spring.damping / h;
        g += (-c * moved / l_n) * d_n;
        energy += share * c / 2 * moved * moved;
    }
    gradient.set(i, g);
    return energy;
}

template class ProjectiveDynamics<float>;
template class ProjectiveDynamics<double>;

}  // namespace weft
