#include "lab/order/order_problems.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/order/test_problems.h"
#include "lab/reference.h"

namespace weft::lab {

namespace {

constexpr double sheet_tolerance = 1e-14;  // of its reference [m]
constexpr double exact_to = 1e-14;         // the closed form in double [m]

bool costly(const IntegratorInfo& info) {
    return info.kind == IntegratorKind::implicit || info.kind == IntegratorKind::by_springs;
}

SceneStretch hanging_ends(Specimen& specimen) {
    SceneStretch ends;
    ends.start = hanging_solution(specimen, 0.0);
    ends.end = hanging_solution(specimen, hanging_end_time);
    ends.reference_error = exact_to;
    return ends;
}

SceneStretch sheet_ends(Specimen& specimen, const Watch& watch) {
    SceneStretch ends;
    ends.start = specimen.start();
    const Reference reference =
        reference_solution(specimen, ends.start, moving_end_time, sheet_tolerance, watch);
    ends.end = reference.state;
    ends.reference_error = std::max(reference.error, exact_to);
    return ends;
}

std::string scene_text(const OrderProblem& problem) {
    const SceneStretch& ends = problem.ends;
    if (!ends.failure.empty()) {
        return fmt::format("The scene itself could not be measured on: {}.", ends.failure);
    }
    std::string text = fmt::format(
        "The scene itself: {}, a state in motion that `rk4` came to, and 8 times the stable step "
        "of "
        "{:.3g} s long, so short that no wave breaks and errors do not grow by themselves. The "
        "particles move by {:.2g} m (rms). The reference is exact to {:.1g} m.",
        stretch_text(ends), ends.limit, ends.motion, ends.reference_error);
    if (problem.scene.wind) {
        text += fmt::format(
            " No draw of the gusts and no keyframe of a pin falls into it. While it lasts the air "
            "meets {} of the {} triangles edge-on, where its force has a kink.",
            ends.edge_on, ends.triangles);
    }
    return text;
}

}  // namespace

std::string OrderProblem::text() const {
    switch (kind) {
        case OrderProblemKind::hanging_masses:
            return "Masses on springs: two masses of 1 kg fall, each on a vertical spring of 25 "
                   "N/m. The solution is a cosine, known to the last digit; 1.1 s are flown, 5.5 "
                   "radians of the swing.";
        case OrderProblemKind::moving_sheet:
            return fmt::format(
                "A smooth cloth: 6 x 6 particles in gravity, one corner held, one moved aside "
                "smoothly, over 0.37 s. The reference is exact to {:.1g} m.",
                ends.reference_error);
        case OrderProblemKind::damped_sheet:
            return fmt::format(
                "The same cloth with dashpots, drag and wind: forces depend on velocity, and some "
                "methods state a lower order for that. The reference is exact to {:.1g} m.",
                ends.reference_error);
        case OrderProblemKind::scene:
            break;
    }
    return scene_text(*this);
}

bool has_damping(const SceneDescription& scene) {
    const MaterialDescription& material = scene.material;
    return scene.forces.damping > 0.0 || (scene.wind && scene.wind->air_density > 0.0) ||
           material.structural.damping > 0.0 || material.shear.damping > 0.0 ||
           material.bend.damping > 0.0;
}

std::vector<OrderProblem> order_problems(const SceneDescription& scene) {
    using Kind = OrderProblemKind;
    return {{Kind::hanging_masses, "hanging-masses", "masses on springs", hanging_masses(), false},
            {Kind::moving_sheet, "moving-sheet", "smooth cloth", moving_sheet(false), false},
            {Kind::damped_sheet, "damped-sheet", "damped cloth in wind", moving_sheet(true), true},
            {Kind::scene, "scene", "the scene", scene, has_damping(scene)}};
}

SceneStretch find_ends(const OrderProblem& problem, bool quick, const Watch& watch) {
    Specimen specimen(problem.scene);
    switch (problem.kind) {
        case OrderProblemKind::hanging_masses:
            return hanging_ends(specimen);
        case OrderProblemKind::moving_sheet:
        case OrderProblemKind::damped_sheet:
            return sheet_ends(specimen, watch);
        case OrderProblemKind::scene:
            break;
    }
    return find_scene_stretch(specimen, quick, watch);
}

namespace {

// What a step takes for one particle, roughly [microseconds].
double step_work(const IntegratorInfo& info) {
    if (info.name == "projective-dynamics") return 15.0;
    if (info.name == "vbd") return 10.0;
    if (info.name == "baraff-witkin") return 0.5;
    return costly(info) ? 2.5 : 0.05;
}

}  // namespace

StepCounts step_counts(const OrderProblem& problem, const IntegratorInfo& info,
                       std::size_t particles, bool quick) {
    const bool halfway = info.order >= 4;
    if (problem.smooth()) {
        if (costly(info)) return {32, quick ? 512u : 2048u, halfway};
        return {32, quick ? 2048u : 4096u, halfway};
    }
    StepCounts counts{16, costly(info) ? (quick ? 128u : 256u) : (quick ? 256u : 512u), halfway};
    const double bound = quick ? 2.5e6 : 1.5e7;
    const auto work = [&] {
        return 2.0 * static_cast<double>(counts.most * particles) * step_work(info);
    };
    while (counts.most > 64 && work() > bound) counts.most /= 2;
    if (work() > bound) counts = {8, 32, halfway};
    if (work() > (quick ? bound : 3.0 * bound)) counts = {};
    return counts;
}

double error_floor(double reference_error, const IntegratorInfo& info) {
    constexpr double clear = 20.0;      // so far above, the reference changes a slope little
    constexpr double unsolved = 5e-12;  // [m]
    return std::max(clear * reference_error, costly(info) ? unsolved : 0.0);
}

}  // namespace weft::lab
