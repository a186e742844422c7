// Every implicit method at a hundred times the explicit limit, for 300 frames: the shipped sheet
// and flag, and a stiff sheet of 200 x 200 (k = 1e6).
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "support/cloth_scenes.h"
#include "support/methods.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

SceneDescription stiff_sheet() {
    SceneDescription scene = bare_sheet(200, 200);
    scene.material.structural.stiffness = 1e6;
    scene.material.shear.stiffness = 5e5;
    scene.material.bend.stiffness = 1e5;
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.cloth.grid.plane = Plane::xz;
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    return scene;
}

// One step a frame, a hundred times what velocity-verlet could take.
SceneDescription in_long_steps(const std::string& name, std::string_view method) {
    SceneDescription scene = name == "stiff" ? stiff_sheet() : load_scene(name);
    scene.output.formats.clear();
    scene.integrator.method = "velocity-verlet";
    scene.integrator.time_step = 1e-6;
    const double step = 100.0 * Simulation(scene).stable_step("velocity-verlet");
    scene.integrator.method = std::string(method);
    scene.integrator.time_step = step;
    scene.output.frames_per_second = 1.0 / step;
    return scene;
}

// The largest strain an L-stable method may end with: it damps, and the cloth comes near to rest,
// or in the wind to where that holds it. Others keep stiff waves ringing or, as cloth is not
// linear, feed them: their cloth is finite, no more.
double bound(const std::string& scene, std::string_view method) {
    if (method == "implicit-midpoint" || method == "trapezoidal") return Divergence::max_strain;
    if (method == "baraff-witkin" && scene == "flag") return 10.0;
    return scene == "sheet" ? 10.0 : scene == "flag" ? 2.0 : 0.1;
}

using Case = std::tuple<std::string, std::string>;

class Unconditional : public testing::TestWithParam<Case> {};

TEST_P(Unconditional, StaysFinite) {
    const auto& [name, method] = GetParam();
    Simulation simulation(in_long_steps(name, method));
    ASSERT_EQ(simulation.steps_per_frame(), 1u);
    for (int n = 0; n < 300; ++n) {
        const FrameReport report = simulation.advance_frame();
        ASSERT_TRUE(report.ok()) << "frame " << n << ": " << report.divergence->message;
        ASSERT_EQ(report.halvings, 0);
    }
    EXPECT_LT(std::abs(simulation.largest_strain().strain), bound(name, method));
}

std::vector<std::string> implicit_methods() {
    std::vector<std::string> names;
    for (const IntegratorInfo& info : methods_of({IntegratorKind::implicit})) {
        names.emplace_back(info.name);
    }
    return names;
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
    std::string name = std::get<0>(info.param) + "_" + std::get<1>(info.param);
    for (char& c : name) c = c == '-' ? '_' : c;
    return name;
}

// What every compiler, sanitizer and instruction set repeats, and all.
INSTANTIATE_TEST_SUITE_P(Quick, Unconditional,
                         testing::Values(Case{"sheet", "implicit-euler"}, Case{"sheet", "bdf2"},
                                         Case{"sheet", "baraff-witkin"},
                                         Case{"stiff", "implicit-euler"}),
                         case_name);
INSTANTIATE_TEST_SUITE_P(Slow, Unconditional,
                         testing::Combine(testing::Values("sheet", "flag", "stiff"),
                                          testing::ValuesIn(implicit_methods())),
                         case_name);

}  // namespace
}  // namespace weft::test
