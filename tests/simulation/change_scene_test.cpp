// Changing the scene in the middle of a run, and beginning with the state of another run.
#include <gtest/gtest.h>

#include <functional>

#include "support/cloth_scenes.h"
#include "support/methods.h"
#include "support/scene_errors.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

using Change = std::function<void(SceneDescription&)>;

SceneDescription flag(const std::string& method) {
    SceneDescription scene;
    scene.cloth.grid.resolution = {16, 11};
    scene.forces.damping = 1e-5;
    scene.integrator.method = method;
    scene.integrator.precision = Precision::f32;
    const bool implicit = find_integrator(method)->kind == IntegratorKind::implicit;
    scene.integrator.time_step = implicit ? 1.0 / 120 : 5e-5;
    return scene;
}

void fly(Simulation& simulation, int frames) {
    for (int n = 0; n < frames; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
}

const std::vector<std::pair<std::string, Change>>& changes() {
    using S = SceneDescription;
    static const std::vector<std::pair<std::string, Change>> all{
        {"stiffness",
         [](S& s) {
             s.material.structural = {300.0, 0.05};
         }},
        {"mass", [](S& s) { s.material.mass_per_area = 0.3; }},
        {"pins",
         [](S& s) {
             s.pins = {{EdgeSelection::top_left, {}}};
         }},
        {"no pins", [](S& s) { s.pins.clear(); }},
        {"moved pins",
         [](S& s) {
             s.pins[0].motion = {{0.0, {0.1, 0.2, 0.0}}};
         }},
        {"gravity",
         [](S& s) {
             s.forces.gravity = {0.0, 3.0, 1.0};
         }},
        {"drag", [](S& s) { s.forces.damping = 1e-3; }},
        {"wind",
         [](S& s) {
             s.wind->velocity = {0.0, 0.0, 9.0};
         }},
        {"no wind", [](S& s) { s.wind.reset(); }},
        {"method", [](S& s) { s.integrator.method = "xpbd"; }},
        {"step", [](S& s) { *s.integrator.time_step *= 0.5; }},
        {"obstacle",
         [](S& s) {
             s.obstacles = {{SphereObstacle{{0.8, 1.5, 0.1}, 0.2}, 0.3, 0.0}};
         }},
        {"all", [](S& s) {
             s.material.bend = {40.0, 0.01};
             s.pins = {{EdgeSelection::top_edge, {}}};
             s.wind->gust.seed = 3;
             s.obstacles = {{PlaneObstacle{{0.0, 1.2, 0.0}, {0.0, 2.0, 0.0}}, 0.3, 0.01}};
             s.integrator.method = "tr-bdf2";
             s.integrator.time_step = 1.0 / 90;
         }}};
    return all;
}

// The changed scene from the same state at the same time, by scene.start.
Simulation begun_anew(SceneDescription scene, const Simulation& other) {
    FrameBuffer frame;
    other.capture(frame);
    scene.start.state = std::make_shared<ClothState>(ClothState{frame.positions, frame.velocities});
    scene.start.time = other.time();
    return Simulation(scene);
}

TEST(ChangingTheScene, DoesWhatANewRunFromTheStateDoes) {
    for (const char* method : {"rk4", "velocity-verlet", "implicit-euler", "bdf2"}) {
        for (const auto& [name, change] : changes()) {
            Simulation simulation(flag(method));
            fly(simulation, 4);
            SceneDescription changed = simulation.scene();
            change(changed);
            const bool history = name == "obstacle" && method != std::string("rk4") &&
                                 method != std::string("implicit-euler");
            Simulation anew = begun_anew(changed, simulation);
            const Surface* const surface = &simulation.surface();
            const std::size_t steps = simulation.step_count();
            simulation.change_scene(changed);
            EXPECT_EQ(&simulation.surface(), surface);
            EXPECT_EQ(simulation.state_hash(), anew.state_hash()) << method << ": " << name;
            EXPECT_EQ(simulation.frame(), 4u);
            EXPECT_EQ(simulation.step_count(), steps);
            EXPECT_EQ(simulation.pinned_count(), anew.pinned_count());
            SCOPED_TRACE(method + (": " + name));
            fly(simulation, 3);
            fly(anew, 3);
            EXPECT_EQ(simulation.time(), 7.0 / 30);
            EXPECT_EQ(anew.time(), 7.0 / 30);
            if (history) continue;  // kept, as nothing else changed
            EXPECT_EQ(simulation.state_hash(), anew.state_hash()) << method << ": " << name;
        }
    }
}

TEST(ChangingTheScene, ToTheSameOneChangesNoBit) {
    for (const char* method : {"verlet", "velocity-verlet", "dopri5", "bdf2", "vbd"}) {
        Simulation changed(flag(method)), left(flag(method));
        fly(changed, 3);
        fly(left, 3);
        changed.change_scene(SceneDescription(changed.scene()));
        changed.change_scene(changed.scene());
        fly(changed, 3);
        fly(left, 3);
        EXPECT_EQ(changed.state_hash(), left.state_hash()) << method;
    }
}

TEST(ChangingTheScene, GoesOnCounting) {
    SceneDescription scene = flag("tr-bdf2");
    scene.output.energy_balance = true;
    Simulation simulation(scene);
    fly(simulation, 3);
    const Work work = simulation.work();
    const SolverCounts counts = simulation.solver_counts();
    EXPECT_NE(work.air, 0.0);
    scene.material.structural.stiffness = 200.0;
    simulation.change_scene(scene);
    EXPECT_EQ(simulation.work().air, work.air);
    EXPECT_EQ(simulation.solver_counts().newton_iterations, counts.newton_iterations);
    fly(simulation, 1);
    EXPECT_GT(simulation.solver_counts().newton_iterations, counts.newton_iterations);
    EXPECT_EQ(simulation.scene().material.structural.stiffness, 200.0);
}

TEST(ChangingTheScene, KeepsGrips) {
    SceneDescription scene = flag("velocity-verlet");
    Simulation simulation(scene);
    simulation.set_grips(std::vector<Grip>{{15, {1.5, 2.0, 0.3}, 20.0, 0.1}});
    scene.material.mass_per_area = 0.2;
    const Vec3d force = simulation.grip_force();
    simulation.change_scene(scene);
    EXPECT_EQ(simulation.grip_force(), force);
    scene.integrator.method = "implicit-euler";
    simulation.change_scene(scene);
    EXPECT_EQ(simulation.grip_force(), force);
    scene.pins.push_back({ParticleSelection{{15}}, {}});
    simulation.change_scene(scene);
    EXPECT_EQ(simulation.grip_force(), Vec3d{});
}

TEST(ChangingTheScene, OfAMeshTakesAFileReadAgain) {
    SceneDescription scene = flag("velocity-verlet");
    make_mesh_of_grid(scene);
    scene.pins = {{ParticleSelection{{0, 16}}, {}}};
    Simulation simulation(scene);
    fly(simulation, 2);
    scene.cloth.mesh = std::make_shared<Mesh>(*scene.cloth.mesh);
    scene.material.shear.stiffness = 90.0;
    Simulation anew = begun_anew(scene, simulation);
    simulation.change_scene(scene);
    fly(simulation, 2);
    fly(anew, 2);
    EXPECT_EQ(simulation.state_hash(), anew.state_hash());
    auto other = std::make_shared<Mesh>(*scene.cloth.mesh);
    other->positions[5].x += 0.01;
    scene.cloth.mesh = other;
    const auto error = error_of([&] { simulation.change_scene(scene); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->place().key, "cloth.mesh");
}

TEST(ChangingTheScene, ThatIsRefusedChangesNothing) {
    using S = SceneDescription;
    const std::vector<std::pair<std::string, Change>> refused{
        {"cloth.resolution",
         [](S& s) {
             s.cloth.grid.resolution = {17, 11};
         }},
        {"cloth.size", [](S& s) { s.cloth.grid.size[0] = 2.0; }},
        {"cloth.plane", [](S& s) { s.cloth.grid.plane = Plane::xz; }},
        {"cloth.origin", [](S& s) { s.cloth.grid.origin.y = 3.0; }},
        {"start.time", [](S& s) { s.start.time = 1.0; }},
        {"start.state",
         [](S& s) {
             s.start.state = std::make_shared<ClothState>(
                 ClothState{std::vector<Vec3d>(176), std::vector<Vec3d>(176)});
         }},
        {"output.frames_per_second", [](S& s) { s.output.frames_per_second = 60.0; }},
        {"integrator.precision", [](S& s) { s.integrator.precision = Precision::f64; }},
        {"material.mass_per_area", [](S& s) { s.material.mass_per_area = -1.0; }},
        {"integrator.time_step",
         [](S& s) {
             s.material.structural.damping = s.material.shear.damping = 0.0;
             s.material.bend.damping = s.forces.damping = 0.0;
             s.integrator.method = "forward-euler";
             s.integrator.time_step.reset();
         }},
        {"pins[1].select", [](S& s) {
             s.pins.push_back({BoxSelection{{90, 90, 90}, {91, 91, 91}}, {}});
         }}};
    Simulation simulation(flag("velocity-verlet")), left(flag("velocity-verlet"));
    fly(simulation, 2);
    fly(left, 2);
    for (const auto& [key, change] : refused) {
        SceneDescription changed = simulation.scene();
        changed.forces.gravity.y = -1.0;
        change(changed);
        const auto error = error_of([&] { simulation.change_scene(changed); });
        ASSERT_TRUE(error) << key;
        EXPECT_EQ(error->kind(), ErrorKind::usage);
        EXPECT_EQ(error->place().key, key);
        EXPECT_EQ(simulation.state_hash(), left.state_hash()) << key;
        EXPECT_EQ(simulation.scene().forces.gravity.y, -9.81);
    }
    fly(simulation, 3);
    fly(left, 3);
    EXPECT_EQ(simulation.state_hash(), left.state_hash());
}

// To the bit where a method keeps nothing between steps, at times that are whole frames of the
// rate.
TEST(StartState, GoesOnAsTheRunItIsOf) {
    for (const Precision precision : {Precision::f32, Precision::f64}) {
        for (const char* method : {"symplectic-euler", "rk2", "rk4", "yoshida4", "forest-ruth",
                                   "implicit-euler", "tr-bdf2", "sdirk2", "xpbd"}) {
            SceneDescription scene = flag(method);
            scene.integrator.precision = precision;
            Simulation whole(scene);
            fly(whole, 7);
            Simulation second = begun_anew(scene, whole);
            EXPECT_EQ(second.state_hash(), whole.state_hash()) << method;
            EXPECT_EQ(second.frame(), 0u);
            EXPECT_EQ(second.time(), whole.time());
            fly(whole, 5);
            fly(second, 5);
            EXPECT_EQ(second.time(), whole.time());
            EXPECT_EQ(second.state_hash(), whole.state_hash()) << method;
        }
    }
}

TEST(StartState, TakesAnyTimeAndPutsPinsWhereTheyAreThen) {
    SceneDescription scene = flag("rk4");
    scene.integrator.precision = Precision::f64;
    scene.pins[0].motion = {{0.0, {}}, {2.0, {1.0, 0.0, 0.0}}};
    scene.start.time = 1.0;
    Simulation moved(scene);
    FrameBuffer frame;
    moved.capture(frame);
    EXPECT_EQ(frame.time, 1.0);
    EXPECT_EQ(frame.positions[0], (Vec3d{0.5, 2.0, 0.0}));
    EXPECT_EQ(frame.positions[1], (Vec3d{0.1, 2.0, 0.0}));  // at rest
    scene.start.time = 0.1234;
    Simulation odd(scene);
    fly(odd, 30);
    EXPECT_DOUBLE_EQ(odd.time(), 1.1234);
}

TEST(StartState, IsWhereSettlingBegins) {
    SceneDescription scene = flag("implicit-euler");
    scene.wind.reset();
    scene.output.settle = true;
    scene.integrator.precision = Precision::f64;
    const Simulation first(scene);
    FrameBuffer rest, again;
    first.capture(rest);
    EXPECT_GT(first.settle_report()->newton_iterations, 3u);
    scene.start.state = std::make_shared<ClothState>(ClothState{
        rest.positions, std::vector<Vec3d>(rest.positions.size(), Vec3d{1.0, 0.0, 0.0})});
    const Simulation second(scene);
    EXPECT_EQ(second.settle_report()->newton_iterations, 0u);
    second.capture(again);
    EXPECT_EQ(again.positions, rest.positions);
    EXPECT_EQ(again.velocities, rest.velocities);
}

TEST(StartState, OfAnotherClothIsRefused) {
    SceneDescription scene = flag("rk4");
    make_mesh_of_grid(scene);
    scene.pins = {{ParticleSelection{{0, 16}}, {}}};
    scene.start.state =
        std::make_shared<ClothState>(ClothState{std::vector<Vec3d>(175), std::vector<Vec3d>(175)});
    const auto error = error_of([&] { Simulation simulation(scene); });
    ASSERT_TRUE(error);
    EXPECT_EQ(std::string(error->what()),
              "start.state: a state of 175 particles is not allowed: this cloth has 176");
}

// What held the cloth up in the last step before.
TEST(Settling, KnowsNothingOfObstaclesThatWereTakenAway) {
    SceneDescription scene = flag("implicit-euler");
    scene.wind.reset();
    scene.obstacles = {{PlaneObstacle{{0.0, 1.2, 0.0}, {0.0, 1.0, 0.0}}, 0.4, 0.0}};
    Simulation simulation(scene);
    fly(simulation, 30);
    scene.obstacles.clear();
    Simulation anew = begun_anew(scene, simulation);
    simulation.change_scene(scene);
    EXPECT_TRUE(simulation.settle().converged);
    EXPECT_TRUE(anew.settle().converged);
    EXPECT_EQ(simulation.state_hash(), anew.state_hash());
}

TEST(Settling, AmongObstaclesIsRefused) {
    SceneDescription scene = flag("rk4");
    scene.obstacles = {ObstacleDescription{}};
    Simulation simulation(scene);
    const auto error = error_of([&] { (void)simulation.settle(); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::usage);
    EXPECT_EQ(error->place().key, "output.settle");
}

}  // namespace
}  // namespace weft::test
