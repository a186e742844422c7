// When a scene's forces change abruptly: the order of a method is lost there.
#pragma once

#include <vector>

#include "weft/scene.h"

namespace weft::lab {

/// Times strictly between `from` and `to` at which a pin comes to a keyframe or the wind to a new
/// draw of its gust: a second derivative jumps. Rising, each once [s].
std::vector<double> kinks_between(const SceneDescription& scene, double from, double to);

/// A stretch of time.
struct Stretch {
    double begin = 0.0, end = 0.0;  ///< [s]
    [[nodiscard]] double length() const { return end - begin; }
};

/// The stretch free of kinks that begins at `from` or soonest after it and is `length` long; where
/// kinks are closer together than that, the longest of the next hundred gaps. It keeps a twentieth
/// of the gap away from both kinks.
Stretch smooth_stretch(const SceneDescription& scene, double from, double length);

}  // namespace weft::lab
