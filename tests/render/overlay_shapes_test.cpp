// Lists of lines and points: how many, where, in which colours.
#include "render/overlay_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/waving_cloth.h"

namespace weft {
namespace {

using Colour = std::array<std::uint8_t, 4>;
using test::WavingCloth;

constexpr Colour white{255, 255, 255, 255};

glm::vec3 place(const WavingCloth& cloth, std::size_t particle) {
    return to_glm(cloth.rest[particle]);
}
Frame at_rest(const WavingCloth& cloth) {
    return {0, 0.0, cloth.rest, {}, {}};
}
/// Seen lightness of an sRGB colour, roughly.
float lightness(Colour colour) {
    return 0.30F * colour[0] + 0.59F * colour[1] + 0.11F * colour[2];
}

TEST(Edges, OfAGridStandOnceInOrder) {
    const auto edges = edges_of(test::waving_grid(7, 5).surface);
    EXPECT_EQ(edges.size(), 7U * 4U + 6U * 5U);
    EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end()));
    EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end());
    for (const auto& edge : edges) EXPECT_LT(edge[0], edge[1]);
}

TEST(Edges, AtASeamAndOfTrianglesStandOnceToo) {
    const WavingCloth sleeve = test::waving_sleeve(8, 4);
    const auto edges = edges_of(sleeve.surface);
    // Around every ring, along between rings, and a diagonal for each face that was cut.
    EXPECT_EQ(edges.size(), 8U * 4U + 8U * 3U + 8U);
    for (const auto& edge : edges) EXPECT_LT(edge[1], sleeve.rest.size());
}

TEST(Wireframe, RunsFromParticleToParticle) {
    const WavingCloth cloth = test::waving_grid(4, 3);
    const auto edges = edges_of(cloth.surface);
    OverlayList lines{{glm::vec3(9.0F), white}};
    add_wireframe(edges, at_rest(cloth), lines);
    ASSERT_EQ(lines.size(), 1 + 2 * edges.size());  // appended
    EXPECT_EQ(lines.front().position, glm::vec3(9.0F));
    for (std::size_t i = 0; i < edges.size(); ++i) {
        EXPECT_EQ(lines[1 + 2 * i].position, place(cloth, edges[i][0]));
        EXPECT_EQ(lines[2 + 2 * i].position, place(cloth, edges[i][1]));
    }
}

TEST(Overlays, ReadRoundedPositionsWhereAFrameHasThem) {
    const std::vector<Vec3f> rounded{{1.0F, 2.0F, 3.0F}, {4.0F, 5.0F, 6.0F}};
    OverlayList points;
    add_particles({0, 0.0, {}, {}, {}, rounded}, points);
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[1].position, glm::vec3(4, 5, 6));
}

TEST(StrainColours, AreWhiteAtRestBlueCompressedRedStretched) {
    EXPECT_EQ(colour_of_strain(0.0F, 0.1F), white);
    const Colour red = colour_of_strain(0.1F, 0.1F), blue = colour_of_strain(-0.1F, 0.1F);
    EXPECT_GT(red[0], 3 * red[2]);
    EXPECT_GT(blue[2], 3 * blue[0]);
    EXPECT_EQ(colour_of_strain(7.0F, 0.1F), red);
    EXPECT_EQ(colour_of_strain(-7.0F, 0.1F), blue);
    EXPECT_EQ(colour_of_strain(0.05F, 0.1F), colour_of_strain(0.5F, 1.0F));
    EXPECT_EQ(colour_of_strain(std::numeric_limits<float>::quiet_NaN(), 0.1F), red);
}

TEST(StrainColours, DarkenWithStrainForEyesThatSeeNoHue) {
    for (const float sign : {-1.0F, 1.0F})
        for (int i = 1; i <= 20; ++i) {
            const Colour less = colour_of_strain(0.05F * sign * static_cast<float>(i - 1), 1.0F);
            const Colour more = colour_of_strain(0.05F * sign * static_cast<float>(i), 1.0F);
            EXPECT_LT(lightness(more), lightness(less));
            EXPECT_EQ(more[3], 255);
        }
}

TEST(KindColours, DifferInLightnessAndHue) {
    const Colour structural = colour_of_kind(0), shear = colour_of_kind(1),
                 bend = colour_of_kind(2);
    EXPECT_GT(lightness(shear), lightness(structural) + 20.0F);
    EXPECT_GT(lightness(bend), lightness(shear) + 40.0F);
    // Blue against yellow is what the colour-blind, save a very few, tell apart.
    EXPECT_GT(shear[2], shear[0] + 100);
    EXPECT_GT(structural[0], structural[2] + 100);
    EXPECT_GT(bend[0], bend[2] + 100);
}

class Springs : public testing::Test {
protected:
    /// Three particles in a row, 1 m apart, the last a little farther.
    std::vector<Vec3d> positions{{0, 0, 0}, {1, 0, 0}, {2.1, 0, 0}};
    std::vector<Vec3f> normals{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    std::vector<DrawnSpring> springs{{0, 1, 1.0F, 0}, {1, 2, 1.0F, 1}, {0, 2, 2.0F, 2}};
    OverlayList lines;
};

TEST_F(Springs, ShowTheirStrain) {
    add_springs_by_strain(springs, {}, {0, 0.0, positions, {}, {}}, 0.1F, lines);
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_EQ(lines[0].colour, white);
    EXPECT_EQ(lines[2].colour, colour_of_strain(0.1F, 0.1F));
    EXPECT_EQ(lines[3].colour, lines[2].colour);
    const Colour half = colour_of_strain(0.05F, 0.1F);
    for (std::size_t channel = 0; channel < 4; ++channel)
        EXPECT_NEAR(lines[4].colour[channel], half[channel], 3);
    EXPECT_EQ(lines[3].position, glm::vec3(2.1F, 0, 0));
}

TEST_F(Springs, StrainThatIsNoNumberIsTheWorst) {
    positions[1].x = std::numeric_limits<double>::quiet_NaN();
    springs.resize(1);
    add_springs_by_strain(springs, {}, {0, 0.0, positions, {}, {}}, 0.1F, lines);
    EXPECT_EQ(lines[0].colour, colour_of_strain(1.0F, 0.1F));
}

TEST_F(Springs, OfChosenKindsAlone) {
    const Frame frame{0, 0.0, positions, {}, {}};
    add_springs_by_kind(springs, {true, false, false}, frame, lines);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].colour, colour_of_kind(0));
    add_springs_by_kind(springs, {false, true, false}, frame, lines);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[2].colour, colour_of_kind(1));
    add_springs_by_strain(springs, {false, false, true}, frame, 1.0F, lines);
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_EQ(lines[5].position, glm::vec3(2.1F, 0, 0));
    add_springs_by_strain(springs, {false, false, false}, frame, 1.0F, lines);
    EXPECT_EQ(lines.size(), 6U);
}

TEST_F(Springs, OfBendingRunBesideTheOthers) {
    add_springs_by_kind(springs, {}, {0, 0.0, positions, {}, normals}, lines);
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_EQ(lines[1].position, glm::vec3(1, 0, 0));
    EXPECT_NEAR(std::abs(lines[4].position.y), 0.07F * 2.1F, 1e-5F);
    EXPECT_EQ(lines[4].position.y, lines[5].position.y);
    EXPECT_EQ(lines[4].position.z, 0.0F);  // within the cloth
}

TEST_F(Springs, FillAListAgainWithoutNewMemory) {
    const Frame frame{0, 0.0, positions, {}, {}};
    add_springs_by_kind(springs, {}, frame, lines);
    const OverlayVertex* memory = lines.data();
    for (int i = 0; i < 3; ++i) {
        lines.clear();
        add_springs_by_strain(springs, {}, frame, 0.1F, lines);
        EXPECT_EQ(lines.data(), memory);
    }
}

TEST(Normals, HaveTheLengthAskedFor) {
    WavingCloth cloth = test::waving_grid(5, 4);
    const Frame frame = cloth.frame(3);
    OverlayList lines;
    add_normals(frame, 0.05F, lines);
    ASSERT_EQ(lines.size(), 2 * frame.positions.size());
    for (std::size_t i = 0; i < lines.size(); i += 2) {
        EXPECT_EQ(lines[i].position, to_glm(frame.positions[i / 2]));
        EXPECT_NEAR(glm::distance(lines[i].position, lines[i + 1].position), 0.05F, 1e-5F);
    }
}

TEST(Points, StandOnParticles) {
    const WavingCloth cloth = test::waving_grid(5, 4);
    OverlayList points;
    add_particles(at_rest(cloth), points);
    ASSERT_EQ(points.size(), 20U);
    const std::vector<std::uint32_t> pinned{0, 15};
    add_pins(pinned, at_rest(cloth), points);
    ASSERT_EQ(points.size(), 22U);
    EXPECT_EQ(points[21].position, place(cloth, 15));
    EXPECT_NE(points[21].colour, points[15].colour);
}

TEST(Arrow, HasAHeadAcrossAllSides) {
    const Colour colour{1, 2, 3, 4};
    for (const glm::vec3 way : {glm::vec3(2, 0, 0), {0, 3, 0}, {1, -1, 4}}) {
        OverlayList lines;
        const glm::vec3 from{1, 1, 1}, to = from + way;
        add_arrow(from, to, colour, lines);
        ASSERT_EQ(lines.size(), 10U);
        EXPECT_EQ(lines[0].position, from);
        EXPECT_EQ(lines[1].position, to);
        glm::vec3 sum(0.0F);
        for (std::size_t i = 2; i < 10; i += 2) {
            EXPECT_EQ(lines[i].position, to);
            EXPECT_EQ(lines[i].colour, colour);
            const glm::vec3 barb = lines[i + 1].position - to;
            EXPECT_LT(glm::dot(barb, way), 0.0F);  // backward
            EXPECT_GT(glm::length(glm::cross(barb, way)), 0.0F);
            sum += barb;
        }
        EXPECT_NEAR(glm::length(glm::cross(sum, way)), 0.0F, 1e-4F);
    }
}

TEST(Arrow, OfNoLengthHasNoHead) {
    OverlayList lines;
    add_arrow({1, 2, 3}, {1, 2, 3}, white, lines);
    EXPECT_EQ(lines.size(), 2U);
}

TEST(Wind, IsShownOnAllSidesOfTheCloth) {
    const Box box{{0, 1, 0}, {1.5F, 2, 0}};
    const glm::vec3 velocity{3, 0, 1};
    OverlayList lines;
    add_wind(box, velocity, 0.1F, lines);
    ASSERT_GT(lines.size(), 80U);
    ASSERT_EQ(lines.size() % 10, 0U);
    EXPECT_LE(lines.size() / 10, 125U);
    Box spanned{lines[0].position, lines[0].position};
    for (std::size_t i = 0; i < lines.size(); i += 10) {
        const glm::vec3 way = lines[i + 1].position - lines[i].position;
        EXPECT_NEAR(glm::distance(way, 0.1F * velocity), 0.0F, 1e-5F);
        spanned = spanned.grown_to(0.5F * (lines[i].position + lines[i + 1].position));
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LT(spanned.low[axis], box.low[axis] - 0.1F);
        EXPECT_GT(spanned.high[axis], box.high[axis] + 0.1F);
    }
}

TEST(Wind, OfNothingIsNotShown) {
    OverlayList lines;
    add_wind({{0, 0, 0}, {1, 1, 1}}, {0, 0, 0}, 0.1F, lines);
    add_wind({{0, 0, 0}, {1, 1, 1}}, {1, 0, 0}, 0.0F, lines);
    EXPECT_TRUE(lines.empty());
}

}  // namespace
}  // namespace weft
