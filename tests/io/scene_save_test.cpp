// A saved scene reads back as the same scene.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "io/toml_value.h"
#include "math/random.h"
#include "simulation/scene_words.h"
#include "support/cloth_scenes.h"
#include "support/recording.h"
#include "support/saved_scene.h"
#include "support/scene_errors.h"
#include "weft/integrators.h"
#include "weft/scene.h"
#include "weft/simulation.h"

namespace weft {
namespace {

namespace fs = std::filesystem;

std::string saved_text(const SceneDescription& scene) {
    const test::ScratchDirectory directory;
    save_scene(scene, directory / "saved.toml");
    return test::file_text(directory / "saved.toml");
}

TEST(SavedScene, OfTheDefaultsIsReadable) {
    EXPECT_EQ(saved_text(SceneDescription{}),
              R"(# Saved by weft: every key that counts in this scene, with its value.

version = 1
name = "Flag in the wind"

[cloth]
size = [1.5, 1.0]                 # [m]
resolution = [61, 41]
plane = "xy"
origin = [0.0, 2.0, 0.0]          # [m]

[material]
fabric = "flag"
mass_per_area = 0.12              # [kg/m2]
stiffness_per = "width"
structural = { stiffness = 120.0, damping = 0.012 }  # stiffness [N/m], damping [N s/m]
shear = { stiffness = 40.0, damping = 0.004 }  # stiffness [N/m], damping [N s/m]
bend = { stiffness = 10.0, damping = 0.001, layout = "interior" }  # stiffness [N/m], damping [N s/m]

[[pins]]
select = "left-edge"

[forces]
gravity = [0.0, -9.81, 0.0]       # [m/s2]
damping = 0.0                     # [kg/s]

[wind]
velocity = [4.0, 0.0, 1.4]        # [m/s]
air_density = 1.2                 # [kg/m3]
drag = 1.0
skin_friction = 0.01
gust = { model = "coefficient", spread = 0.5, period = 0.25, seed = 7 }  # period [s]

[integrator]
method = "auto"
time_step = "auto"
precision = "single"
tolerance = "auto"
iterations = "auto"
linear_solver = "auto"
on_divergence = "stop"

[output]
duration = 8.0                    # [s]
frames_per_second = 30.0          # [1/s]
formats = ["glb", "pc2", "mp4"]
energy_balance = false
settle = false

[render]
size = [1280, 720]                # [pixels]
texture = "flag"
mast = true
ground = true
camera = "auto"
target = "auto"
field_of_view = 35.0              # [degrees]
)");
}

TEST(SavedScene, HasPinsAndObstaclesAsTables) {
    SceneDescription scene = test::bare_sheet(30, 20);
    scene.pins = {{ParticleSelection{{0, 7}}, {{0.5, {}}, {1.0, {0.25, 0.0, -1.0}}}},
                  {EverySelection{3, EdgeSelection::top_edge}, {}}};
    scene.obstacles = {{SphereObstacle{{0.0, 1.0, 0.0}, 0.5}, 0.3, 0.01}, {PlaneObstacle{}}};
    scene.start.time = 2.0;
    const std::string text = saved_text(scene);
    const std::size_t from = text.find("[[pins]]"), to = text.find("[forces]");
    EXPECT_EQ(text.substr(from, to - from), R"([[pins]]
select = { particles = [0, 7] }
motion = [                        # [s], [m]
    { time = 0.5, offset = [0.0, 0.0, 0.0] },
    { time = 1.0, offset = [0.25, 0.0, -1.0] },
]

[[pins]]
select = { every = 3, of = "top-edge" }

[[obstacles]]
sphere = { centre = [0.0, 1.0, 0.0], radius = 0.5 }  # [m]
friction = 0.3
gap = 0.01                        # [m]

[[obstacles]]
plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 1.0, 0.0] }  # point [m]
friction = 0.4
gap = 0.005                       # [m]

[start]
time = 2.0                        # [s]

)");
    EXPECT_EQ(text.find("[wind]"), std::string::npos);
}

TEST(SavedScene, BreaksLongListsOfParticles) {
    SceneDescription scene = test::bare_sheet(40, 40);
    ParticleSelection all;
    for (std::size_t p = 0; p < 1600; ++p) all.particles.push_back(p);
    scene.pins = {{all, {}}};
    const test::ScratchDirectory directory;
    const SceneDescription read = test::saved_and_loaded(scene, directory / "all.toml");
    EXPECT_EQ(std::get<ParticleSelection>(read.pins[0].select).particles, all.particles);
    std::istringstream lines(test::file_text(directory / "all.toml"));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST(SavedScene, IsEqualForShippedScenes) {
    const test::ScratchDirectory directory;
    for (const ShippedScene& shipped : shipped_scenes()) {
        SCOPED_TRACE(shipped.name);
        const fs::path file = directory / (shipped.name + "-edited.toml");
        const SceneDescription scene = load_scene(shipped.name);
        const SceneDescription read = test::saved_and_loaded(scene, file);
        test::expect_same_scene(scene, read);
        EXPECT_EQ(read.stem, shipped.name + "-edited");
        EXPECT_EQ(read.file, file.string());
        // Saved again, not a byte changes.
        save_scene(read, directory / "again.toml");
        EXPECT_EQ(test::file_text(directory / "again.toml"), test::file_text(file));
    }
}

TEST(SavedScene, IsEqualForTheScenesOfTests) {
    const test::ScratchDirectory directory;
    SceneDescription dashpots = test::bare_sheet(4, 3, 0.7, 0.1);
    test::add_dashpots(dashpots, 1e-3);
    for (const SceneDescription& scene : {test::bare_sheet(2, 2), dashpots}) {
        test::expect_same_scene(scene, test::saved_and_loaded(scene, directory / "saved.toml"));
    }
    for (const auto& entry : fs::directory_iterator(WEFT_SOURCE_DIR "/tests/end_to_end/scenes")) {
        SCOPED_TRACE(entry.path());
        const SceneDescription scene = load_scene(entry.path().string());
        test::expect_same_scene(scene, test::saved_and_loaded(scene, directory / "saved.toml"));
    }
}

/// Draws values of every key.
class RandomScene {
public:
    explicit RandomScene(std::uint64_t seed) : seed_(seed) {}

    SceneDescription draw() {
        SceneDescription scene;
        scene.name = "Random \"scene\" \\ é " + std::to_string(seed_);
        scene.cloth.grid = {{positive(), positive()},
                            {4 + whole(5), 3 + whole(5)},
                            static_cast<Plane>(whole(2)),
                            vector()};
        draw_material(scene.material);
        draw_pins(scene.pins);
        draw_obstacles(scene.obstacles);
        scene.start.time = whole(2) == 0 ? 0.0 : uniform();
        scene.forces = {vector(), positive()};
        draw_wind(scene.wind);
        draw_integrator(scene.integrator);
        draw_output(scene.output);
        scene.render = {
            {16 + 2 * whole(99), 720}, "checker", coin(), coin(), {}, {}, 170 * uniform()};
        if (coin()) scene.render.camera = vector();
        return scene;
    }

private:
    double uniform() { return 1e-300 + random_uniform(seed_, ++drawn_, 0); }
    int whole(int below) { return static_cast<int>(uniform() * below); }
    bool coin() { return whole(2) == 1; }
    /// Of any magnitude, denormal ones included.
    double positive() { return uniform() * std::pow(10.0, 8 - whole(332)) + 5e-324; }
    double number() { return coin() ? positive() : -positive(); }
    Vec3d vector() { return {number(), number(), number()}; }

    void draw_material(MaterialDescription& material) {
        const auto fabrics = fabric_catalogue();
        material.fabric = fabrics[static_cast<std::size_t>(whole(6)) % fabrics.size()].name;
        material.stiffness_per = static_cast<StiffnessPer>(whole(2));
        if (coin()) {
            material.particle_mass = positive();
        } else {
            material.mass_per_area = positive();
        }
        for (SpringMaterial* spring : {&material.structural, &material.shear, &material.bend})
            *spring = {positive(), positive()};
        material.bend_layout = static_cast<BendLayout>(whole(2));
    }

    void draw_pins(std::vector<PinDescription>& pins) {
        const Vec3d low = vector();
        const std::vector<PinSelector> kinds{
            static_cast<EdgeSelection>(whole(8)), ParticleSelection{{0, 5, 11}},
            EverySelection{static_cast<std::size_t>(1 + whole(4)), EdgeSelection::right_edge},
            BoxSelection{low, low + Vec3d{1.0, 1.0, 1e9}}};
        pins.clear();
        for (int n = whole(4); n > 0; --n) {
            pins.push_back({kinds[static_cast<std::size_t>(whole(4))], {}});
            for (int k = whole(3); k > 0; --k)
                pins.back().motion.push_back({1.0 / k + uniform() / 10.0, vector()});
        }
    }

    void draw_obstacles(std::vector<ObstacleDescription>& obstacles) {
        for (int n = whole(4); n > 0; --n) {
            obstacles.push_back({SphereObstacle{vector(), positive()}, uniform(), uniform() / 2});
            if (coin()) obstacles.back().shape = PlaneObstacle{vector(), {uniform(), 1.0, 0.0}};
        }
    }

    void draw_wind(std::optional<WindDescription>& wind) {
        if (coin()) return wind.reset();
        wind = {vector(), positive(), positive(), positive(), {}};
        if (coin()) {
            wind->gust.model = GustModel::none;
        } else {
            wind->gust = {GustModel::coefficient, uniform() / 2, positive(),
                          std::bit_cast<std::uint64_t>(uniform()) >> 1};
        }
    }

    void draw_integrator(IntegratorDescription& integrator) {
        const auto methods = integrator_catalogue();
        integrator.method =
            methods[static_cast<std::size_t>(whole(static_cast<int>(methods.size())))].name;
        if (coin()) integrator.time_step = uniform();
        integrator.precision = static_cast<Precision>(whole(2));
        if (coin()) integrator.tolerance = positive();
        if (coin()) integrator.iterations = 1 + whole(99);
        integrator.linear_solver = static_cast<LinearSolver>(whole(5));
        integrator.on_divergence = static_cast<OnDivergence>(whole(2));
    }

    void draw_output(OutputDescription& output) {
        output = {10 * uniform(), 1.0 + 99 * uniform(), {}, coin(), false};
        if (coin()) output.formats = {"npy", "glb"};
    }

    std::uint64_t seed_, drawn_ = 0;
};

TEST(SavedScene, IsEqualForRandomScenes) {
    const test::ScratchDirectory directory;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        const SceneDescription scene = RandomScene(seed).draw();
        test::expect_same_scene(scene, test::saved_and_loaded(scene, directory / "r.toml"));
    }
}

TEST(SavedScene, KeepsTheExtremesOfNumbers) {
    using Limits = std::numeric_limits<double>;
    SceneDescription scene;
    scene.cloth.grid.origin = {Limits::denorm_min(), -Limits::max(), -0.0};
    scene.forces.gravity = {0.1 + 0.2, 1.0 / 3.0, 1e15};
    scene.wind->gust.seed = std::uint64_t{1} << 62;
    const test::ScratchDirectory directory;
    const SceneDescription read = test::saved_and_loaded(scene, directory / "extreme.toml");
    test::expect_same_scene(scene, read);
    EXPECT_TRUE(std::signbit(read.cloth.grid.origin.z));
}

TEST(SavedScene, RefusesWhatNoSceneFileCanHold) {
    const test::ScratchDirectory directory;
    const auto error = [&](const SceneDescription& scene) {
        const auto thrown = test::error_of([&] { save_scene(scene, directory / "no.toml"); });
        EXPECT_TRUE(directory.names().empty());
        EXPECT_TRUE(thrown && thrown->kind() == ErrorKind::usage);
        return thrown ? std::string(thrown->what()) : std::string();
    };
    SceneDescription seed;
    seed.wind->gust.seed = std::uint64_t{1} << 63;
    EXPECT_EQ(error(seed),
              "wind.gust.seed: 9223372036854775808 is not allowed: in a scene file, at most "
              "9223372036854775807");
    SceneDescription invalid;
    invalid.cloth.grid.size = {0.0, 1.0};
    EXPECT_EQ(error(invalid), "cloth.size: [0, 1] is not allowed: two finite numbers above 0");
    SceneDescription bytes;
    bytes.render.texture = "/elsewhere/\xff.png";
    EXPECT_EQ(
        error(bytes),
        "render.texture: \"/elsewhere/\xff.png\" is not allowed: in a scene file, text in UTF-8");
    SceneDescription mesh = test::bare_sheet(3, 3);
    test::make_mesh_of_grid(mesh);
    mesh.cloth.mesh_path.clear();
    EXPECT_EQ(error(mesh),
              "cloth.mesh: \"\" is not allowed: the path of the mesh's file, to save the scene");
}

TEST(SavedScene, RunsToTheSameStateHash) {
    const test::ScratchDirectory directory;
    for (const ShippedScene& shipped : shipped_scenes()) {
        SCOPED_TRACE(shipped.name);
        const SceneDescription scene = load_scene(shipped.name);
        const fs::path file = directory / (shipped.name + ".toml");
        Simulation first(scene), second(test::saved_and_loaded(scene, file));
        for (int frame = 0; frame < 30; ++frame) {
            ASSERT_TRUE(first.advance_frame().ok());
            ASSERT_TRUE(second.advance_frame().ok());
        }
        EXPECT_EQ(first.state_hash(), second.state_hash());
        EXPECT_EQ(first.step_count(), second.step_count());
    }
}

}  // namespace
}  // namespace weft
