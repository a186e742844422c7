// The same bits for any number of threads: every method, both precisions, grids and meshes large
// enough that their loops are split.
#include <gtest/gtest.h>

#include <atomic>
#include <map>

#include "integrators/integrator.h"
#include "math/parallel.h"
#include "simulation/cloth_system.h"
#include "support/cloth_forces.h"
#include "support/methods.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

SceneDescription large_flag(bool mesh) {
    SceneDescription scene;
    scene.cloth.grid.resolution = mesh ? std::array{230, 200} : std::array{300, 200};
    scene.forces.damping = 1e-6;
    if (mesh) {
        make_mesh_of_grid(scene);
        scene.pins = {{ParticleSelection{{0, 230, 460}}, {{0.0, {}}, {1.0, {0.1, 0.0, 0.2}}}}};
    }
    return scene;
}

template <typename Real>
ParticleState<Real> after_steps(const ClothModel& cloth, const SceneDescription& scene,
                                std::string_view method, int threads) {
    ThreadTeam team(threads);
    ClothSystem<Real> system(cloth, scene, chosen_instruction_set(), threads);
    ParticleState<Real> state =
        disturbed_state<Real>(cloth, cloth.is_grid() ? cloth.shape.dx : 0.005);
    const auto integrator = make_integrator<Real>(method);
    integrator->prepare(system);
    team.run([&] {
        for (int n = 0; n < 3; ++n) integrator->step(system, 2e-5, state);
    });
    return state;
}

template <typename Real>
void expect_same_bits(const ClothModel& cloth, const SceneDescription& scene) {
    for (const IntegratorInfo& info : explicit_methods()) {
        const ParticleState<Real> one = after_steps<Real>(cloth, scene, info.name, 1);
        ASSERT_TRUE(is_finite(one.x[cloth.slot(cloth.particle_count - 1)]));
        for (const int threads : {2, 7}) {
            const ParticleState<Real> many = after_steps<Real>(cloth, scene, info.name, threads);
            EXPECT_EQ(different_bits(one.x, many.x), 0u) << info.name << " " << threads;
            EXPECT_EQ(different_bits(one.v, many.v), 0u) << info.name << " " << threads;
        }
    }
}

TEST(Threads, GiveTheSameBitsOnAGrid) {
    const SceneDescription scene = large_flag(false);
    const ClothModel cloth = build_cloth(scene);
    expect_same_bits<float>(cloth, scene);
    expect_same_bits<double>(cloth, scene);
}

TEST(Threads, GiveTheSameBitsOnAMesh) {
    const SceneDescription scene = large_flag(true);
    const ClothModel cloth = build_cloth(scene);
    expect_same_bits<float>(cloth, scene);
    expect_same_bits<double>(cloth, scene);
}

// The loops above are split indeed: with 7 threads 200 rows of 304 slots, in parts of 13 at least,
// and 182 400 components, in parts of 65 536.
TEST(Threads, ShareLoopsOfThisSize) {
    ThreadTeam team(7);
    for (const auto& [count, grain] : {std::pair{200, 13}, {182'400, 65'536}}) {
        std::atomic<int> parts = 0;
        team.run([&] {
            parallel_for(static_cast<std::size_t>(count), static_cast<std::size_t>(grain),
                         [&](std::size_t, std::size_t) { ++parts; });
        });
        EXPECT_GE(parts, 2) << count;
    }
}

// The whole simulation, with automatic step and wind.
TEST(Threads, GiveTheSameHashOfAFlag) {
    SceneDescription scene;
    scene.cloth.grid.resolution = {150, 100};
    std::map<int, std::uint64_t> hashes;
    for (const int threads : {1, 2, 7}) {
        Simulation simulation(scene, threads);
        EXPECT_EQ(simulation.threads(), threads);
        for (int n = 0; n < 2; ++n) ASSERT_TRUE(simulation.advance_frame().ok());
        hashes[threads] = simulation.state_hash();
    }
    EXPECT_EQ(hashes[2], hashes[1]);
    EXPECT_EQ(hashes[7], hashes[1]);
}

}  // namespace
}  // namespace weft::test
