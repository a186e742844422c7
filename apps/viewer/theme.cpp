#include "viewer/theme.h"

#include <array>
#include <filesystem>

namespace weft::viewer {

namespace {

constexpr float text_height = 15.0F, heading_height = 16.0F;

constexpr std::array<ImWchar, 15> glyphs{0x0020, 0x00FF,  // Latin
                                         0x0100, 0x017F,  // more Latin, for names of scenes
                                         0x0370, 0x03FF,  // Greek
                                         0x0400, 0x04FF,  // Cyrillic
                                         0x2010, 0x2027,  // dashes, quotes, dots
                                         0x2190, 0x21FF,  // arrows
                                         0x2200, 0x22FF,  // mathematics
                                         0};

ImFont* load_font(const char* name, float height) {
    const std::filesystem::path file =
        std::filesystem::path("/usr/share/fonts/truetype/dejavu") / name;
    std::error_code missing;
    if (!std::filesystem::exists(file, missing)) return nullptr;
    return ImGui::GetIO().Fonts->AddFontFromFileTTF(file.c_str(), height, nullptr, glyphs.data());
}

struct StyleColour {
    ImGuiCol which;
    ImU32 colour;
};

// What ImGui's dark style has otherwise.
constexpr std::array style_colours{
    StyleColour{ImGuiCol_Text, colours::text},
    StyleColour{ImGuiCol_TextDisabled, colours::faint},
    StyleColour{ImGuiCol_FrameBg, colours::groove},
    StyleColour{ImGuiCol_FrameBgHovered, colours::groove_hovered},
    StyleColour{ImGuiCol_FrameBgActive, colours::groove_hovered},
    StyleColour{ImGuiCol_CheckMark, colours::accent},
    StyleColour{ImGuiCol_WindowBg, IM_COL32(26, 30, 41, 255)},
    StyleColour{ImGuiCol_PopupBg, IM_COL32(31, 36, 49, 252)},
    StyleColour{ImGuiCol_Border, IM_COL32(52, 60, 79, 255)},
    StyleColour{ImGuiCol_Button, IM_COL32(47, 55, 74, 255)},
    StyleColour{ImGuiCol_ButtonHovered, IM_COL32(62, 72, 97, 255)},
    StyleColour{ImGuiCol_ButtonActive, IM_COL32(78, 92, 124, 255)},
    StyleColour{ImGuiCol_Header, IM_COL32(34, 40, 54, 255)},
    StyleColour{ImGuiCol_HeaderHovered, IM_COL32(45, 53, 72, 255)},
    StyleColour{ImGuiCol_HeaderActive, IM_COL32(55, 64, 87, 255)},
    StyleColour{ImGuiCol_Separator, IM_COL32(52, 60, 79, 255)},
    StyleColour{ImGuiCol_ScrollbarBg, IM_COL32(26, 30, 41, 0)},
    StyleColour{ImGuiCol_ScrollbarGrab, IM_COL32(58, 67, 88, 255)},
    StyleColour{ImGuiCol_ScrollbarGrabHovered, IM_COL32(74, 85, 112, 255)},
    StyleColour{ImGuiCol_ScrollbarGrabActive, IM_COL32(90, 103, 135, 255)},
    StyleColour{ImGuiCol_TextSelectedBg, colours::fill},
    StyleColour{ImGuiCol_ModalWindowDimBg, IM_COL32(10, 12, 18, 130)}};

}  // namespace

ImU32 lane_colour(std::size_t lane) {
    constexpr std::array<ImU32, 4> of_lane{IM_COL32(240, 180, 75, 255), IM_COL32(96, 169, 232, 255),
                                           IM_COL32(126, 201, 143, 255),
                                           IM_COL32(226, 130, 190, 255)};
    return of_lane[lane % of_lane.size()];
}

Fonts apply_theme(float content_scale, float pixels_per_unit) {
    ImGuiIO& io = ImGui::GetIO();
    Fonts fonts;
    fonts.text = load_font("DejaVuSans.ttf", text_height * content_scale);
    if (fonts.text == nullptr) {
        ImFontConfig config;
        config.SizePixels = text_height * content_scale;
        fonts.text = io.Fonts->AddFontDefault(&config);
    }
    fonts.heading = load_font("DejaVuSans-Bold.ttf", heading_height * content_scale);
    if (fonts.heading == nullptr) fonts.heading = fonts.text;
    // Glyphs are made in pixels; the layout is in screen units.
    io.FontGlobalScale = 1.0F / pixels_per_unit;

    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    ImGui::StyleColorsDark(&style);
    for (const StyleColour& row : style_colours) {
        style.Colors[row.which] = ImGui::ColorConvertU32ToFloat4(row.colour);
    }
    style.WindowPadding = {10.0F, 8.0F};
    style.FramePadding = {8.0F, 4.0F};
    style.ItemSpacing = {8.0F, 5.0F};
    style.ItemInnerSpacing = {6.0F, 4.0F};
    style.ScrollbarSize = 11.0F;
    style.WindowBorderSize = 0.0F;
    style.FrameRounding = 4.0F;
    style.PopupRounding = style.WindowRounding = 6.0F;
    style.ScrollbarRounding = style.GrabRounding = 4.0F;
    style.WindowTitleAlign = {0.5F, 0.5F};
    style.ScaleAllSizes(content_scale / pixels_per_unit);
    return fonts;
}

}  // namespace weft::viewer
