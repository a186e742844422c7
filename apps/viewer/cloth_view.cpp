// One frame of the view: mouse, then cloths, then what is written over them.
#include "viewer/cloth_view.h"

#include <imgui.h>

#include <algorithm>

#include "viewer/cloth_labels.h"
#include "viewer/cloth_layers.h"
#include "viewer/cloth_marks.h"
#include "viewer/cloth_picture.h"
#include "viewer/draw_effort.h"
#include "viewer/draw_quality.h"
#include "viewer/frame_times.h"
#include "viewer/still_picture.h"
#include "viewer/strain_scale.h"
#include "viewer/view_camera.h"
#include "viewer/view_framebuffer.h"

namespace weft::viewer {

namespace {

constexpr float usual_font = 15.0F;  // of a display whose marks are one unit large
constexpr int frames_a_sample = 8;   // of the cost of drawing, while there is time enough
constexpr std::array<float, 3> gap_colour{0.07F, 0.08F, 0.10F};

double seconds_since(Clock::time_point start) {
    return seconds_between(start, Clock::now());
}

Pointer pointer_of(const ImGuiIO& io, float scale, double time) {
    Pointer pointer;
    pointer.pixel = scale * glm::vec2(io.MousePos.x, io.MousePos.y);
    // In the order of MouseButton; ImGui counts left, right, middle.
    constexpr std::array<int, 3> imgui_buttons{0, 2, 1};
    for (std::size_t n = 0; n < imgui_buttons.size(); ++n) {
        const int button = imgui_buttons[n];
        pointer.buttons[n] = {ImGui::IsMouseClicked(button), ImGui::IsMouseReleased(button),
                              ImGui::IsMouseDown(button)};
    }
    pointer.free = !io.WantCaptureMouse;
    pointer.wheel = io.MouseWheel;
    pointer.time = time;
    pointer.scale = scale * ImGui::GetFontSize() / usual_font;
    return pointer;
}

Box bounds_of(const Shown& shown) {
    Box box;
    bool empty = true;
    for (const ShownCloth& cloth : shown.cloths) {
        for (const Vec3d& position : cloth.frame.positions) {
            if (!is_finite(position)) continue;
            const glm::vec3 point = to_glm(position);
            box = empty ? Box{point, point} : box.grown_to(point);
            empty = false;
        }
    }
    return box;
}

}  // namespace

/// What of show()'s arguments its parts share.
struct ShownFrame {
    const Shown& shown;
    const WindowSettings& settings;
    const RenderDescription& render;
    ViewArea area;
    std::vector<ViewArea> places;  ///< [cloth]
    int window_height;
};

struct ClothView::Parts {
    explicit Parts(TouchRequests requests)
        : touch(std::move(requests)),
          samples(ViewFramebuffer::offered_samples()),
          driver(reinterpret_cast<const char*>(glGetString(GL_RENDERER))),
          window_has_depth(ViewFramebuffer::window_has_depth()) {
        choose_efforts(false);
    }

    ClothTouch touch;
    ViewCamera camera;
    ViewFramebuffer framebuffer;
    std::vector<ClothPicture> pictures;
    ClothLayers layers;
    StrainScale strain;
    std::vector<int> samples;
    std::string driver;
    bool window_has_depth;
    bool fine = false;
    std::vector<DrawEffort> efforts;
    DrawQuality quality{1};
    StillPicture still;
    bool best = false;  ///< for the picture that is being drawn
    int frames_to_sample = 0;
    const Clock::time_point start = Clock::now();

    void choose_efforts(bool for_fine);
    [[nodiscard]] const DrawEffort& effort() const {
        return best ? efforts.front() : efforts[quality.level()];
    }
    /// Straight into the window, where the picture need not be kept.
    [[nodiscard]] bool draws_at_once() const {
        return window_has_depth && !best && effort().samples == 1;
    }
    void obey_mouse(const ShownFrame& frame, const Pointer& pointer);
    void draw(const ShownFrame& frame, float scale);
    void draw_cloth(const ShownFrame& frame, std::size_t index, float scale);
    void draw_sampled(const ShownFrame& frame, float scale);
    void draw_wanted(const ShownFrame& frame, float scale);
    void write_over(const ShownFrame& frame, const Canvas& canvas);
};

void ClothView::Parts::choose_efforts(bool for_fine) {
    fine = for_fine;
    efforts = draw_efforts(samples, fine);
    quality = DrawQuality(efforts.size(), first_level(efforts, driver));
}

void ClothView::Parts::obey_mouse(const ShownFrame& frame, const Pointer& pointer) {
    camera.follow(frame.shown.cloths.front().shape->stage, frame.render, frame.places.front(),
                  [&frame] { return bounds_of(frame.shown); });
    touch.update(pointer, frame.shown, frame.places, camera.orbit());
    if (touch.moved_camera()) camera.keep();
    touch.forget_camera_moves();
    if (pointer.free || touch.gesture() != Gesture::none)
        ImGui::SetMouseCursor(cursor_of(touch.target()));
}

void ClothView::Parts::draw_cloth(const ShownFrame& frame, std::size_t index, float scale) {
    const ShownCloth& cloth = frame.shown.cloths[index];
    const ViewArea& place = frame.places[index];
    const int left = draws_at_once() ? 0 : frame.area.left;
    const int height = draws_at_once() ? frame.window_height : frame.area.top + frame.area.height;
    const DrawTarget target{draws_at_once() ? 0 : framebuffer.name(), place.width, place.height,
                            place.left - left, height - place.top - place.height};
    ClothPicture& picture = pictures[index];
    picture.take(cloth.shape, frame.render, frame.shown.obstacles);
    picture.draw(cloth.frame, camera.camera(), target, effort().options);
    layers.draw(layers_of(frame.settings, cloth, frame.shown), cloth, frame.shown, strain.range(),
                scale, camera.camera(), target);
}

void ClothView::Parts::draw(const ShownFrame& frame, float scale) {
    if (frame.settings.springs == 1) {
        float greatest = 0.0F;
        for (const ShownCloth& cloth : frame.shown.cloths)
            greatest = std::max(greatest, usual_strain(cloth.shape->springs, cloth.frame));
        strain.follow(greatest);
    }
    pictures.resize(frame.shown.cloths.size());
    glDisable(GL_SCISSOR_TEST);
    if (draws_at_once()) {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    } else {
        framebuffer.prepare(frame.area.width, frame.area.height, effort().samples);
    }
    if (frame.places.size() > 1) {  // what stays between them
        glClearColor(gap_colour[0], gap_colour[1], gap_colour[2], 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    for (std::size_t n = 0; n < frame.places.size(); ++n) draw_cloth(frame, n, scale);
    if (!draws_at_once()) framebuffer.show(frame.area, frame.window_height);
}

/// While all rests: once as well as it can be, and that again.
void ClothView::Parts::draw_wanted(const ShownFrame& frame, float scale) {
    const bool now_fine = is_fine(frame.shown.cloths.front().shape->surface);
    if (now_fine != fine) choose_efforts(now_fine);
    auto wanted = StillPicture::Wanted::quick;
    if (frame.shown.paused)
        wanted = still.next(picture_key(frame.shown, frame.settings, camera.camera(), frame.area),
                            seconds_since(start));
    else
        still.moved();
    if (wanted == StillPicture::Wanted::kept)
        return framebuffer.show(frame.area, frame.window_height);
    if (wanted == StillPicture::Wanted::quick) return draw_sampled(frame, scale);
    best = true;
    draw(frame, scale);
    best = false;
}

/// Now and then waits for the drawing to be finished, to learn what it takes; at every frame while
/// that is so much that the waiting does not matter.
void ClothView::Parts::draw_sampled(const ShownFrame& frame, float scale) {
    const bool sampled = quality.pressed() || --frames_to_sample <= 0;
    if (sampled) glFinish();
    const Clock::time_point begin = Clock::now();
    draw(frame, scale);
    if (sampled) {
        glFinish();
        quality.add(seconds_since(start), 1000.0 * seconds_since(begin));
        frames_to_sample = frames_a_sample;
    }
}

void ClothView::Parts::write_over(const ShownFrame& frame, const Canvas& canvas) {
    for (std::size_t n = 0; n < frame.places.size(); ++n) {
        const ShownCloth& cloth = frame.shown.cloths[n];
        const std::string& trouble = pictures[n].trouble();
        const std::string note = cloth.note.empty() || trouble.empty()
                                     ? cloth.note + trouble
                                     : cloth.note + "\n" + trouble;
        draw_label(canvas, frame.places[n], cloth.label, note);
    }
    if (frame.settings.springs == 1) draw_strain_legend(canvas, frame.area, strain.range());
    if (frame.settings.springs == 2) draw_kind_legend(canvas, frame.area);
    if (const auto& hold = touch.hold()) {
        const Vec3d held = frame.shown.cloths[hold->cloth].frame.positions[hold->particle];
        draw_hold(canvas, frame.places[hold->cloth], camera.camera(), to_glm(held),
                  glm::vec3(hold->hand), length(frame.shown.grip_force));
    } else if (touch.gesture() != Gesture::orbit && touch.gesture() != Gesture::pan &&
               touch.target().kind != PointerTarget::nothing) {
        draw_target(canvas, frame.places[touch.target().cloth], camera.camera(), frame.shown,
                    touch.target());
    }
}

ClothView::ClothView(TouchRequests requests)
    : parts_(std::make_unique<Parts>(std::move(requests))) {}

ClothView::~ClothView() = default;

void ClothView::show(const Shown& shown, const WindowSettings& layers,
                     const RenderDescription& render, const ViewArea& area, int framebuffer_height,
                     float scale) {
    const ShownFrame frame{
        shown, layers, render, area, split_area(area, shown.cloths.size()), framebuffer_height};
    const auto& places = frame.places;
    if (places.empty() ||
        std::any_of(places.begin(), places.end(), [](const ViewArea& a) { return a.empty(); }))
        return;
    const Pointer pointer = pointer_of(ImGui::GetIO(), scale, seconds_since(parts_->start));
    parts_->obey_mouse(frame, pointer);
    parts_->draw_wanted(frame, pointer.scale);
    const Canvas canvas{ImGui::GetBackgroundDrawList(), scale, pointer.scale};
    const ImVec2 low = canvas.at({area.left, area.top});
    const ImVec2 high = canvas.at({area.left + area.width, area.top + area.height});
    canvas.list->PushClipRect(low, high, true);
    parts_->write_over(frame, canvas);
    canvas.list->PopClipRect();
}

void ClothView::frame_cloth() {
    parts_->camera.frame_cloth();
}
void ClothView::reset_camera() {
    parts_->camera.reset();
}
void ClothView::cancel_gesture() {
    parts_->touch.cancel();
}
bool ClothView::in_gesture() const {
    return parts_->touch.gesture() != Gesture::none;
}
const Camera& ClothView::camera() const {
    return parts_->camera.camera();
}
std::string ClothView::quality() const {
    return describe(parts_->effort());
}

}  // namespace weft::viewer
