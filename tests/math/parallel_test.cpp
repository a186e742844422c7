// Loops over threads visit every index once.
#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "math/parallel.h"

namespace weft::test {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnceWithAnyThreads) {
    for (const int threads : {1, 2, 7}) {
        ThreadTeam team(threads);
        EXPECT_EQ(team.size(), threads);
        for (const std::size_t count : {0u, 1u, 9u, 10u, 999u, 10000u}) {
            std::vector<std::atomic<int>> visits(count);
            team.run([&] {
                parallel_for(count, 5, [&](std::size_t begin, std::size_t end) {
                    ASSERT_LT(begin, end);
                    ASSERT_LE(end, count);
                    for (std::size_t n = begin; n < end; ++n) ++visits[n];
                });
            });
            for (const auto& n : visits) ASSERT_EQ(n, 1);
        }
    }
}

TEST(ParallelFor, KeepsShortLoopsWhole) {
    ThreadTeam team(4);
    std::atomic<int> calls = 0;
    team.run([&] { parallel_for(199, 100, [&](std::size_t, std::size_t) { ++calls; }); });
    EXPECT_EQ(calls, 1);
}

TEST(ThreadTeam, TakesAllHardwareThreadsForZero) {
    EXPECT_GE(ThreadTeam(0).size(), 1);
}

}  // namespace
}  // namespace weft::test
