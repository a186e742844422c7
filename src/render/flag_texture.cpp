// The flag of weft: an indigo field, a coral triangle from the fly edged in cream, and a knot of
// ribbons woven over and under. Lengths are in units of the flag's height; x runs to the fly.
#include <cmath>
#include <glm/glm.hpp>

#include "render/built_in_textures.h"
#include "render/painting.h"

namespace weft {

namespace {

constexpr int height = 1024, width = 1536;
constexpr float pixel = 1.0F / static_cast<float>(height);
constexpr float fly = 1.5F;  // x of the fly edge

constexpr Paint indigo{35, 47, 112}, coral{226, 78, 58}, cream{250, 240, 220}, gold{246, 184, 60},
    canvas{238, 232, 219}, brass{176, 137, 66}, thread{20, 24, 40};

/// Signed distance to a segment with round ends; the segment runs along the first axis.
float ribbon_distance(glm::vec2 point, float half_length, float half_width) {
    const float beyond = std::max(std::abs(point.x) - half_length, 0.0F);
    return std::hypot(beyond, point.y) - half_width;
}

/// Signed distance to the three ribbons that run along the first axis.
float ribbons_distance(glm::vec2 point, float spacing, float half_length, float half_width) {
    const float nearest = std::clamp(std::round(point.y / spacing), -1.0F, 1.0F);
    return ribbon_distance({point.x, point.y - nearest * spacing}, half_length, half_width);
}

/// Paints the knot over `below`. Where two ribbons cross, the parity of the crossing says which
/// one is above; it is set off by a rim in the colour of the field.
Paint paint_knot(Paint below, glm::vec2 point) {
    constexpr float spacing = 0.132F, half_length = 0.215F, half_width = 0.043F, rim = 0.014F;
    constexpr float diagonal = 0.70710678F;
    const glm::vec2 turned = diagonal * glm::vec2(point.x + point.y, point.y - point.x);
    const int crossing =
        static_cast<int>(std::round(turned.x / spacing) + std::round(turned.y / spacing));
    const float gold_distance = ribbons_distance(turned, spacing, half_length, half_width);
    const float cream_distance =
        ribbons_distance({turned.y, turned.x}, spacing, half_length, half_width);
    const bool gold_above = crossing % 2 == 0;
    const float lower = gold_above ? cream_distance : gold_distance;
    const float upper = gold_above ? gold_distance : cream_distance;
    Paint paint = glm::mix(below, gold_above ? cream : gold, coverage(lower, pixel));
    paint = glm::mix(paint, indigo, coverage(upper - rim, pixel));
    return glm::mix(paint, gold_above ? gold : cream, coverage(upper, pixel));
}

/// Signed distance to the triangle that opens toward the fly from `apex` on the middle line.
float fly_triangle_distance(glm::vec2 point, float apex) {
    const glm::vec2 edge = glm::normalize(glm::vec2(fly - apex, 0.5F));
    const glm::vec2 from_apex{point.x - apex, std::abs(point.y - 0.5F)};
    return from_apex.y * edge.x - from_apex.x * edge.y;
}

/// The band of canvas at the hoist, its two eyelets, and the stitched hem on the other sides.
Paint paint_finish(Paint paint, glm::vec2 point) {
    constexpr float band = 0.046F, hem = 0.020F;
    const float to_hem = std::min({fly - point.x, point.y, 1.0F - point.y}) - hem;
    if (to_hem < 0.0F) paint *= 0.93F;
    const float stitches = std::abs(to_hem + 0.3F * hem) - 0.0012F;
    const float along = (point.x + point.y) * 90.0F;
    if (along - std::floor(along) < 0.6F) {
        paint = glm::mix(paint, 0.8F * paint + 0.2F * thread, coverage(stitches, pixel));
    }
    paint = glm::mix(paint, canvas, coverage(point.x - band, pixel));
    paint = glm::mix(paint, 0.8F * canvas, coverage(std::abs(point.x - band) - 0.0015F, pixel));
    for (const float y : {0.055F, 0.945F}) {
        const float radius = glm::distance(point, glm::vec2(0.5F * band, y));
        paint = glm::mix(paint, brass, coverage(radius - 0.016F, pixel));
        paint = glm::mix(paint, thread, coverage(radius - 0.008F, pixel));
    }
    return paint;
}

}  // namespace

Image paint_flag() {
    return paint_image(width, height, [](float x, float y) {
        const glm::vec2 point = glm::vec2(x, y) * pixel;
        Paint paint = indigo;
        const float to_triangle = fly_triangle_distance(point, 0.94F);
        paint = glm::mix(paint, cream, coverage(to_triangle - 0.055F, pixel));
        paint = glm::mix(paint, coral, coverage(to_triangle, pixel));
        paint = paint_knot(paint, point - glm::vec2(0.47F, 0.5F));
        return paint_finish(paint, point);
    });
}

}  // namespace weft
