// Keys set on the command line.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/recording.h"
#include "support/scene_errors.h"
#include "weft/scene.h"

namespace weft {
namespace {

const std::string towel = R"(version = 1
[cloth]
size = [0.7, 1.0]
resolution = [8, 11]
[material]
mass_per_area = 0.2
structural = { stiffness = 500.0, damping = 0.25 }
[[pins]]
select = "top-left"
[[pins]]
select = "top-right"
)";

SceneDescription with(const std::string& text, const std::vector<SceneOverride>& overrides) {
    return parse_scene(text, "scene.toml", overrides);
}

TEST(SceneOverride, TakesValuesInTomlAndBareWords) {
    const SceneDescription scene = with(towel, {{"integrator.method", "rk4"},
                                                {"integrator.precision", "\"double\""},
                                                {"cloth.resolution", "[100,90]"},
                                                {"output.duration", "2"},
                                                {"output.formats", "[]"},
                                                {"name", "A towel"}});
    EXPECT_EQ(scene.integrator.method, "rk4");
    EXPECT_EQ(scene.integrator.precision, Precision::f64);
    EXPECT_EQ(scene.cloth.grid.resolution, (std::array{100, 90}));
    EXPECT_EQ(scene.output.duration, 2.0);
    EXPECT_TRUE(scene.output.formats.empty());
    EXPECT_EQ(scene.name, "A towel");
}

TEST(SceneOverride, ReachesIntoInlineTablesAndLeavesTheRest) {
    const SceneDescription scene =
        with(towel, {{"material.structural.stiffness", "900"}, {"material.bend.layout", "border"}});
    EXPECT_EQ(scene.material.structural.stiffness, 900.0);
    EXPECT_EQ(scene.material.structural.damping, 0.25);
    EXPECT_EQ(scene.material.bend_layout, BendLayout::border);
    EXPECT_EQ(scene.material.bend.stiffness, 16.5);  // cotton
}

TEST(SceneOverride, TheLastOneCounts) {
    const SceneDescription scene =
        with(towel, {{"integrator.time_step", "0.001"}, {"integrator.time_step", "auto"}});
    EXPECT_FALSE(scene.integrator.time_step);
    EXPECT_EQ(with(towel, {{"integrator.time_step", "auto"}, {"integrator.time_step", "1e-3"}})
                  .integrator.time_step,
              0.001);
}

TEST(SceneOverride, DoesNotTurnTheFlagIntoAClothOfOnesOwn) {
    const SceneDescription scene = with("version = 1\n", {{"cloth.resolution", "[100,100]"}});
    EXPECT_EQ(scene.cloth.grid.resolution, (std::array{100, 100}));
    EXPECT_EQ(scene.material.fabric, "flag");
    EXPECT_EQ(scene.pins.size(), 1U);
    EXPECT_TRUE(scene.wind);
    EXPECT_TRUE(scene.render.mast);
    EXPECT_EQ(scene.name, "Flag in the wind");
}

TEST(SceneOverride, BringsTheWindWhereThereIsNone) {
    EXPECT_FALSE(with(towel, {}).wind);
    const SceneDescription scene = with(towel, {{"wind.gust.spread", "0.1"}});
    ASSERT_TRUE(scene.wind);
    EXPECT_EQ(scene.wind->gust.spread, 0.1);
    EXPECT_EQ(scene.wind->velocity, (WindDescription{}.velocity));
}

TEST(SceneOverride, MakesATableOfAWord) {
    const std::string steady = towel + "[wind]\ngust = \"none\"\n";
    EXPECT_EQ(with(steady, {}).wind->gust.model, GustModel::none);
    const SceneDescription scene = with(steady, {{"wind.gust.period", "0.5"}});
    EXPECT_EQ(scene.wind->gust.model, GustModel::coefficient);
    EXPECT_EQ(scene.wind->gust.period, 0.5);
}

TEST(SceneOverride, ReachesPinsByIndexAndReplacesThemWhole) {
    const SceneDescription one = with(towel, {{"pins[1].select", "{ particles = [3] }"}});
    ASSERT_EQ(one.pins.size(), 2U);
    EXPECT_EQ(std::get<EdgeSelection>(one.pins[0].select), EdgeSelection::top_left);
    EXPECT_EQ(std::get<ParticleSelection>(one.pins[1].select).particles,
              std::vector<std::size_t>{3});
    EXPECT_TRUE(with(towel, {{"pins", "[]"}}).pins.empty());
    const SceneDescription every =
        with(towel, {{"pins", "[{ select = { every = 2, of = \"top-edge\" } }]"}});
    ASSERT_EQ(every.pins.size(), 1U);
    EXPECT_EQ(std::get<EverySelection>(every.pins[0].select).every, 2U);
}

TEST(SceneOverride, ReachesObstaclesByIndex) {
    const std::string table = towel +
                              "[[obstacles]]\nplane = {}\n"
                              "[[obstacles]]\nsphere = { radius = 0.3 }\n";
    const SceneDescription scene = with(
        table, {{"obstacles[1].sphere.centre", "[0, 1, 0]"}, {"obstacles[0].friction", "0.1"}});
    EXPECT_EQ(std::get<SphereObstacle>(scene.obstacles[1].shape).centre, (Vec3d{0.0, 1.0, 0.0}));
    EXPECT_EQ(std::get<SphereObstacle>(scene.obstacles[1].shape).radius, 0.3);
    EXPECT_EQ(scene.obstacles[0].friction, 0.1);
    // A shape takes the other's place.
    const SceneDescription ball = with(table, {{"obstacles[0].sphere.radius", "0.1"}});
    EXPECT_EQ(std::get<SphereObstacle>(ball.obstacles[0].shape).radius, 0.1);
    const SceneDescription floor = with(table, {{"obstacles[1].plane", "{}"}});
    EXPECT_TRUE(std::holds_alternative<PlaneObstacle>(floor.obstacles[1].shape));
    EXPECT_TRUE(with(table, {{"obstacles", "[]"}}).obstacles.empty());
    EXPECT_EQ(with(towel, {{"obstacles", "[{ sphere = {} }]"}}).obstacles.size(), 1U);
    EXPECT_EQ(
        test::parse_error(table, std::vector<SceneOverride>{{"obstacles[1].sphere.raduis", "0.3"}}),
        "--set obstacles[1].sphere.raduis=0.3: obstacles[1].sphere.raduis: unknown key "
        "(value 0.3); did you mean obstacles[1].sphere.radius? Known here: centre, radius");
}

TEST(SceneOverride, OfOneMassTakesTheOtherAway) {
    const SceneDescription scene = with(towel, {{"material.particle_mass", "1"}});
    EXPECT_EQ(scene.material.particle_mass, 1.0);
    const SceneDescription back =
        with(towel, {{"material.particle_mass", "1"}, {"material.mass_per_area", "0.3"}});
    EXPECT_FALSE(back.material.particle_mass);
    EXPECT_EQ(back.material.mass_per_area, 0.3);
}

TEST(SceneOverride, OfTheMeshTakesTheGridAway) {
    const std::string cape = WEFT_SOURCE_DIR "/scenes/cape.obj";
    const SceneDescription scene = with(towel, {{"cloth.mesh", cape}, {"pins", "[]"}});
    EXPECT_NE(scene.cloth.mesh, nullptr);
    EXPECT_EQ(test::parse_error(towel,
                                std::vector<SceneOverride>{
                                    {"cloth.mesh", cape}, {"pins", "[]"}, {"cloth.size", "[1,1]"}}),
              "--set cloth.size=[1,1]: cloth.size: [1, 1] is not allowed: mesh or size, not both; "
              "a mesh has its own size and place");
}

TEST(SceneOverride, TakesPathsFromTheCurrentDirectory) {
    const test::ScratchDirectory directory;
    test::write_text(directory / "picture.png", "not looked into before it is drawn");
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(directory.path());
    const std::vector<SceneOverride> texture{{"render.texture", "picture.png"}};
    const SceneDescription scene = parse_scene("version = 1\n", "/elsewhere/s.toml", texture);
    std::filesystem::current_path(before);
    EXPECT_EQ(scene.render.texture, "picture.png");
}

TEST(SceneOverride, ErrorsNameTheOverride) {
    const auto error = [](const std::string& key, const std::string& value) {
        return test::parse_error(towel, std::vector<SceneOverride>{{key, value}});
    };
    EXPECT_EQ(error("cloth.resolution", "[1,5]"),
              "--set cloth.resolution=[1,5]: cloth.resolution: [1, 5] is not allowed: two integers "
              "(columns, rows), each at least 2");
    EXPECT_EQ(error("output.duration", "long"),
              "--set output.duration=long: output.duration: \"long\" is not allowed: a finite "
              "number, 0 or more");
    EXPECT_EQ(error("integrator.metod", "rk4"),
              "--set integrator.metod=rk4: integrator.metod: unknown key (value \"rk4\"); did you "
              "mean integrator.method? Known here: method, time_step, precision, tolerance, "
              "iterations, linear_solver, on_divergence");
    EXPECT_EQ(error("pins[2].select", "top-edge"),
              "--set pins[2].select=top-edge: pins[2].select: the scene file has no value of this "
              "index");
    EXPECT_EQ(error("pins[1].selct", "top-edge"),
              "--set pins[1].selct=top-edge: pins[1].selct: unknown key (value \"top-edge\"); did "
              "you mean pins[1].select? Known here: select, motion");
    EXPECT_EQ(error("version", "2"),
              "--set version=2: version: 2 is not allowed: 1, the only version so far");
    for (const std::string key : {"", ".", "a..b", "pins[x]", "pins[0", "pins[-1].select", "a]"}) {
        EXPECT_NE(error(key, "1"), "") << key;
    }
}

TEST(SceneOverride, ALineBreakIsNoWayToSetMore) {
    const auto error = test::error_of([] { with(towel, {{"output.duration", "1\nname = 2"}}); });
    ASSERT_TRUE(error);
    EXPECT_EQ(std::string(error->what()),
              "--set output.duration=1 name = 2: output.duration: \"1\\u000aname = 2\" is not "
              "allowed: a finite number, 0 or more");
}

}  // namespace
}  // namespace weft
