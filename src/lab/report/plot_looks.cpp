#include "lab/report/plot_looks.h"

#include <algorithm>
#include <string>
#include <utility>

namespace weft::lab {

namespace {

// Hues of Okabe and Ito (2008), yellow left out, and moved until the least distance of two of them
// (CIELAB, after Machado, Oliveira and Fernandes' simulation of colour blindness) was above 24.
constexpr std::array<PlotColour, 8> colours{{{"#1935bf", "#6063ff"},    // blue
                                             {"#9c2400", "#e64c17"},    // vermilion
                                             {"#0d7756", "#239566"},    // green
                                             {"#b88902", "#ffd435"},    // orange
                                             {"#b03594", "#b25ea0"},    // purple
                                             {"#2394ff", "#60caff"},    // sky blue
                                             {"#1f2328", "#f2f2f2"},    // ink
                                             {"#767b82", "#8f959d"}}};  // neutral

constexpr std::array<std::string_view, 5> dashes{"solid", "(12,5)", "(3,4)", "(12,4,3,4)",
                                                 "(20,4,3,4,3,4)"};

// gnuplot's point types; those that are told apart at a glance come first.
enum Mark : int {
    circle = 7,
    square = 5,
    triangle = 9,
    diamond = 13,
    wedge = 11,
    pentagon = 15,
    open_circle = 6,
    open_square = 4,
    open_triangle = 8,
    open_diamond = 12,
    open_wedge = 10,
    open_pentagon = 14,
    cross = 2,
    plus = 1,
    star = 3
};
constexpr std::array<Mark, 15> marks{circle,        square,       triangle,    diamond,
                                     wedge,         pentagon,     open_circle, open_square,
                                     open_triangle, open_diamond, open_wedge,  open_pentagon,
                                     cross,         plus,         star};

enum Colour : std::size_t { blue, vermilion, green, orange, purple, sky, ink };
enum Dash : std::size_t { solid, dashed, dotted, dash_dotted };

struct MethodLook {
    std::string_view method;
    PlotLook look;
};

// Kin have the same colour. Explicit methods are solid, their kin and adaptive ones dashed,
// implicit ones dotted, those that go by springs dash-dotted.
constexpr std::array<MethodLook, 22> method_looks{{
    {"forward-euler", {blue, circle, solid}},
    {"symplectic-euler", {vermilion, square, solid}},
    {"verlet", {green, triangle, solid}},
    {"time-corrected-verlet", {green, open_triangle, dashed}},
    {"velocity-verlet", {orange, diamond, solid}},
    {"rk2", {sky, wedge, solid}},
    {"rk3", {purple, pentagon, solid}},
    {"rk4", {ink, open_circle, solid}},
    {"yoshida4", {vermilion, open_square, dashed}},
    {"forest-ruth", {orange, open_diamond, dashed}},
    {"bosh3", {purple, open_wedge, dashed}},
    {"dopri5", {ink, open_pentagon, dashed}},
    {"implicit-euler", {blue, cross, dotted}},
    {"implicit-midpoint", {vermilion, plus, dotted}},
    {"trapezoidal", {green, star, dotted}},
    {"bdf2", {orange, open_square, dotted}},
    {"tr-bdf2", {sky, open_circle, dotted}},
    {"sdirk2", {purple, open_triangle, dotted}},
    {"baraff-witkin", {ink, open_diamond, dotted}},
    {"projective-dynamics", {blue, open_wedge, dash_dotted}},
    {"xpbd", {vermilion, open_pentagon, dash_dotted}},
    {"vbd", {green, circle, dash_dotted}},
}};

// Hands out looks that nothing else in the plot has.
class FreeLooks {
public:
    explicit FreeLooks(const Plot& plot) {
        for (const Series& series : plot.series) {
            if (const auto look = method_look(series.look)) taken_.push_back(*look);
        }
    }

    // The same for the same name, unless that is empty.
    PlotLook look_of(const std::string& name) {
        for (const auto& [known, look] : given_) {
            if (!name.empty() && known == name) return look;
        }
        while (is_taken(numbered_look(next_))) ++next_;
        given_.emplace_back(name, numbered_look(next_++));
        return given_.back().second;
    }

private:
    [[nodiscard]] bool is_taken(const PlotLook& look) const {
        return std::ranges::any_of(taken_, [&](const PlotLook& other) {
            return look.colour == other.colour &&
                   (look.mark == other.mark || look.dash == other.dash);
        });
    }

    std::vector<PlotLook> taken_;
    std::vector<std::pair<std::string, PlotLook>> given_;
    std::size_t next_ = 0;
};

// How many named series of the same look and style stand before series n, under other names.
std::size_t alike_before(const Plot& plot, std::size_t n) {
    const Series& own = plot.series[n];
    std::vector<std::string> names;
    for (std::size_t m = 0; m < n; ++m) {
        const Series& other = plot.series[m];
        const bool alike = other.look == own.look && other.style == own.style;
        if (!alike || other.name.empty() || other.name == own.name) continue;
        if (std::ranges::find(names, other.name) == names.end()) names.push_back(other.name);
    }
    return names.size();
}

}  // namespace

std::span<const PlotColour> plot_colours() {
    return colours;
}

std::span<const std::string_view> dash_patterns() {
    return dashes;
}

PlotLook numbered_look(std::size_t n) {
    return {n % neutral_colour, marks[n % marks.size()], n / neutral_colour % dashes.size()};
}

std::optional<PlotLook> method_look(std::string_view method) {
    const auto found = std::ranges::find(method_looks, method, &MethodLook::method);
    if (found == method_looks.end()) return std::nullopt;
    return found->look;
}

std::vector<PlotLook> looks_of(const Plot& plot) {
    FreeLooks free(plot);
    std::vector<PlotLook> looks;
    for (std::size_t n = 0; n < plot.series.size(); ++n) {
        const Series& series = plot.series[n];
        PlotLook look{neutral_colour, marks[0], 0};
        if (const auto own = method_look(series.look)) {
            look = *own;
        } else if (series.look != "neutral") {
            look = free.look_of(series.look);
        }
        if (series.style == Series::Style::dashed) look.dash = 1;
        if (!series.look.empty() && !series.name.empty()) {
            look.dash = (look.dash + alike_before(plot, n)) % dashes.size();
        }
        looks.push_back(look);
    }
    return looks;
}

}  // namespace weft::lab
