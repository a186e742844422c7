// Plates of text, drawn by ImGui under its panels.
#include "viewer/cloth_labels.h"

#include <algorithm>
#include <array>
#include <cfloat>

#include "render/overlay_shapes.h"
#include "viewer/label_text.h"
#include "viewer/strain_scale.h"

namespace weft::viewer {

namespace {

constexpr ImU32 plate_colour = IM_COL32(18, 22, 30, 178);
constexpr ImU32 title_colour = IM_COL32(255, 255, 255, 255);
constexpr ImU32 text_colour = IM_COL32(214, 221, 230, 255);
constexpr ImU32 note_colour = IM_COL32(255, 128, 116, 255);

constexpr float margin = 8.0F, padding = 7.0F, rounding = 5.0F;  // [marks], see Canvas

ImU32 packed(std::array<std::uint8_t, 4> colour) {
    return IM_COL32(colour[0], colour[1], colour[2], colour[3]);
}

struct TextLine {
    const std::string* text;
    ImU32 colour;
    ImVec2 size;
};

std::vector<TextLine> lay_out(const std::vector<std::string>& lines, const std::string& note,
                              float wrap) {
    std::vector<TextLine> laid;
    const auto add = [&](const std::string& text, ImU32 colour) {
        const ImVec2 size = ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, wrap,
                                                            text.data(), text.data() + text.size());
        laid.push_back({&text, colour, size});
    };
    for (const std::string& line : lines) add(line, laid.empty() ? title_colour : text_colour);
    if (!note.empty()) add(note, note_colour);
    return laid;
}

/// The rows of a label, a third of the area's height at most.
std::vector<std::string> rows_for(const std::vector<std::string>& lines, float width,
                                  float height) {
    const float line = ImGui::GetFontSize();
    if (height > 30.0F * line) return lines;
    std::vector<std::string> rows =
        shared_rows(lines, std::min(0.75F * width, 24.0F * line),
                    [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; });
    const auto most = static_cast<std::size_t>(std::max(height / (3.0F * line), 1.0F));
    rows.resize(std::min(rows.size(), most));
    return rows;
}

/// A legend's plate in the lower left corner. @return where its contents begin.
ImVec2 draw_lower_plate(const Canvas& canvas, const ViewArea& area, ImVec2 contents) {
    const float edge = canvas.length(margin), inset = canvas.length(padding);
    const ImVec2 corner = canvas.at({area.left, area.top + area.height});
    const ImVec2 high{corner.x + edge + contents.x + 2.0F * inset, corner.y - edge};
    const ImVec2 low{corner.x + edge, high.y - contents.y - 2.0F * inset};
    canvas.list->AddRectFilled(low, high, plate_colour, canvas.length(rounding));
    return {low.x + inset, low.y + inset};
}

}  // namespace

void draw_label(const Canvas& canvas, const ViewArea& area, const std::vector<std::string>& lines,
                const std::string& note) {
    const float edge = canvas.length(margin), inset = canvas.length(padding);
    const ImVec2 corner = canvas.at({area.left, area.top});
    const ImVec2 end = canvas.at({area.left + area.width, area.top + area.height});
    const float wrap = end.x - corner.x - 2.0F * (edge + inset);
    if (wrap < ImGui::GetFontSize()) return;
    const std::vector<std::string> rows = rows_for(lines, wrap, end.y - corner.y);
    const std::vector<TextLine> laid = lay_out(rows, note, wrap);
    if (laid.empty()) return;
    ImVec2 size{0.0F, 0.0F};
    for (const TextLine& line : laid) size = {std::max(size.x, line.size.x), size.y + line.size.y};
    const ImVec2 low{corner.x + edge, corner.y + edge};
    const ImVec2 high{low.x + size.x + 2.0F * inset, low.y + size.y + 2.0F * inset};
    canvas.list->PushClipRect(corner, end, true);
    canvas.list->AddRectFilled(low, high, plate_colour, canvas.length(rounding));
    ImVec2 pen{low.x + inset, low.y + inset};
    for (const TextLine& line : laid) {
        canvas.list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), pen, line.colour,
                             line.text->data(), line.text->data() + line.text->size(), wrap);
        pen.y += line.size.y;
    }
    canvas.list->PopClipRect();
}

void draw_strain_legend(const Canvas& canvas, const ViewArea& area, float strain_range) {
    const std::string low = "-" + percent_text(strain_range),
                      high = "+" + percent_text(strain_range);
    const float line = ImGui::GetFontSize(), bar = canvas.length(10.0F);
    const float width = std::max(canvas.length(170.0F), 4.0F * ImGui::CalcTextSize(high.c_str()).x);
    const ImVec2 pen =
        draw_lower_plate(canvas, area, {width, 2.0F * line + bar + canvas.length(4.0F)});
    canvas.list->AddText(pen, title_colour, "Strain of the springs");
    const float top = pen.y + line + canvas.length(2.0F);
    constexpr int parts = 16;
    for (int n = 0; n < parts; ++n) {
        const auto from = static_cast<float>(n) / parts, to = static_cast<float>(n + 1) / parts;
        const ImU32 left =
            packed(colour_of_strain((2.0F * from - 1.0F) * strain_range, strain_range));
        const ImU32 right =
            packed(colour_of_strain((2.0F * to - 1.0F) * strain_range, strain_range));
        canvas.list->AddRectFilledMultiColor(
            {pen.x + from * width, top}, {pen.x + to * width, top + bar}, left, right, right, left);
    }
    const float below = top + bar + canvas.length(2.0F);
    canvas.list->AddText({pen.x, below}, text_colour, low.c_str());
    canvas.list->AddText({pen.x + 0.5F * (width - ImGui::CalcTextSize("0").x), below}, text_colour,
                         "0");
    canvas.list->AddText({pen.x + width - ImGui::CalcTextSize(high.c_str()).x, below}, text_colour,
                         high.c_str());
}

void draw_kind_legend(const Canvas& canvas, const ViewArea& area) {
    constexpr std::array<const char*, 3> names{"structural", "shear", "bend"};
    const float line = ImGui::GetFontSize(), swatch = canvas.length(22.0F);
    const float width = swatch + canvas.length(8.0F) + ImGui::CalcTextSize("structural").x;
    ImVec2 pen = draw_lower_plate(canvas, area, {width, 3.0F * line});
    for (std::uint8_t kind = 0; kind < names.size(); ++kind) {
        const float middle = pen.y + 0.5F * line;
        canvas.list->AddLine({pen.x, middle}, {pen.x + swatch, middle},
                             packed(colour_of_kind(kind)), canvas.length(3.0F));
        canvas.list->AddText({pen.x + swatch + canvas.length(8.0F), pen.y}, text_colour,
                             names[kind]);
        pen.y += line;
    }
}

}  // namespace weft::viewer
