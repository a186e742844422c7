// What is measured once a frame, by the kernels of every instruction set, against the readable
// twins: over sizes with rows of whole vectors and rows with tails, on grids and meshes.
#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <string>

#include "forces/energy.h"
#include "forces/measure_cloth.h"
#include "math/parallel.h"
#include "support/cloth_scenes.h"

namespace weft::test {
namespace {

struct Size {
    int columns, rows;
};

const std::vector<Size> sizes{{2, 2},  {2, 3},  {3, 2},  {3, 3},  {4, 5},  {5, 9},  {7, 7},
                              {8, 4},  {9, 3},  {10, 3}, {15, 6}, {16, 5}, {17, 4}, {18, 3},
                              {19, 3}, {31, 3}, {32, 2}, {33, 7}, {34, 3}, {35, 2}, {65, 5}};

constexpr double cell = 0.1;  // [m]

SceneDescription scene_of(Size size, BendLayout layout) {
    SceneDescription scene = bare_sheet(size.columns, size.rows, cell * (size.columns - 1),
                                        1.3 * cell * (size.rows - 1));
    scene.material.stiffness_per = StiffnessPer::width;  // borders differ
    scene.material.bend_layout = layout;
    scene.forces.gravity = {0.7, -9.81, 1.3};
    return scene;
}

// Calls visit(cloth, forces) for grids, their meshes, and meshes whose particles stand elsewhere.
template <typename Visit>
void for_each_cloth(const std::vector<Size>& these, const Visit& visit) {
    for (const Size size : these) {
        for (const BendLayout layout : {BendLayout::interior, BendLayout::border}) {
            SceneDescription scene = scene_of(size, layout);
            SCOPED_TRACE(std::to_string(size.columns) + " x " + std::to_string(size.rows));
            visit(build_cloth(scene), scene.forces);
            if (layout == BendLayout::border) continue;  // meshes have but one
            SCOPED_TRACE("as a mesh");
            make_mesh_of_grid(scene);
            ClothModel mesh = build_cloth(scene);
            visit(mesh, scene.forces);
            shuffle_layout(mesh);
            visit(mesh, scene.forces);
        }
    }
}

std::vector<InstructionSet> all_sets() {
    std::vector<InstructionSet> sets;
    for (std::size_t n = 0; n < instruction_sets().size(); ++n) {
        sets.push_back(static_cast<InstructionSet>(n));
    }
    return sets;
}

// The same, with visit(cloth, measures, forces) for every instruction set.
template <typename Real, typename Visit>
void for_each_kernel(const std::vector<Size>& these, const Visit& visit) {
    for_each_cloth(these, [&](const ClothModel& cloth, const ForcesDescription& forces) {
        for (const InstructionSet set : all_sets()) {
            SCOPED_TRACE(name_of(set));
            ClothMeasures<Real> measures(cloth, forces, set);
            visit(cloth, measures, forces);
        }
    });
}

template <typename Real>
class Measure : public ::testing::Test {
protected:
    /// Of strains: squared lengths are rounded as the state is.
    static constexpr double strain_tolerance = sizeof(Real) == 4 ? 1e-6 : 2e-15;
    /// Of unit normals: in double the twin's sums in float are what is left.
    static constexpr float normal_tolerance = sizeof(Real) == 4 ? 5e-6F : 1e-6F;
};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Measure, Precisions);

template <typename Real>
void expect_strain_of_twin(const ClothModel& cloth, ClothMeasures<Real>& measures,
                           const ParticleState<Real>& state, double tolerance) {
    const auto x = state.x.view(), v = state.v.view();
    const SpringStrain twin = largest_strain(cloth, x);
    const StrainCheck check = measures.check(x, v);
    EXPECT_TRUE(check.finite);
    tolerance *= 1.0 + std::abs(twin.strain);
    EXPECT_NEAR(check.strain, std::abs(twin.strain), tolerance);
    const SpringStrain found = measures.largest_strain(x, check);
    EXPECT_NEAR(std::abs(found.strain), std::abs(twin.strain), tolerance);
    // The spring that is named has the strain that is said.
    if (std::abs(twin.strain) < 1e-3) return;
    bool named = false;
    cloth.for_each_spring([&](const Spring& spring, const SpringConstants&) {
        if (spring.p != std::min(found.p, found.q) || spring.q != std::max(found.p, found.q))
            return;
        const Vec3d d = vec3_cast<double>(state.x[cloth.slot(spring.q)]) -
                        vec3_cast<double>(state.x[cloth.slot(spring.p)]);
        named |= std::abs(length(d) / spring.rest_length - 1.0 - found.strain) < 1e-12 &&
                 spring_kind_names[static_cast<std::size_t>(spring.kind)] == found.kind;
    });
    EXPECT_TRUE(named) << found.kind << " " << found.p << " " << found.q;
}

TYPED_TEST(Measure, OfStrainIsThatOfTheTwin) {
    for_each_kernel<TypeParam>(sizes, [&](const ClothModel& cloth, auto& measures, const auto&) {
        ParticleState<TypeParam> state = disturbed_state<TypeParam>(cloth, cell);
        expect_strain_of_twin(cloth, measures, state, this->strain_tolerance);
        state = rest_state<TypeParam>(cloth);
        expect_strain_of_twin(cloth, measures, state, this->strain_tolerance);
        for (std::size_t n = 0; n < state.x.data_size(); ++n) {
            state.x.data()[n] *= TypeParam(0.3);  // every spring is shortened alike
        }
        expect_strain_of_twin(cloth, measures, state, this->strain_tolerance);
    });
}

// One particle away from its place: its own springs alone are strained, wherever it stands.
TYPED_TEST(Measure, OfStrainSeesEverySpring) {
    const std::vector<Size> these{{2, 2},  {3, 4},  {9, 3},  {16, 3},
                                  {17, 4}, {18, 2}, {19, 3}, {35, 3}};
    for_each_kernel<TypeParam>(these, [&](const ClothModel& cloth, auto& measures, const auto&) {
        ParticleState<TypeParam> state = rest_state<TypeParam>(cloth);
        for (std::size_t p = 0; p < cloth.particle_count; ++p) {
            const auto place = state.x[cloth.slot(p)];
            state.x.set(cloth.slot(p),
                        place + Vec3<TypeParam>{TypeParam(0.03), TypeParam(0.04), TypeParam(0.2)});
            expect_strain_of_twin(cloth, measures, state, this->strain_tolerance);
            state.x.set(cloth.slot(p), place);
        }
    });
}

void scale_rest_lengths(ClothModel& cloth, SpringKind kind, double factor) {
    for (GridSpringFamily& family : cloth.families) {
        if (family.kind == kind) family.rest_length *= factor;
    }
    for (Spring& spring : cloth.springs) {
        if (spring.kind == kind) spring.rest_length *= factor;
    }
}

// One kind of springs is far too short, or too long: of these, the ones at the moved particle are
// the farthest from their rest length.
TYPED_TEST(Measure, OfStrainSeesEverySpringOfEachKind) {
    const std::vector<Size> these{{3, 3}, {9, 5}, {17, 4}, {19, 3}, {35, 3}};
    for_each_cloth(these, [&](ClothModel cloth, const ForcesDescription& forces) {
        for (const SpringKind kind :
             {SpringKind::structural, SpringKind::shear, SpringKind::bend}) {
            for (const double factor : {1.0 / 3.0, 3.0}) {
                scale_rest_lengths(cloth, kind, factor);
                for (const InstructionSet set : all_sets()) {
                    SCOPED_TRACE(name_of(set));
                    ClothMeasures<TypeParam> measures(cloth, forces, set);
                    ParticleState<TypeParam> state = rest_state<TypeParam>(cloth);
                    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
                        const auto place = state.x[cloth.slot(p)];
                        for (const double way : {0.04, -0.04}) {
                            state.x.set(cloth.slot(p),
                                        place + vec3_cast<TypeParam>(Vec3d{way, 0.8 * way, 0.0}));
                            expect_strain_of_twin(cloth, measures, state, this->strain_tolerance);
                        }
                        state.x.set(cloth.slot(p), place);
                    }
                }
                scale_rest_lengths(cloth, kind, 1.0 / factor);
            }
        }
    });
}

TYPED_TEST(Measure, FindsWhatIsNotFiniteWhereverItStands) {
    using Limits = std::numeric_limits<TypeParam>;
    const std::vector<Size> these{{2, 2}, {5, 3}, {16, 2}, {17, 3}, {19, 2}, {33, 3}};
    for_each_kernel<TypeParam>(these, [&](const ClothModel& cloth, auto& measures, const auto&) {
        ParticleState<TypeParam> state = disturbed_state<TypeParam>(cloth, cell);
        const auto finite = [&] { return measures.check(state.x.view(), state.v.view()).finite; };
        EXPECT_TRUE(finite());
        for (std::size_t p = 0; p < cloth.particle_count; ++p) {
            const std::size_t slot = cloth.slot(p);
            for (Vec3Array<TypeParam>* array : {&state.x, &state.v}) {
                const auto view = array->view();
                for (TypeParam* component : {view.x, view.y, view.z}) {
                    for (const TypeParam bad :
                         {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
                        const TypeParam good = std::exchange(component[slot], bad);
                        EXPECT_FALSE(finite()) << "particle " << p;
                        component[slot] = good;
                    }
                }
            }
        }
        EXPECT_TRUE(finite());
    });
}

// Finite places whose distance is not: the twins in double are asked, never passed over.
TYPED_TEST(Measure, OfStrainDoesNotPassOverWhatOverflows) {
    for_each_kernel<TypeParam>({{17, 3}}, [](const ClothModel& cloth, auto& measures, const auto&) {
        ParticleState<TypeParam> state = rest_state<TypeParam>(cloth);
        state.x.set(cloth.slot(16), {std::numeric_limits<TypeParam>::max(), 0, 0});
        const StrainCheck check = measures.check(state.x.view(), state.v.view());
        EXPECT_TRUE(!check.finite || check.strain > 1e30);
    });
}

TYPED_TEST(Measure, OfEnergyIsThatOfTheTwin) {
    for_each_kernel<TypeParam>(
        sizes, [](const ClothModel& cloth, auto& measures, const ForcesDescription& forces) {
            const auto state = disturbed_state<TypeParam>(cloth, cell);
            const Energy twin = energy(cloth, forces, state.x.view(), state.v.view());
            const Energy got = measures.energy(state.x.view(), state.v.view());
            EXPECT_GT(twin.kinetic, 0.0);
            EXPECT_GT(twin.shear, 0.0);
            const auto expect_near = [](double a, double b) {
                EXPECT_NEAR(a, b, 1e-13 * (1.0 + std::abs(b)));
            };
            expect_near(got.kinetic, twin.kinetic);
            expect_near(got.gravity, twin.gravity);
            expect_near(got.structural, twin.structural);
            expect_near(got.shear, twin.shear);
            expect_near(got.bend, twin.bend);
        });
}

template <typename Real>
std::vector<Vec3d> positions_of(const ClothModel& cloth, const Vec3Array<Real>& array) {
    std::vector<Vec3d> positions;
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        positions.push_back(vec3_cast<double>(array[cloth.slot(p)]));
    }
    return positions;
}

TYPED_TEST(Measure, OfNormalsIsThatOfTheTwin) {
    for_each_kernel<TypeParam>(sizes, [&](const ClothModel& cloth, auto& measures, const auto&) {
        const auto state = disturbed_state<TypeParam>(cloth, cell);
        const std::size_t count = cloth.particle_count;
        std::vector<Vec3f> twin(count), got(count + 1, Vec3f{7, 8, 9});
        compute_normals(cloth.surface, positions_of(cloth, state.x), twin);
        measures.normals(state.x.view(), std::span(got).first(count));
        for (std::size_t p = 0; p < count; ++p) {
            EXPECT_LT(length(got[p] - twin[p]), this->normal_tolerance) << "particle " << p;
        }
        EXPECT_EQ(got[count], (Vec3f{7, 8, 9}));  // nothing beyond the end
    });
}

TYPED_TEST(Measure, OfNormalsIsZeroWithoutArea) {
    for_each_kernel<TypeParam>({{19, 4}}, [](const ClothModel& cloth, auto& measures, const auto&) {
        ParticleState<TypeParam> state = rest_state<TypeParam>(cloth);
        cloth.layout.for_each([&](std::size_t, std::size_t slot) { state.x.set(slot, {1, 2, 3}); });
        std::vector<Vec3f> normals(cloth.particle_count, Vec3f{7, 8, 9});
        measures.normals(state.x.view(), normals);
        for (const Vec3f normal : normals) EXPECT_EQ(normal, Vec3f{});
    });
}

TYPED_TEST(Measure, CopiesEveryParticleToTheBit) {
    for_each_kernel<TypeParam>(sizes, [](const ClothModel& cloth, auto& measures, const auto&) {
        const auto state = disturbed_state<TypeParam>(cloth, cell);
        const std::vector<Vec3d> twin = positions_of(cloth, state.x);
        const std::size_t count = cloth.particle_count;
        std::vector<Vec3d> exact(count + 1, Vec3d{7, 8, 9});
        std::vector<Vec3f> rounded(count + 1, Vec3f{7, 8, 9});
        measures.copy(state.x.view(), std::span(exact).first(count));
        measures.copy(state.x.view(), std::span(rounded).first(count));
        for (std::size_t p = 0; p < count; ++p) {
            EXPECT_EQ(exact[p], twin[p]);
            EXPECT_EQ(rounded[p], vec3_cast<float>(twin[p]));
        }
        EXPECT_EQ(exact[count], (Vec3d{7, 8, 9}));  // nothing beyond the end
        EXPECT_EQ(rounded[count], (Vec3f{7, 8, 9}));
    });
}

// The hash as it is defined, by particle.
template <typename Real>
std::uint64_t plain_hash(const ClothModel& cloth, const ParticleState<Real>& state) {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    std::uint64_t sum = cloth.particle_count, index = 0;
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        const Vec3<Real> x = state.x[cloth.slot(p)], v = state.v[cloth.slot(p)];
        for (const Real component : {x.x, x.y, x.z, v.x, v.y, v.z}) {
            sum += mix_bits(std::bit_cast<Bits>(component) + index++ * 0xd6e8feb86659fd93u);
        }
    }
    return mix_bits(sum);
}

TYPED_TEST(Measure, OfTheHashIsTheSameForEveryInstructionSetAndLayout) {
    for_each_kernel<TypeParam>(sizes, [](const ClothModel& cloth, auto& measures, const auto&) {
        const auto state = disturbed_state<TypeParam>(cloth, cell);
        EXPECT_EQ(measures.state_hash(state.x.view(), state.v.view()), plain_hash(cloth, state));
    });
}

template <typename Real>
struct Results {
    StrainCheck check;
    Energy energy;
    std::vector<Vec3f> normals;
    std::vector<Vec3d> copy;
    std::uint64_t hash = 0;
};

template <typename Real>
Results<Real> results_with(int threads, const ClothModel& cloth, const ForcesDescription& forces,
                           InstructionSet set) {
    const auto state = disturbed_state<Real>(cloth, cell);
    const auto x = state.x.view(), v = state.v.view();
    Results<Real> results;
    results.normals.resize(cloth.particle_count);
    results.copy.resize(cloth.particle_count);
    ThreadTeam team(threads);
    team.run([&] {
        ClothMeasures<Real> measures(cloth, forces, set);
        results.check = measures.check(x, v);
        results.energy = measures.energy(x, v);
        measures.normals(x, results.normals);
        measures.copy(x, std::span(results.copy));
        results.hash = measures.state_hash(x, v);
    });
    return results;
}

TYPED_TEST(Measure, GivesTheSameBitsForAnyThreads) {
    for_each_cloth({{300, 250}}, [](const ClothModel& cloth, const ForcesDescription& forces) {
        for (const InstructionSet set : all_sets()) {
            const auto one = results_with<TypeParam>(1, cloth, forces, set);
            for (const int threads : {2, 7}) {
                const auto many = results_with<TypeParam>(threads, cloth, forces, set);
                EXPECT_EQ(many.check.finite, one.check.finite);
                EXPECT_EQ(many.check.strain, one.check.strain);
                EXPECT_EQ(many.check.place, one.check.place);
                EXPECT_EQ(many.energy.kinetic, one.energy.kinetic);
                EXPECT_EQ(many.energy.gravity, one.energy.gravity);
                EXPECT_EQ(many.energy.springs(), one.energy.springs());
                EXPECT_EQ(many.normals, one.normals);
                EXPECT_EQ(many.copy, one.copy);
                EXPECT_EQ(many.hash, one.hash);
            }
        }
    });
}

}  // namespace
}  // namespace weft::test
