// Pins: which particles every selector takes, and how keyframed ones move.
#include <gtest/gtest.h>

#include "cloth/pins.h"
#include "support/cloth_scenes.h"
#include "weft/error.h"

namespace weft::test {
namespace {

using Particles = std::vector<std::size_t>;

// A sheet of 5 x 4: particle 5 row + column.
Particles pinned_by(std::vector<PinSelector> selectors) {
    SceneDescription scene = bare_sheet(5, 4, 4.0, 3.0);
    for (PinSelector& selector : selectors) scene.pins.push_back({std::move(selector), {}});
    Particles particles;
    for (const Pin& pin : build_cloth(scene).pins) {
        EXPECT_EQ(pin.motion, Pin::no_motion);
        particles.push_back(pin.particle);
    }
    return particles;
}

TEST(PinSelectors, TakeCorners) {
    EXPECT_EQ(pinned_by({EdgeSelection::top_left}), (Particles{0}));
    EXPECT_EQ(pinned_by({EdgeSelection::top_right}), (Particles{4}));
    EXPECT_EQ(pinned_by({EdgeSelection::bottom_left}), (Particles{15}));
    EXPECT_EQ(pinned_by({EdgeSelection::bottom_right}), (Particles{19}));
}

TEST(PinSelectors, TakeEdges) {
    EXPECT_EQ(pinned_by({EdgeSelection::left_edge}), (Particles{0, 5, 10, 15}));
    EXPECT_EQ(pinned_by({EdgeSelection::right_edge}), (Particles{4, 9, 14, 19}));
    EXPECT_EQ(pinned_by({EdgeSelection::top_edge}), (Particles{0, 1, 2, 3, 4}));
    EXPECT_EQ(pinned_by({EdgeSelection::bottom_edge}), (Particles{15, 16, 17, 18, 19}));
}

TEST(PinSelectors, TakeEveryNthOfAnEdge) {
    EXPECT_EQ(pinned_by({EverySelection{2, EdgeSelection::top_edge}}), (Particles{0, 2, 4}));
    EXPECT_EQ(pinned_by({EverySelection{3, EdgeSelection::left_edge}}), (Particles{0, 15}));
    EXPECT_EQ(pinned_by({EverySelection{100, EdgeSelection::bottom_edge}}), (Particles{15}));
}

TEST(PinSelectors, TakeListsAndBoxes) {
    EXPECT_EQ(pinned_by({ParticleSelection{{7, 3, 7}}}), (Particles{3, 7}));
    // Rest positions (column, -row, 0), borders included.
    EXPECT_EQ(pinned_by({BoxSelection{{1.0, -2.0, -0.1}, {2.5, -1.0, 0.1}}}),
              (Particles{6, 7, 11, 12}));
}

TEST(PinSelectors, MayOverlap) {
    EXPECT_EQ(pinned_by({EdgeSelection::top_left, EdgeSelection::left_edge}),
              (Particles{0, 5, 10, 15}));
}

std::string refusal(std::vector<PinDescription> pins) {
    SceneDescription scene = bare_sheet(5, 4, 4.0, 3.0);
    scene.pins = std::move(pins);
    try {
        build_cloth(scene);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.what();
    }
    return "accepted";
}

TEST(PinSelectors, ThatAreWrongAreRefused) {
    EXPECT_EQ(refusal({{ParticleSelection{{20}}, {}}}),
              "pins[0].select: particle 20 is not allowed: the cloth has particles 0 to 19");
    EXPECT_EQ(refusal({{EdgeSelection::top_left, {}}, {BoxSelection{{9, 9, 9}, {9, 9, 9}}, {}}}),
              "pins[1].select: a selector that picks no particle is not allowed: at least one "
              "particle must lie in it");
    EXPECT_EQ(
        refusal({{EdgeSelection::top_edge, {}}, {EdgeSelection::top_right, {{0.0, {1, 0, 0}}}}}),
        "pins[1].select: particle 4 (column 4, row 0) is not allowed: pins[0] already holds it "
        "with another motion");
}

TEST(PinMotion, IsSharedByTheParticlesOfItsPin) {
    SceneDescription scene = bare_sheet(5, 4, 4.0, 3.0);
    const std::vector<PinKeyframe> motion{{0.0, {}}, {1.0, {0.5, 0.0, 0.0}}};
    scene.pins = {{EdgeSelection::top_left, {}},
                  {EdgeSelection::right_edge, motion},
                  {EdgeSelection::bottom_left, {{2.0, {0.0, 1.0, 0.0}}}}};
    const ClothModel cloth = build_cloth(scene);
    ASSERT_EQ(cloth.motions.size(), 2u);
    ASSERT_EQ(cloth.pins.size(), 6u);
    for (const Pin& pin : cloth.pins) {
        const std::uint32_t expected = pin.particle == 0    ? Pin::no_motion
                                       : pin.particle == 15 ? 1
                                                            : 0;
        EXPECT_EQ(pin.motion, expected) << pin.particle;
        EXPECT_EQ(pin.rest, cloth.rest_position(pin.particle));
    }
}

const std::vector<PinKeyframe> path{
    {0.5, {0.1, 0.0, -1.0}}, {1.5, {0.3, 2.0, 0.0}}, {1.75, {0.2, -1.0, 0.5}}};

TEST(PinMotion, PassesThroughItsKeyframesAndRestsOutside) {
    for (const PinKeyframe& keyframe : path) {
        EXPECT_LT(length(pin_offset(path, keyframe.time).offset - keyframe.offset), 1e-15);
        EXPECT_EQ(length(pin_offset(path, keyframe.time).velocity), 0.0);
    }
    for (const double time : {-3.0, 0.0, 0.5})
        EXPECT_EQ(pin_offset(path, time).offset, path.front().offset);
    for (const double time : {1.75, 2.0, 1e6})
        EXPECT_EQ(pin_offset(path, time).offset, path.back().offset);
    EXPECT_EQ(length(pin_offset(path, 0.4).velocity) + length(pin_offset(path, 2.0).velocity), 0.0);
}

// 3 s^2 - 2 s^3: at a quarter 5/32, half way a half.
TEST(PinMotion, FollowsTheCubicBetween) {
    const auto at = [](double s) { return pin_offset(path, 0.5 + s).offset; };
    EXPECT_NEAR(at(0.25).y, 2.0 * 5.0 / 32.0, 1e-15);
    EXPECT_NEAR(at(0.5).y, 1.0, 1e-15);
    EXPECT_NEAR(at(0.75).z, -1.0 + 27.0 / 32.0, 1e-15);
    EXPECT_NEAR(pin_offset(path, 1.0).velocity.y, 1.5 * 2.0, 1e-14);  // fastest in the middle
}

TEST(PinMotion, HasTheVelocityAndAccelerationOfItsOffset) {
    constexpr double h = 1e-5;
    for (double t = 0.503; t < 1.74; t += 0.0307) {
        if (std::abs(t - 1.5) < 2 * h) continue;
        const PinOffset before = pin_offset(path, t - h), now = pin_offset(path, t),
                        after = pin_offset(path, t + h);
        EXPECT_LT(length(now.velocity - (after.offset - before.offset) / (2 * h)), 1e-7) << t;
        EXPECT_LT(length(now.acceleration - (after.velocity - before.velocity) / (2 * h)), 1e-7)
            << t;
    }
}

TEST(PinMotion, NeverJumpsInPlaceOrVelocity) {
    constexpr double h = 1e-4;
    PinOffset before = pin_offset(path, 0.4);
    for (double t = 0.4 + h; t < 1.9; t += h) {
        const PinOffset now = pin_offset(path, t);
        EXPECT_LT(length(now.offset - before.offset), 25.0 * h);       // top speed 19 m/s
        EXPECT_LT(length(now.velocity - before.velocity), 400.0 * h);  // 300 m/s2
        before = now;
    }
}

}  // namespace
}  // namespace weft::test
