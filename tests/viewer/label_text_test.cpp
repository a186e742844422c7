#include "viewer/label_text.h"

#include <gtest/gtest.h>

namespace weft::viewer {
namespace {

TEST(LabelText, LinesShareARowWhereRowsAreFew) {
    const auto width = [](const std::string& text) { return static_cast<float>(text.size()); };
    const std::vector<std::string> lines{"rk4", "1.23 s", "step 0.001 s, 20 a frame", "4 ms",
                                         "5 J"};
    EXPECT_EQ(shared_rows(lines, 30.0F, width),
              (std::vector<std::string>{"rk4, 1.23 s", "step 0.001 s, 20 a frame, 4 ms", "5 J"}));
    EXPECT_EQ(shared_rows(lines, 1.0F, width), lines);
    EXPECT_TRUE(shared_rows({}, 30.0F, width).empty());
}

TEST(LabelText, AForceIsReadAtAGlance) {
    EXPECT_EQ(force_text(0.0), "0 N");
    EXPECT_EQ(force_text(0.0123), "12 mN");
    EXPECT_EQ(force_text(3.24), "3.2 N");
    EXPECT_EQ(force_text(123.4), "123 N");
    EXPECT_EQ(force_text(2.5e6), "2.5e+06 N");
}

}  // namespace
}  // namespace weft::viewer
