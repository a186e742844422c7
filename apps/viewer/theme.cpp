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

ImVec4 colour(ImU32 packed) {
    return ImGui::ColorConvertU32ToFloat4(packed);
}

void set_colours(ImGuiStyle& style) {
    const auto set = [&style](ImGuiCol which, int red, int green, int blue, int opacity = 255) {
        style.Colors[which] = colour(IM_COL32(red, green, blue, opacity));
    };
    ImGui::StyleColorsDark(&style);
    style.Colors[ImGuiCol_Text] = colour(colours::text);
    style.Colors[ImGuiCol_TextDisabled] = colour(colours::faint);
    style.Colors[ImGuiCol_FrameBg] = colour(colours::groove);
    style.Colors[ImGuiCol_FrameBgHovered] = colour(colours::groove_hovered);
    style.Colors[ImGuiCol_FrameBgActive] = colour(colours::groove_hovered);
    style.Colors[ImGuiCol_CheckMark] = colour(colours::accent);
    set(ImGuiCol_WindowBg, 26, 30, 41);
    set(ImGuiCol_PopupBg, 31, 36, 49, 252);
    set(ImGuiCol_Border, 52, 60, 79);
    set(ImGuiCol_Button, 47, 55, 74);
    set(ImGuiCol_ButtonHovered, 62, 72, 97);
    set(ImGuiCol_ButtonActive, 78, 92, 124);
    set(ImGuiCol_Header, 34, 40, 54);
    set(ImGuiCol_HeaderHovered, 45, 53, 72);
    set(ImGuiCol_HeaderActive, 55, 64, 87);
    set(ImGuiCol_Separator, 52, 60, 79);
    set(ImGuiCol_ScrollbarBg, 26, 30, 41, 0);
    set(ImGuiCol_ScrollbarGrab, 58, 67, 88);
    set(ImGuiCol_ScrollbarGrabHovered, 74, 85, 112);
    set(ImGuiCol_ScrollbarGrabActive, 90, 103, 135);
    set(ImGuiCol_TextSelectedBg, 62, 91, 138);
    set(ImGuiCol_ModalWindowDimBg, 10, 12, 18, 130);
}

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
    set_colours(style);
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
