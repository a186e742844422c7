#include "lab/report/plot_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace weft::lab {

namespace {

// Beyond it the ratio of two numbers would not be finite; nothing measured is as large.
constexpr double largest = 1e150;

bool fits(double value, bool logarithmic) {
    return std::isfinite(value) && std::abs(value) <= largest &&
           (!logarithmic || value >= 1.0 / largest);
}

AxisRange padded(double low, double high, bool logarithmic) {
    if (logarithmic) {
        const double room = low == high ? 2.0 : std::pow(high / low, 0.04);
        return {low / room, high * room};
    }
    const double least = 1e-12 * std::max(std::abs(low), std::abs(high));
    if (high - low <= least) {
        const double room = low == 0.0 && high == 0.0 ? 1.0 : 0.1 * std::abs(low);
        return {low - room, high + room};
    }
    return {low - 0.04 * (high - low), high + 0.04 * (high - low)};
}

// 1, 2 or 5 times a power of ten, at least `step`.
double round_step(double step) {
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= step) return factor * power;
    }
    return 10.0 * power;
}

// Tics of a logarithmic axis that spans too little for powers of ten.
std::vector<double> tics_within(const AxisRange& range) {
    std::vector<double> tics;
    const int first = static_cast<int>(std::floor(std::log10(range.low)));
    for (int power = first; std::pow(10.0, power) <= range.high; ++power) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double tic = factor * std::pow(10.0, power);
            if (tic >= range.low && tic <= range.high) tics.push_back(tic);
        }
    }
    if (tics.size() >= 3) return tics;
    tics.clear();
    const double step = round_step((range.high - range.low) / 5.0);
    for (double tic = std::ceil(range.low / step) * step; tic <= range.high; tic += step) {
        tics.push_back(tic);
    }
    return tics;
}

std::string tic_text(double tic) {
    if (tic >= 1e-3 && tic < 1e5) return fmt::format("{:.6g}", tic);
    const int power = static_cast<int>(std::floor(std::log10(tic) + 1e-9));
    return fmt::format("{:.6g}×10^{{{}}}", tic / std::pow(10.0, power), power);
}

std::string short_logarithmic_tics(char name, const AxisRange& range) {
    std::string list;
    for (const double tic : tics_within(range)) {
        list += fmt::format("{}'{}' {:.9g}", list.empty() ? "" : ", ", tic_text(tic), tic);
    }
    return fmt::format("set {}tics ({})\n", name, list);
}

}  // namespace

bool can_draw(const Plot& plot, const std::array<double, 2>& point) {
    return fits(point[0], plot.log_x) && fits(point[1], plot.log_y);
}

bool has_points(const Plot& plot) {
    return std::ranges::any_of(plot.series, [&](const Series& series) {
        return std::ranges::any_of(series.points,
                                   [&](const auto& point) { return can_draw(plot, point); });
    });
}

AxisRange range_of(const Plot& plot, std::size_t axis) {
    const bool logarithmic = axis == 0 ? plot.log_x : plot.log_y;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto take = [&](const std::array<double, 2>& point) {
        if (!can_draw(plot, point)) return;
        low = std::min(low, point[axis]);
        high = std::max(high, point[axis]);
    };
    for (const Series& series : plot.series) std::ranges::for_each(series.points, take);
    for (const Label& label : plot.labels) take({label.x, label.y});
    if (low > high) return {logarithmic ? 0.1 : 0.0, 1.0};
    return padded(low, high, logarithmic);
}

std::string axis_commands(char name, const AxisRange& range, bool logarithmic) {
    std::string script =
        fmt::format("set {}range [{:.17g}:{:.17g}]\n", name, range.low, range.high);
    if (!logarithmic) {
        // Numbers far from zero that differ little need digits to differ in.
        const double size = std::max(std::abs(range.low), std::abs(range.high));
        if ((range.high - range.low) < 1e-4 * size)
            script += fmt::format("set format {} '%.12g'\n", name);
        return script;
    }
    script += fmt::format("set logscale {}\n", name);
    if (std::log10(range.high / range.low) < 1.7) {
        return script + short_logarithmic_tics(name, range);
    }
    return script + fmt::format("set format {} '10^{{%T}}'\n", name);
}

}  // namespace weft::lab
