// How an area is shared between cloths.
#include "viewer/view_area.h"

#include <algorithm>

namespace weft::viewer {

namespace {

constexpr int gap = 3;                // between areas [pixels]
constexpr float usual_aspect = 1.5F;  // of a cloth with its surroundings

/// Part `index` of a length that `count` share: where it begins and how long it is.
struct Part {
    int start, length;
};
Part part_of(int length, int count, int index) {
    const int free = std::max(length - gap * (count - 1), 0);
    const int start = free * index / count, end = free * (index + 1) / count;
    return {start + gap * index, end - start};
}

/// How large a cloth of the usual proportions comes out.
float room_in(int width, int height) {
    return std::min(static_cast<float>(width) / usual_aspect, static_cast<float>(height));
}

int rows_for(const ViewArea& area, std::size_t count) {
    if (count < 2) return 1;
    if (count > 2) return 2;
    return room_in(area.width / 2, area.height) >= room_in(area.width, area.height / 2) ? 1 : 2;
}

}  // namespace

bool ViewArea::contains(glm::vec2 pixel) const {
    return pixel.x >= static_cast<float>(left) && pixel.x < static_cast<float>(left + width) &&
           pixel.y >= static_cast<float>(top) && pixel.y < static_cast<float>(top + height);
}

std::vector<ViewArea> split_area(const ViewArea& area, std::size_t count) {
    std::vector<ViewArea> areas;
    const int rows = rows_for(area, count);
    const int columns = (static_cast<int>(count) + rows - 1) / rows;
    for (int index = 0; index < static_cast<int>(count); ++index) {
        const int row = index / columns;
        const int in_row = std::min(columns, static_cast<int>(count) - row * columns);
        const Part across = part_of(area.width, in_row, index - row * columns);
        const Part down = part_of(area.height, rows, row);
        areas.push_back(
            {area.left + across.start, area.top + down.start, across.length, down.length});
    }
    return areas;
}

std::optional<std::size_t> area_at(std::span<const ViewArea> areas, glm::vec2 pixel) {
    for (std::size_t index = 0; index < areas.size(); ++index)
        if (areas[index].contains(pixel)) return index;
    return std::nullopt;
}

glm::vec2 cursor_in(const ViewArea& area, glm::vec2 pixel) {
    const glm::vec2 corner(area.left, area.top), size(area.width, area.height);
    const glm::vec2 part = (pixel - corner) / size;
    return {2.0F * part.x - 1.0F, 1.0F - 2.0F * part.y};
}

std::optional<glm::vec2> pixel_of(const ViewArea& area, const Camera& camera, glm::vec3 point) {
    if (area.empty()) return std::nullopt;
    const glm::vec4 clip = camera.world_to_clip(area.aspect()) * glm::vec4(point, 1.0F);
    if (clip.w <= 0.0F) return std::nullopt;
    const glm::vec2 cursor(clip.x / clip.w, clip.y / clip.w);
    const glm::vec2 corner(area.left, area.top), size(area.width, area.height);
    return corner + size * glm::vec2(0.5F + 0.5F * cursor.x, 0.5F - 0.5F * cursor.y);
}

}  // namespace weft::viewer
