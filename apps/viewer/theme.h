// The window's colours, fonts and spacing.
#pragma once

#include <imgui.h>

#include <cstddef>

namespace weft::viewer {

/// Those that ImGui's own style has no name for.
namespace colours {
inline constexpr ImU32 text = IM_COL32(229, 231, 236, 255);
inline constexpr ImU32 faint = IM_COL32(148, 156, 173, 255);
inline constexpr ImU32 accent = IM_COL32(240, 180, 75, 255);
inline constexpr ImU32 trouble = IM_COL32(255, 116, 97, 255);
inline constexpr ImU32 good = IM_COL32(126, 201, 143, 255);
inline constexpr ImU32 groove = IM_COL32(40, 47, 63, 255);  ///< of sliders and plots
inline constexpr ImU32 groove_hovered = IM_COL32(49, 57, 76, 255);
inline constexpr ImU32 fill = IM_COL32(62, 91, 138, 255);  ///< of sliders
inline constexpr ImU32 fill_active = IM_COL32(78, 113, 170, 255);
inline constexpr ImU32 forbidden = IM_COL32(122, 45, 42, 255);  ///< beyond the stable step
inline constexpr ImU32 lines = IM_COL32(66, 74, 94, 255);       ///< axes
}  // namespace colours

/// Of a lane, and of its lines in the plots.
ImU32 lane_colour(std::size_t lane);

struct Fonts {
    ImFont* text = nullptr;
    ImFont* heading = nullptr;
};

/// Sets ImGui's style and loads the fonts: DejaVu Sans, or what ImGui brings where that is missing.
/// @param content_scale of the display.  @param pixels_per_unit of the framebuffer.
Fonts apply_theme(float content_scale, float pixels_per_unit);

/// The height of text, the unit of the whole layout [screen units].
inline float em() {
    return ImGui::GetFontSize();
}

}  // namespace weft::viewer
