// check_scene refuses every value out of range and every combination that cannot be, whether the
// scene comes from a file or from a program.
#include "simulation/scene_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "support/scene_errors.h"
#include "weft/error.h"
#include "weft/scene.h"

namespace weft {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Change = std::function<void(SceneDescription&)>;

/// what() of the error that check_scene throws for the flag after a change; empty: none.
std::string refusal(const Change& change) {
    SceneDescription scene;
    change(scene);
    const auto error = test::error_of([&] { check_scene(scene); });
    EXPECT_TRUE(!error || error->kind() == ErrorKind::usage);
    return error ? error->what() : "";
}

/// The key that check_scene names for the flag after a change.
std::string refused_key(const Change& change) {
    SceneDescription scene;
    change(scene);
    const auto error = test::error_of([&] { check_scene(scene); });
    return error ? error->place().key : "";
}

std::shared_ptr<const Mesh> triangle() {
    Mesh mesh;
    mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    mesh.faces = {{.position = {0, 1, 2, 0}}};
    return std::make_shared<const Mesh>(mesh);
}

TEST(CheckScene, AcceptsTheDefaults) {
    EXPECT_EQ(refusal([](SceneDescription&) {}), "");
}

TEST(CheckScene, AcceptsTheEndsOfEveryRange) {
    EXPECT_EQ(refusal([](SceneDescription& s) {
                  s.cloth.grid.resolution = {2, 2};
                  s.material.structural = s.material.shear = s.material.bend = {0.0, 0.0};
                  s.wind->air_density = 0.0;
                  s.wind->gust.spread = 0.0;
                  s.output.duration = 0.0;
                  s.output.formats = {};
                  s.render.size = {16, 8192};
                  s.pins = {{ParticleSelection{{0, 3}}, {}},
                            {EverySelection{1, EdgeSelection::top_edge}, {}}};
              }),
              "");
}

struct BadNumber {
    const char* key;
    void (*set)(SceneDescription&, double);
    std::vector<double> values;
};

class CheckSceneNumbers : public testing::TestWithParam<BadNumber> {};

TEST_P(CheckSceneNumbers, RefusesValuesOutOfRange) {
    for (const double value : GetParam().values) {
        EXPECT_EQ(refused_key([&](SceneDescription& s) { GetParam().set(s, value); }),
                  GetParam().key)
            << value;
    }
}

using S = SceneDescription;
const std::vector<double> not_positive{0.0, -0.0, -1.0, nan, infinity};
const std::vector<double> negative{-1e-300, -1.0, nan, infinity};
const std::vector<double> not_finite{nan, infinity, -infinity};

INSTANTIATE_TEST_SUITE_P(
    Keys, CheckSceneNumbers,
    testing::Values(
        BadNumber{"cloth.size", [](S& s, double v) { s.cloth.grid.size[0] = v; }, not_positive},
        BadNumber{"cloth.size", [](S& s, double v) { s.cloth.grid.size[1] = v; }, not_positive},
        BadNumber{"cloth.origin", [](S& s, double v) { s.cloth.grid.origin.z = v; }, not_finite},
        BadNumber{"material.mass_per_area", [](S& s, double v) { s.material.mass_per_area = v; },
                  not_positive},
        BadNumber{"material.particle_mass", [](S& s, double v) { s.material.particle_mass = v; },
                  not_positive},
        BadNumber{"material.structural.stiffness",
                  [](S& s, double v) { s.material.structural.stiffness = v; }, negative},
        BadNumber{"material.structural.damping",
                  [](S& s, double v) { s.material.structural.damping = v; }, negative},
        BadNumber{"material.shear.stiffness",
                  [](S& s, double v) { s.material.shear.stiffness = v; }, negative},
        BadNumber{"material.shear.damping", [](S& s, double v) { s.material.shear.damping = v; },
                  negative},
        BadNumber{"material.bend.stiffness", [](S& s, double v) { s.material.bend.stiffness = v; },
                  negative},
        BadNumber{"material.bend.damping", [](S& s, double v) { s.material.bend.damping = v; },
                  negative},
        BadNumber{"obstacles[1].sphere.centre",
                  [](S& s, double v) {
                      s.obstacles = {{}, {SphereObstacle{{0.0, v, 0.0}, 0.1}}};
                  },
                  not_finite},
        BadNumber{"obstacles[1].sphere.radius",
                  [](S& s, double v) {
                      s.obstacles = {{}, {SphereObstacle{{}, v}}};
                  },
                  not_positive},
        BadNumber{"obstacles[0].plane.point",
                  [](S& s, double v) {
                      s.obstacles = {{PlaneObstacle{{v, 0.0, 0.0}}}};
                  },
                  not_finite},
        BadNumber{"obstacles[0].plane.normal",
                  [](S& s, double v) {
                      s.obstacles = {{PlaneObstacle{{}, {0.0, 0.0, v}}}};
                  },
                  {0.0, -0.0, nan, infinity}},
        BadNumber{"obstacles[0].friction",
                  [](S& s, double v) {
                      s.obstacles = {{{}, v}};
                  },
                  {-1e-300, 10.1, nan, infinity}},
        BadNumber{"obstacles[0].gap",
                  [](S& s, double v) {
                      s.obstacles = {{{}, 0.4, v}};
                  },
                  {-1e-300, 1.001, nan, infinity}},
        BadNumber{"start.time", [](S& s, double v) { s.start.time = v; }, negative},
        BadNumber{"forces.gravity", [](S& s, double v) { s.forces.gravity.y = v; }, not_finite},
        BadNumber{"forces.damping", [](S& s, double v) { s.forces.damping = v; }, negative},
        BadNumber{"wind.velocity", [](S& s, double v) { s.wind->velocity.x = v; }, not_finite},
        BadNumber{"wind.air_density", [](S& s, double v) { s.wind->air_density = v; }, negative},
        BadNumber{"wind.drag", [](S& s, double v) { s.wind->drag = v; }, negative},
        BadNumber{"wind.skin_friction", [](S& s, double v) { s.wind->skin_friction = v; },
                  negative},
        BadNumber{"wind.gust.spread",
                  [](S& s, double v) { s.wind->gust.spread = v; },
                  {-0.1, 1.0, nan, infinity}},
        BadNumber{"wind.gust.period", [](S& s, double v) { s.wind->gust.period = v; },
                  not_positive},
        BadNumber{"integrator.time_step", [](S& s, double v) { s.integrator.time_step = v; },
                  not_positive},
        BadNumber{"output.duration", [](S& s, double v) { s.output.duration = v; }, negative},
        BadNumber{"output.frames_per_second",
                  [](S& s, double v) { s.output.frames_per_second = v; }, not_positive},
        BadNumber{"render.field_of_view",
                  [](S& s, double v) { s.render.field_of_view = v; },
                  {0.0, 180.0, -1.0, nan, infinity}},
        BadNumber{"render.camera", [](S& s, double v) { s.render.camera = Vec3d{v, 0.0, 0.0}; },
                  not_finite},
        BadNumber{"render.target", [](S& s, double v) { s.render.target = Vec3d{0.0, v, 0.0}; },
                  not_finite}),
    [](const auto& number) {
        std::string name = number.param.key;
        for (char& c : name) {
            if (c == '.' || c == '[' || c == ']') c = '_';
        }
        return name + "_" + std::to_string(number.index);
    });

TEST(CheckScene, SaysValueAndWhatIsAllowed) {
    EXPECT_EQ(refusal([](S& s) {
                  s.cloth.grid.resolution = {1, 41};
              }),
              "cloth.resolution: [1, 41] is not allowed: two integers (columns, rows), each at "
              "least 2");
    EXPECT_EQ(
        refusal([](S& s) { s.integrator.method = "rk44"; }),
        "integrator.method: \"rk44\" is not allowed: auto, forward-euler, symplectic-euler, "
        "verlet, "
        "time-corrected-verlet, velocity-verlet, rk2, rk3, rk4, yoshida4, forest-ruth, bosh3, "
        "dopri5, implicit-euler, implicit-midpoint, trapezoidal, bdf2, tr-bdf2, sdirk2, "
        "baraff-witkin, projective-dynamics, xpbd, vbd (did you mean rk4?)");
    EXPECT_EQ(refusal([](S& s) { s.integrator.tolerance = -1.0; }),
              "integrator.tolerance: -1 is not allowed: a finite number above 0, or \"auto\"");
    EXPECT_EQ(refusal([](S& s) { s.integrator.iterations = 100'001; }),
              "integrator.iterations: 100001 is not allowed: an integer from 1 to 100000, or "
              "\"auto\"");
    EXPECT_EQ(refusal([](S& s) { s.material.fabric = "jute"; }),
              "material.fabric: \"jute\" is not allowed: silk, cotton, wool, denim, leather, flag");
}

TEST(CheckScene, RefusesTooManyObstaclesAndRestAmongThem) {
    const auto with = [](std::size_t count) {
        return [count](S& s) { s.obstacles.resize(count); };
    };
    EXPECT_EQ(refusal(with(64)), "");
    EXPECT_EQ(refusal(with(65)), "obstacles: a list of 65 is not allowed: at most 64");
    EXPECT_EQ(refusal([](S& s) {
                  s.obstacles.resize(1);
                  s.output.settle = true;
              }),
              "output.settle: true is not allowed: false with [[obstacles]]; what rests on them is "
              "not found yet");
}

TEST(CheckScene, RefusesStatesThatAreNotOfTheCloth) {
    const auto with = [](std::size_t positions, std::size_t velocities, double value) {
        return [=](S& s) {
            ClothState state{std::vector<Vec3d>(positions), std::vector<Vec3d>(velocities)};
            if (velocities > 7) state.velocities[7].z = value;
            s.start.state = std::make_shared<ClothState>(state);
        };
    };
    EXPECT_EQ(refusal(with(2501, 2501, 1.0)), "");
    EXPECT_EQ(refusal(with(2500, 2500, 0.0)),
              "start.state: a state of 2500 particles is not allowed: 2501 in a grid of 61 x 41");
    EXPECT_EQ(refusal(with(2501, 2500, 0.0)),
              "start.state: a state of 2501 positions and 2500 velocities is not allowed: as many "
              "of both");
    EXPECT_EQ(refusal(with(2501, 2501, nan)),
              "start.state: position [0, 0, 0] and velocity [0, 0, nan] of particle 7 is not "
              "allowed: finite numbers");
    EXPECT_EQ(refused_key([](S& s) { s.start.state_path = "never loaded.npy"; }), "start.state");
}

TEST(CheckScene, RefusesPinsThatPickNothingSensible) {
    const auto with_pin = [](const PinSelector& selector) {
        return [selector](S& s) { s.pins = {PinDescription{}, {selector, {}}}; };
    };
    EXPECT_EQ(refused_key(with_pin(ParticleSelection{{}})), "pins[1].select");
    EXPECT_EQ(refusal(with_pin(ParticleSelection{{2501}})),
              "pins[1].select: particle 2501 is not allowed: 0 to 2500 in a grid of 61 x 41");
    EXPECT_EQ(refusal(with_pin(ParticleSelection{{2500}})), "");
    EXPECT_EQ(refused_key(with_pin(EverySelection{0, EdgeSelection::top_edge})), "pins[1].select");
    EXPECT_EQ(refused_key(with_pin(EverySelection{1, EdgeSelection::top_left})), "pins[1].select");
    EXPECT_EQ(refused_key(with_pin(BoxSelection{{0, 1, 0}, {1, 0, 0}})), "pins[1].select");
    EXPECT_EQ(refused_key(with_pin(BoxSelection{{0, nan, 0}, {1, 0, 0}})), "pins[1].select");
    EXPECT_EQ(refusal(with_pin(BoxSelection{{0, 0, 0}, {0, 0, 0}})), "");
}

TEST(CheckScene, RefusesKeyframesOutOfOrder) {
    const auto with_motion = [](const std::vector<PinKeyframe>& motion) {
        return [motion](S& s) { s.pins[0].motion = motion; };
    };
    EXPECT_EQ(refused_key(with_motion({{1.0, {}}, {1.0, {}}})), "pins[0].motion[1].time");
    EXPECT_EQ(refused_key(with_motion({{nan, {}}})), "pins[0].motion[0].time");
    EXPECT_EQ(refused_key(with_motion({{0.0, {}}, {1.0, {0.0, infinity, 0.0}}})),
              "pins[0].motion[1].offset");
    EXPECT_EQ(refusal(with_motion({{-1.0, {}}, {0.0, {}}})), "");
}

TEST(CheckScene, RefusesWhatOnlyAGridHasForAMesh) {
    const auto on_mesh = [](const Change& change) {
        return [change](S& s) {
            s.cloth.mesh = triangle();
            s.cloth.mesh_path = "triangle.obj";
            s.pins = {{ParticleSelection{{0}}, {}}};
            change(s);
        };
    };
    EXPECT_EQ(refusal(on_mesh([](S&) {})), "");
    EXPECT_EQ(refused_key(on_mesh([](S& s) { s.pins = {PinDescription{}}; })), "pins[0].select");
    EXPECT_EQ(refused_key(on_mesh([](S& s) {
                  s.pins = {{EverySelection{2, EdgeSelection::top_edge}, {}}};
              })),
              "pins[0].select");
    EXPECT_EQ(refused_key(on_mesh([](S& s) { s.material.bend_layout = BendLayout::border; })),
              "material.bend.layout");
    // The grid of the description is not looked at.
    EXPECT_EQ(refusal(on_mesh([](S& s) { s.cloth.grid.size = {nan, nan}; })), "");
    EXPECT_EQ(refused_key([](S& s) { s.cloth.mesh_path = "never loaded"; }), "cloth.mesh");
}

TEST(CheckScene, RefusesRunsWithoutEnd) {
    EXPECT_EQ(refused_key([](S& s) { s.output.duration = 1e8; }), "output.duration");
    EXPECT_EQ(refused_key([](S& s) { s.integrator.time_step = 1e-12; }), "integrator.time_step");
}

TEST(CheckScene, RefusesPicturesThatCannotBeDrawn) {
    for (const std::array<int, 2> size : {std::array{1281, 720}, std::array{14, 720},
                                          std::array{1280, 8194}, std::array{-1280, 720}}) {
        EXPECT_EQ(refused_key([&](S& s) { s.render.size = size; }), "render.size");
    }
    EXPECT_EQ(refused_key([](S& s) {
                  s.render.camera = s.render.target = Vec3d{1.0, 2.0, 3.0};
              }),
              "render.target");
}

TEST(CheckScene, RefusesNamesOfSeveralLines) {
    EXPECT_EQ(refused_key([](S& s) { s.name = ""; }), "name");
    EXPECT_EQ(refused_key([](S& s) { s.name = "two\nlines"; }), "name");
    EXPECT_EQ(refusal([](S& s) { s.name = "Fahne im Wind, \xc3\xa4hnlich"; }), "");
}

TEST(SceneMemory, IsEstimatedByParticlesAndFrames) {
    SceneDescription scene;
    scene.cloth.grid.resolution = {100, 200};
    scene.output.formats = {"pc2"};
    EXPECT_DOUBLE_EQ(estimate_memory(scene), 20000.0 * 550.0);
    scene.output.formats = {"pc2", "glb"};
    scene.output.duration = 1.0;
    scene.output.frames_per_second = 10.0;
    EXPECT_DOUBLE_EQ(estimate_memory(scene), 20000.0 * (550.0 + 11 * 24.0));
    scene.output.duration = 1000.0;
    EXPECT_DOUBLE_EQ(estimate_memory(scene), 20000.0 * (550.0 + 250 * 24.0));
    scene.cloth.mesh = triangle();
    EXPECT_DOUBLE_EQ(particle_estimate(scene), 3.0);
}

TEST(SceneMemory, BeyondTheMachineIsRefusedWithTheEstimate) {
    SceneDescription scene;
    scene.cloth.grid.resolution = {60000, 60000};
    scene.output.formats = {};
    const auto error = test::error_of([&] { check_scene(scene); });
    ASSERT_TRUE(error);
    EXPECT_STREQ(error->what(),
                 "cloth.resolution: [60000, 60000] is not allowed: 3600000000 particles take about "
                 "1844.0 GiB, more than this machine has");
    EXPECT_TRUE(error->detail().starts_with("This machine has "));
    EXPECT_GT(machine_memory(), 1e8);
}

TEST(SceneMemory, ParticlesAreNumberedIn32Bits) {
    SceneDescription scene;
    scene.cloth.grid.resolution = {std::numeric_limits<int>::max(),
                                   std::numeric_limits<int>::max()};
    const auto error = test::error_of([&] { check_scene(scene); });
    ASSERT_TRUE(error);
    EXPECT_STREQ(error->what(),
                 "cloth.resolution: [2147483647, 2147483647] is not allowed: at most 4294967294 "
                 "particles, as they are numbered in 32 bits");
}

TEST(SceneFrames, AreDurationTimesRateRounded) {
    SceneDescription scene;
    EXPECT_EQ(scene.frame_count(), 240U);
    scene.output.duration = 0.1;
    scene.output.frames_per_second = 24.0;
    EXPECT_EQ(scene.frame_count(), 2U);
    scene.output.duration = 0.0;
    EXPECT_EQ(scene.frame_count(), 0U);
}

}  // namespace
}  // namespace weft
