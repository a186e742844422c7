// scenes/cape.obj, the mesh that ships.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>

#include "cloth/mesh_cloth.h"
#include "io/mesh_file.h"

namespace weft {
namespace {

const std::filesystem::path root = WEFT_SOURCE_DIR;

MeshCloth cape() {
    const auto path = root / "scenes" / "cape.obj";
    return build_mesh_cloth(load_mesh(path), path.string());
}

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Cape, IsOnePieceWeldedDownTheBack) {
    const MeshCloth cloth = cape();
    EXPECT_EQ(cloth.report.vertices, 3280u);
    EXPECT_EQ(cloth.report.particles, 3236u);
    EXPECT_EQ(cloth.report.welded_vertices, 44u);
    EXPECT_EQ(cloth.report.quads, 2996u);
    EXPECT_EQ(cloth.report.triangles, 252u);
    EXPECT_EQ(cloth.report.pieces, 1u);
    EXPECT_EQ(cloth.report.findings.size(), 1u);     // the seam
    EXPECT_EQ(cloth.surface.vertex_count(), 3280u);  // kept for the texture
    // Neck 28 and hem 112 edges, and two front edges of 43.
    EXPECT_EQ(cloth.report.border_edges, 28u + 112u + 2u * 43u);
}

TEST(Cape, EdgesAreEven) {
    for (const Spring& spring : cape().springs) {
        if (spring.kind != SpringKind::structural) continue;
        EXPECT_GT(spring.rest_length, 0.018);
        EXPECT_LT(spring.rest_length, 0.036);
        EXPECT_GT(spring.width_factor, 0.3);
        EXPECT_LT(spring.width_factor, 1.5);
    }
}

TEST(Cape, AreaIsThatOfTheCone) {
    const std::vector<double> areas = cape().areas;
    // Five sixths of a cone's side, pi (r + R) sqrt((R - r)^2 + h^2); chords take 1 in 1000.
    const double cone = 5.0 / 6.0 * M_PI * 0.67 * std::sqrt(0.43 * 0.43 + 1.0);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), cone, 1e-3 * cone);
    EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 5e-5);
}

TEST(Cape, BoxOfTheNecklineHoldsItAlone) {
    std::size_t inside = 0;
    for (const Vec3d p : cape().rest_positions) {
        const bool in_box =
            std::abs(p.x) <= 0.2 && std::abs(p.z) <= 0.2 && p.y >= 1.49 && p.y <= 1.51;
        if (!in_box) continue;
        EXPECT_NEAR(std::hypot(p.x, p.z), 0.12, 1e-6);
        ++inside;
    }
    EXPECT_EQ(inside, 29u);
}

TEST(Cape, FacesShowOutward) {
    const MeshCloth cloth = cape();
    for (const auto& triangle : cloth.surface.triangles) {
        const Vec3d a = cloth.rest_positions[cloth.surface.particle(triangle[0])];
        const Vec3d b = cloth.rest_positions[cloth.surface.particle(triangle[1])];
        const Vec3d c = cloth.rest_positions[cloth.surface.particle(triangle[2])];
        const Vec3d normal = cross(b - a, c - a);
        EXPECT_GT(dot(normal, Vec3d{a.x, 0.0, a.z}), 0.0);
    }
}

TEST(Cape, IsWhatItsScriptWrites) {
    const auto written = std::filesystem::path(::testing::TempDir()) / "weft_cape_test.obj";
    const std::string command =
        "python3 '" + (root / "tools" / "make_cape.py").string() + "' '" + written.string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_TRUE(bytes_of(written) == bytes_of(root / "scenes" / "cape.obj"));
    std::filesystem::remove(written);
}

}  // namespace
}  // namespace weft
