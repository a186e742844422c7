// Telling whether anything that is drawn has changed.
#include "viewer/still_picture.h"

#include <functional>
#include <string_view>
#include <type_traits>
#include <variant>

namespace weft::viewer {

namespace {

class KeyMaker {
public:
    template <typename Value>
    void add(const Value& value) {
        static_assert(std::has_unique_object_representations_v<Value> ||
                      std::is_floating_point_v<Value>);
        add_bytes(&value, sizeof(value));
    }
    void add(glm::vec3 v) { add_bytes(&v, sizeof(v)); }
    void add(const Vec3d& v) { add_bytes(&v, sizeof(v)); }
    void add_bytes(const void* bytes, std::size_t size) {
        const std::string_view text(static_cast<const char*>(bytes), size);
        key_ = (key_ ^ std::hash<std::string_view>{}(text)) * 0x9e3779b97f4a7c15U;
        key_ ^= key_ >> 29U;
    }
    [[nodiscard]] std::uint64_t key() const { return key_; }

private:
    std::uint64_t key_ = 0;
};

void add_obstacle(KeyMaker& maker, const ObstacleDescription& obstacle) {
    if (const auto* sphere = std::get_if<SphereObstacle>(&obstacle.shape)) {
        maker.add(sphere->centre);
        maker.add(sphere->radius);
    } else {
        const auto& plane = std::get<PlaneObstacle>(obstacle.shape);
        maker.add(plane.point);
        maker.add(plane.normal);
    }
}

}  // namespace

std::uint64_t picture_key(const Shown& shown, const WindowSettings& settings, const Camera& camera,
                          const ViewArea& area) {
    KeyMaker maker;
    for (const ShownCloth& cloth : shown.cloths) {
        maker.add(cloth.shape.get());
        maker.add_bytes(cloth.frame.positions.data(), cloth.frame.positions.size_bytes());
    }
    for (const ObstacleDescription& obstacle : shown.obstacles) add_obstacle(maker, obstacle);
    maker.add(shown.wind);
    for (const bool layer : {settings.wireframe, settings.particles, settings.normals,
                             settings.wind_arrows, settings.pins})
        maker.add(layer);
    maker.add(settings.springs);
    maker.add(camera.eye);
    maker.add(camera.target);
    for (const int number : {area.left, area.top, area.width, area.height}) maker.add(number);
    return maker.key();
}

StillPicture::Wanted StillPicture::next(std::uint64_t key, double time) {
    constexpr double at_rest = 0.3;  // [s]
    if (!known_ || key != key_) {
        key_ = key;
        since_ = time;
        known_ = true;
        kept_ = false;
        return Wanted::quick;
    }
    if (kept_) return Wanted::kept;
    if (time - since_ < at_rest) return Wanted::quick;
    kept_ = true;
    return Wanted::best;
}

}  // namespace weft::viewer
