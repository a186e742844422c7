// The mesh's fast kernel against its readable twins, in every instruction set of the machine.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "forces/mesh_kernel.h"
#include "math/parallel.h"
#include "support/cloth_forces.h"
#include "support/mesh_scenes.h"

namespace weft::test {
namespace {

constexpr double cell = 0.1;               // of all meshes here [m]
const Vec3d wind_blowing{3.0, 1.0, -4.0};  // [m/s]

template <typename Real>
std::vector<Real> inverse_masses(const ClothModel& cloth) {
    std::vector<Real> w(cloth.layout.slot_count());
    cloth.layout.for_each(
        [&](std::size_t p, std::size_t slot) { w[slot] = static_cast<Real>(1 / cloth.masses[p]); });
    for (const Pin& pin : cloth.pins) w[cloth.slot(pin.particle)] = 0;
    return w;
}

// g + (springs + dashpots + air - drag v) / m by the twins, zero for pins.
template <typename Real>
Vec3Array<Real> twin_acceleration(const ClothModel& cloth, const SceneDescription& scene,
                                  const ParticleState<Real>& state) {
    const std::size_t slots = cloth.layout.slot_count();
    Vec3Array<Real> a = spring_forces(cloth, state);
    if (scene.wind) {
        MeshAir<Real> air(*scene.wind, cloth.surface, cloth.layout);
        air.compute(vec3_cast<Real>(wind_blowing), state.x.view(), state.v.view(), 0,
                    air.triangle_count());
        air.add_forces(a.view(), 0, slots);
    }
    const std::vector<Real> w = inverse_masses<Real>(cloth);
    const Real drag = static_cast<Real>(scene.forces.damping);
    for (std::size_t s = 0; s < slots; ++s) {
        const Vec3<Real> gravity = vec3_cast<Real>(scene.forces.gravity);
        a.set(s, w[s] > 0 ? gravity + w[s] * (a[s] - drag * state.v[s]) : Vec3<Real>{});
    }
    return a;
}

template <typename Real>
MeshKernel<Real> kernel_of(const ClothModel& cloth, const SceneDescription& scene,
                           InstructionSet set, int threads = 1) {
    return {cloth, scene.forces, scene.wind, inverse_masses<Real>(cloth), set, threads};
}

template <typename Real>
Vec3Array<Real> kernel_acceleration(const ClothModel& cloth, const SceneDescription& scene,
                                    const ParticleState<Real>& state, InstructionSet set) {
    Vec3Array<Real> a(cloth.layout.slot_count());
    kernel_of<Real>(cloth, scene, set)
        .accelerate(vec3_cast<Real>(wind_blowing), state.x.view(), state.v.view(), a.view());
    return a;
}

// Calls visit(set) for all sets of the machine but scalar.
template <typename Visit>
void for_each_set(const Visit& visit) {
    for (std::size_t n = 1; n < instruction_sets().size(); ++n) {
        SCOPED_TRACE(std::string(instruction_sets()[n]));
        visit(static_cast<InstructionSet>(n));
    }
}

// Of the largest acceleration.
template <typename Real>
constexpr double tolerance = sizeof(Real) == 4 ? 1e-5 : 1e-13;

template <typename Real>
void expect_twin(const ClothModel& cloth, const SceneDescription& scene,
                 const ParticleState<Real>& state) {
    const auto twin = as_vectors(cloth, twin_acceleration(cloth, scene, state));
    ASSERT_GT(largest(twin), 1.0);
    for_each_set([&](InstructionSet set) {
        const auto a = as_vectors(cloth, kernel_acceleration(cloth, scene, state, set));
        EXPECT_LT(largest_difference(a, twin), tolerance<Real> * largest(twin));
        for (const Pin& pin : cloth.pins) EXPECT_EQ(length(a[pin.particle]), 0.0);
    });
}

enum class Damped { none, some, all };

SceneDescription scene_with(Mesh mesh, StiffnessPer per, Damped damped, bool air) {
    SceneDescription scene = mesh_scene(std::move(mesh));
    scene.material.stiffness_per = per;
    if (damped == Damped::all) add_dashpots(scene, 0.02);
    if (damped == Damped::some) scene.material.shear.damping = 0.7;
    scene.forces = {{0.3, -9.81, 0.1}, 0.02};
    scene.pins = {{ParticleSelection{{0, 2}}, {}}};
    if (air) scene.wind.emplace();
    return scene;
}

std::vector<Mesh> meshes() {
    std::vector<Mesh> meshes;
    meshes.push_back(tube_mesh(13, 7, cell));
    meshes.push_back(tube_mesh(3, 2, cell));
    for (const auto& [columns, rows] :
         std::initializer_list<std::array<std::uint32_t, 2>>{{2, 2},
                                                             {3, 2},
                                                             {4, 4},
                                                             {5, 3},
                                                             {11, 3},
                                                             {8, 8},
                                                             {9, 7},
                                                             {17, 16},
                                                             {23, 19},
                                                             {5, 701}}) {
        meshes.push_back(sheet_mesh(columns, rows, cell, (columns + rows) % 2 == 1));
        shuffle(meshes.back(), columns);
    }
    return meshes;
}

template <typename Real>
class MeshFastKernel : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(MeshFastKernel, Precisions);

TYPED_TEST(MeshFastKernel, AgreesWithItsTwins) {
    for (const Mesh& mesh : meshes()) {
        for (const StiffnessPer per : {StiffnessPer::spring, StiffnessPer::width}) {
            for (const Damped damped : {Damped::none, Damped::some, Damped::all}) {
                for (const bool air : {false, true}) {
                    SCOPED_TRACE(std::to_string(mesh.positions.size()) + " particles");
                    const SceneDescription scene = scene_with(mesh, per, damped, air);
                    const ClothModel cloth = build_cloth(scene);
                    expect_twin(cloth, scene, disturbed_state<TypeParam>(cloth, cell));
                }
            }
        }
    }
}

// Neighbours thousands of slots from each other, unlike in the layout that build_cloth() chooses.
TYPED_TEST(MeshFastKernel, TakesAnyLayout) {
    const SceneDescription scene =
        scene_with(sheet_mesh(5, 701, cell, true), StiffnessPer::width, Damped::all, true);
    ClothModel cloth = build_cloth(scene);
    shuffle_layout(cloth);
    expect_twin(cloth, scene, disturbed_state<TypeParam>(cloth, cell));
}

// A dashpot may be all that a spring has, and springs without either are as good as none.
TYPED_TEST(MeshFastKernel, TakesKindsWithoutStiffness) {
    SceneDescription scene =
        scene_with(sheet_mesh(9, 8, cell, false), StiffnessPer::width, Damped::none, false);
    scene.material.shear = {0.0, 0.5};
    scene.material.bend = {0.0, 0.0};
    const ClothModel cloth = build_cloth(scene);
    expect_twin(cloth, scene, disturbed_state<TypeParam>(cloth, cell));
}

// Particles in one place have no direction to push each other in; triangles lose their area.
TYPED_TEST(MeshFastKernel, TakesParticlesInOnePlace) {
    for (const Damped damped : {Damped::none, Damped::all}) {
        SceneDescription scene =
            scene_with(sheet_mesh(7, 6, cell, false), StiffnessPer::spring, damped, true);
        scene.material.particle_mass = 0.003;
        const ClothModel cloth = build_cloth(scene);
        auto state = disturbed_state<TypeParam>(cloth, cell);
        for (const std::size_t p : {8u, 9u, 15u, 16u, 24u}) {
            state.x.set(cloth.slot(p), state.x[cloth.slot(8)]);
        }
        expect_twin(cloth, scene, state);
    }
}

// A chain of which every fifth particle hangs on nothing and belongs to no triangle.
TYPED_TEST(MeshFastKernel, TakesParticlesWithoutSprings) {
    SceneDescription scene = bare_sheet(2, 2);
    scene.forces = {{0.0, -9.81, 0.0}, 0.02};
    scene.wind.emplace();
    for (const std::size_t count : {1u, 2u, 15u, 16u, 17u, 40u, 67u}) {
        ClothModel cloth = straight_chain(count, cell, 0.01, 100.0, 0.3);
        std::erase_if(cloth.springs,
                      [](const Spring& spring) { return spring.p % 5 == 0 || spring.q % 5 == 0; });
        if (count > 12) cloth.surface.triangles = {{2, 8, 11}, {8, 2, 9}};
        auto state = disturbed_state<TypeParam>(cloth, cell);
        expect_twin(cloth, scene, state);
        for_each_set([&](InstructionSet set) {
            const auto a = kernel_acceleration(cloth, scene, state, set);
            const double fall = -9.81 - 0.02 / 0.01 * static_cast<double>(state.v[0].y);
            EXPECT_NEAR(a[0].y, fall, 1e-5);
        });
    }
}

TYPED_TEST(MeshFastKernel, KicksAndDriftsByItsAcceleration) {
    const double kick = 1e-3, drift = 2e-3;
    SceneDescription scene =
        scene_with(tube_mesh(11, 9, cell), StiffnessPer::width, Damped::all, true);
    const ClothModel cloth = build_cloth(scene);
    for_each_set([&](InstructionSet set) {
        auto state = disturbed_state<TypeParam>(cloth, cell);
        const auto before = state;
        const auto a = kernel_acceleration(cloth, scene, state, set);
        kernel_of<TypeParam>(cloth, scene, set)
            .kick_drift(vec3_cast<TypeParam>(wind_blowing), kick, drift, state.x.view(),
                        state.v.view());
        const double close = 4 * std::numeric_limits<TypeParam>::epsilon();
        for (std::size_t s = 0; s < a.size(); ++s) {
            const Vec3d v = vec3_cast<double>(before.v[s]) + kick * vec3_cast<double>(a[s]);
            const Vec3d x = vec3_cast<double>(before.x[s]) + drift * v;
            EXPECT_LT(length(vec3_cast<double>(state.v[s]) - v), close * 20.0);
            EXPECT_LT(length(vec3_cast<double>(state.x[s]) - x), close * 2.0);
        }
        // Places behind the last particle stay +0, as in every state.
        for (const Vec3Array<TypeParam>* array : {&state.x, &state.v}) {
            const std::size_t stride = array->data_size() / 3;
            for (std::size_t n = 0; n < array->data_size(); ++n) {
                if (n % stride < array->size()) continue;
                EXPECT_EQ(array->data()[n], 0);
                EXPECT_FALSE(std::signbit(array->data()[n]));
            }
        }
    });
}

// What stands where in the file is nothing to a particle but rounding.
TYPED_TEST(MeshFastKernel, GivesTheSameToAMeshInRandomOrder) {
    Mesh mesh = sheet_mesh(21, 17, cell, true);
    SceneDescription ordered = scene_with(mesh, StiffnessPer::width, Damped::all, true);
    const std::vector<std::uint32_t> number = shuffle(mesh, 8);
    SceneDescription random = scene_with(mesh, StiffnessPer::width, Damped::all, true);
    random.pins = {{ParticleSelection{{number[0], number[2]}}, {}}};
    const ClothModel cloth = build_cloth(ordered), shuffled = build_cloth(random);
    const auto state = disturbed_state<TypeParam>(cloth, cell);
    auto same = rest_state<TypeParam>(shuffled);
    for (std::size_t p = 0; p < number.size(); ++p) {
        same.x.set(shuffled.slot(number[p]), state.x[cloth.slot(p)]);
        same.v.set(shuffled.slot(number[p]), state.v[cloth.slot(p)]);
    }
    for_each_set([&](InstructionSet set) {
        const auto a = as_vectors(cloth, kernel_acceleration(cloth, ordered, state, set));
        const auto b = as_vectors(shuffled, kernel_acceleration(shuffled, random, same, set));
        for (std::size_t p = 0; p < number.size(); ++p) {
            EXPECT_LT(length(a[p] - b[number[p]]), tolerance<TypeParam> * largest(a)) << p;
        }
    });
}

// 60 021 particles: seven parts, of odd sizes.
TYPED_TEST(MeshFastKernel, GivesTheSameBitsOnAnyNumberOfThreads) {
    Mesh mesh = sheet_mesh(243, 247, cell, false);
    shuffle(mesh, 9);
    const SceneDescription scene =
        scene_with(std::move(mesh), StiffnessPer::spring, Damped::all, true);
    const ClothModel cloth = build_cloth(scene);
    for_each_set([&](InstructionSet set) {
        const auto run = [&](int threads) {
            auto state = disturbed_state<TypeParam>(cloth, cell);
            auto kernel = kernel_of<TypeParam>(cloth, scene, set, threads);
            ThreadTeam(threads).run([&] {
                for (int n = 0; n < 3; ++n) {
                    kernel.kick_drift(vec3_cast<TypeParam>(wind_blowing), 1e-4, 1e-4,
                                      state.x.view(), state.v.view());
                }
            });
            return state;
        };
        const auto one = run(1);
        for (const int threads : {2, 7}) {
            const auto several = run(threads);
            EXPECT_EQ(different_bits(one.x, several.x), 0u) << threads;
            EXPECT_EQ(different_bits(one.v, several.v), 0u) << threads;
        }
    });
}

}  // namespace
}  // namespace weft::test
