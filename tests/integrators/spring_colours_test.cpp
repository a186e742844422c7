// Colours: nothing of one colour touches its own kind, nothing is left out, and rows are complete.
#include "integrators/spring_colours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "support/cloth_scenes.h"

namespace weft::test {
namespace {

SpringNetwork network_of(int columns, int rows, bool mesh, bool pinned) {
    SceneDescription scene = bare_sheet(columns, rows);
    if (pinned) scene.pins = {{BoxSelection{{-0.01, -9.0, -9.0}, {0.01, 9.0, 9.0}}, {}}};
    if (mesh) make_mesh_of_grid(scene);
    ClothModel cloth = build_cloth(scene);
    if (mesh) shuffle_layout(cloth);
    return spring_network(cloth);
}

TEST(SpringColours, ShareNoFreeParticleAndLeaveNoSpringOut) {
    for (const bool mesh : {false, true}) {
        for (const bool pinned : {false, true}) {
            const SpringNetwork network = network_of(13, 9, mesh, pinned);
            const ColouredSprings coloured = colour_springs(network);
            std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
            for (std::size_t colour = 0; colour < coloured.colour_count(); ++colour) {
                std::set<std::uint32_t> ends;
                EXPECT_LT(coloured.first[colour], coloured.first[colour + 1]);
                for (std::size_t n = coloured.first[colour]; n < coloured.first[colour + 1]; ++n) {
                    const SpringNetwork::Spring& s = coloured.springs[n];
                    for (const std::uint32_t end : {s.p, s.q}) {
                        if (network.inverse_masses[end] == 0.0) continue;
                        EXPECT_TRUE(ends.insert(end).second);
                    }
                    EXPECT_TRUE(seen.insert({s.p, s.q}).second);
                }
            }
            const auto moves = [&](const SpringNetwork::Spring& s) {
                return network.inverse_masses[s.p] + network.inverse_masses[s.q] > 0.0;
            };
            EXPECT_EQ(seen.size(), static_cast<std::size_t>(std::count_if(
                                       network.springs.begin(), network.springs.end(), moves)));
        }
    }
}

TEST(SpringColours, AreTwelveOnAGridOfTwelveNeighbours) {
    EXPECT_EQ(colour_springs(network_of(40, 30, false, false)).colour_count(), 12u);
    EXPECT_LE(colour_particles(network_of(40, 30, false, false)).colour_count(), 8u);
}

TEST(ParticleColours, JoinNoNeighboursAndHaveEveryFreeParticleOnce) {
    for (const bool mesh : {false, true}) {
        const SpringNetwork network = network_of(13, 9, mesh, true);
        const ColouredParticles coloured = colour_particles(network);
        std::vector<std::size_t> colour_of(network.inverse_masses.size(), 1000);
        for (std::size_t colour = 0; colour < coloured.colour_count(); ++colour) {
            for (std::size_t n = coloured.first[colour]; n < coloured.first[colour + 1]; ++n) {
                EXPECT_EQ(colour_of[coloured.slots[n]], 1000u);
                colour_of[coloured.slots[n]] = colour;
            }
        }
        EXPECT_EQ(coloured.slots.size(), free_slots(network).size());
        for (const SpringNetwork::Spring& s : network.springs) {
            if (colour_of[s.p] == 1000 || colour_of[s.q] == 1000) continue;
            EXPECT_NE(colour_of[s.p], colour_of[s.q]);
        }
    }
}

TEST(SpringRows, HaveEverySpringAtBothItsFreeEnds) {
    const SpringNetwork network = network_of(5, 4, false, true);
    const SpringRows<double> rows(network, free_slots(network));
    ASSERT_EQ(rows.slots.size(), 16u);
    for (std::size_t row = 0; row < rows.slots.size(); ++row) {
        std::size_t entry = rows.first[row];
        for (const SpringNetwork::Spring& s : network.springs) {
            if (s.p != rows.slots[row] && s.q != rows.slots[row]) continue;
            ASSERT_LT(entry, rows.first[row + 1]);
            EXPECT_EQ(rows.entries[entry].other, s.p == rows.slots[row] ? s.q : s.p);
            EXPECT_EQ(rows.entries[entry].rest_length, s.rest_length);
            EXPECT_EQ(rows.entries[entry].stiffness, s.stiffness);
            EXPECT_EQ(rows.entries[entry].damping, s.damping);
            ++entry;
        }
        EXPECT_EQ(entry, rows.first[row + 1]);
    }
}

TEST(SpringRows, AreNoneOfAClothThatIsPinnedWhole) {
    SpringNetwork network;
    network.inverse_masses = {0.0, 0.0};
    network.springs = {{0, 1, 1.0, 10.0, 0.0}};
    EXPECT_EQ(colour_springs(network).colour_count(), 0u);
    EXPECT_EQ(colour_particles(network).colour_count(), 0u);
    EXPECT_TRUE(free_slots(network).empty());
    EXPECT_FALSE(has_dashpots(network));
    network.springs[0].damping = 0.1;
    EXPECT_TRUE(has_dashpots(network));
}

}  // namespace
}  // namespace weft::test
