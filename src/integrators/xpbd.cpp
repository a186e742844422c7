#include "integrators/xpbd.h"

#include <algorithm>
#include <cmath>

#include "math/parallel.h"

namespace weft {

namespace {

constexpr std::size_t spring_grain = 2048;  // below this, waking a thread costs more than it saves

}  // namespace

template <typename Real>
void Xpbd<Real>::prepare(DynamicsSystem<Real>& system) {
    position_step_.prepare(system);
    counts_ = {};
    const SpringNetwork& network = position_step_.network();
    damped_ = has_dashpots(network);
    const ColouredSprings coloured = colour_springs(network);
    first_ = coloured.first;
    constraints_.clear();
    for (const SpringNetwork::Spring& s : coloured.springs) {
        constraints_.push_back({s.p, s.q, static_cast<Real>(s.rest_length),
                                static_cast<Real>(s.stiffness), static_cast<Real>(s.damping)});
    }
    multipliers_.assign(constraints_.size(), Real{0});
}

template <typename Real>
StepReport Xpbd<Real>::step(DynamicsSystem<Real>& system, double dt, ParticleState<Real>& state) {
    position_step_.begin(system, dt, state);
    state.x = position_step_.target();
    std::fill(multipliers_.begin(), multipliers_.end(), Real{0});
    for (int n = 0; n < iterations_; ++n) sweep(static_cast<Real>(dt), state.x.view());
    position_step_.end(system, dt, state);
    ++counts_.evaluations;
    counts_.newton_iterations += static_cast<std::size_t>(iterations_);
    return {};
}

template <typename Real>
void Xpbd<Real>::sweep(Real h, Vec3View<Real> x) {
    for (std::size_t colour = 0; colour + 1 < first_.size(); ++colour) {
        const std::size_t from = first_[colour];
        parallel_for(first_[colour + 1] - from, spring_grain,
                     [&](std::size_t begin, std::size_t end) {
                         if (damped_) {
                             project<true>(h, x, from + begin, from + end);
                         } else {
                             project<false>(h, x, from + begin, from + end);
                         }
                     });
    }
}

template <typename Real>
template <bool damped>
void Xpbd<Real>::project(Real h, Vec3View<Real> x, std::size_t begin, std::size_t end) {
    const std::vector<Real>& inverse_masses = position_step_.inverse_masses();
    const ConstVec3View<Real> start = position_step_.start().view();
    for (std::size_t i = begin; i < end; ++i) {
        const Constraint& s = constraints_[i];
        const Real w_p = inverse_masses[s.p], w_q = inverse_masses[s.q];
        const Vec3<Real> d = x[s.q] - x[s.p];
        const Real l = length(d);
        if (l == 0) continue;  // no direction, no force
        const Vec3<Real> n = (1 / l) * d;
        Real weight = s.stiffness * h * h;
        Real numerator = -weight * (l - s.rest_length) - multipliers_[i];
        if constexpr (damped) {
            numerator -= s.damping * h * dot(n, d - (start[s.q] - start[s.p]));
            weight += s.damping * h;
        }
        const Real change = numerator / (1 + weight * (w_p + w_q));
        multipliers_[i] += change;
        // Pins are read by several springs at once, and never written.
        if (w_p > 0) x.add(s.p, (-w_p * change) * n);
        if (w_q > 0) x.add(s.q, (w_q * change) * n);
    }
}

template class Xpbd<float>;
template class Xpbd<double>;

}  // namespace weft
