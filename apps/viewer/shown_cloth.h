// What a window is given to show, for one of its frames.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viewer/flight.h"

namespace weft::viewer {

/// One cloth as it is to be shown; valid for one frame of the window.
struct ShownCloth {
    std::shared_ptr<const ClothShape> shape;
    Frame frame;
    std::vector<std::string> label;  ///< lines at the top of its place
    std::string note;                ///< in red: that it diverged
};

struct Shown {
    std::vector<ShownCloth> cloths;
    std::vector<ObstacleDescription> obstacles;
    Vec3d wind{};           ///< [m/s]
    Vec3d grip_force{};     ///< of the cloth that is held [N]
    bool touchable = true;  ///< false for a recording: the mouse only moves the camera
    bool paused = false;    ///< nothing moves by itself: there is time for a better picture
};

}  // namespace weft::viewer
