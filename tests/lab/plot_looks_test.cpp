#include "lab/report/plot_looks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "weft/integrators.h"

namespace weft::lab {
namespace {

using Style = Series::Style;

double luminance(std::string_view hex) {
    const auto part = [&](std::size_t place) {
        const double value = std::stoi(std::string(hex.substr(place, 2)), nullptr, 16) / 255.0;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);
}

// WCAG 2: from 1 to 21.
double contrast(std::string_view a, std::string_view b) {
    const double first = luminance(a) + 0.05, second = luminance(b) + 0.05;
    return std::max(first, second) / std::min(first, second);
}

Plot plot_of(std::vector<Series> series) {
    return {.id = "p",
            .title = "",
            .x_label = "",
            .y_label = "",
            .series = std::move(series),
            .text = ""};
}

TEST(PlotLooks, EveryColourStandsOutOnWhiteAndOnTheDarkPage) {
    ASSERT_EQ(plot_colours().size(), 8u);
    for (const PlotColour& colour : plot_colours()) {
        EXPECT_GE(contrast(colour.light, page_background.light), 3.0) << colour.light;
        EXPECT_GE(contrast(colour.dark, page_background.dark), 3.0) << colour.dark;
    }
}

TEST(PlotLooks, EveryMethodDiffersFromEveryOtherWithAndWithoutMarks) {
    std::set<std::pair<std::size_t, int>> marked;
    std::set<std::pair<std::size_t, std::size_t>> lines;
    for (const IntegratorInfo& info : integrator_catalogue()) {
        const auto look = method_look(info.name);
        ASSERT_TRUE(look) << info.name << " has no look";
        EXPECT_TRUE(marked.emplace(look->colour, look->mark).second) << info.name;
        EXPECT_TRUE(lines.emplace(look->colour, look->dash).second) << info.name;
        EXPECT_LT(look->colour, neutral_colour);
    }
    EXPECT_EQ(marked.size(), integrator_catalogue().size());
    EXPECT_FALSE(method_look("kinetic"));
}

TEST(PlotLooks, NumberedLooksDifferTheSameWay) {
    std::set<std::pair<std::size_t, int>> marked;
    std::set<std::pair<std::size_t, std::size_t>> lines;
    for (std::size_t n = 0; n < 35; ++n) {
        EXPECT_TRUE(marked.emplace(numbered_look(n).colour, numbered_look(n).mark).second);
        EXPECT_TRUE(lines.emplace(numbered_look(n).colour, numbered_look(n).dash).second);
    }
}

TEST(PlotLooks, AMethodLooksTheSameInEveryPlot) {
    const auto alone = looks_of(plot_of({{"rk4", {}, Style::line, "rk4"}}));
    const auto beside = looks_of(plot_of({{"kinetic", {}, Style::line},
                                          {"slope", {}, Style::dashed, "neutral"},
                                          {"the rk4 of this scene", {}, Style::marks, "rk4"}}));
    EXPECT_EQ(alone[0], *method_look("rk4"));
    EXPECT_EQ(beside[2], alone[0]);
    EXPECT_EQ(beside[1].colour, neutral_colour);
    EXPECT_NE(beside[0].colour, neutral_colour);
}

TEST(PlotLooks, WhatIsNoMethodTakesALookThatNoMethodOfThePlotHas) {
    std::vector<Series> series;
    for (const IntegratorInfo& info : integrator_catalogue()) {
        series.push_back({std::string(info.name), {}, Style::line, std::string(info.name)});
    }
    series.push_back({"kinetic", {}, Style::line, "kinetic"});
    series.push_back({"total", {}, Style::line});
    series.push_back({"kinetic again", {}, Style::marks, "kinetic"});
    const auto looks = looks_of(plot_of(series));
    const std::size_t methods = integrator_catalogue().size();
    for (std::size_t n = 0; n < methods; ++n) {
        for (std::size_t own : {methods, methods + 1}) {
            const bool alike =
                looks[n].colour == looks[own].colour && looks[n].dash == looks[own].dash;
            EXPECT_FALSE(alike) << n;
        }
    }
    EXPECT_NE(looks[methods], looks[methods + 1]);
    EXPECT_EQ(looks[methods], looks[methods + 2]);
}

TEST(PlotLooks, TwoNamedLinesOfOneLookDifferInDashesAndUnnamedPiecesDoNot) {
    const auto looks = looks_of(plot_of({{"rk4, long step", {}, Style::line, "rk4"},
                                         {"rk4, short step", {}, Style::line, "rk4"},
                                         {"", {}, Style::line, "rk4"},
                                         {"slope 1", {}, Style::dashed, "neutral"},
                                         {"slope 2", {}, Style::dashed, "neutral"}}));
    EXPECT_EQ(looks[0].colour, looks[1].colour);
    EXPECT_NE(looks[0].dash, looks[1].dash);
    EXPECT_EQ(looks[0].dash, looks[2].dash);
    EXPECT_NE(looks[3].dash, looks[4].dash);
}

}  // namespace
}  // namespace weft::lab
