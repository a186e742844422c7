// The wave from which the search for the fastest mode starts.
#include <gtest/gtest.h>

#include <numbers>

#include "simulation/mode_guess.h"
#include "support/cloth_scenes.h"

namespace weft::test {
namespace {

// Structural springs alone: neighbours along the shorter cell side move against each other.
TEST(FastestWave, OfStructuralSpringsAlternatesAlongTheStifferLines) {
    SceneDescription scene = bare_sheet(9, 9, 2.0, 1.0);
    scene.material.stiffness_per = StiffnessPer::width;
    scene.material.shear = scene.material.bend = {};
    const PlaneWave wave = fastest_wave(build_cloth(scene));
    EXPECT_DOUBLE_EQ(wave.along_column, std::numbers::pi);
    EXPECT_NEAR(std::abs(wave.direction.y), 1.0, 1e-12);
}

// A chain of k to the next and b to the second next particle: omega^2 = 2k (1 - cos a) +
// 2b (1 - cos 2a) is largest at cos a = -k / (4 b).
TEST(FastestWave, OfStiffBendSpringsIsLongerThanTwoCells) {
    SceneDescription scene = bare_sheet(9, 2);
    scene.material.structural.stiffness = 40.0;
    scene.material.shear.stiffness = 0.0;
    scene.material.bend.stiffness = 20.0;
    const PlaneWave wave = fastest_wave(build_cloth(scene));
    EXPECT_NEAR(wave.along_row, 2 * std::numbers::pi / 3, 1e-12);
    EXPECT_NEAR(std::abs(wave.direction.x), 1.0, 1e-12);
}

TEST(FastestWave, LiesInThePlaneOfTheGrid) {
    SceneDescription scene = bare_sheet(9, 9, 2.0, 1.0);
    scene.cloth.grid.plane = Plane::xz;
    const Vec3d direction = fastest_wave(build_cloth(scene)).direction;
    EXPECT_NEAR(length(direction), 1.0, 1e-12);
    EXPECT_NEAR(direction.y, 0.0, 1e-12);
}

TEST(ModeGuess, IsZeroForPinnedParticlesAndPaddingAlone) {
    SceneDescription scene = bare_sheet(9, 7);
    for (const bool as_mesh : {false, true}) {
        if (as_mesh) make_mesh_of_grid(scene);
        const ClothModel cloth = build_cloth(scene);
        std::vector<double> masses(cloth.layout.slot_count(), 0.0);
        for (std::size_t p = 3; p < cloth.particle_count; ++p) masses[cloth.slot(p)] = 1.0;
        Vec3Array<double> vector(cloth.layout.slot_count());
        guess_fastest_mode(cloth, masses, vector);
        disturb_mode(cloth, masses, vector);
        for (std::size_t s = 0; s < vector.size(); ++s) {
            EXPECT_EQ(length(vector[s]) > 0.0, masses[s] > 0.0) << s;
        }
    }
}

}  // namespace
}  // namespace weft::test
