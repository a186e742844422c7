// What a scene file means: defaults, what is left out, presets, values of every shape.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "io/scene_json.h"
#include "support/recording.h"
#include "support/scene_errors.h"
#include "weft/scene.h"

namespace weft {
namespace {

SceneDescription parsed(const std::string& text) {
    return parse_scene(text, "my/towel.toml");
}

TEST(SceneFile, TheVersionAloneIsTheFlag) {
    const SceneDescription scene = parsed("version = 1\n");
    EXPECT_EQ(scene_to_json(scene).dump(), scene_to_json(SceneDescription{}).dump());
    EXPECT_EQ(scene.file, "my/towel.toml");
    EXPECT_EQ(scene.stem, "towel");
    EXPECT_EQ(scene.frame_count(), 240U);
}

TEST(SceneFile, ATextWithoutAFileIsCalledFlagOrScene) {
    EXPECT_EQ(parse_scene("version = 1\n", "").stem, "flag");
    EXPECT_EQ(parse_scene("version = 1\n[cloth]\n", "").stem, "scene");
}

TEST(SceneFile, AClothOfOnesOwnStartsBare) {
    const SceneDescription scene = parsed("version = 1\n[cloth]\n");
    EXPECT_EQ(scene.name, "towel");
    EXPECT_TRUE(scene.pins.empty());
    EXPECT_FALSE(scene.wind);
    EXPECT_EQ(scene.forces.gravity, (Vec3d{0.0, -9.81, 0.0}));
    EXPECT_EQ(scene.forces.damping, 0.0);
    EXPECT_EQ(scene.material.fabric, "cotton");
    EXPECT_EQ(scene.material.mass_per_area, 0.15);
    EXPECT_EQ(scene.material.structural.stiffness, 825.0);
    EXPECT_EQ(scene.render.texture, "linen");
    EXPECT_FALSE(scene.render.mast);
    EXPECT_EQ(scene.cloth.grid.resolution, (std::array{61, 41}));
}

TEST(SceneFile, AKeyOverridesTheFabricAlone) {
    const SceneDescription scene =
        parsed("version = 1\n[material]\nstructural = { stiffness = 800 }\nfabric = \"denim\"\n");
    EXPECT_EQ(scene.material.structural.stiffness, 800.0);
    EXPECT_EQ(scene.material.structural.damping, 0.4);
    EXPECT_EQ(scene.material.shear.stiffness, 1300.0);
    EXPECT_EQ(scene.material.mass_per_area, 0.4);
    EXPECT_EQ(scene.material.stiffness_per, StiffnessPer::width);
}

TEST(SceneFile, StiffnessPerSpringTakesTheMassAloneFromTheFabric) {
    const SceneDescription scene = parsed(
        "version = 1\n[material]\nstiffness_per = \"spring\"\n"
        "structural = { stiffness = 800.0 }\n");
    EXPECT_EQ(scene.material.mass_per_area, 0.12);
    EXPECT_EQ(scene.material.structural.stiffness, 800.0);
    EXPECT_EQ(scene.material.structural.damping, 0.0);
    EXPECT_EQ(scene.material.shear.stiffness, 0.0);
    EXPECT_EQ(scene.material.bend.stiffness, 0.0);
}

TEST(SceneFile, ReadsEverySelectorAndMotion) {
    const SceneDescription scene = parsed(R"(version = 1
[cloth]
resolution = [11, 11]
[[pins]]
select = "bottom-edge"
[[pins]]
select = { particles = [0, 40] }
motion = [{ time = 0, offset = [0, 0, 0] }, { offset = [0.2, 0.0, -1], time = 1.5 }]
[[pins]]
select = { every = 5, of = "left-edge" }
[[pins]]
select = { box = [[-1, 0.5, 0], [1, 2, 0]] }
)");
    ASSERT_EQ(scene.pins.size(), 4U);
    EXPECT_EQ(std::get<EdgeSelection>(scene.pins[0].select), EdgeSelection::bottom_edge);
    EXPECT_EQ(std::get<ParticleSelection>(scene.pins[1].select).particles,
              (std::vector<std::size_t>{0, 40}));
    ASSERT_EQ(scene.pins[1].motion.size(), 2U);
    EXPECT_EQ(scene.pins[1].motion[1].time, 1.5);
    EXPECT_EQ(scene.pins[1].motion[1].offset, (Vec3d{0.2, 0.0, -1.0}));
    EXPECT_EQ(std::get<EverySelection>(scene.pins[2].select).every, 5U);
    EXPECT_EQ(std::get<EverySelection>(scene.pins[2].select).of, EdgeSelection::left_edge);
    EXPECT_EQ(std::get<BoxSelection>(scene.pins[3].select).low, (Vec3d{-1.0, 0.5, 0.0}));
    EXPECT_EQ(std::get<BoxSelection>(scene.pins[3].select).high, (Vec3d{1.0, 2.0, 0.0}));
}

TEST(SceneFile, ReadsEveryOtherKey) {
    const SceneDescription scene = parsed(R"(version = 1
name = "All"
cloth = { size = [2, 3], resolution = [4, 5], plane = "xz", origin = [1, 2, 3] }
[material]
particle_mass = 0.5
bend = { stiffness = 1, damping = 2, layout = "border" }
[forces]
gravity = [0, 0, -1]
damping = 0.1
[wind]
velocity = [1, 2, 3]
air_density = 0.0
drag = 2
skin_friction = 0
gust = { model = "coefficient", spread = 0.5, period = 2, seed = 9223372036854775807 }
[integrator]
method = "rk4"
time_step = 0.001
precision = "double"
tolerance = 1e-7
iterations = 12
linear_solver = "cholesky"
on_divergence = "halve-step"
[output]
duration = 0
frames_per_second = 31.25
formats = []
energy_balance = true
settle = false
[render]
size = [640, 480]
texture = "plain"
mast = true
ground = false
camera = [0, 1, 5]
target = "auto"
field_of_view = 50
)");
    EXPECT_EQ(
        scene_to_json(scene).dump(),
        R"({"version":1,"name":"All",)"
        R"("cloth":{"size":[2.0,3.0],"resolution":[4,5],"plane":"xz","origin":[1.0,2.0,3.0]},)"
        R"("material":{"fabric":"cotton","particle_mass":0.5,"stiffness_per":"width",)"
        R"("structural":{"stiffness":825.0,"damping":0.0825},)"
        R"("shear":{"stiffness":275.0,"damping":0.0275},)"
        R"("bend":{"stiffness":1.0,"damping":2.0,"layout":"border"}},"pins":[],"obstacles":[],)"
        R"("forces":{"gravity":[0.0,0.0,-1.0],"damping":0.1},)"
        R"("wind":{"velocity":[1.0,2.0,3.0],"air_density":0.0,"drag":2.0,"skin_friction":0.0,)"
        R"("gust":{"model":"coefficient","spread":0.5,"period":2.0,"seed":9223372036854775807}},)"
        R"("integrator":{"method":"rk4","time_step":0.001,"precision":"double",)"
        R"("tolerance":1e-07,"iterations":12,"linear_solver":"cholesky",)"
        R"("on_divergence":"halve-step"},)"
        R"("output":{"duration":0.0,"frames_per_second":31.25,"formats":[],"energy_balance":true,)"
        R"("settle":false},)"
        R"("render":{"size":[640,480],"texture":"plain","mast":true,"ground":false,)"
        R"("camera":[0.0,1.0,5.0],"target":"auto","field_of_view":50.0}})");
    EXPECT_EQ(scene.frame_count(), 0U);
}

TEST(SceneFile, WritesPinsAndASteadyWindAsJson) {
    const SceneDescription scene = parsed(R"(version = 1
[[pins]]
select = { every = 5, of = "top-edge" }
motion = [{ time = 1, offset = [0, 0, 1] }]
[[pins]]
select = { box = [[0, 0, 0], [1, 1, 1]] }
[wind]
gust = "none"
)");
    const auto json = scene_to_json(scene);
    EXPECT_EQ(json["pins"].dump(),
              R"([{"select":{"every":5,"of":"top-edge"},)"
              R"("motion":[{"time":1.0,"offset":[0.0,0.0,1.0]}]},)"
              R"({"select":{"box":[[0.0,0.0,0.0],[1.0,1.0,1.0]]},"motion":[]}])");
    EXPECT_EQ(json["wind"]["gust"], "none");
}

TEST(SceneFile, ReadsObstacles) {
    const SceneDescription scene = parsed(R"(version = 1
[cloth]
[[obstacles]]
sphere = { centre = [1, 2, 3], radius = 0.5 }
friction = 0.75
gap = 0
[[obstacles]]
plane = { normal = [0, 2, 1] }
[[obstacles]]
sphere = {}
)");
    ASSERT_EQ(scene.obstacles.size(), 3U);
    const auto& sphere = std::get<SphereObstacle>(scene.obstacles[0].shape);
    EXPECT_EQ(sphere.centre, (Vec3d{1.0, 2.0, 3.0}));
    EXPECT_EQ(sphere.radius, 0.5);
    EXPECT_EQ(scene.obstacles[0].friction, 0.75);
    EXPECT_EQ(scene.obstacles[0].gap, 0.0);
    const auto& plane = std::get<PlaneObstacle>(scene.obstacles[1].shape);
    EXPECT_EQ(plane.point, Vec3d{});
    EXPECT_EQ(plane.normal, (Vec3d{0.0, 2.0, 1.0}));
    EXPECT_EQ(scene.obstacles[1].friction, 0.4);
    EXPECT_EQ(scene.obstacles[1].gap, 0.005);
    EXPECT_EQ(std::get<SphereObstacle>(scene.obstacles[2].shape).radius, 0.25);
    EXPECT_EQ(scene_to_json(scene)["obstacles"].dump(),
              R"([{"sphere":{"centre":[1.0,2.0,3.0],"radius":0.5},"friction":0.75,"gap":0.0},)"
              R"({"plane":{"point":[0.0,0.0,0.0],"normal":[0.0,2.0,1.0]},)"
              R"("friction":0.4,"gap":0.005},)"
              R"({"sphere":{"centre":[0.0,0.5,0.0],"radius":0.25},"friction":0.4,"gap":0.005}])");
}

TEST(SceneFile, AStartWithoutAStateIsATime) {
    const SceneDescription scene = parsed("version = 1\n[start]\ntime = 2.5\n");
    EXPECT_EQ(scene.start.time, 2.5);
    EXPECT_EQ(scene.start.state, nullptr);
    EXPECT_EQ(scene_to_json(scene)["start"].dump(), R"({"time":2.5})");
    EXPECT_FALSE(scene_to_json(parsed("version = 1\n[start]\n")).contains("start"));
}

TEST(SceneFile, PathsAreRelativeToIt) {
    const test::ScratchDirectory directory;
    std::filesystem::create_directory(directory / "sub");
    test::write_text(directory / "triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    test::write_text(directory / "sub/picture.png", "not looked into before it is drawn");
    const std::string file = (directory / "sub/scene.toml").string();
    test::write_text(file,
                     "version = 1\n[cloth]\nmesh = \"../triangle.obj\"\n"
                     "[render]\ntexture = \"picture.png\"\n");
    const SceneDescription scene = load_scene(file);
    EXPECT_EQ(scene.cloth.mesh_path, (directory / "triangle.obj").string());
    ASSERT_NE(scene.cloth.mesh, nullptr);
    EXPECT_EQ(scene.cloth.mesh->positions.size(), 3U);
    EXPECT_EQ(scene.render.texture, (directory / "sub/picture.png").string());
    const auto json = scene_to_json(scene);
    EXPECT_EQ(json["cloth"].size(), 1U);
    EXPECT_EQ(json["cloth"]["mesh"], scene.cloth.mesh_path);
}

TEST(SceneFile, AMeshWithoutFacesIsAnErrorOfThatFile) {
    const test::ScratchDirectory directory;
    test::write_text(directory / "broken.obj", "v 0 0 zero\n");
    const auto error = test::error_of([&] {
        parse_scene("version = 1\n[cloth]\nmesh = \"broken.obj\"\n",
                    (directory / "scene.toml").string());
    });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::file);
    EXPECT_EQ(error->place().file, (directory / "broken.obj").string());
}

TEST(SceneFile, ErrorsCarryTheirPlace) {
    const auto error = test::error_of(
        [] { parse_scene("version = 1\n\n[cloth]\n  size =   [0, 1]\n", "dir/scene.toml"); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::usage);
    EXPECT_EQ(error->place().file, "dir/scene.toml");
    EXPECT_EQ(error->place().line, 4);
    EXPECT_EQ(error->place().column, 12);
    EXPECT_EQ(error->place().key, "cloth.size");
}

TEST(SceneFile, AnErrorOfADefaultNamesTheNearestTableOrTheFile) {
    // The duration is a default, and too long at this rate.
    EXPECT_EQ(test::parse_error("version = 1\n[output]\nframes_per_second = 1e9\n"),
              "scene.toml:2:1: output.duration: 8 is not allowed: at most 1000000000 frames at "
              "1000000000 frames per second");
    EXPECT_EQ(test::parse_error(""),
              "scene.toml: version: not given; a scene file begins with version = 1");
}

TEST(SceneFile, EveryFirstUnknownKeyIsReportedInTheOrderOfTheFile) {
    EXPECT_TRUE(test::parse_error("version = 1\n[wind]\nzzz = 1\n[cloth]\naaa = 1\n")
                    .starts_with("scene.toml:3:1: wind.zzz: unknown key (value 1)"));
}

TEST(SceneFile, StrangeKeysAndValuesStayOnOneLine) {
    const std::string error = test::parse_error("version = 1\n\"a\\nb\" = \"c\\nd\"\n");
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    EXPECT_TRUE(error.starts_with("scene.toml:2:1: a b: unknown key (value \"c\\u000ad\")"))
        << error;
    const std::string name = test::parse_error("version = 1\nname = \"c\\nd\"\n");
    EXPECT_EQ(name,
              "scene.toml:2:8: name: \"c\\u000ad\" is not allowed: a string of one line, "
              "not empty");
}

TEST(SceneFile, LongValuesAreCut) {
    std::string list = "[0";
    for (int i = 1; i < 1000; ++i) list += ", " + std::to_string(i);
    const std::string error = test::parse_error("version = 1\n[cloth]\nsize = " + list + "]\n");
    EXPECT_LT(error.size(), 200U);
    EXPECT_NE(error.find("[0, 1, 2, 3,"), std::string::npos);
    EXPECT_NE(error.find("... is not allowed"), std::string::npos);
}

TEST(SceneFile, DeepNestingIsAnError) {
    EXPECT_NE(test::parse_error("version = 1\nx = " + std::string(100000, '[')), "");
}

TEST(SceneFile, ACarriageReturnAndAByteOrderMarkAreFine) {
    EXPECT_EQ(test::parse_error("\xef\xbb\xbfversion = 1\r\n[cloth]\r\nsize = [1, 1]\r\n"), "");
}

TEST(SceneFile, WhatCannotBeReadIsAnErrorOfKindFile) {
    const test::ScratchDirectory directory;
    const std::string missing = (directory / "missing.toml").string();
    const auto error = [](const std::string& path) {
        const auto thrown = test::error_of([&] { load_scene(path); });
        EXPECT_TRUE(thrown);
        EXPECT_EQ(thrown->kind(), ErrorKind::file);
        return std::string(thrown->what());
    };
    EXPECT_EQ(error(missing), missing + ": cannot be read: No such file or directory");
    const std::string folder = directory.path().string();
    EXPECT_EQ(error(folder), folder + ": cannot be read: it is a directory");
    const std::string large = (directory / "large.toml").string();
    test::write_text(large, "version = 1\n");
    std::filesystem::resize_file(large, 16 * 1024 * 1024 + 1);
    EXPECT_EQ(error(large), large + ": cannot be read: it is larger than 16 MiB");
}

}  // namespace
}  // namespace weft
