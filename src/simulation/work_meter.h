// Work over time.
#pragma once

#include "weft/measures.h"

namespace weft {

/// Integrates powers over steps by the trapezoidal rule.
class WorkMeter {
public:
    /// @param power measures the present one; only where it is not known from the last step.
    template <typename Power>
    void begin(const Power& power) {
        if (!known_) last_ = power();
        known_ = true;
    }

    /// @param power as a step of `dt` ended.
    void add(double dt, const Work& power) {
        const double half = 0.5 * dt;
        work_.dashpots += half * (last_.dashpots + power.dashpots);
        work_.drag += half * (last_.drag + power.drag);
        work_.air += half * (last_.air + power.air);
        work_.pins += half * (last_.pins + power.pins);
        last_ = power;
    }

    /// The state was changed, or is of a step that was not measured.
    void forget_power() { known_ = false; }

    void set_work(const Work& work) {
        work_ = work;
        known_ = false;
    }
    [[nodiscard]] const Work& work() const { return work_; }

private:
    Work work_, last_;
    bool known_ = false;
};

}  // namespace weft
