#include "viewer/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "viewer/controls.h"
#include "viewer/value_slider.h"

namespace weft::viewer {

namespace {

constexpr float shown_seconds = 20.0F;

struct Range {
    float low = 0.0F, high = 0.0F;
    float first = 0.0F, last = 0.0F;  ///< time
};

// Of everything that is to be seen, and 0.
Range range_of(std::span<const PlotLine> lines) {
    Range range;
    for (const PlotLine& line : lines) {
        if (!line.series->times().empty())
            range.last = std::max(range.last, line.series->times().back());
    }
    range.first = std::max(0.0F, range.last - shown_seconds);
    for (const PlotLine& line : lines) {
        const std::span<const float> times = line.series->times(), values = line.series->values();
        for (std::size_t n = 0; n < times.size(); ++n) {
            if (times[n] < range.first || !std::isfinite(values[n])) continue;
            range.low = std::min(range.low, values[n]);
            range.high = std::max(range.high, values[n]);
        }
    }
    if (range.high - range.low < 1e-30F) range.high = range.low + 1.0F;
    if (range.last - range.first < 1.0F) range.last = range.first + 1.0F;
    return range;
}

class Axes {
public:
    Axes(ImVec2 low, ImVec2 high, const Range& range) : low_(low), high_(high), range_(range) {}
    [[nodiscard]] ImVec2 point(float time, float value) const {
        const float right = (time - range_.first) / (range_.last - range_.first);
        const float up = (value - range_.low) / (range_.high - range_.low);
        constexpr float margin = 2.0F;
        return {low_.x + right * (high_.x - low_.x),
                high_.y - margin - up * (high_.y - low_.y - 2 * margin)};
    }

private:
    ImVec2 low_, high_;
    Range range_;
};

void draw_line(const PlotLine& line, const Axes& axes, float first) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const std::span<const float> times = line.series->times(), values = line.series->values();
    static std::vector<ImVec2> points;  // reused: a plot is drawn in every frame
    points.clear();
    for (std::size_t n = 0; n < times.size(); ++n) {
        if (times[n] >= first && std::isfinite(values[n])) {
            points.push_back(axes.point(times[n], values[n]));
        }
    }
    list->AddPolyline(points.data(), static_cast<int>(points.size()), line.colour, ImDrawFlags_None,
                      0.1F * em());
}

void draw_axes(ImVec2 low, ImVec2 high, const Range& range, const Axes& axes) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, colours::groove, ImGui::GetStyle().FrameRounding);
    if (range.low < 0.0F && range.high > 0.0F) {
        const float y = axes.point(range.first, 0.0F).y;
        list->AddLine({low.x, y}, {high.x, y}, colours::lines);
    }
    for (float second = std::ceil(range.first / 5.0F) * 5.0F; second < range.last; second += 5.0F) {
        const float x = axes.point(second, 0.0F).x;
        list->AddLine({x, low.y}, {x, high.y}, colours::lines);
    }
}

void draw_ends(ImVec2 low, ImVec2 high, const Range& range, const std::string& unit) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const std::string top = fmt::format("{} {}", brief(range.high, 3), unit);
    const std::string bottom = brief(range.low, 3);
    ImFont* font = ImGui::GetFont();
    const float size = 0.8F * em(), margin = 0.25F * em();
    list->AddText(font, size, {low.x + margin, low.y + 1.0F}, colours::faint, top.c_str());
    list->AddText(font, size, {low.x + margin, high.y - size - 2.0F}, colours::faint,
                  bottom.c_str());
}

// As many entries a line as find room.
void draw_legend(std::span<const PlotLine> lines, const std::string& unit) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    bool first = true;
    for (const PlotLine& line : lines) {
        if (line.label.empty()) continue;
        const std::span<const float> values = line.series->values();
        const std::string text =
            values.empty() ? line.label
                           : fmt::format("{} {} {}", line.label, brief(values.back(), 3), unit);
        const float width = ImGui::CalcTextSize(text.c_str()).x + em();
        if (!first) {
            ImGui::SameLine(0.0F, 0.7F * em());
            if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
        }
        first = false;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float middle = at.y + 0.5F * em();
        ImGui::GetWindowDrawList()->AddLine({at.x, middle}, {at.x + 0.7F * em(), middle},
                                            line.colour, 3.0F);
        ImGui::SetCursorScreenPos({at.x + em(), at.y});
        ImGui::TextUnformatted(text.c_str());
    }
}

}  // namespace

void line_plot(const PlotLook& look, std::span<const PlotLine> lines) {
    ImGui::TextUnformatted(look.title.c_str());
    const float width = ImGui::GetContentRegionAvail().x;
    if (!look.present.empty()) text_at_right(look.present);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + width, low.y + look.height * em()};
    ImGui::Dummy({width, look.height * em()});
    const Range range = range_of(lines);
    const Axes axes(low, high, range);
    draw_axes(low, high, range, axes);
    const auto measured = [](const PlotLine& line) { return !line.series->times().empty(); };
    if (std::any_of(lines.begin(), lines.end(), measured)) draw_ends(low, high, range, look.unit);
    ImGui::PushClipRect(low, high, true);
    for (const PlotLine& line : lines) draw_line(line, axes, range.first);
    ImGui::PopClipRect();
    draw_legend(lines, look.unit);
    ImGui::Spacing();
}

}  // namespace weft::viewer
