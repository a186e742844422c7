// Even thinning of long recordings.
#include "io/frame_selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace weft {
namespace {

std::vector<std::size_t> kept(std::size_t planned, std::size_t most) {
    FrameSelection selection(planned, most);
    std::vector<std::size_t> frames;
    for (std::size_t i = 0; i < planned; ++i)
        if (selection.keep(i)) frames.push_back(i);
    EXPECT_EQ(frames.size(), selection.kept_of_all());
    return frames;
}

TEST(FrameSelection, KeepsAllThatFit) {
    EXPECT_EQ(kept(1, 251), (std::vector<std::size_t>{0}));
    EXPECT_EQ(kept(251, 251).size(), 251U);
    EXPECT_EQ(kept(251, 251).back(), 250U);
}

TEST(FrameSelection, ThinsEvenlyAndKeepsBothEnds) {
    EXPECT_EQ(kept(9, 5), (std::vector<std::size_t>{0, 2, 4, 6, 8}));
    EXPECT_EQ(kept(100, 2), (std::vector<std::size_t>{0, 99}));
    for (const std::size_t planned : {252U, 300U, 301U, 500U, 1801U, 100'000U}) {
        const auto frames = kept(planned, 251);
        ASSERT_EQ(frames.size(), 251U);
        EXPECT_EQ(frames.front(), 0U);
        EXPECT_EQ(frames.back(), planned - 1);
        const std::size_t gap = (planned - 1) / 250;
        for (std::size_t i = 1; i < frames.size(); ++i) {
            EXPECT_GE(frames[i] - frames[i - 1], gap);
            EXPECT_LE(frames[i] - frames[i - 1], gap + 1);
        }
    }
}

}  // namespace
}  // namespace weft
