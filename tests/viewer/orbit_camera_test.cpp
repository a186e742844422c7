// The camera under the mouse: what stays under the cursor, and what is in the picture.
#include "viewer/orbit_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "math/random.h"

namespace weft::viewer {
namespace {

constexpr float height = 720.0F, aspect = 1280.0F / 720.0F;

Camera start() {
    Camera camera;
    camera.eye = {2.0F, 3.0F, 4.0F};
    camera.target = {0.5F, 1.5F, -0.25F};
    camera.near_plane = 0.04F;  // of a cloth of 2 m
    return camera;
}

/// Pixels from the left and the top.
glm::vec2 pixels_of(const Camera& camera, glm::vec3 point) {
    const glm::vec4 clip = camera.world_to_clip(aspect) * glm::vec4(point, 1.0F);
    EXPECT_GT(clip.w, 0.0F);
    return 0.5F * height * glm::vec2(aspect * (1.0F + clip.x / clip.w), 1.0F - clip.y / clip.w);
}

/// The point under the cursor in the target's depth.
glm::vec3 point_under(const Camera& camera, glm::vec2 cursor) {
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
    const float half = std::tan(0.5F * glm::radians(camera.field_of_view)) *
                       glm::distance(camera.eye, camera.target);
    return camera.target +
           half * (aspect * cursor.x * right + cursor.y * glm::cross(right, forward));
}

TEST(OrbitCamera, BeginsAsItIsGiven) {
    const Camera camera = OrbitCamera(start()).camera();
    EXPECT_LT(glm::distance(camera.eye, start().eye), 1e-5F);
    EXPECT_EQ(camera.target, start().target);
    EXPECT_EQ(camera.field_of_view, start().field_of_view);
}

TEST(OrbitCamera, TurnsOnceForADragOfTwoPictureHeights) {
    OrbitCamera orbit(start());
    for (int n = 0; n < 4; ++n) orbit.orbit({0.25F * height, 0.0F}, height);
    const glm::vec3 before = start().eye - start().target;
    const glm::vec3 half_way = orbit.camera().eye - start().target;
    EXPECT_LT(glm::distance(half_way, glm::vec3(-before.x, before.y, -before.z)), 1e-4F);
    for (int n = 0; n < 4; ++n) orbit.orbit({0.25F * height, 0.0F}, height);
    EXPECT_LT(glm::distance(orbit.camera().eye, start().eye), 1e-4F);
}

TEST(OrbitCamera, TurnsTheClothTheWayItIsDragged) {
    OrbitCamera orbit(start());
    const glm::vec3 forward = glm::normalize(start().target - start().eye);
    const glm::vec3 facing = start().target - 0.2F * forward;  // on the side toward the eye
    const glm::vec2 before = pixels_of(orbit.camera(), facing);
    orbit.orbit({20.0F, 0.0F}, height);
    EXPECT_GT(pixels_of(orbit.camera(), facing).x, before.x + 1.0F);
    orbit.orbit({-20.0F, 20.0F}, height);
    EXPECT_GT(pixels_of(orbit.camera(), facing).y, before.y + 1.0F);
}

TEST(OrbitCamera, NeverTurnsOverThePoles) {
    for (const float way : {1.0F, -1.0F}) {
        OrbitCamera orbit(start());
        for (int n = 0; n < 100; ++n) {
            orbit.orbit({3.0F, way * 20.0F}, height);
            const glm::vec3 out = orbit.camera().eye - orbit.camera().target;
            EXPECT_GT(std::hypot(out.x, out.z), 0.05F * glm::length(out));
            const glm::vec3 above = orbit.camera().target + glm::vec3(0.0F, 0.1F, 0.0F);
            EXPECT_LT(pixels_of(orbit.camera(), above).y,
                      pixels_of(orbit.camera(), orbit.camera().target).y);
        }
        EXPECT_GT(way * orbit.camera().eye.y, way * orbit.camera().target.y);
    }
}

TEST(OrbitCamera, StraightDownIsTiltedAndThenStaysStill) {
    Camera camera = start();
    camera.eye = camera.target + glm::vec3(0.0F, 5.0F, 0.0F);
    OrbitCamera orbit(camera);
    const glm::vec3 point = point_under(orbit.camera(), {0.3F, 0.2F});
    const glm::vec2 before = pixels_of(orbit.camera(), point);
    orbit.pan({50.0F, 30.0F}, height);
    EXPECT_LT(glm::distance(pixels_of(orbit.camera(), point), before + glm::vec2(50, 30)), 0.5F);
    EXPECT_NEAR(glm::distance(orbit.camera().eye, orbit.camera().target), 5.0F, 1e-4F);
}

TEST(OrbitCamera, PanKeepsThePointUnderTheCursor) {
    OrbitCamera orbit(start());
    for (const glm::vec2 cursor : {glm::vec2(0, 0), glm::vec2(-0.8F, 0.5F), glm::vec2(0.9F, -1)}) {
        const glm::vec3 point = point_under(orbit.camera(), cursor);
        const glm::vec2 before = pixels_of(orbit.camera(), point);
        const glm::vec2 drag(-123.0F, 77.0F);
        for (int n = 0; n < 10; ++n) orbit.pan(0.1F * drag, height);
        EXPECT_LT(glm::distance(pixels_of(orbit.camera(), point), before + drag), 0.5F);
    }
}

TEST(OrbitCamera, ZoomKeepsThePointUnderTheCursor) {
    OrbitCamera orbit(start());
    for (const float notches : {3.0F, -7.0F, 0.25F, 12.0F}) {
        const glm::vec2 cursor(0.7F, -0.6F);
        const glm::vec3 point = point_under(orbit.camera(), cursor);
        const glm::vec2 before = pixels_of(orbit.camera(), point);
        const float distance = glm::distance(orbit.camera().eye, orbit.camera().target);
        orbit.zoom(notches, cursor, aspect);
        EXPECT_LT(glm::distance(pixels_of(orbit.camera(), point), before), 0.5F) << notches;
        EXPECT_NEAR(glm::distance(orbit.camera().eye, orbit.camera().target),
                    distance * std::pow(0.9F, notches), 1e-3F * distance);
    }
}

TEST(OrbitCamera, TheWheelLosesNothing) {
    OrbitCamera orbit(start());
    for (int n = 0; n < 400; ++n) orbit.zoom(1.0F, {0.0F, 0.0F}, aspect);
    EXPECT_NEAR(glm::distance(orbit.camera().eye, orbit.camera().target), 0.01F, 1e-4F);
    EXPECT_LT(orbit.camera().near_plane, 0.001F);
    for (int n = 0; n < 400; ++n) orbit.zoom(-1.0F, {0.0F, 0.0F}, aspect);
    EXPECT_NEAR(glm::distance(orbit.camera().eye, orbit.camera().target), 200.0F, 0.1F);
    EXPECT_LT(glm::distance(orbit.camera().target, start().target), 1e-3F);
    EXPECT_GT(orbit.camera().far_plane, 400.0F);
}

/// A box as random as can be, of sides from a centimetre to ten metres.
Box random_box(std::uint64_t n) {
    const auto number = [&](std::uint64_t k) {
        return static_cast<float>(random_uniform(9, k, n));
    };
    const glm::vec3 low = 20.0F * glm::vec3(number(0), number(1), number(2)) - 10.0F;
    const auto side = [&](std::uint64_t k) { return 0.01F * std::pow(1000.0F, number(k)); };
    return {low, low + glm::vec3(side(3), side(4), side(5))};
}

TEST(OrbitCamera, FramesAllOfABoxAndFillsThePicture) {
    for (std::uint64_t n = 0; n < 60; ++n) {
        for (const float ratio : {0.4F, aspect, 4.0F}) {
            OrbitCamera orbit(start());
            orbit.orbit({97.0F * static_cast<float>(n), 31.0F * static_cast<float>(n % 7)}, height);
            const glm::vec3 forward = glm::normalize(orbit.camera().target - orbit.camera().eye);
            orbit.frame(random_box(n), ratio);
            glm::vec2 low(1e9F), high(-1e9F);
            for (const glm::vec3& corner : random_box(n).corners()) {
                const glm::vec4 clip = orbit.camera().world_to_clip(ratio) * glm::vec4(corner, 1);
                ASSERT_GT(clip.w, 0.0F);
                EXPECT_LT(std::abs(clip.z), clip.w);
                low = glm::min(low, glm::vec2(clip) / clip.w);
                high = glm::max(high, glm::vec2(clip) / clip.w);
            }
            EXPECT_GT(std::min(low.x, low.y), -1.0F) << n;
            EXPECT_LT(std::max(high.x, high.y), 1.0F) << n;
            EXPECT_GT(std::max(high.x - low.x, high.y - low.y), 2 * 0.7F) << n;
            const glm::vec3 now = glm::normalize(orbit.camera().target - orbit.camera().eye);
            EXPECT_LT(glm::distance(now, forward), 1e-4F);
        }
    }
}

TEST(OrbitCamera, FramesASinglePoint) {
    OrbitCamera orbit(start());
    orbit.frame({glm::vec3(1.0F), glm::vec3(1.0F)}, aspect);
    EXPECT_LT(glm::distance(orbit.camera().target, glm::vec3(1.0F)), 1e-5F);
    EXPECT_GT(glm::distance(orbit.camera().eye, orbit.camera().target), 1e-3F);
}

}  // namespace
}  // namespace weft::viewer
