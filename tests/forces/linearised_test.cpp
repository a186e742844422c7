// Products with the stiffness and damping matrices against differences of the forces.
#include <gtest/gtest.h>

#include "forces/linearised.h"
#include "support/cloth_forces.h"

namespace weft::test {
namespace {

// Every spring longer than at rest: the sheet blown up by a half, and disturbed a little.
ParticleState<double> stretched_state(const ClothModel& cloth) {
    ParticleState<double> state = rest_state<double>(cloth);
    for (std::size_t s = 0; s < state.x.size(); ++s) state.x.set(s, 1.5 * state.x[s]);
    disturb(cloth, state.x, 0.02, 3);
    cloth.for_each_spring([&](const Spring& s, const SpringConstants&) {
        EXPECT_GT(length(state.x[cloth.slot(s.q)] - state.x[cloth.slot(s.p)]), s.rest_length);
    });
    return state;
}

Vec3Array<double> direction(const ClothModel& cloth) {
    Vec3Array<double> u(cloth.layout.slot_count());
    disturb(cloth, u, 1.0, 8);
    return u;
}

// (f(x + h u) - f(x - h u)) / (2 h), at no velocity.
std::vector<Vec3d> difference_of_forces(const ClothModel& cloth, ParticleState<double> state,
                                        const Vec3Array<double>& u, double h) {
    const Vec3Array<double> x = state.x;
    std::vector<Vec3d> result(cloth.particle_count);
    for (const double side : {1.0, -1.0}) {
        for (std::size_t s = 0; s < x.size(); ++s) state.x.set(s, x[s] + side * h * u[s]);
        const std::vector<Vec3d> f = as_vectors(cloth, spring_forces(cloth, state));
        for (std::size_t p = 0; p < cloth.particle_count; ++p) result[p] += (side / (2 * h)) * f[p];
    }
    return result;
}

TEST(StiffnessProduct, IsMinusTheForcesGradientWhereSpringsAreStretched) {
    for (const bool as_mesh : {false, true}) {
        SceneDescription scene = bare_sheet(5, 4, 1.0, 0.6);
        if (as_mesh) make_mesh_of_grid(scene);
        ClothModel cloth = build_cloth(scene);
        if (as_mesh) shuffle_layout(cloth);
        const ParticleState<double> state = stretched_state(cloth);
        const Vec3Array<double> u = direction(cloth);
        Vec3Array<double> product(cloth.layout.slot_count());
        stiffness_product<double>(cloth, state.x.view(), u.view(), product.view());
        std::vector<Vec3d> sum = difference_of_forces(cloth, state, u, 1e-6);
        const double size = largest(sum);
        for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += product[cloth.slot(p)];
        EXPECT_GT(size, 50.0);
        EXPECT_LT(largest(sum), 1e-8 * size);
    }
}

// At rest only the direction along a spring is stiff: the sheet's normal is free.
TEST(StiffnessProduct, AtRestHoldsNothingAcrossTheSheet) {
    const ClothModel cloth = build_cloth(bare_sheet(5, 4));
    const auto state = rest_state<double>(cloth);
    Vec3Array<double> u(cloth.layout.slot_count()), product(cloth.layout.slot_count());
    for (std::size_t p = 0; p < cloth.particle_count; ++p)
        u.set(cloth.slot(p), {0.0, 0.0, random_vector(1, p).z});
    stiffness_product<double>(cloth, state.x.view(), u.view(), product.view());
    EXPECT_LT(largest(as_vectors(cloth, product)), 1e-12);
}

// One spring of k = 30, compressed to half: k along it, and nothing across, where the true Hessian
// has the negative k (1 - L/l) = -30.
TEST(StiffnessProduct, LeavesOutTheNegativePartOfACompressedSpring) {
    const ClothModel pair = straight_chain(2, 1.0, 1.0, 30.0);
    auto state = rest_state<double>(pair);
    state.x.set(1, {0.5, 0.0, 0.0});
    Vec3Array<double> u(2), product(2);
    u.set(1, {2.0, 3.0, -1.0});
    stiffness_product<double>(pair, state.x.view(), u.view(), product.view());
    EXPECT_EQ(product[1], (Vec3d{60.0, 0.0, 0.0}));
    EXPECT_EQ(product[0], (Vec3d{-60.0, 0.0, 0.0}));
    state.x.set(1, {1.5, 0.0, 0.0});  // stretched: a third of k across
    stiffness_product<double>(pair, state.x.view(), u.view(), product.view());
    EXPECT_LT(length(product[1] - Vec3d{60.0, 30.0, -10.0}), 1e-13);
}

TEST(StiffnessProduct, OfASpringWithoutLengthIsNothing) {
    const ClothModel pair = straight_chain(2, 1.0, 1.0, 30.0, 2.0);
    auto state = rest_state<double>(pair);
    state.x.set(1, {0.0, 0.0, 0.0});
    const Vec3Array<double> u = direction(pair);
    Vec3Array<double> product(2);
    stiffness_product<double>(pair, state.x.view(), u.view(), product.view());
    EXPECT_EQ(product[0], Vec3d{});
    damping_product<double>(pair, ForcesDescription{}, state.x.view(), u.view(), product.view());
    EXPECT_EQ(product[1], Vec3d{});
}

// Dashpots and drag are linear in velocity: the product is their force at v = u, with its sign
// changed.
TEST(DampingProduct, IsMinusTheForceOfDashpotsAndDrag) {
    for (const bool as_mesh : {false, true}) {
        SceneDescription scene = bare_sheet(5, 4, 1.0, 0.6);
        add_dashpots(scene, 0.03);
        scene.forces.damping = 0.7;
        if (as_mesh) make_mesh_of_grid(scene);
        ClothModel cloth = build_cloth(scene);
        if (as_mesh) shuffle_layout(cloth);
        ParticleState<double> state = disturbed_state<double>(cloth, 0.2);
        const std::vector<Vec3d> moving = as_vectors(cloth, spring_forces(cloth, state));
        const Vec3Array<double> u = state.v;
        state.v.fill_zero();
        const std::vector<Vec3d> still = as_vectors(cloth, spring_forces(cloth, state));
        Vec3Array<double> product(cloth.layout.slot_count());
        damping_product<double>(cloth, scene.forces, state.x.view(), u.view(), product.view());
        std::vector<Vec3d> expected;
        for (std::size_t p = 0; p < moving.size(); ++p) {
            expected.push_back(0.7 * u[cloth.slot(p)] - (moving[p] - still[p]));
        }
        EXPECT_LT(largest_difference(as_vectors(cloth, product), expected),
                  1e-13 * largest(expected));
    }
}

// Both matrices are symmetric and positive semidefinite: u.Kw = w.Ku, u.Ku >= 0.
TEST(LinearisedForces, AreSymmetricAndNotNegative) {
    SceneDescription scene = bare_sheet(5, 4);
    add_dashpots(scene, 0.03);
    const ClothModel cloth = build_cloth(scene);
    const auto state = disturbed_state<double>(cloth, 0.3);
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
        Vec3Array<double> u(cloth.layout.slot_count()), w = u, ku = u, kw = u;
        disturb(cloth, u, 1.0, seed);
        disturb(cloth, w, 1.0, seed + 100);
        const auto inner = [](const Vec3Array<double>& a, const Vec3Array<double>& b) {
            double sum = 0.0;
            for (std::size_t s = 0; s < a.size(); ++s) sum += dot(a[s], b[s]);
            return sum;
        };
        stiffness_product<double>(cloth, state.x.view(), u.view(), ku.view());
        stiffness_product<double>(cloth, state.x.view(), w.view(), kw.view());
        EXPECT_NEAR(inner(u, kw), inner(w, ku), 1e-11 * inner(u, ku));
        EXPECT_GT(inner(u, ku), 0.0);
        damping_product<double>(cloth, scene.forces, state.x.view(), u.view(), ku.view());
        damping_product<double>(cloth, scene.forces, state.x.view(), w.view(), kw.view());
        EXPECT_NEAR(inner(u, kw), inner(w, ku), 1e-11 * inner(u, ku));
        EXPECT_GT(inner(u, ku), 0.0);
    }
}

}  // namespace
}  // namespace weft::test
