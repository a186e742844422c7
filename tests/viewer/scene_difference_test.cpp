#include "viewer/scene_difference.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace weft::viewer {
namespace {

struct Edit {
    const char* name;
    std::function<void(SceneDescription&)> make;
    bool cloth, physics, shape;
};

SceneDescription with_obstacles() {
    SceneDescription scene;
    scene.obstacles = {{.shape = SphereObstacle{}}, {.shape = PlaneObstacle{}}};
    return scene;
}

const Edit edits[]{
    {"none", [](auto&) {}, false, false, false},
    {"name", [](auto& s) { s.name = "Other"; }, false, false, false},
    {"stem", [](auto& s) { s.stem = "other"; }, false, false, false},
    {"duration", [](auto& s) { s.output.duration = 3.0; }, false, false, false},
    {"formats", [](auto& s) { s.output.formats = {"npy"}; }, false, false, false},
    {"render", [](auto& s) { s.render.mast = false; }, false, false, true},
    {"gravity", [](auto& s) { s.forces.gravity.y = -1.6; }, false, true, false},
    {"last bit", [](auto& s) { s.forces.damping = 5e-324; }, false, true, false},
    {"wind", [](auto& s) { s.wind->velocity.x = 5.0; }, false, true, false},
    {"no wind", [](auto& s) { s.wind.reset(); }, false, true, false},
    {"stiffness", [](auto& s) { s.material.shear.stiffness *= 2; }, false, true, false},
    {"mass", [](auto& s) { s.material.mass_per_area = 0.2; }, false, true, true},
    {"particle mass", [](auto& s) { s.material.particle_mass = 0.1; }, false, true, true},
    {"bend layout", [](auto& s) { s.material.bend_layout = BendLayout::border; }, false, true,
     true},
    {"pins", [](auto& s) { s.pins.clear(); }, false, true, true},
    {"sphere moved", [](auto& s) { std::get<SphereObstacle>(s.obstacles[0].shape).centre.x = 1.0; },
     false, true, false},
    {"plane moved", [](auto& s) { std::get<PlaneObstacle>(s.obstacles[1].shape).point.y = 1.0; },
     false, true, true},
    {"obstacle gone", [](auto& s) { s.obstacles.pop_back(); }, false, true, true},
    {"method", [](auto& s) { s.integrator.method = "rk4"; }, false, true, false},
    {"settle", [](auto& s) { s.output.settle = true; }, false, true, false},
    {"precision", [](auto& s) { s.integrator.precision = Precision::f64; }, true, true, false},
    {"frame rate", [](auto& s) { s.output.frames_per_second = 60.0; }, true, true, false},
    {"resolution", [](auto& s) { s.cloth.grid.resolution[0] = 9; }, true, true, true},
    {"mesh", [](auto& s) { s.cloth.mesh = std::make_shared<Mesh>(); }, true, true, true},
    {"start time", [](auto& s) { s.start.time = 1.0; }, true, true, false},
    {"start state", [](auto& s) { s.start.state = std::make_shared<ClothState>(); }, true, true,
     true},
};

TEST(SceneDifference, KnowsWhatEveryEditMeans) {
    for (const Edit& edit : edits) {
        const SceneDescription before = with_obstacles();
        SceneDescription after = before;
        edit.make(after);
        const SceneDifference found = difference(before, after);
        EXPECT_EQ(found.cloth, edit.cloth) << edit.name;
        EXPECT_EQ(found.physics, edit.physics) << edit.name;
        EXPECT_EQ(found.shape, edit.shape) << edit.name;
        const std::string name = edit.name;
        EXPECT_EQ(found.obstacles, name.ends_with(" moved") || name == "obstacle gone") << name;
    }
}

}  // namespace
}  // namespace weft::viewer
