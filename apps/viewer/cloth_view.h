// The part of the window that shows cloths, up to four side by side, and lets a mouse touch them.
#pragma once

#include <memory>
#include <string>

#include "viewer/cloth_touch.h"
#include "viewer/shown_cloth.h"
#include "viewer/view_area.h"
#include "viewer/window_settings.h"

namespace weft::viewer {

/// Lives while its window's OpenGL context is current. All cloths share one camera.
class ClothView {
public:
    explicit ClothView(TouchRequests requests);
    ~ClothView();

    /// Draws into the window's framebuffer, which must not be multisampled, and, over it, labels in
    /// ImGui's background list; obeys the mouse where ImGui does not want it. Once a frame, between
    /// ImGui::NewFrame and Render; requests are called from within it.
    /// @param framebuffer_height of the whole window [pixels].  @param scale pixels a screen unit.
    void show(const Shown& shown, const WindowSettings& layers, const RenderDescription& render,
              const ViewArea& area, int framebuffer_height, float scale);

    void frame_cloth();     ///< shows all of it, from the same side
    void reset_camera();    ///< the scene's own again: another scene was opened
    void cancel_gesture();  ///< lets go; what was dragged goes back
    [[nodiscard]] bool in_gesture() const;
    [[nodiscard]] const Camera& camera() const;
    /// Fewer samples and no shadow while the window is slow; chosen by itself.
    [[nodiscard]] std::string quality() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace weft::viewer
