// What stands under the cursor: rays agree with the picture, hits with a plain search.
#include "viewer/picking.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

#include "cloth/grid_cloth.h"
#include "support/cloth_scenes.h"
#include "support/sanitized.h"

namespace weft::viewer {
namespace {

constexpr float aspect = 1.6F;

Camera camera_at(glm::vec3 eye, glm::vec3 target, float near_plane = 0.02F) {
    return {.eye = eye, .target = target, .near_plane = near_plane, .far_plane = 500.0F};
}

std::vector<Camera> cameras() {
    return {camera_at({0, 0, 5}, {0, 0, 0}), camera_at({3, -2, 1}, {0.2F, 0.1F, -4}),
            camera_at({1, 9, 1}, {1, 0, 1}), camera_at({-7, 0.5F, 60}, {-6, 0.5F, 0}),
            camera_at({0.501F, 0.5F, 0.51F}, {0.5F, 0.5F, 0.5F}, 2e-4F)};
}

TEST(RayThrough, MeetsThePictureAgain) {
    for (const Camera& camera : cameras()) {
        for (const glm::vec2 cursor : {glm::vec2(0, 0), glm::vec2(0.9F, -0.7F), glm::vec2(-1, 1)}) {
            const Ray ray = ray_through(camera, cursor, aspect);
            EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-12);
            EXPECT_EQ(ray.origin, glm::dvec3(camera.eye));
            const double away = glm::distance(camera.eye, camera.target);
            for (const double part : {0.5, 1.0, 3.0}) {
                const glm::vec3 point(ray.origin + part * away * ray.direction);
                const glm::vec4 clip = camera.world_to_clip(aspect) * glm::vec4(point, 1.0F);
                EXPECT_GT(clip.w, 0.0F);
                EXPECT_LT(glm::distance(glm::vec2(clip) / clip.w, cursor), 1e-4F)
                    << camera.eye.x << " " << cursor.x << " " << part;
            }
        }
    }
}

/// A grid with every particle somewhere in a cube: triangles of all sizes through each other.
struct Crumpled {
    Surface surface;
    std::vector<Vec3d> positions;

    Crumpled(int columns, int rows, double reach) {
        const GridDescription grid{{1.0, 1.0}, {columns, rows}, Plane::xy, {-0.5, 0.5, 0.0}};
        surface = grid_surface(grid_shape(grid));
        for (std::size_t p = 0; p < surface.particle_count; ++p) {
            const auto width = static_cast<std::size_t>(columns);
            positions.push_back(grid_position(grid, p % width, p / width) +
                                reach * test::random_vector(4, p));
        }
    }
};

/// Möller and Trumbore's test of one triangle: the distance, or infinity.
double plain_distance(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, const Ray& ray) {
    constexpr double none = std::numeric_limits<double>::infinity();
    const glm::dvec3 p = glm::cross(ray.direction, c - a);
    const double determinant = glm::dot(b - a, p);
    if (determinant == 0.0) return none;
    const double u = glm::dot(ray.origin - a, p) / determinant;
    const glm::dvec3 q = glm::cross(ray.origin - a, b - a);
    const double v = glm::dot(ray.direction, q) / determinant;
    const double t = glm::dot(c - a, q) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : none;
}

void expect_as_plain_search(const Crumpled& cloth, const Ray& ray, int& hits) {
    double nearest = std::numeric_limits<double>::infinity();
    std::array<std::uint32_t, 3> corners{};
    for (const auto& t : cloth.surface.triangles) {
        const double distance =
            plain_distance(to_double(cloth.positions[t[0]]), to_double(cloth.positions[t[1]]),
                           to_double(cloth.positions[t[2]]), ray);
        if (distance >= nearest) continue;
        nearest = distance;
        corners = t;
    }
    const auto hit = pick_cloth(cloth.surface, cloth.positions, ray);
    ASSERT_EQ(hit.has_value(), std::isfinite(nearest));
    if (!hit) return;
    ++hits;
    EXPECT_NEAR(hit->distance, nearest, 1e-9);
    EXPECT_LT(glm::distance(hit->point, ray.origin + nearest * ray.direction), 1e-9);
    double least = std::numeric_limits<double>::infinity();
    std::size_t particle = 0;
    for (const std::uint32_t p : corners) {
        const double away = glm::distance(to_double(cloth.positions[p]), hit->point);
        if (away < least) particle = p;
        least = std::min(least, away);
    }
    EXPECT_EQ(hit->particle, particle);
}

TEST(PickCloth, AgreesWithAPlainSearchFromBothSides) {
    const Crumpled cloth(12, 9, 0.4);
    int hits = 0, rays = 0;
    for (const glm::vec3 eye : {glm::vec3(0.3F, 0.2F, 3.0F), glm::vec3(-0.4F, 0.1F, -3.0F),
                                glm::vec3(0.05F, 0.02F, 0.01F)}) {
        const Camera camera = camera_at(eye, {0, 0, 0});
        for (float x = -1.0F; x < 1.0F; x += 0.093F) {
            for (float y = -1.0F; y < 1.0F; y += 0.127F, ++rays) {
                expect_as_plain_search(cloth, ray_through(camera, {x, y}, aspect), hits);
            }
        }
    }
    EXPECT_GT(hits, rays / 4);
    EXPECT_LT(hits, rays);
}

TEST(PickCloth, FindsTheParticleItLooksAt) {
    const Crumpled flat(9, 7, 0.0);
    for (std::size_t p = 0; p < flat.positions.size(); ++p) {
        for (const double side : {1.0, -1.0}) {
            // From the particle's place a little inward, so that borders are met too.
            const glm::dvec3 place = 0.999 * to_double(flat.positions[p]);
            const Ray ray{place + glm::dvec3(0, 0, side), {0, 0, -side}};
            const auto hit = pick_cloth(flat.surface, flat.positions, ray);
            ASSERT_TRUE(hit) << p;
            EXPECT_EQ(hit->particle, p);
            EXPECT_NEAR(hit->distance, 1.0, 1e-12);
        }
    }
}

// Rays exactly through edges and corners of triangles: none slips through.
TEST(PickCloth, HasNoGapsBetweenTriangles) {
    const Crumpled flat(9, 9, 0.0);
    for (int i = 1; i < 64; ++i) {
        for (int j = 1; j < 64; ++j) {
            const Ray ray{{-0.5 + i / 64.0, -0.5 + j / 64.0, 2.0}, {0, 0, -1}};
            EXPECT_TRUE(pick_cloth(flat.surface, flat.positions, ray)) << i << " " << j;
        }
    }
}

TEST(PickCloth, NamesParticlesWhereAMeshHasASeam) {
    Surface seam;
    seam.particle_count = 4;
    seam.vertex_particle = {3, 2, 1, 1, 2, 0};
    seam.uvs.resize(6);
    seam.triangles = {{0, 1, 2}, {3, 4, 5}};
    const std::vector<Vec3d> positions{{1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    const auto at = [&](double x, double y) {
        return pick_cloth(seam, positions, {{x, y, 3}, {0, 0, -1}})->particle;
    };
    EXPECT_EQ(at(0.1, 0.1), 3U);
    EXPECT_EQ(at(0.9, 0.9), 0U);
    EXPECT_EQ(at(0.9, 0.05), 1U);
}

TEST(PickCloth, SeesNothingBehindOrOfAParticleThatIsNowhere) {
    Crumpled flat(5, 5, 0.0);
    EXPECT_FALSE(pick_cloth(flat.surface, flat.positions, {{0.1, 0.1, 1}, {0, 0, 1}}));
    for (Vec3d& x : flat.positions) x.y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(pick_cloth(flat.surface, flat.positions, {{0.1, 0.1, 1}, {0, 0, -1}}));
    EXPECT_FALSE(pick_cloth(Surface{}, {}, {{0.1, 0.1, 1}, {0, 0, -1}}));
}

TEST(PickCloth, TakesLessThanThreeMillisecondsOf256By256) {
    const Crumpled cloth(256, 256, 0.01);
    const Ray ray = ray_through(camera_at({0.5F, 1, 2}, {0, 0, 0}), {0.1F, 0.1F}, aspect);
    double best = 1e9;
    for (int n = 0; n < 20; ++n) {
        const auto begin = std::chrono::steady_clock::now();
        EXPECT_TRUE(pick_cloth(cloth.surface, cloth.positions, ray));
        const std::chrono::duration<double, std::milli> taken =
            std::chrono::steady_clock::now() - begin;
        best = std::min(best, taken.count());
    }
    RecordProperty("milliseconds", std::to_string(best));
#ifdef NDEBUG
    if (!test::sanitized) {
        EXPECT_LT(best, 3.0);
    }
#endif
}

TEST(PickParticle, TakesTheOneThePictureShowsNearest) {
    const Camera camera = camera_at({0, 0, 5}, {0, 0, 0});
    const std::vector<Vec3d> positions{{0, 0, 0}, {1, 0, 0}, {1.1, 0, -20}, {0, 0, 9}};
    const std::vector<std::uint32_t> all{0, 1, 2, 3};
    const auto at = [&](float x, float y, float reach) {
        return pick_particle(all, positions, camera, {x, y}, aspect, reach);
    };
    const float half = std::tan(glm::radians(0.5F * 35.0F));
    const float x = 1.0F / (5.0F * half * aspect);  // where particle 1 is
    EXPECT_EQ(at(0.0F, 0.01F, 0.02F), 0U);          // not 3, behind the eye
    EXPECT_EQ(at(x, 0.0F, 0.02F), 1U);
    EXPECT_EQ(at(1.1F / (25.0F * half * aspect), 0.0F, 0.02F), 2U);
    EXPECT_FALSE(at(0.4F * x, 0.5F, 0.02F));
    // The reach is one of the picture's height: sideways it is that many pixels too.
    EXPECT_TRUE(at(x + 0.099F / aspect, 0.0F, 0.1F));
    EXPECT_FALSE(at(x + 0.101F / aspect, 0.0F, 0.1F));
    EXPECT_FALSE(pick_particle({}, positions, camera, {0, 0}, aspect, 1.0F));
}

TEST(PickObstacle, MeetsSpheresWhereTheyBegin) {
    const std::vector<ObstacleDescription> obstacles{{SphereObstacle{{0, 0, -5}, 1.0}},
                                                     {SphereObstacle{{0, 0, -3}, 0.5}},
                                                     {SphereObstacle{{0, 0, 4}, 1.0}}};
    const auto hit = pick_obstacle(obstacles, {{0, 0, 0}, {0, 0, -1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->obstacle, 1U);
    EXPECT_NEAR(hit->distance, 2.5, 1e-12);
    EXPECT_LT(glm::distance(hit->point, glm::dvec3(0, 0, -2.5)), 1e-12);
    const Ray beside{{0.6, 0, 0}, {0, 0, -1}};
    ASSERT_TRUE(pick_obstacle(obstacles, beside));
    EXPECT_EQ(pick_obstacle(obstacles, beside)->obstacle, 0U);
    EXPECT_NEAR(pick_obstacle(obstacles, beside)->distance, 5.0 - 0.8, 1e-12);
    EXPECT_FALSE(pick_obstacle(obstacles, {{1.1, 0, 0}, {0, 0, -1}}));
    EXPECT_FALSE(pick_obstacle(obstacles, {{0, 0, 4}, {0, 0, 1}}));  // from within
}

TEST(PickObstacle, MeetsPlanesFromEitherSide) {
    const std::vector<ObstacleDescription> floor{{PlaneObstacle{{7, 1, 7}, {0, 3, 0}}}};
    EXPECT_NEAR(pick_obstacle(floor, {{0, 3, 0}, {0, -1, 0}})->distance, 2.0, 1e-12);
    EXPECT_NEAR(pick_obstacle(floor, {{0, -1, 0}, {0, 1, 0}})->distance, 2.0, 1e-12);
    EXPECT_FALSE(pick_obstacle(floor, {{0, 3, 0}, {0, 1, 0}}));
    EXPECT_FALSE(pick_obstacle(floor, {{0, 3, 0}, {1, 0, 0}}));
    EXPECT_FALSE(pick_obstacle(floor, {{0, 1, 0}, {1, 0, 0}}));  // within it
}

TEST(DraggedPoint, StaysInThePlaneThatFacesTheCamera) {
    const Camera camera = camera_at({3, 2, 5}, {0, 1, 0});
    const glm::dvec3 taken(0.5, 1.2, 0.3);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.target - camera.eye));
    const glm::vec4 clip = camera.world_to_clip(aspect) * glm::vec4(glm::vec3(taken), 1.0F);
    const glm::vec2 cursor = glm::vec2(clip) / clip.w;
    EXPECT_LT(
        glm::distance(dragged_point(ray_through(camera, cursor, aspect), camera, taken), taken),
        1e-5);
    const glm::vec2 further = cursor + glm::vec2(0.3F, -0.2F);
    const glm::dvec3 moved = dragged_point(ray_through(camera, further, aspect), camera, taken);
    EXPECT_NEAR(glm::dot(moved - taken, forward), 0.0, 1e-6);
    const glm::vec4 there = camera.world_to_clip(aspect) * glm::vec4(glm::vec3(moved), 1.0F);
    EXPECT_LT(glm::distance(glm::vec2(there) / there.w, further), 1e-4F);
}

}  // namespace
}  // namespace weft::viewer
