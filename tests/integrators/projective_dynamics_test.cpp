// Projective dynamics: its global step, its acceleration, its tolerance, its failure.
#include "integrators/projective_dynamics.h"

#include <gtest/gtest.h>

#include "support/cloth_scenes.h"
#include "support/spring_system.h"

namespace weft::test {
namespace {

constexpr Vec3d gravity{0.0, -9.81, 0.0};

ClothModel sheet(double stiffness = 1000.0) {
    SceneDescription scene = bare_sheet(17, 13);
    scene.material.structural.stiffness = stiffness;
    scene.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    return build_cloth(scene);
}

struct Outcome {
    Vec3Array<double> x;
    SolverCounts counts;
};

Outcome step_once(const ClothModel& cloth, const ProjectiveDynamics<double>::Settings& settings) {
    SpringSystem<double> system(cloth, gravity);
    ParticleState<double> state = rest_state<double>(cloth);
    disturb(cloth, state.v, 0.1, 3);
    system.constrain(0.0, state.x.view(), state.v.view());
    ProjectiveDynamics<double> method(settings);
    method.prepare(system);
    EXPECT_TRUE(method.step(system, 1.0 / 60, state).ok());
    return {state.x, method.counts()};
}

// (M/h^2 + L) d = r against Eigen's dense solution, assembled here from the springs.
TEST(ProjectiveMatrix, SolvesItsDefinition) {
    SceneDescription scene = bare_sheet(6, 5);
    add_dashpots(scene, 0.01);
    scene.pins = {{EdgeSelection::top_left, {}}};
    const ClothModel cloth = build_cloth(scene);
    const SpringNetwork network = spring_network(cloth);
    const double h = 0.02;
    const auto size = static_cast<Eigen::Index>(network.inverse_masses.size());
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
    for (const SpringNetwork::Spring& s : network.springs) {
        Eigen::VectorXd e = Eigen::VectorXd::Zero(size);
        e(s.p) = 1;
        e(s.q) = -1;
        dense += (s.stiffness + s.damping / h) * e * e.transpose();
    }
    for (Eigen::Index s = 0; s < size; ++s) {
        const double w = network.inverse_masses[static_cast<std::size_t>(s)];
        if (w > 0.0) {
            dense(s, s) += 1 / (w * h * h);
        } else {  // pins and padding: d = 0
            dense.row(s).setZero();
            dense.col(s).setZero();
            dense(s, s) = 1;
        }
    }
    ProjectiveMatrix matrix;
    matrix.analyse(network);
    ASSERT_TRUE(matrix.factor(network, h));
    Vec3Array<double> r(network.inverse_masses.size()), d(network.inverse_masses.size());
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(size, 3);
    for (std::size_t s = 0; s < r.size(); ++s) {
        r.set(s, random_vector(9, s));
        if (network.inverse_masses[s] == 0.0) continue;
        right.row(static_cast<Eigen::Index>(s)) << r[s].x, r[s].y, r[s].z;
    }
    matrix.solve(r, d);
    const Eigen::MatrixX3d expected = dense.partialPivLu().solve(right);
    for (std::size_t s = 0; s < r.size(); ++s) {
        const auto row = expected.row(static_cast<Eigen::Index>(s));
        EXPECT_LT(length(d[s] - Vec3d{row(0), row(1), row(2)}), 1e-15 + 1e-12 * row.norm());
    }
}

// One local and one global step by hand: 0.1 kg on a spring of L = 1 m, k = 50 N/m from the origin,
// at y = (0.3, -1.1): p = L y / |y|, x = (m/h^2 y + k p) / (m/h^2 + k) with m/h^2 = 10.
TEST(ProjectiveDynamics, TakesALocalAndAGlobalStep) {
    ClothModel cloth = straight_chain(2, 1.0, 0.1, 50.0);
    pin_at_rest(cloth, 0);
    SpringSystem<double> system(cloth, {0.0, 0.0, 0.0});
    ParticleState<double> state = rest_state<double>(cloth);
    const Vec3d y{0.3, -1.1, 0.0};
    state.x.set(1, y);
    ProjectiveDynamics<double> method({1, 0.0, 0});
    method.prepare(system);
    method.step(system, 0.1, state);
    const Vec3d expected = (10.0 * y + (50.0 / length(y)) * y) / 60.0;
    EXPECT_LT(length(state.x[1] - expected), 1e-14);
    EXPECT_EQ(method.counts().newton_iterations, 1u);
    EXPECT_EQ(method.counts().linear_iterations, 1u);
}

TEST(ProjectiveDynamics, ConvergesFasterWithLimitedMemory) {
    const ClothModel cloth = sheet();
    const Vec3Array<double> limit = step_once(cloth, {5000, 1e-13, 5}).x;
    const double plain = largest_distance(step_once(cloth, {100, 0.0, 0}).x, limit);
    const double accelerated = largest_distance(step_once(cloth, {100, 0.0, 5}).x, limit);
    EXPECT_LT(5 * accelerated, plain);
}

TEST(ProjectiveDynamics, EndsWithinItsTolerance) {
    const ClothModel cloth = sheet();
    const Outcome exact = step_once(cloth, {5000, 1e-13, 5});
    const Outcome rough = step_once(cloth, {5000, 1e-5, 5});
    EXPECT_LT(rough.counts.newton_iterations, exact.counts.newton_iterations / 2);
    EXPECT_LT(largest_distance(rough.x, exact.x), 1e-3);
}

TEST(ProjectiveDynamics, FactorsAnewForAnotherStepOnly) {
    const ClothModel cloth = sheet();
    SpringSystem<double> system(cloth, gravity);
    const auto positions = [&](double first_step) {
        ProjectiveDynamics<double> method({1, 0.0, 0});
        method.prepare(system);
        ParticleState<double> state = rest_state<double>(cloth);
        method.step(system, first_step, state);
        state = rest_state<double>(cloth);
        method.step(system, 0.01, state);
        return state.x;
    };
    EXPECT_EQ(largest_distance(positions(0.02), positions(0.01)), 0.0);
    EXPECT_EQ(largest_distance(positions(0.01 * (1 + 1e-15)), positions(0.01)), 0.0);
}

TEST(ProjectiveDynamics, SaysSoWhereItsMatrixCannotBeFactored) {
    const ClothModel cloth = sheet(1e308);
    SpringSystem<double> system(cloth, gravity);
    ProjectiveDynamics<double> method({5, 0.0, 5});
    method.prepare(system);
    ParticleState<double> state = rest_state<double>(cloth);
    const StepReport report = method.step(system, 0.01, state);
    ASSERT_FALSE(report.ok());
    EXPECT_NE(report.failure->reason.find("cannot be factored"), std::string::npos);
    EXPECT_FALSE(report.failure->advice.empty());
    EXPECT_EQ(largest_distance(state.x, rest_state<double>(cloth).x), 0.0);
    EXPECT_EQ(state.time, 0.0);
}

TEST(ProjectiveDynamics, MovesAStateInSinglePrecisionAsInDouble) {
    const ClothModel cloth = sheet();
    SpringSystem<float> system(cloth, gravity);
    ParticleState<float> state = rest_state<float>(cloth);
    disturb(cloth, state.v, 0.1, 3);
    system.constrain(0.0, state.x.view(), state.v.view());
    ProjectiveDynamics<float> method({20, 0.0, 5});
    method.prepare(system);
    method.step(system, 1.0 / 60, state);
    const Vec3Array<double> expected = step_once(cloth, {20, 0.0, 5}).x;
    for (std::size_t s = 0; s < expected.size(); ++s) {
        EXPECT_LT(length(vec3_cast<double>(state.x[s]) - expected[s]), 1e-5);
    }
}

}  // namespace
}  // namespace weft::test
