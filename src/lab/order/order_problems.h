// The problems that orders are measured on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lab/order/convergence.h"
#include "lab/scene_stretch.h"
#include "weft/integrators.h"
#include "weft/scene.h"

namespace weft::lab {

enum class OrderProblemKind { hanging_masses, moving_sheet, damped_sheet, scene };

struct OrderProblem {
    OrderProblemKind kind = OrderProblemKind::scene;
    std::string key;    ///< of files and trials: "hanging-masses"
    std::string title;  ///< of plots and columns: "masses on springs"
    SceneDescription scene;
    bool damped = false;  ///< forces depend on velocity: methods state another order
    SceneStretch ends{};  ///< its start, its end, and how exact that is

    /// What the method states for it.
    [[nodiscard]] int stated(const IntegratorInfo& info) const {
        return damped ? info.damped_order : info.order;
    }
    /// The three whose solutions are smooth by construction.
    [[nodiscard]] bool smooth() const { return kind != OrderProblemKind::scene; }
    /// What it is, for the report.
    [[nodiscard]] std::string text() const;
};

/// The three smooth problems and the scene, their ends not yet known.
std::vector<OrderProblem> order_problems(const SceneDescription& scene);

/// Whether any force of the scene depends on velocity.
bool has_damping(const SceneDescription& scene);

/// The end of a problem: in closed form, or by the reference.
SceneStretch find_ends(const OrderProblem& problem, bool quick, const Watch& watch);

/// How many steps a method takes over a problem. On a large scene fewer, so that all its flights
/// together take some 15 s at most (`quick`: 2.5 s), by counting steps and not by a clock; none
/// where even three flights would take much longer.
StepCounts step_counts(const OrderProblem& problem, const IntegratorInfo& info,
                       std::size_t particles, bool quick);

/// Errors of no more than this cannot be told from that of the reference, or from what is left of
/// systems that are solved by iteration [m].
double error_floor(double reference_error, const IntegratorInfo& info);

}  // namespace weft::lab
