// The same bits whether or not anything looks at the cloth between the steps of a frame: unseen,
// wide sheets move in another order in memory (forces/grid_strips.h).
#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "weft/instruction_set.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

// Wide enough for strips in every instruction set, with enough steps a frame.
SceneDescription wide_flag(const char* method, Precision precision, bool pins_move) {
    SceneDescription scene = bare_sheet(530, 13, 5.29, 0.12);
    add_dashpots(scene, 1e-4);
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.wind = WindDescription{};
    scene.pins = {{EdgeSelection::top_left, {}},
                  {EdgeSelection::top_right, {{0.0, {}}, {1.0, {0.1, 0.0, 0.2}}}}};
    if (!pins_move) scene.pins.back().motion.clear();  // and two steps are one sweep
    scene.integrator.method = method;
    scene.integrator.precision = precision;
    scene.output.frames_per_second = 300.0;
    scene.integrator.time_step = 1.0 / (160 * scene.output.frames_per_second);
    return scene;
}

std::uint64_t hash_after_a_frame(const SceneDescription& scene) {
    Simulation simulation(scene);
    const FrameReport report = simulation.advance_frame();
    EXPECT_TRUE(report.ok()) << report.divergence->message;
    return simulation.state_hash();
}

TEST(Watched, ChangesNoBit) {
    for (const std::string_view set : instruction_sets()) {
        if (set == "scalar") continue;  // it has no strips
        use_instruction_set(set);
        for (const char* method : {"symplectic-euler", "velocity-verlet", "yoshida4"}) {
            for (const Precision precision : {Precision::f32, Precision::f64}) {
                SCOPED_TRACE(std::string(set) + " " + method);
                const SceneDescription scene =
                    wide_flag(method, precision, precision == Precision::f64);
                const std::uint64_t hash = hash_after_a_frame(scene);

                SceneDescription balanced = scene;  // its work is measured step by step
                balanced.output.energy_balance = true;
                EXPECT_EQ(hash_after_a_frame(balanced), hash);

                SceneDescription beside = scene;
                beside.obstacles.push_back({.shape = SphereObstacle{{0.0, -100.0, 0.0}, 1.0}});
                EXPECT_EQ(hash_after_a_frame(beside), hash);
            }
        }
    }
    use_instruction_set(instruction_sets().back());
}

}  // namespace
}  // namespace weft::test
