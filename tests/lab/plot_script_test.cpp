#include "lab/report/plot_script.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "io/gnuplot.h"
#include "lab/report/inline_svg.h"
#include "lab/report/plot_axes.h"
#include "lab/report/plot_file.h"
#include "lab/report/report.h"
#include "support/sample_report.h"
#include "weft/error.h"

namespace weft::lab {
namespace {

using Style = Series::Style;

constexpr double infinity = std::numeric_limits<double>::infinity();

Plot plot_of(std::vector<std::array<double, 2>> points, bool logarithmic) {
    return {.id = "p",
            .title = "A plot",
            .x_label = "x",
            .y_label = "y",
            .log_x = logarithmic,
            .log_y = logarithmic,
            .series = {{"a line", std::move(points), Style::line}},
            .text = "A line."};
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t number = 0;
    for (std::size_t n = text.find(part); n != std::string::npos; n = text.find(part, n + 1)) {
        ++number;
    }
    return number;
}

std::string drawn(const Plot& plot) {
    const GnuplotRun run = run_gnuplot(plot_script(plot, {PlotCanvas::Kind::page, false}));
    EXPECT_TRUE(run.ok()) << run.messages;
    EXPECT_EQ(run.messages, "");
    return inline_svg(run.output, "figure", {plot.title, plot.text});
}

TEST(PlotAxes, ARangeHoldsEverythingThatCanBeDrawnWithRoom) {
    Plot plot = plot_of({{1.0, 10.0}, {3.0, infinity}, {std::nan(""), 99.0}, {2.0, 20.0}}, false);
    plot.labels = {{2.0, 30.0, "above"}, {infinity, 50.0, "nowhere"}};
    const AxisRange x = range_of(plot, 0), y = range_of(plot, 1);
    EXPECT_DOUBLE_EQ(x.low, 0.96);
    EXPECT_DOUBLE_EQ(x.high, 2.04);
    EXPECT_DOUBLE_EQ(y.low, 9.2);
    EXPECT_DOUBLE_EQ(y.high, 30.8);
}

TEST(PlotAxes, ALogarithmicRangeLeavesOutWhatIsNotPositive) {
    const AxisRange range =
        range_of(plot_of({{1.0, 0.0}, {2.0, -1.0}, {1e-3, 1e-9}, {1.0, 1.0}}, true), 1);
    EXPECT_GT(range.low, 1e-10);
    EXPECT_LT(range.low, 1e-9);
    EXPECT_GT(range.high, 1.0);
    EXPECT_LT(range.high, 10.0);
}

TEST(PlotAxes, OnePointAndNoPointStillHaveARange) {
    for (const bool logarithmic : {false, true}) {
        for (const auto& points : {std::vector<std::array<double, 2>>{{5.0, 5.0}}, {}}) {
            const AxisRange range = range_of(plot_of(points, logarithmic), 0);
            EXPECT_LT(range.low, range.high);
        }
    }
    EXPECT_LT(range_of(plot_of({{0.0, 0.0}}, false), 0).low, 0.0);
}

TEST(PlotAxes, ShortLogarithmicAxesHaveTicsThatAreNoPowersOfTen) {
    EXPECT_EQ(
        axis_commands('x', {0.9, 6.0}, true),
        "set xrange [0.90000000000000002:6]\nset logscale x\nset xtics ('1' 1, '2' 2, '5' 5)\n");
    const std::string narrow = axis_commands('y', {1.01e-5, 1.09e-5}, true);
    EXPECT_NE(narrow.find("'1.02×10^{-5}' 1.02e-05"), std::string::npos) << narrow;
    const std::string wide = axis_commands('y', {1e-9, 1.0}, true);
    EXPECT_NE(wide.find("set format y '10^{%T}'"), std::string::npos) << wide;
}

TEST(PlotScript, LinesBreakWhereAPointCannotBeDrawn) {
    const Plot plot = plot_of({{1, 1}, {2, 0}, {3, 3}, {4, 4}, {5, std::nan("")}, {6, 6}}, true);
    const std::string script = plot_script(plot, {});
    EXPECT_NE(script.find("$d0 << end_of_data\n1 1\n\n3 3\n4 4\n\n6 6\nend_of_data\n"),
              std::string::npos)
        << script;
}

TEST(PlotScript, LongLinesKeepTheirExtremes) {
    std::vector<std::array<double, 2>> points;
    for (int n = 0; n < 100000; ++n) points.push_back({1.0 * n, std::sin(0.01 * n)});
    points[54321][1] = 17.0;
    points[12345][1] = -19.0;
    const std::string script = plot_script(plot_of(points, false), {});
    EXPECT_LE(count(script, "\n"), 1300u);
    EXPECT_NE(script.find("\n54321 17\n"), std::string::npos);
    EXPECT_NE(script.find("\n12345 -19\n"), std::string::npos);
    EXPECT_NE(script.find("\n0 0\n"), std::string::npos);
    EXPECT_NE(script.find("\n99999 "), std::string::npos);
}

TEST(PlotScript, MarksAloneAreAllDrawn) {
    Plot plot = plot_of({}, false);
    for (int n = 0; n < 3000; ++n) plot.series[0].points.push_back({1.0 * n, 1.0});
    plot.series[0].style = Style::marks;
    const std::string script = plot_script(plot, {});
    EXPECT_EQ(count(script.substr(script.find("$d0")), " 1\n"), 3000u);
}

TEST(PlotFile, TextIsDrawnAsItIs) {
    Plot plot = plot_of({{1.0, 1.0}, {2.0, 2.0}}, false);
    plot.title = plot.x_label = plot.text = test::odd_text;
    plot.series[0].name = "it's `id` $(id) @x {/Bold}";
    plot.labels = {{1.5, 1.5, "stroke='black' id='1'\nnext line"}};
    const std::string svg = drawn(plot);
    EXPECT_NE(
        svg.find("<text>odd &lt;b&gt;&amp;amp;&lt;/b&gt; \"double\" 'single' {/Bold x}_y^z \\n "
                 "$HOME @a %d</text>"),
        std::string::npos)
        << svg;
    EXPECT_NE(svg.find("<text>it's `id` $(id) @x {/Bold}</text>"), std::string::npos);
    EXPECT_NE(svg.find("<text>stroke='black' id='1' next line</text>"), std::string::npos);
}

TEST(PlotFile, InlineDrawingsFollowThePageAndKeepTheirNamesApart) {
    const Plot plot = test::sample_orders();
    const std::string svg = drawn(plot);
    EXPECT_TRUE(svg.starts_with("<svg class=\"plot\" viewBox=\"0 0 960 "));
    EXPECT_NE(svg.find("role=\"img\" aria-labelledby=\"figure.title\""), std::string::npos);
    EXPECT_NE(svg.find("<title id=\"figure.title\">Error against the step</title>"),
              std::string::npos);
    for (const char* left :
         {"black", "rgb(", "#ffffff", "xlink", "font-family", "<filter", "id='gp", "id=\"gnuplot",
          "href='#gp", "<?xml", "Gnuplot", "background", "white"}) {
        EXPECT_EQ(svg.find(left), std::string::npos) << left;
    }
    EXPECT_NE(svg.find("stroke=\"currentColor\""), std::string::npos);
    EXPECT_NE(svg.find("href='#figure.gpPt6'"), std::string::npos);
    for (int n = 0; n < 8; ++n) {
        EXPECT_NE(svg.find("var(--line" + std::to_string(n) + ")"), std::string::npos) << n;
    }
    EXPECT_EQ(count(svg, "<title>"), 24u) << "22 methods and two slopes";
}

TEST(PlotFile, WholeFilesStandOnWhiteWithTheirTitle) {
    const Plot plot = test::sample_region();
    const PlotJob job{&plot, "figure", true};
    const DrawnPlot drawing = draw_plots({&job, 1}).front();
    EXPECT_TRUE(drawing.svg.starts_with("<?xml"));
    EXPECT_NE(drawing.svg.find("fill=\"#ffffff\""), std::string::npos);
    EXPECT_NE(drawing.svg.find("<text>Stability regions ω Δt</text>"), std::string::npos);
    EXPECT_EQ(drawing.inline_svg.find("<text>Stability regions"), std::string::npos);
    EXPECT_TRUE(drawing.png.starts_with("\x89PNG"));
}

TEST(PlotFile, APlotWithoutPointsSaysSo) {
    for (const bool logarithmic : {false, true}) {
        EXPECT_NE(drawn(plot_of({{-1.0, std::nan("")}}, logarithmic)).find("<text>no data</text>"),
                  std::string::npos);
    }
    Plot none = plot_of({}, false);
    none.series.clear();
    EXPECT_NE(drawn(none).find("<text>no data</text>"), std::string::npos);
}

TEST(PlotFile, NumbersOfAnySizeCanBeDrawn) {
    for (const bool logarithmic : {false, true}) {
        for (const double size : {1e-300, 1e-140, 1e-12, 1e20, 1e140, 1e308}) {
            EXPECT_NE(drawn(plot_of({{size, size}, {1.5 * size, 1.2 * size}}, logarithmic)), "");
        }
        EXPECT_NE(drawn(plot_of({{1e-140, 1e-140}, {1e140, 1e140}}, logarithmic)), "");
        EXPECT_NE(drawn(plot_of({{1.0, 1e9}, {2.0, 1e9 + 1e-6}}, logarithmic)), "");
    }
}

TEST(PlotFile, TheSamePlotIsDrawnTheSame) {
    const Plot plot = test::sample_orders();
    const std::vector<PlotJob> jobs(3, PlotJob{&plot, "figure", false});
    const std::vector<DrawnPlot> drawings = draw_plots(jobs);
    for (const DrawnPlot& drawing : drawings) {
        EXPECT_EQ(drawing.inline_svg, drawings[0].inline_svg);
        EXPECT_EQ(drawing.png, drawings[0].png);
    }
}

TEST(PlotFile, WithoutGnuplotTheErrorNamesThePackage) {
    check_plotting();
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    const Plot plot = plot_of({{1.0, 1.0}}, false);
    const PlotJob job{&plot, "figure", false};
    for (int n = 0; n < 2; ++n) {
        try {
            if (n == 0) check_plotting();
            if (n == 1) draw_plots({&job, 1});
            ADD_FAILURE() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::file);
            EXPECT_STREQ(error.what(), "gnuplot: the plots need this program, which is not found");
            EXPECT_NE(error.detail().find("gnuplot-nox"), std::string::npos);
        }
    }
    setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace weft::lab
