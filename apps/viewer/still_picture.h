// When nothing moves there is time for the best picture, once; it is then kept until something
// does.
#pragma once

#include <cstdint>

#include "render/camera.h"
#include "viewer/shown_cloth.h"
#include "viewer/view_area.h"
#include "viewer/window_settings.h"

namespace weft::viewer {

/// Equal as long as a picture would come out the same.
std::uint64_t picture_key(const Shown& shown, const WindowSettings& settings, const Camera& camera,
                          const ViewArea& area);

class StillPicture {
public:
    enum class Wanted { quick, best, kept };
    /// What to draw now: a quick picture, the best one, which is then kept, or the kept one again.
    /// @param time rising [s].
    Wanted next(std::uint64_t key, double time);
    /// For what moves, there is no key.
    void moved() { known_ = kept_ = false; }

private:
    std::uint64_t key_ = 0;
    double since_ = 0.0;  ///< the key is the same [s]
    bool known_ = false, kept_ = false;
};

}  // namespace weft::viewer
