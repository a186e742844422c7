// The stable step: omega_max against dense eigenvalues and closed forms, and cloths that run at
// 0.99 of the step and blow up at 1.01.
#include <gtest/gtest.h>

#include <numbers>
#include <ostream>

#include "integrators/integrator.h"
#include "simulation/cloth_system.h"
#include "simulation/engine.h"
#include "simulation/stability.h"
#include "support/cloth_scenes.h"
#include "support/dense_modes.h"
#include "support/methods.h"
#include "weft/simulation.h"

namespace weft::test {
namespace {

struct Case {
    const char* name;
    SceneDescription scene;
    std::set<std::size_t> pinned;

    friend std::ostream& operator<<(std::ostream& out, const Case& sheet) {
        return out << sheet.name;
    }
};

std::vector<Case> sheets() {
    std::vector<Case> cases;
    const SceneDescription square = bare_sheet(8, 8);
    cases.push_back({"PerSpring", square, {}});

    SceneDescription seed = square;  // the paper's: 800 N/m everywhere, particles of 1 kg
    seed.material.particle_mass = 1.0;
    seed.material.structural = seed.material.shear = seed.material.bend = {800.0, 0.0};
    seed.pins = {{EdgeSelection::top_left, {}}, {EdgeSelection::top_right, {}}};
    cases.push_back({"PaperSheet", seed, {0, 7}});

    SceneDescription oblong = bare_sheet(9, 6, 1.0, 0.3);
    oblong.material.stiffness_per = StiffnessPer::width;
    cases.push_back({"PerWidthOblongCells", oblong, {}});

    SceneDescription border = oblong;
    border.material.bend_layout = BendLayout::border;
    border.material.bend.stiffness = 200.0;
    border.pins = {{EdgeSelection::left_edge, {}}};
    cases.push_back({"BorderBendPinnedEdge", border, {0, 9, 18, 27, 36, 45}});

    for (const auto& [name, ratio] :
         {std::pair{"LightlyDamped", 4e-4}, {"Damped", 2e-3}, {"StronglyDamped", 2e-2}}) {
        SceneDescription damped = square;
        add_dashpots(damped, ratio);
        cases.push_back({name, damped, {}});
    }
    SceneDescription drag = square;  // the same mass everywhere: drag damps every mode alike
    drag.material.particle_mass = 0.01;
    drag.forces.damping = 0.2;
    add_dashpots(drag, 1e-3);
    cases.push_back({"DashpotsAndDrag", drag, {}});
    return cases;
}

class StableStep : public ::testing::TestWithParam<Case> {};

TEST_P(StableStep, ComesFromTheLargestFrequencyOfDenseMatrices) {
    // The search stops when its gains foretell a millionth of the square yet; it ends below.
    const double expected = dense_omega_max(GetParam().scene, GetParam().pinned);
    const double found = Simulation(GetParam().scene).linear_analysis().omega_max;
    EXPECT_LE(found, expected * (1 + 1e-12));
    EXPECT_GT(found, expected * (1 - 5e-5));
    SceneDescription single = GetParam().scene;
    single.integrator.precision = Precision::f32;
    EXPECT_NEAR(Simulation(single).linear_analysis().omega_max, expected, 1e-4 * expected);
}

// Larger sheets, whose highest modes lie closer to each other.
TEST(StableStepOfSheets, IsRightToFourDigits) {
    SceneDescription flag = bare_sheet(20, 16, 1.0, 0.7);
    flag.material.stiffness_per = StiffnessPer::width;
    SceneDescription stiff_bend = bare_sheet(20, 16);
    stiff_bend.material.bend.stiffness = 200.0;
    SceneDescription held = flag;
    held.pins = {{EdgeSelection::left_edge, {}}};
    std::set<std::size_t> left;
    for (std::size_t j = 0; j < 16; ++j) left.insert(20 * j);
    for (const auto& [scene, pinned] :
         {std::pair{flag, std::set<std::size_t>{}}, {stiff_bend, {}}, {held, left}}) {
        const double expected = dense_omega_max(scene, pinned);
        const double found = Simulation(scene).linear_analysis().omega_max;
        EXPECT_LE(found, expected * (1 + 1e-12));
        EXPECT_GT(found, expected * (1 - 2e-5));
    }
}

// Rows of springs alone, particles dx = 1/n apart: omega_max = 2 sqrt(K / rho) / dx, to the bit of
// a mode in which every other particle of a row moves against its neighbours.
TEST(StableStepOfSheets, IsTheClosedFormOnALargeSheet) {
    SceneDescription scene = bare_sheet(161, 121, 1.0, 1.0);
    scene.material.stiffness_per = StiffnessPer::width;
    scene.material.shear = scene.material.bend = {};
    const double expected = 2 * std::sqrt(100.0 / 0.2) * 160;
    for (const Precision precision : {Precision::f64, Precision::f32}) {
        scene.integrator.precision = precision;
        const double found = Simulation(scene).linear_analysis().omega_max;
        EXPECT_LE(found, expected * (1 + (precision == Precision::f64 ? 1e-12 : 1e-6)));
        EXPECT_GT(found, expected * (1 - 5e-5));
    }
}

// Every instruction set finds the same.
TEST(StableStepOfSheets, DoesNotDependOnTheInstructionSet) {
    SceneDescription scene = bare_sheet(33, 21, 1.0, 0.6);
    add_dashpots(scene, 1e-3);
    for (const bool as_mesh : {false, true}) {
        if (as_mesh) make_mesh_of_grid(scene);
        const ClothModel cloth = build_cloth(scene);
        const ParticleState<double> state = rest_state<double>(cloth);
        StabilityAnalysis<double> twin(cloth, scene.forces, InstructionSet::scalar);
        const StabilityModes expected = twin.find(state.x.view());
        for (std::size_t set = 1; set < instruction_sets().size(); ++set) {
            StabilityAnalysis<double> fast(cloth, scene.forces, static_cast<InstructionSet>(set));
            const StabilityModes found = fast.find(state.x.view());
            ASSERT_EQ(found.modes.size(), expected.modes.size());
            for (std::size_t n = 0; n < found.modes.size(); ++n) {
                EXPECT_NEAR(found.modes[n].omega, expected.modes[n].omega,
                            1e-5 * expected.modes[n].omega);
                EXPECT_NEAR(found.modes[n].damping_rate, expected.modes[n].damping_rate,
                            1e-4 * expected.modes[n].damping_rate);
            }
        }
    }
}

// Size of the disturbance after `steps`, over its size at first; stops when it has grown 1e6-fold.
double growth(const Case& sheet, std::string_view method, double dt, int steps) {
    const ClothModel cloth = build_cloth(sheet.scene);
    ClothSystem<double> system(cloth, sheet.scene);
    ParticleState<double> state = rest_state<double>(cloth);
    for (std::size_t p = 0; p < cloth.particle_count; ++p) {
        const Vec3d u = 1e-10 * random_vector(4, p);  // so small that the springs are linear
        state.x.set(cloth.slot(p), state.x[cloth.slot(p)] + Vec3d{u.x, u.y, 0.0});
    }
    system.constrain(0.0, state.x.view(), state.v.view());
    const auto size = [&] {
        double sum = 0.0;
        for (std::size_t p = 0; p < cloth.particle_count; ++p) {
            const Vec3d u = state.x[cloth.slot(p)] - cloth.rest_position(p);
            sum += dot(u, u);
        }
        return std::sqrt(sum);
    };
    const double start = size();
    const auto integrator = make_integrator<double>(method);
    integrator->prepare(system);
    double ratio = 1.0;
    for (int n = 0; n < steps && ratio < 1e6; ++n) {
        integrator->step(system, dt, state);
        ratio = size() / start;
    }
    return ratio;
}

TEST_P(StableStep, RunsAt99AndBlowsUpAt101HundredthsOfIt) {
    const Simulation simulation(GetParam().scene);
    const auto [omega, zeta] = simulation.linear_analysis();
    for (const IntegratorInfo& info : explicit_methods()) {
        const double limit = simulation.stable_step(info.name);
        if (limit == 0.0) {
            EXPECT_EQ(zeta, 0.0) << info.name;
            EXPECT_EQ(info.imaginary_limit, 0.0) << info.name;
            continue;
        }
        // 1 % beyond, the fastest mode grows by this a step; others may limit sooner.
        const double rate = std::log(amplification(info.name, 1.01 * limit * omega, zeta));
        // Where damping makes a slower mode the limit, as for the fourth-order compositions, the
        // step is safe for every mode there could be, not sharp for those there are.
        const bool sharp = zeta == 0.0 || info.damped_order == info.order;
        const int steps =
            !sharp ? 4000 : static_cast<int>(std::clamp(30.0 / std::max(rate, 1e-9), 1e3, 2e5));
        EXPECT_LT(growth(GetParam(), info.name, 0.99 * limit, steps), 50.0) << info.name;
        EXPECT_GT(growth(GetParam(), info.name, (sharp ? 1.01 : 1.1) * limit, steps), 1e4)
            << info.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Sheets, StableStep, ::testing::ValuesIn(sheets()),
                         [](const auto& sheet) { return std::string(sheet.param.name); });

TEST(StableStepOfMethods, IsTheirLimitOverOmega) {
    const Simulation simulation(bare_sheet(8, 8));
    const double omega = simulation.linear_analysis().omega_max;
    EXPECT_EQ(simulation.linear_analysis().damping_ratio, 0.0);
    EXPECT_NEAR(simulation.stable_step("velocity-verlet") * omega, 2.0, 1e-9);
    EXPECT_NEAR(simulation.stable_step("rk4") * omega, 2.0 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(simulation.stable_step("rk3") * omega, std::sqrt(3.0), 1e-9);
    EXPECT_EQ(simulation.stable_step("forward-euler"), 0.0);
}

// Dashpots c = b k damp the mode of omega by zeta = b omega / 2; drag c on masses m adds c/(2 m
// omega).
TEST(StableStepOfMethods, KnowsTheDampingOfTheFastestMode) {
    SceneDescription scene = bare_sheet(8, 8);
    scene.material.particle_mass = 0.01;
    add_dashpots(scene, 1e-3);
    scene.forces.damping = 0.2;
    const auto [omega, zeta] = Simulation(scene).linear_analysis();
    EXPECT_NEAR(zeta, 1e-3 * omega / 2 + 0.2 / 0.01 / (2 * omega), 1e-6 * zeta);
}

// 1-D chain of n free masses between two walls: omega_max = 2 sqrt(k/m) sin(n pi / (2 (n + 1)));
// free at both ends: 2 sqrt(k/m) sin((n - 1) pi / (2 n)).
TEST(StableStepOfChains, IsTheClosedForm) {
    const double k = 50.0, m = 0.02;
    SceneDescription scene = bare_sheet(2, 2);
    for (const std::size_t n : {1u, 2u, 3u, 10u, 50u}) {
        const auto count = static_cast<double>(n);
        ClothModel chain = straight_chain(n + 2, 0.1, m, k);
        pin_at_rest(chain, 0);
        pin_at_rest(chain, static_cast<std::uint32_t>(n + 1));
        const double fixed =
            2 * std::sqrt(k / m) * std::sin(count * std::numbers::pi / (2 * (count + 1)));
        EXPECT_NEAR(make_engine<double>(chain, scene)->linear_analysis().omega_max, fixed,
                    2e-6 * fixed);

        const ClothModel loose = straight_chain(n + 1, 0.1, m, k);
        const double free =
            2 * std::sqrt(k / m) * std::sin(count * std::numbers::pi / (2 * (count + 1)));
        EXPECT_NEAR(make_engine<double>(loose, scene)->linear_analysis().omega_max, free,
                    2e-6 * free);
    }
}

// Without springs or drag no step is too long.
TEST(StableStepOfMethods, IsInfiniteWhereNothingLimitsIt) {
    SceneDescription scene = bare_sheet(4, 4);
    scene.material.structural = scene.material.shear = scene.material.bend = {};
    const Simulation simulation(scene);
    EXPECT_EQ(simulation.linear_analysis().omega_max, 0.0);
    for (const IntegratorInfo& info : explicit_methods()) {
        EXPECT_TRUE(std::isinf(simulation.stable_step(info.name))) << info.name;
    }
}

// Springs with different ratios of damping to stiffness have no common damping: then the step is on
// the safe side.
TEST(StableStepOfMethods, IsSafeForUnevenDamping) {
    for (const double ratio : {1e-4, 2e-3, 2e-2}) {
        SceneDescription scene = bare_sheet(8, 6, 1.0, 0.5);
        scene.material.structural.damping = ratio * scene.material.structural.stiffness;
        scene.material.shear.damping = 5 * ratio * scene.material.shear.stiffness;
        scene.material.bend.damping = 0.3 * ratio * scene.material.bend.stiffness;
        scene.forces.damping = 0.002;
        const Simulation simulation(scene);
        for (const IntegratorInfo& info : explicit_methods()) {
            const double step = 0.9 * simulation.stable_step(info.name);
            ASSERT_GT(step, 0.0) << info.name;
            EXPECT_LT(growth({"Uneven", scene, {}}, info.name, step, 3000), 50.0)
                << info.name << " " << ratio;
        }
    }
}

// The estimate that follows a moving cloth climbs to the top frequency of a stretched state.
TEST(StableStepOfMethods, FollowsTheClothAsItStretches) {
    const SceneDescription scene = bare_sheet(8, 8);
    const ClothModel cloth = build_cloth(scene);
    ParticleState<double> state = rest_state<double>(cloth);
    StabilityAnalysis<double> analysis(cloth, scene.forces), fresh(cloth, scene.forces);
    const double rest = analysis.find(state.x.view()).modes[0].omega;
    for (std::size_t s = 0; s < state.x.size(); ++s) state.x.set(s, 2.0 * state.x[s]);
    const double stretched = fresh.find(state.x.view()).modes[0].omega;
    EXPECT_GT(stretched, 1.05 * rest);
    double before = 0.0;
    for (int n = 0; n < 30; ++n) {
        const double now = std::sqrt(analysis.follow(state.x.view(), 2));
        EXPECT_GE(now, before * (1 - 1e-12));
        EXPECT_LE(now, stretched * (1 + 1e-6));
        before = now;
    }
    EXPECT_GT(before, 0.97 * stretched);
}

// In float the mode's length would overflow in a few products, were it not brought back.
TEST(StableStepOfMethods, FollowsForAsLongAsARunLasts) {
    const SceneDescription scene = bare_sheet(8, 8);
    const ClothModel cloth = build_cloth(scene);
    const ParticleState<float> state = rest_state<float>(cloth);
    StabilityAnalysis<float> analysis(cloth, scene.forces);
    const double omega = analysis.find(state.x.view()).modes[0].omega;
    for (int n = 0; n < 200; ++n) {
        EXPECT_NEAR(std::sqrt(analysis.follow(state.x.view(), 2)), omega, 1e-4 * omega);
    }
}

TEST(StableStepOfMethods, IsNothingToFollowWithoutSprings) {
    SceneDescription scene = bare_sheet(4, 4);
    scene.material.structural = scene.material.shear = scene.material.bend = {};
    const ClothModel cloth = build_cloth(scene);
    const ParticleState<double> state = rest_state<double>(cloth);
    StabilityAnalysis<double> analysis(cloth, scene.forces);
    EXPECT_EQ(analysis.find(state.x.view()).modes[0].omega, 0.0);
    EXPECT_EQ(analysis.follow(state.x.view(), 3), 0.0);
}

}  // namespace
}  // namespace weft::test
