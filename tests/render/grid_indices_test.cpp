// Grids found in surfaces, and thinned.
#include "render/grid_indices.h"

#include <gtest/gtest.h>

#include <utility>

#include "support/waving_cloth.h"

namespace weft {
namespace {

/// Twice the area that the triangles cover of the texture, with its sign.
double covered(const Surface& surface, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    double sum = 0.0;
    for (const auto& [a, b, c] : triangles) {
        const auto &p = surface.uvs[a], &q = surface.uvs[b], &r = surface.uvs[c];
        const double part = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
        EXPECT_GT(part, 0.0);  // turned as the surface's own
        sum += part;
    }
    return sum;
}

TEST(GridIndices, FindsColumnsAndRows) {
    for (const auto& [columns, rows] : {std::pair{31U, 21U}, {2U, 2U}, {2U, 9U}, {9U, 2U}}) {
        const auto grid = grid_of(test::waving_grid(columns, rows).surface);
        ASSERT_TRUE(grid);
        EXPECT_EQ(grid->columns, columns);
        EXPECT_EQ(grid->rows, rows);
    }
}

TEST(GridIndices, FindsNoneInAMeshOrADamagedGrid) {
    EXPECT_FALSE(grid_of(test::waving_sleeve(24, 10).surface));
    EXPECT_FALSE(grid_of(Surface{}));
    Surface surface = test::waving_grid(7, 5).surface;
    std::swap(surface.faces[3], surface.faces[4]);
    EXPECT_FALSE(grid_of(surface));
    surface = test::waving_grid(7, 5).surface;
    surface.faces.pop_back();
    EXPECT_FALSE(grid_of(surface));
}

TEST(GridIndices, EveryStepCoversTheWholeCloth) {
    const Surface surface = test::waving_grid(31, 20).surface;
    EXPECT_EQ(triangles_of(surface, 1), surface.triangles);
    std::size_t before = surface.triangles.size();
    for (const std::uint32_t step : {2U, 3U, 7U, 40U}) {
        const auto triangles = triangles_of(surface, step);
        EXPECT_NEAR(covered(surface, triangles), 2.0, 1e-4) << step;
        EXPECT_LT(triangles.size(), before);
        before = triangles.size();
    }
    EXPECT_EQ(before, 2U);
    EXPECT_EQ(triangles_of(surface, 2).size(), 2U * 15U * 10U);
}

TEST(GridIndices, MeshStaysWhole) {
    const Surface surface = test::waving_sleeve(24, 10).surface;
    EXPECT_EQ(triangles_of(surface, 4), surface.triangles);
}

}  // namespace
}  // namespace weft
