// A regular grid given as a quad mesh is the grid of PHYSICS.md section 1.
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <tuple>

#include "cloth/mesh_examples.h"

namespace weft::testing {
namespace {

using SpringKey = std::tuple<SpringKind, std::uint32_t, std::uint32_t>;
using Factors = std::map<SpringKey, double>;

/// Springs of the grid by its own definition (interior layout), with their width factors.
Factors grid_springs(std::uint32_t columns, std::uint32_t rows, double dx, double dy) {
    Factors factors;
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return j * columns + i; };
    const auto add = [&](SpringKind kind, std::uint32_t p, std::uint32_t q, double factor) {
        factors[{kind, std::min(p, q), std::max(p, q)}] = factor;
    };
    const double shear = (dx * dx + dy * dy) / (2 * dx * dy);
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const double row_strip = j == 0 || j == rows - 1 ? 0.5 : 1.0;
            const double column_strip = i == 0 || i == columns - 1 ? 0.5 : 1.0;
            const bool right = i + 1 < columns, down = j + 1 < rows;
            if (right) add(SpringKind::structural, at(i, j), at(i + 1, j), row_strip * dy / dx);
            if (down) add(SpringKind::structural, at(i, j), at(i, j + 1), column_strip * dx / dy);
            if (right && down) add(SpringKind::shear, at(i, j), at(i + 1, j + 1), shear);
            if (right && down) add(SpringKind::shear, at(i + 1, j), at(i, j + 1), shear);
            if (i + 2 < columns)
                add(SpringKind::bend, at(i, j), at(i + 2, j), row_strip * dy / (4 * dx));
            if (j + 2 < rows)
                add(SpringKind::bend, at(i, j), at(i, j + 2), column_strip * dx / (4 * dy));
        }
    return factors;
}

TEST(MeshGrid, FortyByFortyHasTheCountsOfTheGrid) {
    const MeshCloth cloth = cloth_of(grid_mesh(40, 40, 0.5, 0.5));
    EXPECT_EQ(cloth.rest_positions.size(), 1600u);
    EXPECT_EQ(spring_counts(cloth), (std::array<std::size_t, 3>{3120, 3042, 3040}));
}

TEST(MeshGrid, SpringsAndWidthFactorsAreThoseOfTheGrid) {
    const double dx = 0.03, dy = 0.02;
    const MeshCloth cloth = cloth_of(grid_mesh(9, 7, dx, dy));
    const Factors expected = grid_springs(9, 7, dx, dy);
    ASSERT_EQ(cloth.springs.size(), expected.size());
    for (const Spring& spring : cloth.springs) {
        const auto found = expected.find({spring.kind, spring.p, spring.q});
        ASSERT_NE(found, expected.end()) << spring.p << " - " << spring.q;
        EXPECT_NEAR(spring.width_factor, found->second, 1e-12 * found->second)
            << spring.p << " - " << spring.q;
    }
}

TEST(MeshGrid, RestLengthsAreDistances) {
    const MeshCloth cloth = cloth_of(grid_mesh(5, 4, 0.03, 0.04));
    EXPECT_NEAR(find_spring(cloth, SpringKind::structural, 0, 1)->rest_length, 0.03, 1e-15);
    EXPECT_NEAR(find_spring(cloth, SpringKind::shear, 0, 6)->rest_length, 0.05, 1e-15);
    EXPECT_NEAR(find_spring(cloth, SpringKind::bend, 0, 10)->rest_length, 0.08, 1e-15);
}

TEST(MeshGrid, SpringsStandByKindThenByParticles) {
    const MeshCloth cloth = cloth_of(grid_mesh(6, 5, 1, 1));
    for (std::size_t k = 0; k < cloth.springs.size(); ++k) {
        const Spring& spring = cloth.springs[k];
        EXPECT_LT(spring.p, spring.q);
        if (k == 0) continue;
        const Spring& last = cloth.springs[k - 1];
        EXPECT_LT(std::tuple(last.kind, last.p, last.q),
                  std::tuple(spring.kind, spring.p, spring.q));
    }
}

TEST(MeshGrid, TwoByTwoHasNoBendSprings) {
    const MeshCloth cloth = cloth_of(grid_mesh(2, 2, 1, 1));
    EXPECT_EQ(spring_counts(cloth), (std::array<std::size_t, 3>{4, 2, 0}));
}

TEST(MeshGrid, SurfaceVerticesAreTheParticles) {
    const MeshCloth cloth = cloth_of(grid_mesh(4, 3, 1, 1));
    EXPECT_TRUE(cloth.surface.vertex_particle.empty());
    EXPECT_EQ(cloth.surface.particle_count, 12u);
    EXPECT_EQ(cloth.surface.vertex_count(), 12u);
    EXPECT_EQ(cloth.surface.faces.size(), 6u);
    EXPECT_EQ(cloth.surface.uvs, grid_mesh(4, 3, 1, 1).uvs);
    using Triangle = std::array<std::uint32_t, 3>;
    ASSERT_EQ(cloth.surface.triangles.size(), 12u);
    EXPECT_EQ(cloth.surface.triangles[0], (Triangle{0, 4, 5}));
    EXPECT_EQ(cloth.surface.triangles[1], (Triangle{0, 5, 1}));
}

TEST(MeshGrid, AreasAreThirdsOfTheTrianglesAround) {
    const MeshCloth cloth = cloth_of(grid_mesh(4, 3, 0.5, 0.2));
    const double quad = 0.5 * 0.2;
    EXPECT_NEAR(std::accumulate(cloth.areas.begin(), cloth.areas.end(), 0.0), 6 * quad, 1e-15);
    EXPECT_NEAR(cloth.areas[5], quad, 1e-15);      // inside: six triangles
    EXPECT_NEAR(cloth.areas[1], quad / 2, 1e-15);  // border: three
    EXPECT_NEAR(cloth.areas[0], quad / 3, 1e-15);  // corner on a diagonal: two
    EXPECT_NEAR(cloth.areas[3], quad / 6, 1e-15);  // corner off the diagonals: one
}

TEST(MeshGrid, ReportCountsAndFindsNothing) {
    const MeshReport report = cloth_of(grid_mesh(40, 40, 0.5, 0.5)).report;
    EXPECT_EQ(report.vertices, 1600u);
    EXPECT_EQ(report.particles, 1600u);
    EXPECT_EQ(report.faces, 1521u);
    EXPECT_EQ(report.quads, 1521u);
    EXPECT_EQ(report.triangles, 0u);
    EXPECT_EQ(report.border_edges, 156u);
    EXPECT_EQ(report.pieces, 1u);
    EXPECT_TRUE(report.findings.empty());
}

TEST(MeshGrid, BuildsTheSameClothEveryTime) {
    const MeshCloth one = cloth_of(grid_mesh(30, 20, 0.1, 0.07));
    const MeshCloth two = cloth_of(grid_mesh(30, 20, 0.1, 0.07));
    ASSERT_EQ(one.springs.size(), two.springs.size());
    for (std::size_t k = 0; k < one.springs.size(); ++k) {
        EXPECT_EQ(one.springs[k].p, two.springs[k].p);
        EXPECT_EQ(one.springs[k].q, two.springs[k].q);
        EXPECT_EQ(one.springs[k].width_factor, two.springs[k].width_factor);
    }
    EXPECT_EQ(one.areas, two.areas);
}

}  // namespace
}  // namespace weft::testing
