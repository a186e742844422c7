// What happens to a step after the integrator proposed it: grips pull, obstacles stop.
#pragma once

#include <span>
#include <utility>

#include "contact/grip_springs.h"
#include "contact/obstacle_contact.h"
#include "integrators/integrator.h"
#include "simulation/cloth_system.h"
#include "weft/integrators.h"

namespace weft {

template <typename Real>
class StepFilter {
public:
    explicit StepFilter(const ClothModel& cloth) : contact_(cloth) {}

    void set_obstacles(std::span<const ObstacleDescription> obstacles) { contact_.set(obstacles); }
    /// Of obstacles.
    [[nodiscard]] bool is_free() const { return contact_.empty(); }
    /// Whether it looks at the state between steps.
    [[nodiscard]] bool looks(const ClothSystem<Real>& system) const {
        return !contact_.empty() || !system.grips().empty();
    }
    /// @param info of the integrator. An implicit method has the system's grips in its equations;
    /// one of a single stage, which goes by where it ends alone, also what holds up the cloth on
    /// obstacles: how far that yields is then how hard the cloth presses.
    void suit(const IntegratorInfo& info) {
        implicit_ = info.kind == IntegratorKind::implicit;
        supports_ = implicit_ && info.order == 1;
    }

    /// The integrator's step, and what the filter does to it. Where that is anything, the
    /// integrator forgets the steps it keeps: they lead to another place.
    StepReport step(Integrator<Real>& integrator, ClothSystem<Real>& system, double dt,
                    ParticleState<Real>& state) {
        ContactSupports& supports = system.supports();
        supports.list.clear();
        if (!contact_.empty()) {
            contact_.begin_step(state.x);
            if (supports_) contact_.find_supports(dt, state.x, state.v, supports);
        }
        const bool pulled = !implicit_ && !system.grips().empty();
        if (pulled) begin_grips<Real>(system.grips(), std::as_const(state.x).view());
        StepReport report = integrator.step(system, dt, state);
        if (!report.ok()) return report;
        if (pulled) pull_grips(system.grips(), dt, state.x.view(), state.v.view());
        const bool touched =
            !contact_.empty() && contact_.apply(dt, supports, state.x.view(), state.v.view());
        const bool changed = pulled || touched;
        if (changed) integrator.restart();
        return report;
    }

private:
    ObstacleContact<Real> contact_;
    bool implicit_ = false, supports_ = false;
};

}  // namespace weft
