// The colours of springs. They are told apart by people who see no red or no green too: the scale
// of strains runs through lightness with blue against red, and kinds differ in lightness as well.
#include <algorithm>
#include <cmath>

#include "render/overlay_shapes.h"

namespace weft {

namespace {

using Colour = std::array<std::uint8_t, 4>;

// From rest to the end of the range, in equal parts.
constexpr std::array<Colour, 4> compressed{
    {{255, 255, 255, 255}, {146, 197, 240, 255}, {48, 126, 205, 255}, {8, 48, 130, 255}}};
constexpr std::array<Colour, 4> stretched{
    {{255, 255, 255, 255}, {250, 170, 132, 255}, {220, 70, 52, 255}, {120, 0, 28, 255}}};

constexpr std::array<Colour, 3> kinds{
    {{213, 94, 0, 255}, {70, 170, 240, 255}, {247, 226, 84, 255}}};

}  // namespace

Colour colour_of_strain(float strain, float strain_range) {
    const float share = std::abs(strain) / strain_range;
    // What is no number is shown as the worst.
    const float place = share < 1.0F ? 3.0F * share : 3.0F;
    const auto& scale = strain < 0.0F ? compressed : stretched;
    const auto from = std::min<std::size_t>(static_cast<std::size_t>(place), 2);
    const float along = place - static_cast<float>(from);
    Colour result{};
    for (std::size_t channel = 0; channel < 4; ++channel) {
        const auto low = static_cast<float>(scale[from][channel]),
                   high = static_cast<float>(scale[from + 1][channel]);
        result[channel] = static_cast<std::uint8_t>(low + (high - low) * along + 0.5F);
    }
    return result;
}

Colour colour_of_kind(std::uint8_t kind) {
    return kinds[std::min<std::size_t>(kind, kinds.size() - 1)];
}

}  // namespace weft
