#include "viewer/cloth_layers.h"

#include <gtest/gtest.h>

#include "shown_sheet.h"

namespace weft::viewer {
namespace {

TEST(ClothLayers, PinsAreShownUnlessTurnedOff) {
    ShownSheet sheet;
    WindowSettings settings;
    EXPECT_EQ(layers_of(settings, sheet.shown.cloths[0], sheet.shown),
              std::vector<Layer>{Layer::pins});
    settings.pins = false;
    EXPECT_TRUE(layers_of(settings, sheet.shown.cloths[0], sheet.shown).empty());
}

TEST(ClothLayers, AreWhatIsAskedForAndThere) {
    ShownSheet sheet;
    WindowSettings settings;
    settings.wireframe = settings.particles = settings.normals = settings.wind_arrows = true;
    settings.springs = 1;
    using enum Layer;
    EXPECT_EQ(layers_of(settings, sheet.shown.cloths[0], sheet.shown),
              (std::vector<Layer>{wireframe, particles, normals, pins}))
        << "there are neither springs nor wind";
    auto shape = std::make_shared<ClothShape>(*sheet.shown.cloths[0].shape);
    shape->springs.push_back({0, 1, 0.1F, 0});
    sheet.shown.cloths[0].shape = shape;
    sheet.shown.wind = {1.0, 0.0, 0.0};
    sheet.shown.obstacles = {{PlaneObstacle{}}};
    EXPECT_EQ(layers_of(settings, sheet.shown.cloths[0], sheet.shown),
              (std::vector<Layer>{springs_by_strain, wireframe, particles, normals, wind, pins,
                                  handles}));
    settings.springs = 2;
    EXPECT_EQ(layers_of(settings, sheet.shown.cloths[0], sheet.shown).front(), springs_by_kind);
    sheet.shown.touchable = false;
    EXPECT_EQ(layers_of(settings, sheet.shown.cloths[0], sheet.shown).back(), pins)
        << "what cannot be touched has no handle";
}

TEST(ClothLayers, AHandleIsTwoArrowsAlongThePlanesNormal) {
    ShownSheet sheet;
    sheet.shown.obstacles = {{PlaneObstacle{{0.0, -1.0, 0.0}, {0.0, 3.0, 0.0}}}};
    OverlayList list;
    add_layer(Layer::handles, sheet.shown.cloths[0], sheet.shown, 0.1F, list);
    ASSERT_FALSE(list.empty());
    float low = 9.0F, high = -9.0F;
    for (const OverlayVertex& vertex : list) {
        low = std::min(low, vertex.position.y);
        high = std::max(high, vertex.position.y);
    }
    const PlaneHandle handle =
        plane_handles(sheet.shown.obstacles, sheet.shown.cloths[0].shape->stage)[0];
    EXPECT_NEAR(low, handle.middle.y - handle.length, 1e-4F);
    EXPECT_NEAR(high, handle.middle.y + handle.length, 1e-4F);
    EXPECT_GT(low, -1.0F) << "the plane would hide it";
}

}  // namespace
}  // namespace weft::viewer
