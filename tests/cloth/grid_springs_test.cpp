// The springs of a grid: counts as the papers have them, lengths, and widths.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "support/cloth_scenes.h"
#include "support/naive_cloth.h"

namespace weft::test {
namespace {

using Counts = std::array<std::size_t, 3>;  // structural, shear, bend

Counts counts_of(int columns, int rows, BendLayout layout) {
    SceneDescription scene = bare_sheet(columns, rows);
    scene.material.bend_layout = layout;
    return build_cloth(scene).spring_counts();
}

TEST(GridSprings, CountsOfThePapersSheet) {
    EXPECT_EQ(counts_of(40, 40, BendLayout::interior), (Counts{3120, 3042, 3040}));
    EXPECT_EQ(counts_of(40, 40, BendLayout::border), (Counts{3120, 3042, 152}));
}

TEST(GridSprings, CountsOfOddShapes) {
    for (const BendLayout layout : {BendLayout::interior, BendLayout::border}) {
        EXPECT_EQ(counts_of(2, 2, layout), (Counts{4, 2, 0}));
        EXPECT_EQ(counts_of(2, 7, layout), (Counts{19, 12, 10}));  // both columns are borders
        EXPECT_EQ(counts_of(7, 2, layout), (Counts{19, 12, 10}));
    }
    EXPECT_EQ(counts_of(3, 3, BendLayout::interior), (Counts{12, 8, 6}));
    EXPECT_EQ(counts_of(3, 3, BendLayout::border), (Counts{12, 8, 4}));
    EXPECT_EQ(counts_of(61, 41, BendLayout::interior),
              (Counts{60 * 41 + 61 * 40, 4800, 59 * 41 + 61 * 39}));
}

// Ends, rest length, stiffness and damping of every spring, against an independent list.
TEST(GridSprings, AreThoseOfAnIndependentList) {
    for (const StiffnessPer per : {StiffnessPer::spring, StiffnessPer::width}) {
        for (const BendLayout layout : {BendLayout::interior, BendLayout::border}) {
            for (const auto& [columns, rows] : {std::pair{2, 2}, {2, 5}, {5, 2}, {3, 3}, {7, 5}}) {
                SceneDescription scene = bare_sheet(columns, rows, 1.3, 0.6);
                scene.material.stiffness_per = per;
                scene.material.bend_layout = layout;
                add_dashpots(scene, 0.01);
                using Row = std::tuple<std::size_t, std::size_t, int>;
                std::map<Row, std::array<double, 3>> expected, found;
                const NaiveCloth naive(scene);
                for (const NaiveCloth::Spring& s : naive.springs()) {
                    expected[{std::min(s.p, s.q), std::max(s.p, s.q), s.kind}] = {s.rest_length,
                                                                                  s.k, s.c};
                }
                build_cloth(scene).for_each_spring([&](const Spring& s, const SpringConstants& c) {
                    EXPECT_LT(s.p, s.q);
                    const bool is_new = found
                                            .insert({{s.p, s.q, static_cast<int>(s.kind)},
                                                     {s.rest_length, c.stiffness, c.damping}})
                                            .second;
                    EXPECT_TRUE(is_new);
                });
                ASSERT_EQ(found.size(), expected.size());
                for (const auto& [key, values] : expected) {
                    ASSERT_TRUE(found.contains(key));
                    for (std::size_t n = 0; n < 3; ++n) {
                        EXPECT_NEAR(found[key][n], values[n], 1e-14 * values[n]);
                    }
                }
            }
        }
    }
}

// Per width, the springs across any cut add up to stiffness times width: pulled to a strain e along
// x, a strip of height H holds K H e in its structural springs and again K_b H e in its bend
// springs.
TEST(GridSprings, PerWidthHoldTheTensionOfTheStrip) {
    for (const auto& [columns, rows] : {std::pair{9, 7}, {17, 13}, {33, 25}}) {
        const double width = 2.0, height = 0.9, strain = 0.01;
        SceneDescription scene = bare_sheet(columns, rows, width, height);
        scene.material.stiffness_per = StiffnessPer::width;
        scene.material.structural.stiffness = 120.0;
        scene.material.bend.stiffness = 7.0;
        const ClothModel cloth = build_cloth(scene);
        const double cut = 0.5 * width + 1e-6;
        std::array<double, 3> tension{};
        cloth.for_each_spring([&](const Spring& s, const SpringConstants& c) {
            const Vec3d a = cloth.rest_position(s.p), b = cloth.rest_position(s.q);
            if ((a.x < cut) == (b.x < cut) || a.y != b.y) return;
            tension[static_cast<std::size_t>(s.kind)] += c.stiffness * s.rest_length * strain;
        });
        EXPECT_NEAR(tension[0], 120.0 * height * strain, 1e-12);
        EXPECT_NEAR(tension[2], 7.0 * height * strain, 1e-12);
    }
}

// A simple shear gamma stores K gamma^2 / 2 per area in the shear springs, also in oblong cells.
TEST(GridSprings, PerWidthGiveTheShearModulus) {
    for (const auto& [columns, rows] : {std::pair{5, 5}, {9, 5}, {5, 11}}) {
        SceneDescription scene = bare_sheet(columns, rows, 2.0, 1.5);
        scene.material.stiffness_per = StiffnessPer::width;
        scene.material.shear.stiffness = 40.0;
        const ClothModel cloth = build_cloth(scene);
        const double gamma = 1e-5;
        double stored = 0.0;
        cloth.for_each_spring([&](const Spring& s, const SpringConstants& c) {
            if (s.kind != SpringKind::shear) return;
            Vec3d d = cloth.rest_position(s.q) - cloth.rest_position(s.p);
            d.x += gamma * d.y;
            stored += 0.5 * c.stiffness * std::pow(length(d) - s.rest_length, 2);
        });
        const double expected = 0.5 * 40.0 * gamma * gamma * 2.0 * 1.5;
        EXPECT_NEAR(stored, expected, 1e-4 * expected);
    }
}

}  // namespace
}  // namespace weft::test
