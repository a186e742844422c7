// The derivative of the plate's force by velocity, against finite differences of the force.
#include "forces/air_damping.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "support/cloth_scenes.h"

namespace weft::test {
namespace {

AirConstants<double> constants(double friction) {
    WindDescription wind;
    wind.skin_friction = friction;
    return AirConstants<double>(wind);
}

Eigen::Matrix3d as_matrix(const std::array<double, 6>& m) {
    Eigen::Matrix3d full;
    full << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    return full;
}

// d force / d wind, central differences: rows are the force's components.
Eigen::Matrix3d differences(const AirConstants<double>& air, Vec3d wind, Vec3d normal) {
    Eigen::Matrix3d jacobian;
    constexpr double shift = 1e-5;
    const std::array<Vec3d, 3> axes{{{shift, 0, 0}, {0, shift, 0}, {0, 0, shift}}};
    for (int c = 0; c < 3; ++c) {
        const Vec3d e = axes[static_cast<std::size_t>(c)];
        const Vec3d d =
            (plate_force_third(air, wind + e, normal) - plate_force_third(air, wind - e, normal)) /
            (2 * shift);
        jacobian.col(c) << d.x, d.y, d.z;
    }
    return jacobian;
}

// Along the normal and within the plate all of the derivative is there; what is left out is how
// the normal force follows the wind along the plate.
TEST(AirDamping, IsTheDerivativeOfThePlatesForce) {
    const Vec3d normal{0.3, -0.5, 0.7};
    const Eigen::Vector3d n = Eigen::Vector3d(normal.x, normal.y, normal.z).normalized();
    const Eigen::Matrix3d across = n * n.transpose(), along = Eigen::Matrix3d::Identity() - across;
    for (const double friction : {0.0, 0.02, 1.5}) {
        const AirConstants<double> air = constants(friction);
        for (const Vec3d wind :
             {Vec3d{4, 1, -2}, Vec3d{0.5, -0.5, 0.7}, Vec3d{-1, 0.2, 3}, Vec3d{0.1, 0, 0}}) {
            const Eigen::Matrix3d exact = differences(air, wind, normal),
                                  damping = as_matrix(plate_damping_third(air, wind, normal));
            const double size = exact.norm();
            EXPECT_LT((across * (damping - exact) * across).norm(), 1e-7 * size);
            EXPECT_LT((along * (damping - exact) * along).norm(), 1e-7 * size);
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(damping);
            EXPECT_GT(modes.eigenvalues().minCoeff(), -1e-12 * size);
        }
    }
}

TEST(AirDamping, IsNoneWithoutWindOrArea) {
    for (const double entry : plate_damping_third(constants(0.1), {}, {0, 0, 1})) {
        EXPECT_EQ(entry, 0.0);
    }
    for (const double entry : plate_damping_third(constants(0.1), {1, 2, 3}, {})) {
        EXPECT_EQ(entry, 0.0);
    }
}

// Lumped: moving all particles alike meets the whole resistance of the cloth, on grid and mesh.
TEST(AirDamping, OfAClothIsThatOfItsPlates) {
    for (const bool mesh : {false, true}) {
        SceneDescription scene = bare_sheet(7, 5, 1.2, 0.8);
        if (mesh) make_mesh_of_grid(scene);
        const ClothModel cloth = build_cloth(scene);
        const ParticleState<double> state = rest_state<double>(cloth);
        WindDescription wind;
        SymmetricBlocks<double> blocks(cloth.layout.slot_count());
        const Vec3d blowing{2.0, 0.5, 3.0};
        AirDamping(wind, cloth).add(blowing, state.x.view(), state.v.view(), 10.0, blocks);
        // One plate of the cloth's area: its third, three times.
        const auto third =
            plate_damping_third(AirConstants<double>(wind), blowing, {0, 0, 2 * 1.2 * 0.8});
        for (std::size_t e = 0; e < 6; ++e) {
            double sum = 0.0;
            for (const double entry : blocks.entries[e]) sum += entry;
            EXPECT_NEAR(sum, 10.0 * 3.0 * third[e], 1e-12);
        }
    }
}

}  // namespace
}  // namespace weft::test
