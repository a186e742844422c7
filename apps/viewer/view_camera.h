// The one camera of all cloths: the scene's own until the mouse moves it.
#pragma once

#include <functional>
#include <optional>

#include "viewer/orbit_camera.h"
#include "viewer/view_area.h"

namespace weft::viewer {

class ViewCamera {
public:
    /// Places the camera for what is shown now. One that nobody moved shows the scene as its
    /// recordings do, whatever the area's proportions; one that was moved stays, unless it shows
    /// another cloth, or was asked for one of the two below.
    /// @param cloth gives the bounds of what is shown now; only asked where it is to be framed.
    void follow(const Stage& stage, const RenderDescription& render, const ViewArea& area,
                const std::function<Box()>& cloth);

    void reset() { orbit_.reset(); }         ///< the scene's own, at the next follow()
    void frame_cloth() { framing_ = true; }  ///< all of the cloth, from the same side
    void keep() { kept_ = true; }            ///< it was moved, and stays

    /// @pre follow() was called.
    [[nodiscard]] OrbitCamera& orbit() { return *orbit_; }
    [[nodiscard]] const Camera& camera() const { return orbit_ ? orbit_->camera() : unplaced_; }

private:
    void begin(const Stage& stage, const RenderDescription& render, const ViewArea& area);

    Camera unplaced_;
    std::optional<OrbitCamera> orbit_;
    Box rest_;  ///< of the cloth it was placed for
    ViewArea area_;
    bool kept_ = false, framing_ = false;
};

/// The camera of a recording, drawn back where the area is narrower than the recording's pictures.
Camera camera_for(const Stage& stage, RenderDescription render, const ViewArea& area);

/// Whether two cloths are so unlike in place or size that a camera for one is none for the other.
bool elsewhere(const Box& one, const Box& other);

}  // namespace weft::viewer
