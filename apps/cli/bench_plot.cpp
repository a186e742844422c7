#include "cli/bench_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "io/gnuplot.h"
#include "weft/error.h"

namespace weft {

namespace {

constexpr std::array<std::string_view, 7> principal_cases{
    "textbook",        "odeint rk4", "odeint velocity_verlet",        "symplectic-euler",
    "velocity-verlet", "rk4",        "pinned copies symplectic-euler"};

// A line of the plot: one case, precision and number of threads at all its sizes.
struct Series {
    std::string title;
    std::size_t colour;  // a case's own
    Precision precision;
    int threads;
    std::vector<std::pair<double, double>> points;  // particles, ns a particle-step
};

std::string title_of(const bench::Label& label) {
    return fmt::format("{}, {}{}", label.name,
                       label.precision == Precision::f32 ? "single" : "double",
                       label.threads > 1 ? fmt::format(", {} threads", label.threads) : "");
}

std::vector<Series> series_of(std::span<const bench::Row> rows, bool all) {
    std::vector<Series> series;
    std::vector<std::string> cases;
    for (const bench::Row& row : rows) {
        const bench::Label& label = row.label;
        if (!row.ns_per_particle_step) continue;
        if (!all && std::ranges::find(principal_cases, label.name) == principal_cases.end()) {
            continue;
        }
        const std::string title = title_of(label);
        auto found = std::ranges::find(series, title, &Series::title);
        if (found == series.end()) {
            const auto place = std::ranges::find(cases, label.name);
            const auto colour = static_cast<std::size_t>(place - cases.begin());
            if (place == cases.end()) cases.push_back(label.name);
            series.push_back({title, colour, label.precision, label.threads, {}});
            found = series.end() - 1;
        }
        found->points.emplace_back(static_cast<double>(label.columns) * label.rows,
                                   *row.ns_per_particle_step);
    }
    for (Series& line : series) std::ranges::sort(line.points);
    return series;
}

std::string head(bool svg) {
    return std::string(svg ? "set terminal svg size 1100,720 font 'sans-serif,14' background "
                             "'#ffffff'\n"
                           : "set terminal pngcairo size 1100,720 font 'sans,11'\n") +
           "set encoding utf8\n"
           "set logscale xy\n"
           "set xlabel 'particles'\n"
           "set ylabel 'nanoseconds a particle and step'\n"
           "set format x '10^{%T}'\n"
           "set ytics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)\n"
           "set grid xtics ytics lc rgb '#d0d0d0' lt 1\n"
           "set key outside right top Left reverse noenhanced samplen 3\n";
}

constexpr std::array<std::string_view, 10> colours{"#303030", "#0060b0", "#d04000", "#008060",
                                                   "#a040a0", "#c09000", "#50a0e0", "#f08080",
                                                   "#70b050", "#806040"};

// A range with some room around all points.
std::string ranges(const std::vector<Series>& series) {
    double left = 1e30, right = 0.0, low = 1e30, high = 0.0;
    for (const Series& line : series) {
        for (const auto& [particles, cost] : line.points) {
            left = std::min(left, particles);
            right = std::max(right, particles);
            low = std::min(low, cost);
            high = std::max(high, cost);
        }
    }
    return fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", left / 1.5,
                       right * 1.5, low / 1.5, high * 1.5);
}

// Single precision is drawn solid, double dashed; filled marks are one thread, open ones several.
std::string script_of(const std::vector<Series>& series, bool svg) {
    std::string script = head(svg) + ranges(series), plot = "plot ";
    for (std::size_t n = 0; n < series.size(); ++n) {
        const Series& line = series[n];
        script += fmt::format("$series{} << end\n", n);
        for (const auto& [particles, cost] : line.points) {
            script += fmt::format("{:.0f} {:.6g}\n", particles, cost);
        }
        script += "end\n";
        plot += fmt::format(
            "{}$series{} using 1:2 with linespoints lw 2 lc rgb '{}' dt {} pt {} title \"{}\"",
            n == 0 ? "" : ", ", n, colours[line.colour % colours.size()],
            line.precision == Precision::f32 ? 1 : 2, line.threads > 1 ? 6 : 7, line.title);
    }
    return script + plot + "\n";
}

bool is_svg(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".svg") return true;
    if (ending == ".png") return false;
    throw Error(ErrorKind::usage, {.key = "-o " + path.string()},
                "the plot is a file that ends in .svg or .png");
}

}  // namespace

BenchPlot::BenchPlot(const std::filesystem::path& path) : file_(path), svg_(is_svg(path)) {
    if (run_gnuplot("exit\n").status == -1) {
        throw file_error(path.string(), "needs the program gnuplot, which is not found",
                         "Install it (apt install gnuplot-nox), or leave out -o.");
    }
}

void BenchPlot::draw(std::span<const bench::Row> rows, bool all) {
    const std::vector<Series> series = series_of(rows, all);
    if (series.empty()) {
        throw file_error(file_.path().string(), "none of the rows is timed a particle-step");
    }
    const GnuplotRun run = run_gnuplot(script_of(series, svg_));
    if (!run.ok() || run.output.empty()) {
        throw file_error(file_.path().string(), "gnuplot failed", run.messages);
    }
    file_.write(run.output);
    file_.commit();
}

}  // namespace weft
