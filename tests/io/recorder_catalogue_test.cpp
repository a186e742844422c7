// The table of formats.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "weft/error.h"
#include "weft/recorder.h"

namespace weft {
namespace {

TEST(FormatCatalogue, ListsEveryFormatOnce) {
    std::vector<std::string_view> names;
    for (const FormatInfo& info : format_catalogue()) {
        names.push_back(info.name);
        EXPECT_NE(info.files.find("NAME"), std::string_view::npos) << info.name;
        EXPECT_FALSE(info.description.empty()) << info.name;
    }
    EXPECT_EQ(names, (std::vector<std::string_view>{"glb", "pc2", "mdd", "npy", "obj", "ply", "png",
                                                    "mp4", "webm", "gif"}));
}

TEST(FormatCatalogue, MakesARecorderOfEach) {
    for (const FormatInfo& info : format_catalogue())
        EXPECT_NE(make_recorder(info.name), nullptr) << info.name;
}

TEST(FormatCatalogue, UnknownFormatIsAUsageErrorThatNamesTheKnownOnes) {
    try {
        make_recorder("fbx");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_EQ(error.place().key, "output.formats");
        EXPECT_NE(error.message().find("\"fbx\""), std::string::npos);
        EXPECT_NE(error.message().find("one of glb, pc2, mdd, npy, obj, ply, png, mp4, webm, gif"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace weft
