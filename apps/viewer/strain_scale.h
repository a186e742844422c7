// The strain at which springs are drawn in full colour: a round number that suits what is shown.
#pragma once

#include <span>
#include <string>

#include "render/overlay_shapes.h"

namespace weft::viewer {

/// The strain that only one spring in fifty exceeds, of at most some thousands looked at.
float usual_strain(std::span<const DrawnSpring> springs, const Frame& frame);

/// 0.005, 0.01, 0.02, 0.05, ... 1: the least that is not below `strain`.
float round_strain(float strain);

/// Follows a strain without jumping to and fro: up at once, down only when it is two steps lower.
class StrainScale {
public:
    void follow(float strain);
    [[nodiscard]] float range() const { return range_; }

private:
    float range_ = 0.005F;
};

/// "5 %", "0.5 %".
std::string percent_text(float strain);

}  // namespace weft::viewer
