// What must hold of the spring forces: the gradient of their energy, no net force or torque,
// dashpots that only take energy, the third law.
#include <gtest/gtest.h>

#include <ostream>

#include "forces/energy.h"
#include "support/cloth_forces.h"
#include "support/naive_cloth.h"

namespace weft::test {
namespace {

struct Case {
    const char* name;
    StiffnessPer per;
    BendLayout layout;
    bool mesh;

    friend std::ostream& operator<<(std::ostream& out, const Case& cloth) {
        return out << cloth.name;
    }
};

class SpringForces : public ::testing::TestWithParam<Case> {
protected:
    SpringForces() : scene_(bare_sheet(5, 4, 1.0, 0.6)) {
        scene_.material.stiffness_per = GetParam().per;
        scene_.material.bend_layout = GetParam().layout;
        if (GetParam().mesh) make_mesh_of_grid(scene_);
    }

    [[nodiscard]] std::vector<Vec3d> forces(const ParticleState<double>& state) const {
        const ClothModel cloth = model();
        return as_vectors(cloth, spring_forces(cloth, state));
    }

    // A mesh's particles out of order: nothing may take a slot for a particle.
    [[nodiscard]] ClothModel model() const {
        ClothModel cloth = build_cloth(scene_);
        if (GetParam().mesh) shuffle_layout(cloth);
        return cloth;
    }

    SceneDescription scene_;
};

// f = -dE/dx by central differences, for each kind of spring by itself.
TEST_P(SpringForces, AreTheGradientOfTheirEnergyByKind) {
    const MaterialDescription all = scene_.material;
    for (int kind = 0; kind < 3; ++kind) {
        scene_.material.structural = kind == 0 ? all.structural : SpringMaterial{};
        scene_.material.shear = kind == 1 ? all.shear : SpringMaterial{};
        scene_.material.bend = kind == 2 ? all.bend : SpringMaterial{};
        const ClothModel cloth = model();
        ParticleState<double> state = disturbed_state<double>(cloth, 0.2);
        const std::vector<Vec3d> f = forces(state);
        ASSERT_GT(largest(f), 0.01);
        const auto stored = [&] {
            const Energy e = energy(cloth, scene_.forces, std::as_const(state.x).view(),
                                    std::as_const(state.v).view());
            EXPECT_EQ(e.springs(), kind == 0 ? e.structural : kind == 1 ? e.shear : e.bend);
            return e.springs();
        };
        constexpr double h = 1e-6;
        for (std::size_t p = 0; p < cloth.particle_count; ++p) {
            const std::size_t slot = cloth.slot(p);
            const Vec3d x = state.x[slot];
            const std::array<Vec3d, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
            for (const Vec3d axis : axes) {
                state.x.set(slot, x + h * axis);
                const double above = stored();
                state.x.set(slot, x - h * axis);
                const double below = stored();
                state.x.set(slot, x);
                EXPECT_NEAR(dot(f[p], axis), -(above - below) / (2 * h), 1e-8 * largest(f));
            }
        }
    }
}

TEST_P(SpringForces, HaveNoNetForceAndNoNetTorque) {
    add_dashpots(scene_, 0.02);
    const ClothModel cloth = model();
    const ParticleState<double> state = disturbed_state<double>(cloth, 0.2);
    const std::vector<Vec3d> f = forces(state);
    EXPECT_LT(length(sum_of(f)), 1e-14 * largest(f) * 20);
    EXPECT_LT(length(torque_of(as_vectors(cloth, state.x), f)), 1e-14 * largest(f) * 20);
}

// P = sum f.v of the dashpots alone = -sum c rate^2, below zero; equal to what the report uses.
TEST_P(SpringForces, OfDashpotsTakeEnergy) {
    add_dashpots(scene_, 0.02);
    for (SpringMaterial* spring :
         {&scene_.material.structural, &scene_.material.shear, &scene_.material.bend}) {
        spring->stiffness = 0.0;
    }
    const ClothModel cloth = model();
    const ParticleState<double> state = disturbed_state<double>(cloth, 0.2);
    const std::vector<Vec3d> f = forces(state);
    double power = 0.0, expected = 0.0;
    for (std::size_t p = 0; p < f.size(); ++p) power += dot(f[p], state.v[cloth.slot(p)]);
    cloth.for_each_spring([&](const Spring& s, const SpringConstants& c) {
        const std::size_t p = cloth.slot(s.p), q = cloth.slot(s.q);
        const Vec3d d = state.x[q] - state.x[p];
        const double rate = dot(state.v[q] - state.v[p], d) / length(d);
        expected -= c.damping * rate * rate;
    });
    EXPECT_LT(power, -0.1);
    EXPECT_NEAR(power, expected, 1e-13 * std::abs(expected));
    EXPECT_NEAR(dashpot_power<double>(cloth, state.x.view(), state.v.view()), expected,
                1e-13 * std::abs(expected));
}

// A rigid motion, v = w x x + u, changes no length: no dashpot pulls.
TEST_P(SpringForces, OfDashpotsVanishInARigidMotion) {
    add_dashpots(scene_, 5.0);
    const ClothModel cloth = model();
    ParticleState<double> state = disturbed_state<double>(cloth, 0.2), still = state;
    cloth.layout.for_each([&](std::size_t, std::size_t s) {
        state.v.set(s, cross(Vec3d{1.0, -2.0, 3.0}, state.x[s]) + Vec3d{4.0, 5.0, 6.0});
        still.v.set(s, {});
    });
    EXPECT_LT(largest_difference(forces(state), forces(still)), 1e-11);
    EXPECT_NEAR(dashpot_power<double>(cloth, state.x.view(), state.v.view()), 0.0, 1e-20);
}

// Moved and turned as a whole, the forces turn with the cloth.
TEST_P(SpringForces, TurnWithTheCloth) {
    add_dashpots(scene_, 0.02);
    const ClothModel cloth = model();
    ParticleState<double> state = disturbed_state<double>(cloth, 0.2);
    const std::vector<Vec3d> f = forces(state);
    const auto turn = [](Vec3d a) {
        return Vec3d{0.36 * a.x + 0.48 * a.y - 0.8 * a.z, -0.8 * a.x + 0.6 * a.y,
                     0.48 * a.x + 0.64 * a.y + 0.6 * a.z};
    };
    cloth.layout.for_each([&](std::size_t, std::size_t s) {
        state.x.set(s, turn(state.x[s]) + Vec3d{2.0, -1.0, 0.5});
        state.v.set(s, turn(state.v[s]) + Vec3d{-3.0, 0.0, 1.0});
    });
    std::vector<Vec3d> turned;
    for (const Vec3d a : f) turned.push_back(turn(a));
    EXPECT_LT(largest_difference(forces(state), turned), 1e-12 * largest(f));
}

INSTANTIATE_TEST_SUITE_P(
    Cloths, SpringForces,
    ::testing::Values(Case{"GridPerSpring", StiffnessPer::spring, BendLayout::interior, false},
                      Case{"GridPerWidth", StiffnessPer::width, BendLayout::interior, false},
                      Case{"GridWithBorderBend", StiffnessPer::width, BendLayout::border, false},
                      Case{"MeshPerSpring", StiffnessPer::spring, BendLayout::interior, true},
                      Case{"MeshPerWidth", StiffnessPer::width, BendLayout::interior, true}),
    [](const auto& cloth) { return cloth.param.name; });

// k (l - L) + c rate on one spring, by hand: L = 1 m, l = 1.5 m, closing at 0.4 m/s.
TEST(SpringForce, OfOneSpringIsStiffnessTimesStretchPlusDampingTimesRate) {
    ClothModel pair = straight_chain(2, 1.0, 1.0, 30.0, 5.0);
    ParticleState<double> state = rest_state<double>(pair);
    state.x.set(1, {0.0, 1.5, 0.0});
    state.v.set(1, {7.0, -0.4, 2.0});  // across the spring nothing is damped
    const Vec3Array<double> f = spring_forces(pair, state);
    EXPECT_NEAR(f[0].y, 30.0 * 0.5 - 5.0 * 0.4, 1e-14);
    EXPECT_EQ(f[0].x, 0.0);
    EXPECT_EQ(f[0].z, 0.0);
    state.x.set(1, {0.0, 0.25, 0.0});  // compressed: pushed apart
    EXPECT_NEAR(spring_forces(pair, state)[0].y, -30.0 * 0.75 - 5.0 * 0.4, 1e-14);
}

template <typename Real>
void expect_opposite_to_the_bit(const ClothModel& cloth, std::size_t p, std::size_t q) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const auto state = disturbed_state<Real>(cloth, 1.0, seed);
        const Vec3Array<Real> f = spring_forces(cloth, state);
        ASSERT_NE(f[cloth.slot(p)], Vec3<Real>{});
        ASSERT_EQ(f[cloth.slot(p)], -f[cloth.slot(q)]) << seed;
    }
}

// Newton's third law to the bit: the two diagonals of a single cell, and a lone pair of a mesh.
TEST(SpringForce, OnBothEndsIsOppositeToTheBit) {
    SceneDescription scene = bare_sheet(2, 2);
    scene.material.structural = {};
    add_dashpots(scene, 0.02);
    const ClothModel cell = build_cloth(scene);
    const ClothModel pair = straight_chain(2, 1.0, 1.0, 30.0, 5.0);
    expect_opposite_to_the_bit<float>(cell, 0, 3);
    expect_opposite_to_the_bit<float>(cell, 1, 2);
    expect_opposite_to_the_bit<double>(cell, 0, 3);
    expect_opposite_to_the_bit<float>(pair, 0, 1);
    expect_opposite_to_the_bit<double>(pair, 0, 1);
}

// Where a spring has no length it has no direction: no force, and no NaN.
template <typename Real>
void expect_no_force_at_one_point(const SceneDescription& scene) {
    const ClothModel cloth = build_cloth(scene);
    ParticleState<Real> state = rest_state<Real>(cloth);
    for (std::size_t s = 0; s < state.x.size(); ++s) state.x.set(s, {1, 2, 3});
    disturb(cloth, state.v, 1.0, 3);
    const Vec3Array<Real> f = spring_forces(cloth, state);
    for (std::size_t s = 0; s < f.size(); ++s) EXPECT_EQ(f[s], Vec3<Real>{});
    EXPECT_EQ(dashpot_power<Real>(cloth, state.x.view(), state.v.view()), 0.0);
}

TEST(SpringForce, IsNoneWhereTheLengthIsZero) {
    SceneDescription scene = bare_sheet(4, 4);
    add_dashpots(scene, 0.02);
    expect_no_force_at_one_point<float>(scene);
    expect_no_force_at_one_point<double>(scene);
    make_mesh_of_grid(scene);
    expect_no_force_at_one_point<float>(scene);
    expect_no_force_at_one_point<double>(scene);
}

}  // namespace
}  // namespace weft::test
