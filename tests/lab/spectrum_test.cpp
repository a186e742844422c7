// The Ritz values of a cloth against dense eigenvalues, and the regions that they are drawn on
// against closed forms.
#include "lab/stability/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lab/stability/stability_region.h"
#include "support/cloth_scenes.h"
#include "support/dense_modes.h"
#include "weft/integrators.h"

namespace weft::lab {
namespace {

using test::add_dashpots;
using test::bare_sheet;

// Frequencies of the dense matrix, each once, rising.
std::vector<double> distinct_frequencies(const SceneDescription& scene) {
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                                       test::dense_stiffness(scene, {}), Eigen::EigenvaluesOnly)
                                       .eigenvalues();
    std::vector<double> found;
    for (const double value : values) {
        const double omega = std::sqrt(std::max(value, 0.0));
        if (found.empty() || omega > found.back() + 1e-6 * std::sqrt(values.maxCoeff())) {
            found.push_back(omega);
        }
    }
    return found;
}

TEST(Spectrum, OfASmallClothIsEveryFrequencyOnce) {
    const SceneDescription scene = bare_sheet(5, 4, 1.0, 0.6);
    const Specimen specimen(scene);
    const Spectrum spectrum = ritz_spectrum(specimen, specimen.start(), 80, [] {});
    const std::vector<double> expected = distinct_frequencies(scene);
    EXPECT_TRUE(spectrum.complete);
    ASSERT_EQ(spectrum.modes.size(), expected.size());
    for (std::size_t n = 0; n < expected.size(); ++n) {
        EXPECT_NEAR(spectrum.modes[n].omega, expected[n], 2e-5 * expected.back()) << n;
    }
}

TEST(Spectrum, OfALargerClothHasItsEndsAndLiesBetweenThem) {
    const SceneDescription scene = bare_sheet(14, 11, 1.0, 0.6);
    const Specimen specimen(scene);
    const Spectrum spectrum = ritz_spectrum(specimen, specimen.start(), 60, [] {});
    const double largest = test::dense_omega_max(scene);
    EXPECT_FALSE(spectrum.complete);
    ASSERT_EQ(spectrum.modes.size(), 60u);
    EXPECT_LE(spectrum.modes.back().omega, largest * (1 + 1e-12));
    EXPECT_NEAR(spectrum.modes.back().omega, largest, 1e-4 * largest);
    EXPECT_NEAR(spectrum.modes.front().omega, 0.0, 1e-3 * largest);  // a sheet may drift
    for (std::size_t n = 1; n < spectrum.modes.size(); ++n) {
        EXPECT_LE(spectrum.modes[n - 1].omega, spectrum.modes[n].omega);
        // Spread: no gap of a quarter of the spectrum.
        EXPECT_LT(spectrum.modes[n].omega - spectrum.modes[n - 1].omega, 0.25 * largest);
    }
}

// Dashpots c = b k and a drag that is the same for every mass: 2 zeta omega = b omega^2 + c / m.
TEST(Spectrum, KnowsTheDampingOfEveryMode) {
    SceneDescription scene = bare_sheet(9, 9);
    scene.material.particle_mass = 0.01;
    scene.forces.damping = 0.02;
    add_dashpots(scene, 1e-3);
    const Specimen specimen(scene);
    const Spectrum spectrum = ritz_spectrum(specimen, specimen.start(), 40, [] {});
    for (const Mode& mode : spectrum.modes) {
        const double expected = 1e-3 * mode.omega * mode.omega + 2.0;
        EXPECT_NEAR(mode.damping_rate, expected, 1e-9 * expected);
    }
}

TEST(Spectrum, OfAClothThatIsHeldEverywhereIsEmpty) {
    SceneDescription scene = bare_sheet(2, 2);
    scene.pins = {{EdgeSelection::left_edge, {}}, {EdgeSelection::right_edge, {}}};
    const Specimen specimen(scene);
    EXPECT_TRUE(ritz_spectrum(specimen, specimen.start(), 20, [] {}).modes.empty());
}

TEST(Spectrum, StopsWhereTheUserWantsTo) {
    const Specimen specimen(bare_sheet(9, 9));
    EXPECT_THROW(ritz_spectrum(specimen, specimen.start(), 20, [] { throw Interrupted{}; }),
                 Interrupted);
}

double size(const PlanePoint& z) {
    return std::hypot(z[0], z[1]);
}

TEST(StabilityBoundary, CrossesTheImaginaryAxisAtTheStatedLimits) {
    for (const IntegratorInfo& info : integrator_catalogue()) {
        if (info.kind != IntegratorKind::explicit_steps || info.imaginary_limit == 0.0) continue;
        const std::vector<PlanePoint> boundary = stability_boundary(info.name, 8);
        EXPECT_NEAR(boundary.front()[1], info.imaginary_limit, 2e-4) << info.name;
        EXPECT_EQ(boundary.front()[0], 0.0) << info.name;
        EXPECT_EQ(boundary.back()[1], -boundary.front()[1]) << info.name;
        ASSERT_EQ(boundary.size(), 17u);
    }
}

// Of forward Euler |1 + z| = 1; of classical Runge-Kutta it ends at -2.7853 on the real axis.
TEST(StabilityBoundary, IsTheClosedForm) {
    for (const PlanePoint& z : stability_boundary("forward-euler", 16)) {
        if (size(z) < 1e-3) continue;  // on the imaginary axis there is no stable step
        EXPECT_NEAR(std::hypot(1.0 + z[0], z[1]), 1.0, 1e-8);
    }
    EXPECT_NEAR(stability_boundary("rk4", 16)[16][0], -2.785294, 1e-6);
    EXPECT_NEAR(stability_boundary("rk2", 16)[16][0], -2.0, 1e-6);
    EXPECT_EQ(stability_boundary("implicit-euler", 4, 7.0)[2],
              (PlanePoint{-7.0 * std::sin(std::acos(-1.0) / 4), 7.0 * std::sqrt(1.0 - 0.5)}));
}

TEST(StabilityBoundary, IsWhereAmplificationIsOne) {
    for (const IntegratorInfo& info : integrator_catalogue()) {
        if (info.kind != IntegratorKind::explicit_steps) continue;
        const std::vector<PlanePoint> boundary = stability_boundary(info.name, 12);
        for (std::size_t n = 1; n < 12; ++n) {
            const double zeta = -boundary[n][0] / size(boundary[n]);
            EXPECT_NEAR(amplification(info.name, size(boundary[n]), zeta), 1.0, 2e-9) << info.name;
            EXPECT_GT(amplification(info.name, 1.001 * size(boundary[n]), zeta), 1.0) << info.name;
        }
    }
}

TEST(Eigenvalues, AreRootsOfTheModesEquation) {
    for (const double rate : {0.0, 1.0, 6.0, 14.0}) {
        const double omega = 5.0, dt = 0.1;
        for (const PlanePoint& z : eigenvalues({omega, rate}, dt)) {
            const std::complex<double> lambda(z[0] / dt, z[1] / dt);
            EXPECT_NEAR(std::abs(lambda * lambda + rate * lambda + omega * omega), 0.0, 1e-12);
        }
    }
}

// What implicit methods leave of a mode: implicit Euler 1 / sqrt(1 + y^2), the midpoint rule all.
TEST(GrowthCurves, AreTheClosedForms) {
    const auto euler = growth_on_imaginary_axis("implicit-euler", 0.01, 100.0, 9);
    const auto midpoint = growth_on_imaginary_axis("implicit-midpoint", 0.01, 100.0, 9);
    ASSERT_EQ(euler.size(), 9u);
    EXPECT_NEAR(euler.back()[0], 100.0, 1e-10);
    for (std::size_t n = 0; n < euler.size(); ++n) {
        EXPECT_NEAR(euler[n][1], 1.0 / std::hypot(1.0, euler[n][0]), 1e-12);
        EXPECT_NEAR(midpoint[n][1], 1.0, 1e-12);
    }
    for (const PlanePoint& point : growth_on_real_axis("implicit-euler", 0.1, 10.0, 5)) {
        EXPECT_NEAR(point[1], 1.0 / (1.0 + point[0]), 1e-9);
    }
}

}  // namespace
}  // namespace weft::lab
