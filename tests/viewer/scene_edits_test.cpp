// Edits of pins, obstacles, fabrics and the start: each gives a scene that a cloth can be built of.
#include "viewer/scene_edits.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <vector>

#include "cloth/cloth_model.h"
#include "support/cloth_scenes.h"
#include "viewer/parameters.h"
#include "weft/simulation.h"

namespace weft::viewer {
namespace {

using Motion = std::vector<PinKeyframe>;
using Particles = std::vector<std::size_t>;

const Motion swing{{0.5, {0.0, 0.0, 0.0}}, {1.0, {0.1, 0.2, 0.3}}};

/// Where every pinned particle is at time t; checks the scene on the way.
std::map<std::size_t, Vec3d> held_at(const SceneDescription& scene, double time = 0.75) {
    check_scene(scene);
    const ClothModel cloth = build_cloth(scene);
    std::map<std::size_t, Vec3d> held;
    for (const Pin& pin : cloth.pins) {
        const Vec3d offset = pin.motion == Pin::no_motion
                                 ? Vec3d{}
                                 : pin_offset(cloth.motions[pin.motion], time).offset;
        held[pin.particle] = pin.rest + offset;
    }
    return held;
}

Particles held(const SceneDescription& scene) {
    Particles particles;
    for (const auto& [particle, place] : held_at(scene)) particles.push_back(particle);
    return particles;
}

// A sheet of 5 x 4: particle 5 row + column, at (column, -row, 0).
SceneDescription sheet(std::vector<PinDescription> pins) {
    SceneDescription scene = test::bare_sheet(5, 4, 4.0, 3.0);
    scene.pins = std::move(pins);
    return scene;
}

bool is_list(const PinDescription& pin) {
    return std::holds_alternative<ParticleSelection>(pin.select);
}

const std::vector<PinSelector> selectors{
    EdgeSelection::top_left,
    EdgeSelection::bottom_right,
    EdgeSelection::left_edge,
    EdgeSelection::right_edge,
    EdgeSelection::top_edge,
    EdgeSelection::bottom_edge,
    ParticleSelection{{7, 3, 7, 12}},
    EverySelection{2, EdgeSelection::top_edge},
    EverySelection{3, EdgeSelection::right_edge},
    BoxSelection{{1.0, -2.0, -0.1}, {2.5, -1.0, 0.1}},
};

TEST(PinToggle, FreesOneParticleOfAnySelectorAndMovesNoOther) {
    for (const PinSelector& select : selectors) {
        for (const Motion& motion : {Motion{}, swing}) {
            const SceneDescription scene = sheet({{select, motion}});
            for (const std::size_t particle : held(scene)) {
                auto expected = held_at(scene);
                expected.erase(particle);
                EXPECT_EQ(held_at(with_pin_toggled(scene, particle, {})), expected) << particle;
            }
        }
    }
}

TEST(PinToggle, PinsAnyFreeParticleAndMovesNoOther) {
    for (const PinSelector& select : selectors) {
        const SceneDescription scene = sheet({{select, swing}});
        for (std::size_t particle = 0; particle < 20; ++particle) {
            auto expected = held_at(scene);
            if (expected.contains(particle)) continue;
            const Vec3d rest = rest_position(scene, particle);
            expected[particle] = rest;
            EXPECT_EQ(held_at(with_pin_toggled(scene, particle, {})), expected) << particle;
            expected[particle] = rest + Vec3d{0.5, 0.25, -1.0};
            for (const double time : {0.0, 0.75, 100.0}) {
                expected = held_at(scene, time);
                expected[particle] = rest + Vec3d{0.5, 0.25, -1.0};
                EXPECT_EQ(held_at(with_pin_toggled(scene, particle, {0.5, 0.25, -1.0}), time),
                          expected);
            }
        }
    }
}

TEST(PinToggle, TwiceIsAsBefore) {
    for (const PinSelector& select : selectors) {
        const SceneDescription scene = sheet({{select, {}}});
        for (std::size_t particle = 0; particle < 20; ++particle) {
            const SceneDescription once = with_pin_toggled(scene, particle, {});
            EXPECT_EQ(held_at(with_pin_toggled(once, particle, {})), held_at(scene)) << particle;
        }
    }
}

TEST(PinToggle, WritesOutSelectorsOnlyWhereItMust) {
    const SceneDescription scene =
        sheet({{EdgeSelection::left_edge, {}}, {EdgeSelection::right_edge, swing}});
    const SceneDescription pinned = with_pin_toggled(scene, 7, {});
    ASSERT_EQ(pinned.pins.size(), 3U);
    EXPECT_FALSE(is_list(pinned.pins[0]) || is_list(pinned.pins[1]));
    EXPECT_EQ(std::get<ParticleSelection>(pinned.pins[2].select).particles, (Particles{7}));
    EXPECT_TRUE(pinned.pins[2].motion.empty());
    const SceneDescription freed = with_pin_toggled(pinned, 9, {});
    ASSERT_EQ(freed.pins.size(), 3U);
    EXPECT_FALSE(is_list(freed.pins[0]));
    EXPECT_EQ(std::get<ParticleSelection>(freed.pins[1].select).particles, (Particles{4, 14, 19}));
    EXPECT_EQ(freed.pins[1].motion.size(), 2U);
}

TEST(PinToggle, GathersPinsThatRestInOneList) {
    SceneDescription scene = sheet({});
    for (const std::size_t particle : {3U, 17U, 8U}) scene = with_pin_toggled(scene, particle, {});
    ASSERT_EQ(scene.pins.size(), 1U);
    EXPECT_EQ(std::get<ParticleSelection>(scene.pins[0].select).particles, (Particles{3, 17, 8}));
    // 0.5 m aside is a place of its own; there, another one may join.
    scene = with_pin_toggled(scene, 1, {0.5, 0.0, 0.0});
    scene = with_pin_toggled(scene, 2, {0.5, 0.0, 0.0});
    ASSERT_EQ(scene.pins.size(), 2U);
    EXPECT_EQ(held_at(scene)[2], (Vec3d{2.5, 0.0, 0.0}));
}

TEST(PinToggle, FreesAParticleThatSeveralPinsHold) {
    const SceneDescription scene = sheet({{EdgeSelection::top_left, {}},
                                          {EdgeSelection::left_edge, {}},
                                          {EdgeSelection::top_edge, {}},
                                          {ParticleSelection{{0, 7}}, {}}});
    const SceneDescription freed = with_pin_toggled(scene, 0, {});
    EXPECT_EQ(held(freed), (Particles{1, 2, 3, 4, 5, 7, 10, 15}));
    EXPECT_EQ(freed.pins.size(), 3U);  // of "top-left" nothing is left
}

TEST(PinToggle, FreesTheLastPin) {
    SceneDescription scene = sheet({{ParticleSelection{{7}}, swing}});
    scene.forces.gravity = {0.0, -9.81, 0.0};
    scene.output.settle = true;
    const SceneDescription freed = with_pin_toggled(scene, 7, {});
    EXPECT_TRUE(freed.pins.empty());
    EXPECT_FALSE(freed.output.settle);  // what nothing holds comes to no rest
    EXPECT_TRUE(held(freed).empty());
}

TEST(PinToggle, WorksOnTheSmallestSheet) {
    SceneDescription scene = test::bare_sheet(2, 2);
    scene.pins = {{EdgeSelection::left_edge, {}}};
    EXPECT_EQ(held(scene), (Particles{0, 2}));
    EXPECT_EQ(held(with_pin_toggled(scene, 2, {})), (Particles{0}));
    EXPECT_EQ(held(with_pin_toggled(scene, 3, {})), (Particles{0, 2, 3}));
    for (std::size_t p = 0; p < 4; ++p) scene = with_pin_toggled(scene, p, {});
    EXPECT_EQ(held(scene), (Particles{1, 3}));
}

TEST(PinToggle, WorksOnMeshes) {
    SceneDescription scene = sheet({{ParticleSelection{{0, 4}}, {}},
                                    {BoxSelection{{-0.1, -3.1, -0.1}, {4.1, -2.9, 0.1}}, swing}});
    test::make_mesh_of_grid(scene);
    EXPECT_EQ(held(scene), (Particles{0, 4, 15, 16, 17, 18, 19}));
    const SceneDescription freed = with_pin_toggled(scene, 17, {});
    EXPECT_EQ(held(freed), (Particles{0, 4, 15, 16, 18, 19}));
    EXPECT_EQ(held_at(freed)[16], held_at(scene)[16]);
    EXPECT_EQ(held(with_pin_toggled(freed, 7, {})), (Particles{0, 4, 7, 15, 16, 18, 19}));
    EXPECT_EQ(rest_position(scene, 7), (Vec3d{2.0, -1.0, 0.0}));
}

TEST(PinToggle, LeavesTheShippedScenesBuildable) {
    for (const ShippedScene& shipped : shipped_scenes()) {
        const SceneDescription scene = load_scene(shipped.name);
        const Particles before = held(scene);
        SceneDescription all_free = scene;
        for (const std::size_t particle : before) {
            all_free = with_pin_toggled(all_free, particle, {});
        }
        EXPECT_TRUE(all_free.pins.empty()) << shipped.name;
        EXPECT_EQ(held(with_pin_toggled(scene, 1234, {})).size(), before.size() + 1);
    }
}

TEST(PinToggle, OfAParticleThatDoesNotExistChangesNothing) {
    const SceneDescription scene = sheet({{EdgeSelection::left_edge, {}}});
    EXPECT_EQ(held(with_pin_toggled(scene, 20, {})), held(scene));
}

TEST(PinMove, TakesOneParticleAlongForGood) {
    const Vec3d shift{0.25, -0.5, 1.0};
    for (const PinSelector& select : selectors) {
        for (const Motion& motion : {Motion{}, swing}) {
            const SceneDescription scene = sheet({{select, motion}});
            for (const std::size_t particle : held(scene)) {
                const SceneDescription moved = with_pin_moved(scene, particle, shift);
                for (const double time : {0.0, 0.7, 1.0, 50.0}) {
                    auto expected = held_at(scene, time);
                    const auto now = held_at(moved, time);
                    ASSERT_TRUE(now.contains(particle));
                    EXPECT_LT(length(now.at(particle) - expected.at(particle) - shift), 1e-12);
                    expected[particle] = now.at(particle);
                    EXPECT_EQ(now, expected);
                }
            }
        }
    }
}

TEST(PinMove, ManySmallShiftsMakeOnePin) {
    SceneDescription scene = sheet({{EdgeSelection::left_edge, {}}});
    for (int n = 0; n < 64; ++n) scene = with_pin_moved(scene, 5, {1.0 / 64, 0.0, 0.0});
    ASSERT_EQ(scene.pins.size(), 2U);
    ASSERT_EQ(scene.pins[1].motion.size(), 1U);
    EXPECT_EQ(scene.pins[1].motion[0].offset, (Vec3d{1.0, 0.0, 0.0}));
    EXPECT_EQ(held_at(scene)[5], (Vec3d{1.0, -1.0, 0.0}));
}

TEST(PinMove, LeavesFreeParticlesFree) {
    const SceneDescription scene = sheet({{EdgeSelection::left_edge, {}}});
    EXPECT_EQ(held_at(with_pin_moved(scene, 7, {1, 0, 0})), held_at(scene));
    EXPECT_EQ(held_at(with_pin_moved(scene, 999, {1, 0, 0})), held_at(scene));
}

TEST(Obstacles, AreAddedMovedAndTakenAway) {
    SceneDescription scene = sheet({});
    scene = with_obstacle(scene, {SphereObstacle{{1, 2, 3}, 0.5}, 0.3, 0.01});
    scene = with_obstacle(scene, {PlaneObstacle{{0, 1, 0}, {0, 1, 0}}, 0.4, 0.005});
    ASSERT_EQ(scene.obstacles.size(), 2U);
    scene = with_obstacle_moved(scene, 0, {0.5, 0.0, -1.0});
    scene = with_obstacle_moved(scene, 1, {0.0, 0.5, 0.0});
    scene = with_obstacle_moved(scene, 2, {9, 9, 9});
    EXPECT_EQ(std::get<SphereObstacle>(scene.obstacles[0].shape).centre, (Vec3d{1.5, 2.0, 2.0}));
    EXPECT_EQ(scene.obstacles[0].friction, 0.3);
    EXPECT_EQ(std::get<PlaneObstacle>(scene.obstacles[1].shape).point, (Vec3d{0.0, 1.5, 0.0}));
    EXPECT_EQ(std::get<PlaneObstacle>(scene.obstacles[1].shape).normal, (Vec3d{0.0, 1.0, 0.0}));
    EXPECT_EQ(without_obstacle(scene, 2).obstacles.size(), 2U);
    scene = without_obstacle(scene, 0);
    ASSERT_EQ(scene.obstacles.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<PlaneObstacle>(scene.obstacles[0].shape));
    check_scene(scene);
}

TEST(Method, IsAllThatChanges) {
    SceneDescription scene;
    scene.integrator.time_step = 0.002;
    scene.integrator.precision = Precision::f64;
    const SceneDescription other = with_method(scene, "rk4");
    EXPECT_EQ(other.integrator.method, "rk4");
    EXPECT_EQ(other.integrator.time_step, 0.002);
    EXPECT_EQ(other.integrator.precision, Precision::f64);
}

TEST(Fabric, BringsItsMassAndItsSpringsPerWidth) {
    SceneDescription scene = load_scene("sheet");  // of springs and particles of 1 kg
    const SceneDescription denim = with_fabric(scene, "denim");
    EXPECT_EQ(denim.material.fabric, "denim");
    EXPECT_EQ(denim.material.mass_per_area, 0.4);
    EXPECT_FALSE(denim.material.particle_mass);
    EXPECT_EQ(denim.material.stiffness_per, StiffnessPer::width);
    EXPECT_EQ(denim.material.structural.stiffness, 4000.0);
    EXPECT_EQ(denim.material.bend.damping, 0.02);
    EXPECT_EQ(with_fabric(scene, "chainmail").material.fabric, scene.material.fabric);
}

TEST(Wind, StartsStillAndKeepsWhatThereIs) {
    const SceneDescription still = with_wind(sheet({}), true);
    ASSERT_TRUE(still.wind);
    EXPECT_EQ(still.wind->velocity, Vec3d{});
    EXPECT_GT(still.wind->air_density, 1.0);
    EXPECT_EQ(with_wind(SceneDescription{}, true).wind->velocity, (Vec3d{4.0, 0.0, 1.4}));
    EXPECT_FALSE(with_wind(SceneDescription{}, false).wind);
    EXPECT_EQ(with_gusts(SceneDescription{}, false).wind->gust.model, GustModel::none);
    EXPECT_EQ(with_gusts(still, true).wind->gust.model, GustModel::coefficient);
    EXPECT_FALSE(with_gusts(sheet({}), true).wind);
}

TEST(Resolution, KeepsWhatIsHeldWhereItIs) {
    const SceneDescription curtain = load_scene("curtain");  // 81 x 60, rings every eighth column
    const SceneDescription coarse = with_resolution(curtain, {41, 30});
    EXPECT_EQ(held(coarse), (Particles{0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40}));
    for (const double time : {0.0, 5.0}) {
        const auto before = held_at(curtain, time), after = held_at(coarse, time);
        for (std::size_t ring = 0; ring <= 10; ++ring) {
            EXPECT_LT(length(after.at(4 * ring) - before.at(8 * ring)), 1e-12);
        }
    }
    EXPECT_EQ(held(with_resolution(curtain, {161, 60})).back(), 160U);
    // Rings that meet become one.
    EXPECT_EQ(held(with_resolution(curtain, {3, 3})), (Particles{0, 1, 2}));
    EXPECT_EQ(held(with_resolution(curtain, {2, 2})), (Particles{0, 1}));
}

TEST(Resolution, SpacesEveryNthParticleAnew) {
    const SceneDescription top = sheet({{EverySelection{2, EdgeSelection::top_edge}, {}}});
    EXPECT_EQ(held(with_resolution(top, {9, 4})), (Particles{0, 4, 8}));
    EXPECT_EQ(held(with_resolution(top, {3, 4})), (Particles{0, 1, 2}));
    const SceneDescription side = sheet({{EverySelection{3, EdgeSelection::left_edge}, {}}});
    EXPECT_EQ(held(with_resolution(side, {5, 7})), (Particles{0, 30}));
}

TEST(Resolution, LeavesAParticleToTheEdgeItFallsOn) {
    const SceneDescription scene =
        sheet({{ParticleSelection{{1, 8}}, swing}, {EdgeSelection::left_edge, {}}});
    const SceneDescription coarse = with_resolution(scene, {2, 2});
    EXPECT_EQ(held(coarse), (Particles{0, 1, 2}));
    EXPECT_EQ(held_at(coarse, 9.0)[0], (Vec3d{0.0, 0.0, 0.0}));
}

TEST(Resolution, ThatIsRefusedLeavesPinsAlone) {
    const SceneDescription scene = sheet({{ParticleSelection{{19}}, {}}});
    for (const std::array<int, 2> bad : {std::array{1, 4}, {0, 0}, {-5, 3}, {2'000'000'000, 9}}) {
        const SceneDescription changed = with_resolution(scene, bad);
        EXPECT_EQ(changed.cloth.grid.resolution, bad);
        EXPECT_EQ(std::get<ParticleSelection>(changed.pins[0].select).particles, (Particles{19}));
    }
}

TEST(Start, HoldsWhatIsOnTheScreen) {
    SceneDescription scene = sheet({{EdgeSelection::left_edge, swing}});
    scene.start.state_path = "/tmp/old.npy";
    scene.start.state = std::make_shared<const ClothState>(
        ClothState{std::vector<Vec3d>(20), std::vector<Vec3d>(20)});
    scene.output.settle = true;
    const std::vector<Vec3d> positions(20, {1.0, 2.0, 3.0}), velocities(20, {0.5, 0.0, 0.0});
    const SceneDescription start = with_start(scene, positions, velocities, 0.75);
    ASSERT_NE(start.start.state, nullptr);
    EXPECT_EQ(start.start.state->positions, positions);
    EXPECT_EQ(start.start.state->velocities, velocities);
    EXPECT_EQ(start.start.time, 0.75);
    EXPECT_EQ(start.start.state_path, "");
    EXPECT_FALSE(start.output.settle);
    EXPECT_EQ(held_at(start), held_at(scene));
}

}  // namespace
}  // namespace weft::viewer
