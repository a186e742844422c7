// What presses, drags and the wheel do.
#include "viewer/cloth_touch.h"

#include <algorithm>
#include <variant>

namespace weft::viewer {

namespace {

constexpr float pin_reach = 9.0F;      // [screen units]
constexpr double patch_radius = 0.04;  // of the cloth's size

Vec3d to_vec3d(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}

/// Whether what was found in an earlier frame can still be there.
bool fits(const Shown& shown, const TouchTarget& target) {
    if (target.cloth >= shown.cloths.size()) return false;
    if (target.kind == PointerTarget::obstacle) return target.obstacle < shown.obstacles.size();
    return target.kind == PointerTarget::nothing ||
           target.particle < shown.cloths[target.cloth].frame.positions.size();
}

}  // namespace

void ClothTouch::update(const Pointer& pointer, const Shown& shown, std::span<const ViewArea> areas,
                        OrbitCamera& camera) {
    if (gesture() != Gesture::none && !still_there(shown)) cancel();
    if (gesture() != Gesture::none) go_on(pointer, shown, areas, camera);
    const std::size_t cloth = area_at(areas, pointer.pixel).value_or(areas.size());
    if (!pointer.free || cloth >= areas.size()) {
        if (gesture() == Gesture::none) target_ = {};
        return;
    }
    const CursorPlace place(cloth, areas[cloth], pointer.pixel);
    if (pointer.wheel != 0.0F) {
        camera.zoom(pointer.wheel, place.cursor, place.area.aspect());
        moved_camera_ = true;
    }
    if (gesture() != Gesture::none) return;
    look(pointer, shown, place, camera.camera());
    for (std::size_t button = 0; button < pointer.buttons.size(); ++button) {
        if (!pointer.buttons[button].pressed) continue;
        target_.cloth = place.cloth;
        begin(pointer, button, shown.cloths[place.cloth]);
        // Pressed and released between two frames: a click.
        if (!pointer.buttons[button].down) go_on(pointer, shown, areas, camera);
        return;
    }
}

/// Looking through a fine cloth takes milliseconds: not at every frame while the pointer rests.
void ClothTouch::look(const Pointer& pointer, const Shown& shown, const CursorPlace& place,
                      const Camera& camera) {
    constexpr double often_enough = 0.1;  // [s]
    const bool pressed = std::any_of(pointer.buttons.begin(), pointer.buttons.end(),
                                     [](const Pointer::Button& button) { return button.pressed; });
    const bool stale = pointer.pixel != looked_at_ || pointer.wheel != 0.0F ||
                       pointer.time - looked_time_ >= often_enough || !fits(shown, target_);
    if (!pressed && !stale) return;
    target_ = target_at(shown, place, camera, pin_reach * pointer.scale);
    looked_at_ = pointer.pixel;
    looked_time_ = pointer.time;
}

void ClothTouch::begin(const Pointer& pointer, std::size_t button, const ShownCloth& cloth) {
    gesture_.press(static_cast<MouseButton>(button), target_.kind, pointer.pixel / pointer.scale,
                   pointer.time);
    button_ = button;
    particles_ = cloth.frame.positions.size();
    shifted_ = glm::dvec3(0.0);
    if (gesture() == Gesture::grab_cloth)
        patch_.emplace(cloth.frame.positions, target_.particle, to_vec3d(target_.point),
                       patch_radius * cloth.shape->stage.size, cloth.shape->mass);
}

void ClothTouch::go_on(const Pointer& pointer, const Shown& shown, std::span<const ViewArea> areas,
                       OrbitCamera& camera) {
    const CursorPlace place(target_.cloth, areas[target_.cloth], pointer.pixel);
    const glm::vec2 moved = gesture_.move(pointer.pixel / pointer.scale) * pointer.scale;
    drag(place, shown, moved, pointer.time, camera);
    const Pointer::Button& button = pointer.buttons[button_];
    if (!button.released && button.down) return;
    const bool click = gesture_.release(static_cast<MouseButton>(button_),
                                        pointer.pixel / pointer.scale, pointer.time);
    end(click, shown);
}

void ClothTouch::drag(const CursorPlace& place, const Shown& shown, glm::vec2 moved, double time,
                      OrbitCamera& camera) {
    const auto height = static_cast<float>(place.area.height);
    switch (gesture()) {
        case Gesture::orbit:
            camera.orbit(moved, height);
            break;
        case Gesture::pan:
            camera.pan(moved, height);
            break;
        case Gesture::none:
            return;
        default:
            // A click pins, and must not pull.
            if (gesture_.is_drag(time))
                drag_thing(place.ray(camera.camera()), shown, camera.camera());
            return;
    }
    moved_camera_ = moved_camera_ || moved != glm::vec2(0.0F);
}

void ClothTouch::drag_thing(const Ray& ray, const Shown& shown, const Camera& camera) {
    glm::dvec3 to = dragged_point(ray, camera, target_.point);
    if (gesture() == Gesture::grab_cloth) {
        if (hold_ && hold_->hand == to) return;
        hold_ = Hold{target_.cloth, target_.particle, to};
        requests_.grip(target_.cloth, patch_->grips(to_vec3d(to)));
        return;
    }
    if (gesture() == Gesture::move_obstacle) {
        const auto& shape = shown.obstacles[target_.obstacle].shape;
        if (const auto* plane = std::get_if<PlaneObstacle>(&shape))
            to = nearest_on_line(ray, target_.point,
                                 glm::dvec3(glm::normalize(to_glm(plane->normal))));
    }
    shift_thing(to - target_.point - shifted_);
}

void ClothTouch::shift_thing(glm::dvec3 shift) {
    if (shift == glm::dvec3(0.0)) return;
    shifted_ += shift;
    if (gesture() == Gesture::drag_pin) requests_.move_pin(target_.particle, to_vec3d(shift));
    if (gesture() == Gesture::move_obstacle)
        requests_.move_obstacle(target_.obstacle, to_vec3d(shift));
}

void ClothTouch::end(bool click, const Shown& shown) {
    const TouchTarget target = target_;
    let_go();
    if (click) {
        const Vec3d position = shown.cloths[target.cloth].frame.positions[target.particle];
        requests_.toggle_pin(target.particle, position);
    }
    requests_.gesture_ended();
}

void ClothTouch::let_go() {
    if (hold_) requests_.grip(hold_->cloth, {});
    hold_.reset();
    patch_.reset();
    target_ = {};
    looked_time_ = -1.0;
}

void ClothTouch::cancel() {
    if (gesture() == Gesture::none) return;
    shift_thing(-shifted_);
    gesture_.cancel();
    let_go();
    requests_.gesture_ended();
}

bool ClothTouch::still_there(const Shown& shown) const {
    return fits(shown, target_) && shown.cloths[target_.cloth].frame.positions.size() == particles_;
}

}  // namespace weft::viewer
