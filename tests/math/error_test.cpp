// Errors in one line, with their place.
#include <gtest/gtest.h>

#include "weft/error.h"

namespace weft::test {
namespace {

TEST(Error, SaysPlaceKeyAndMessageInOneLine) {
    const Error error(ErrorKind::usage, {"flag.toml", 12, 3, "cloth.size"}, "too small", "more");
    EXPECT_STREQ(error.what(), "flag.toml:12:3: cloth.size: too small");
    EXPECT_EQ(error.message(), "too small");
    EXPECT_EQ(error.detail(), "more");
    EXPECT_EQ(error.place().line, 12);
}

TEST(Error, LeavesOutWhatItDoesNotKnow) {
    const auto text = [](ErrorPlace place) {
        return std::string(Error(ErrorKind::file, std::move(place), "gone").what());
    };
    EXPECT_EQ(text({}), "gone");
    EXPECT_EQ(text({"a.obj", 0, 0, ""}), "a.obj: gone");
    EXPECT_EQ(text({"a.obj", 7, 0, ""}), "a.obj:7: gone");
    EXPECT_EQ(text({"", 0, 0, "pins[0]"}), "pins[0]: gone");
}

TEST(Error, OfASceneValueQuotesItAndWhatIsAllowed) {
    const Error error = scene_error("cloth.size", "-1", "a number above 0");
    EXPECT_STREQ(error.what(), "cloth.size: -1 is not allowed: a number above 0");
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_STREQ(file_error("x.png", "no such file").what(), "x.png: no such file");
    EXPECT_EQ(file_error("x.png", "no such file").kind(), ErrorKind::file);
}

}  // namespace
}  // namespace weft::test
