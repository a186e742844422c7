// Where particles stand in a state's arrays is nobody's business: padding stays zero, and a mesh in
// any layout runs alike.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "integrators/integrator.h"
#include "math/largest_eigenvalue.h"
#include "simulation/cloth_system.h"
#include "simulation/engine.h"
#include "simulation/stability.h"
#include "support/cloth_forces.h"
#include "support/methods.h"

namespace weft::test {
namespace {

SceneDescription small_flag(std::string_view method = "velocity-verlet") {
    SceneDescription scene;
    scene.cloth.grid.resolution = {13, 9};
    scene.forces.damping = 1e-5;
    scene.pins = {{ParticleSelection{{0, 13, 26}}, {{0.0, {}}, {1.0, {0.1, 0.0, 0.2}}}}};
    scene.integrator.method = std::string(method);
    scene.integrator.precision = Precision::f64;
    scene.integrator.time_step = 1e-4;
    scene.output.energy_balance = true;
    return scene;
}

// Components that are not +0 and belong to no particle.
template <typename Real>
std::size_t nonzero_padding(const ClothModel& cloth, const Vec3Array<Real>& array) {
    Vec3Array<Real> rest = array;
    cloth.layout.for_each([&](std::size_t, std::size_t slot) { rest.set(slot, {}); });
    std::size_t count = 0;
    for (std::size_t n = 0; n < rest.data_size(); ++n) {
        count += rest.data()[n] != 0 || std::signbit(rest.data()[n]);
    }
    return count;
}

template <typename Real>
void expect_zero_padding(const SceneDescription& scene) {
    const ClothModel cloth = build_cloth(scene);
    ASSERT_EQ(cloth.layout.slot_count(), 9u * 16u);
    for (const IntegratorInfo& info : explicit_methods()) {
        ClothSystem<Real> system(cloth, scene);
        ParticleState<Real> state = disturbed_state<Real>(cloth, 0.1);
        const auto integrator = make_integrator<Real>(info.name);
        integrator->prepare(system);
        for (const double dt : {1e-4, 1e-4, 1e-4, 5e-5, 5e-5, 7e-5}) {
            integrator->step(system, dt, state);
        }
        EXPECT_TRUE(is_finite(state.x[cloth.slot(116)])) << info.name;
        EXPECT_EQ(nonzero_padding(cloth, state.x), 0u) << info.name;
        EXPECT_EQ(nonzero_padding(cloth, state.v), 0u) << info.name;
    }
}

TEST(Padding, StaysZeroInTheStepsOfEveryMethod) {
    expect_zero_padding<float>(small_flag());
    expect_zero_padding<double>(small_flag());
}

TEST(Padding, IsZeroInTheProductsOfTheStabilityAnalysis) {
    const SceneDescription scene = small_flag();
    const ClothModel cloth = build_cloth(scene);
    const auto state = disturbed_state<double>(cloth, 0.1);
    StabilityAnalysis<double> analysis(cloth, scene.forces);
    analysis.find(state.x.view());
    const Vec3Array<double>& mode = analysis.fastest_mode();
    EXPECT_EQ(mode.size(), cloth.layout.slot_count());
    EXPECT_NEAR(dot_product(mode, mode), 1.0, 1e-9);
    for (std::size_t s = 0; s < mode.size(); ++s) {
        if (s % 16 < 13) continue;
        EXPECT_EQ(length(mode[s]), 0.0) << s;
    }
}

// The mesh kernel sums a particle's neighbours as they stand in memory, its twin as springs are
// listed.
struct ShortRun {
    static constexpr EngineOptions scalar{InstructionSet::scalar, 1};
    std::unique_ptr<Engine> engine;
    FrameBuffer frame;

    ShortRun(const ClothModel& cloth, const SceneDescription& scene)
        : engine(scene.integrator.precision == Precision::f32
                     ? make_engine<float>(cloth, scene, scalar)
                     : make_engine<double>(cloth, scene, scalar)) {
        for (int n = 0; n < 3; ++n) EXPECT_TRUE(engine->advance_frame().ok());
        engine->capture(frame, {});
    }
};

// The user's numbers are the same to the bit: the state, its hash, work, strain; energies to
// rounding.
TEST(Layout, OfAMeshChangesNoResult) {
    for (const IntegratorInfo& info : explicit_methods()) {
        for (const Precision precision : {Precision::f32, Precision::f64}) {
            SceneDescription scene = small_flag(info.name);
            scene.integrator.precision = precision;
            make_mesh_of_grid(scene);
            const ClothModel cloth = build_cloth(scene);
            ClothModel other = cloth;
            shuffle_layout(other);
            ASSERT_NE(other.slot(1), cloth.slot(1));
            const ShortRun a(cloth, scene), b(other, scene);
            EXPECT_EQ(a.frame.positions, b.frame.positions) << info.name;
            EXPECT_EQ(a.frame.velocities, b.frame.velocities) << info.name;
            EXPECT_EQ(a.engine->state_hash(), b.engine->state_hash()) << info.name;
            const double energy = a.engine->energy().total();  // but for the order of its sum
            EXPECT_NEAR(b.engine->energy().total(), energy, 1e-13 * std::abs(energy));
            const Work work = a.engine->work(), other_work = b.engine->work();
            EXPECT_EQ(work.dashpots, other_work.dashpots);
            EXPECT_EQ(work.drag, other_work.drag);
            EXPECT_EQ(work.air, other_work.air);
            EXPECT_EQ(work.pins, other_work.pins);
            EXPECT_LT(work.drag, 0.0);
            const SpringStrain strain = a.engine->largest_strain();
            EXPECT_EQ(strain.strain, b.engine->largest_strain().strain);
            EXPECT_EQ(strain.p, b.engine->largest_strain().p);
            EXPECT_EQ(strain.q, b.engine->largest_strain().q);
        }
    }
}

// The stable step is found from the same first guess, but for the order of sums.
TEST(Layout, OfAMeshHardlyChangesTheStableStep) {
    SceneDescription scene = small_flag();
    make_mesh_of_grid(scene);
    const ClothModel cloth = build_cloth(scene);
    ClothModel other = cloth;
    shuffle_layout(other);
    const double omega = ShortRun(cloth, scene).engine->linear_analysis().omega_max;
    EXPECT_NEAR(ShortRun(other, scene).engine->linear_analysis().omega_max, omega, 1e-9 * omega);
}

// What diverged is named by its number: the first of those that a NaN has spread to.
TEST(Layout, OfAMeshNamesTheSameParticle) {
    SceneDescription scene = small_flag();
    make_mesh_of_grid(scene);
    ClothModel cloth = build_cloth(scene);
    std::vector<std::string> messages;
    for (const bool shuffled : {false, true}) {
        if (shuffled) shuffle_layout(cloth);
        ShortRun run(cloth, scene);
        run.frame.velocities[110].y = std::numeric_limits<double>::quiet_NaN();
        run.engine->set_state(run.frame.positions, run.frame.velocities);
        const FrameReport report = run.engine->advance_frame();
        ASSERT_TRUE(report.divergence);
        messages.push_back(report.divergence->message);
    }
    EXPECT_NE(messages[0].find("particle 58 "), std::string::npos) << messages[0];
    EXPECT_EQ(messages[1], messages[0]);
}

}  // namespace
}  // namespace weft::test
