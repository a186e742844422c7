// Slots of a mesh's particles: each once, and neighbours near each other whatever the file's order.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "cloth/mesh_order.h"
#include "support/mesh_scenes.h"

namespace weft::test {
namespace {

std::size_t distance(std::uint32_t a, std::uint32_t b) {
    return a > b ? a - b : b - a;
}

// The farthest that two joined particles stand from each other.
std::size_t bandwidth(const std::vector<Spring>& springs, const std::vector<std::uint32_t>& slots) {
    std::size_t width = 0;
    for (const Spring& spring : springs) {
        width = std::max(width, distance(slots[spring.p], slots[spring.q]));
    }
    return width;
}

std::vector<std::uint32_t> slots_of(const ClothModel& cloth) {
    std::vector<std::uint32_t> slots;
    cloth.layout.for_each(
        [&](std::size_t, std::size_t s) { slots.push_back(static_cast<std::uint32_t>(s)); });
    return slots;
}

std::vector<std::uint32_t> in_order(std::size_t count) {
    std::vector<std::uint32_t> slots(count);
    std::iota(slots.begin(), slots.end(), 0u);
    return slots;
}

void expect_permutation(std::vector<std::uint32_t> slots, std::size_t count) {
    std::sort(slots.begin(), slots.end());
    EXPECT_EQ(slots, in_order(count));
}

TEST(MeshOrder, BringsTheNeighboursOfAShuffledSheetTogether) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        Mesh mesh = sheet_mesh(64, 64, 0.1, false);
        shuffle(mesh, seed);
        const ClothModel cloth = build_cloth(mesh_scene(std::move(mesh)));
        expect_permutation(slots_of(cloth), 4096);
        EXPECT_GT(bandwidth(cloth.springs, in_order(4096)), 4000u);
        // Row by row it would be 128 as well: bend springs reach two rows.
        EXPECT_EQ(bandwidth(cloth.springs, slots_of(cloth)), 128u);
    }
}

TEST(MeshOrder, StandsOnTheShortSideOfALongSheet) {
    Mesh mesh = sheet_mesh(300, 10, 0.1, true);
    shuffle(mesh, 4);
    const ClothModel cloth = build_cloth(mesh_scene(std::move(mesh)));
    expect_permutation(slots_of(cloth), 3000);
    EXPECT_LE(bandwidth(cloth.springs, slots_of(cloth)), 3u * 10u);
}

TEST(MeshOrder, OfATubeIsNoWiderThanItsRings) {
    Mesh mesh = tube_mesh(21, 100, 0.1);
    shuffle(mesh, 5);
    const ClothModel cloth = build_cloth(mesh_scene(std::move(mesh)));
    expect_permutation(slots_of(cloth), 2101);
    EXPECT_LE(bandwidth(cloth.springs, slots_of(cloth)), 4u * 21u);
}

TEST(MeshOrder, HasAPlaceForParticlesWithoutSpringsAndForEveryPiece) {
    // 0 - 3 - 6 and 5 - 2; nothing at 1 and 4.
    const std::vector<Spring> springs{{0, 3, SpringKind::structural, 1.0, 1.0},
                                      {3, 6, SpringKind::structural, 1.0, 1.0},
                                      {2, 5, SpringKind::structural, 1.0, 1.0}};
    const auto slots = mesh_order(7, springs);
    expect_permutation(slots, 7);
    EXPECT_EQ(bandwidth(springs, slots), 1u);
    expect_permutation(mesh_order(3, {}), 3);
    EXPECT_TRUE(mesh_order(0, {}).empty());
}

TEST(MeshOrder, IsTheSameEveryTime) {
    Mesh mesh = sheet_mesh(20, 31, 0.1, true);
    shuffle(mesh, 6);
    const ClothModel cloth = build_cloth(mesh_scene(std::move(mesh)));
    EXPECT_EQ(mesh_order(cloth.particle_count, cloth.springs), slots_of(cloth));
    // The order of the springs is nothing to it either.
    std::vector<Spring> turned(cloth.springs.rbegin(), cloth.springs.rend());
    EXPECT_EQ(mesh_order(cloth.particle_count, turned), slots_of(cloth));
}

}  // namespace
}  // namespace weft::test
