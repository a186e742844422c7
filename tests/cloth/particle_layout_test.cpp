// Where particles stand in the arrays of a state: rows on cache lines, permutations.
#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "cloth/cloth_model.h"
#include "support/cloth_scenes.h"

namespace weft::test {
namespace {

using Size = std::pair<std::size_t, std::size_t>;

template <typename Visit>
void for_each_layout(const Visit& visit) {
    for (const auto& [columns, rows] : {Size{2, 2}, {3, 5}, {15, 4}, {16, 4}, {17, 4}, {497, 3}}) {
        visit(ParticleLayout::of_grid(columns, rows), columns * rows);
    }
    visit(ParticleLayout::in_order(9), std::size_t{9});
    visit(ParticleLayout::of_slots({3, 0, 4, 1, 2}), std::size_t{5});
}

TEST(ParticleLayout, GivesEveryParticleItsOwnSlot) {
    for_each_layout([](const ParticleLayout& layout, std::size_t count) {
        EXPECT_EQ(layout.particle_count(), count);
        std::set<std::size_t> taken;
        for (std::size_t p = 0; p < count; ++p) {
            EXPECT_LT(layout.slot(p), layout.slot_count());
            EXPECT_TRUE(taken.insert(layout.slot(p)).second) << p;
        }
    });
}

TEST(ParticleLayout, IsVisitedInTheOrderOfParticles) {
    for_each_layout([](const ParticleLayout& layout, std::size_t count) {
        std::size_t next = 0;
        layout.for_each([&](std::size_t particle, std::size_t slot) {
            EXPECT_EQ(particle, next++);
            EXPECT_EQ(slot, layout.slot(particle));
        });
        EXPECT_EQ(next, count);
    });
}

// 16 floats, or 8 doubles twice, are a line; 512 doubles, or half of 1024 floats, are a page.
TEST(ParticleLayout, OfAGridBeginsRowsOnCacheLinesAndNeverPagesApart) {
    for (std::size_t columns = 2; columns <= 2100; ++columns) {
        const ParticleLayout layout = ParticleLayout::of_grid(columns, 3);
        const std::size_t stride = layout.row_stride();
        ASSERT_EQ(stride % 16, 0u) << columns;
        ASSERT_NE(stride % 512, 0u) << columns;
        ASSERT_GE(stride, columns);
        ASSERT_LT(stride, columns + 32);
        ASSERT_EQ(layout.slot_count(), 3 * stride);
        ASSERT_EQ(layout.slot(2 * columns + 1), 2 * stride + 1);
    }
    EXPECT_EQ(ParticleLayout::of_grid(496, 2).row_stride(), 496u);
    EXPECT_EQ(ParticleLayout::of_grid(497, 2).row_stride(), 528u);  // not 512
    EXPECT_EQ(ParticleLayout::of_grid(512, 2).row_stride(), 528u);
}

TEST(ParticleLayout, OfSlotsIsThePermutationGiven) {
    const ParticleLayout layout = ParticleLayout::of_slots({3, 0, 4, 1, 2});
    const std::vector<std::size_t> expected{3, 0, 4, 1, 2};
    for (std::size_t p = 0; p < 5; ++p) EXPECT_EQ(layout.slot(p), expected[p]);
    EXPECT_EQ(layout.slot_count(), 5u);
    const ParticleLayout plain = ParticleLayout::in_order(5);
    for (std::size_t p = 0; p < 5; ++p) EXPECT_EQ(plain.slot(p), p);
}

TEST(ParticleLayout, OfNothingHasNoSlots) {
    for (const ParticleLayout& layout : {ParticleLayout{}, ParticleLayout::in_order(0)}) {
        EXPECT_EQ(layout.particle_count(), 0u);
        EXPECT_EQ(layout.slot_count(), 0u);
        layout.for_each([](std::size_t, std::size_t) { FAIL(); });
    }
}

TEST(ParticleLayout, OfAClothHoldsItsParticles) {
    SceneDescription scene = bare_sheet(7, 5);
    const ClothModel grid = build_cloth(scene);
    EXPECT_EQ(grid.layout.particle_count(), 35u);
    EXPECT_EQ(grid.layout.slot_count(), 5u * 16u);
    EXPECT_EQ(grid.slot(34), 4u * 16u + 6u);
    make_mesh_of_grid(scene);
    EXPECT_EQ(build_cloth(scene).layout.particle_count(), 35u);
}

// The slots that springs are given with are those of their particles.
TEST(ParticleLayout, IsThatOfTheSpringsSlots) {
    SceneDescription scene = bare_sheet(7, 5);
    const ClothModel grid = build_cloth(scene);
    make_mesh_of_grid(scene);
    ClothModel mesh = build_cloth(scene);
    shuffle_layout(mesh);
    for (const ClothModel* cloth : {&grid, &std::as_const(mesh)}) {
        std::size_t springs = 0;
        cloth->for_each_spring_with_slots([&](const Spring& spring, const SpringConstants&,
                                              std::size_t slot_p, std::size_t slot_q) {
            EXPECT_EQ(slot_p, cloth->slot(spring.p));
            EXPECT_EQ(slot_q, cloth->slot(spring.q));
            ++springs;
        });
        const auto counts = cloth->spring_counts();
        EXPECT_EQ(springs, counts[0] + counts[1] + counts[2]);
    }
}

}  // namespace
}  // namespace weft::test
