#include "lab/report/plot_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lab/report/plot_axes.h"
#include "lab/report/plot_looks.h"

namespace weft::lab {

namespace {

using Kind = PlotCanvas::Kind;
using Points = std::vector<std::array<double, 2>>;

constexpr std::size_t most_points = 1200;  // of a line, as drawn

// In single quotes gnuplot takes everything as it is, but for the quote itself.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'') result += '\'';
        result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return result + "'";
}

struct Shape {
    int width, height;
    bool key_right;  // else below
};

Shape shape_of(const Plot& plot, bool narrow) {
    std::size_t named = 0, longest = 0;
    for (const Series& series : plot.series) {
        if (series.name.empty()) continue;
        ++named;
        longest = std::max(longest, series.name.size());
    }
    const int count = static_cast<int>(named);
    const int width = narrow ? 720 : 960;
    if (plot.equal_axes) return {width, narrow ? 520 : 620, true};
    const int drawing = narrow ? 440 : 540;
    if (!narrow && count > 4 && longest <= 40) {
        return {width, std::max(drawing, 110 + 21 * count), true};
    }
    const int columns = std::max(1, width / (90 + 9 * static_cast<int>(longest)));
    return {width, drawing + 20 * ((count + columns - 1) / columns), false};
}

std::string terminal(Kind kind, const Shape& shape) {
    if (kind == Kind::png) {
        return fmt::format(
            "set terminal pngcairo size {},{} enhanced font 'sans,15' "
            "linewidth 1.5 pointscale 1.5 background '{}'\n",
            shape.width * 3 / 2, shape.height * 3 / 2, page_background.light);
    }
    return fmt::format(
        "set terminal svg size {},{} enhanced font 'sans-serif,14'{}\n", shape.width, shape.height,
        kind == Kind::svg ? fmt::format(" background '{}'", page_background.light) : "");
}

std::string frame(const Plot& plot, const PlotCanvas& canvas, const Shape& shape) {
    std::string script = "set encoding utf8\nset border 3 lw 1\nset tics nomirror out scale 0.6\n";
    script += fmt::format("set grid xtics ytics lt 1 lw 1 lc rgb '{}'\n", grid_colour.light);
    if (canvas.kind != Kind::page) {
        script += fmt::format("set title {} noenhanced\n", quoted(plot.title));
    }
    script += fmt::format("set xlabel {} noenhanced\n", quoted(plot.x_label));
    script += fmt::format("set ylabel {} noenhanced\n", quoted(plot.y_label));
    script += shape.key_right ? "set key outside right top Left reverse"
                              : "set key outside below center horizontal Left reverse height 1";
    // A line of a key is higher in SVG.
    script +=
        fmt::format(" noenhanced samplen 3 spacing {}\n", canvas.kind == Kind::png ? 1.15 : 0.95);
    script += axis_commands('x', range_of(plot, 0), plot.log_x);
    script += axis_commands('y', range_of(plot, 1), plot.log_y);
    if (plot.equal_axes) script += "set size ratio -1\n";
    return script;
}

// A mark at the place, and the text on the side where there is room.
std::string labels(const Plot& plot, const Shape& shape) {
    const AxisRange range = range_of(plot, 0);
    const double width = shape.width * (shape.key_right ? 0.65 : 0.88);
    std::string script;
    for (const Label& label : plot.labels) {
        if (!can_draw(plot, {label.x, label.y})) continue;
        const double along = plot.log_x
                                 ? std::log(label.x / range.low) / std::log(range.high / range.low)
                                 : (label.x - range.low) / (range.high - range.low);
        const double text = 7.5 * static_cast<double>(label.text.size());
        const bool right_of_it = along * width + text < width || along * width < text;
        script += fmt::format(
            "set label {} at {:.17g},{:.17g} {} noenhanced front point pt 7 ps 0.5 lc rgb '{}' "
            "offset char {},0.4\n",
            quoted(label.text), label.x, label.y, right_of_it ? "left" : "right",
            plot_colours()[neutral_colour].light, right_of_it ? "0.6" : "-0.6");
    }
    return script;
}

// Of every stretch of points the first, the lowest, the highest and the last, in their order.
Points thinned(const Points& points) {
    if (points.size() <= most_points) return points;
    const std::size_t stretches = most_points / 4;
    Points kept;
    for (std::size_t n = 0; n < stretches; ++n) {
        const std::size_t begin = n * points.size() / stretches;
        const std::size_t end = (n + 1) * points.size() / stretches;
        const auto [low, high] =
            std::minmax_element(points.begin() + static_cast<std::ptrdiff_t>(begin),
                                points.begin() + static_cast<std::ptrdiff_t>(end),
                                [](const auto& a, const auto& b) { return a[1] < b[1]; });
        std::array<std::size_t, 4> places{begin, static_cast<std::size_t>(low - points.begin()),
                                          static_cast<std::size_t>(high - points.begin()), end - 1};
        std::ranges::sort(places);
        for (std::size_t k = 0; k < places.size(); ++k) {
            if (k == 0 || places[k] != places[k - 1]) kept.push_back(points[places[k]]);
        }
    }
    return kept;
}

// Stretches of points that can be drawn.
std::vector<Points> stretches_of(const Plot& plot, const Series& series) {
    std::vector<Points> stretches;
    bool open = false;
    for (const auto& point : series.points) {
        const bool drawn = can_draw(plot, point);
        if (drawn && !open) stretches.emplace_back();
        if (drawn) stretches.back().push_back(point);
        open = drawn;
    }
    return stretches;
}

// A block of data under the name $dN; the number of points in it.
std::size_t add_data(std::string& script, const Plot& plot, std::size_t n) {
    const Series& series = plot.series[n];
    std::size_t count = 0;
    script += fmt::format("$d{} << end_of_data\n", n);
    for (const Points& stretch : stretches_of(plot, series)) {
        if (count > 0) script += '\n';
        const bool line = series.style != Series::Style::marks;
        for (const auto& [x, y] : line ? thinned(stretch) : stretch) {
            script += fmt::format("{:.9g} {:.9g}\n", x, y);
            ++count;
        }
    }
    script += "end_of_data\n";
    return count;
}

std::string style_of(const Series& series, const PlotLook& look, std::size_t count) {
    const auto colour = plot_colours()[look.colour].light;
    const auto dashes = dash_patterns()[look.dash];
    const double width = look.colour == neutral_colour ? 1.4 : 1.8;
    const std::string strokes = fmt::format("lc rgb '{}' lw {} dt {}", colour, width, dashes);
    if (series.style == Series::Style::marks) {
        return fmt::format("with points lc rgb '{}' lw 1.4 pt {} ps 0.9", colour, look.mark);
    }
    if (series.style == Series::Style::line_and_marks) {
        // Not every point of a long line has room for a mark.
        const std::size_t interval = std::max<std::size_t>(1, count / 16);
        return fmt::format("with linespoints {} pt {} ps 0.9 pi {}", strokes, look.mark, interval);
    }
    return "with lines " + strokes;
}

std::string series_commands(const Plot& plot) {
    const std::vector<PlotLook> looks = looks_of(plot);
    std::string script, list;
    for (std::size_t n = 0; n < plot.series.size(); ++n) {
        const Series& series = plot.series[n];
        const std::size_t count = add_data(script, plot, n);
        if (count == 0) continue;
        list += fmt::format("{}$d{} using 1:2 {} {}", list.empty() ? "" : ", \\\n", n,
                            style_of(series, looks[n], count),
                            series.name.empty() ? "notitle" : "title " + quoted(series.name));
    }
    return script + "plot " + list + "\n";
}

}  // namespace

std::string plot_script(const Plot& plot, const PlotCanvas& canvas) {
    const Shape shape = shape_of(plot, canvas.narrow);
    std::string script =
        terminal(canvas.kind, shape) + frame(plot, canvas, shape) + labels(plot, shape);
    if (has_points(plot)) return script + series_commands(plot);
    return script + "set label 'no data' at graph 0.5,0.5 center noenhanced\nplot NaN notitle\n";
}

}  // namespace weft::lab
