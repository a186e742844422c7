#include "viewer/still_picture.h"

#include <gtest/gtest.h>

#include "shown_sheet.h"

namespace weft::viewer {
namespace {

using Wanted = StillPicture::Wanted;

TEST(StillPicture, IsDrawnBestOnceAfterARestAndThenKept) {
    StillPicture still;
    EXPECT_EQ(still.next(7, 0.0), Wanted::quick);
    EXPECT_EQ(still.next(7, 0.1), Wanted::quick);
    EXPECT_EQ(still.next(8, 0.2), Wanted::quick) << "something moved";
    EXPECT_EQ(still.next(8, 0.4), Wanted::quick);
    EXPECT_EQ(still.next(8, 0.6), Wanted::best);
    EXPECT_EQ(still.next(8, 0.61), Wanted::kept);
    EXPECT_EQ(still.next(9, 0.7), Wanted::quick);
    EXPECT_EQ(still.next(9, 1.1), Wanted::best);
    still.moved();
    EXPECT_EQ(still.next(9, 2.0), Wanted::quick);
}

TEST(StillPicture, TheKeyChangesWithAllThatIsDrawn) {
    ShownSheet sheet;
    WindowSettings settings;
    Camera camera;
    const auto key = [&] { return picture_key(sheet.shown, settings, camera, sheet.areas[0]); };
    std::vector<std::uint64_t> keys{key()};
    EXPECT_EQ(key(), keys[0]);
    const auto expect_new = [&] {
        for (const std::uint64_t earlier : keys) EXPECT_NE(key(), earlier);
        keys.push_back(key());
    };
    sheet.positions[17].y += 1e-9;
    expect_new();
    sheet.shown.obstacles = {{SphereObstacle{}}};
    expect_new();
    std::get<SphereObstacle>(sheet.shown.obstacles[0].shape).radius += 0.1;
    expect_new();
    sheet.shown.obstacles.push_back({PlaneObstacle{}});
    expect_new();
    sheet.shown.cloths[0].shape = std::make_shared<ClothShape>(*sheet.shown.cloths[0].shape);
    expect_new();
    settings.wireframe = true;
    expect_new();
    settings.springs = 2;
    expect_new();
    camera.eye.x += 0.001F;
    expect_new();
    sheet.areas[0].width += 1;
    expect_new();
    sheet.shown.cloths[0].label = {"written over it"};
    EXPECT_EQ(key(), keys.back());
}

}  // namespace
}  // namespace weft::viewer
