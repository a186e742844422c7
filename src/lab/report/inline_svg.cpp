#include "lab/report/inline_svg.h"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "lab/report/html_text.h"
#include "lab/report/plot_looks.h"

namespace weft::lab {

namespace {

using Replacement = std::pair<std::string, std::string>;

// gnuplot's way to write a colour.
std::string svg_colour(std::string_view hex) {
    const auto part = [&](std::size_t place) {
        return std::stoi(std::string(hex.substr(place, 2)), nullptr, 16);
    };
    return fmt::format("'rgb({:3}, {:3}, {:3})'", part(1), part(3), part(5));
}

std::vector<Replacement> replacements(const std::string& name) {
    std::vector<Replacement> list;
    for (std::size_t n = 0; n < plot_colours().size(); ++n) {
        list.emplace_back(svg_colour(plot_colours()[n].light), fmt::format("\"var(--line{})\"", n));
    }
    list.emplace_back(svg_colour(grid_colour.light), "\"var(--grid)\"");
    for (const std::string_view key : {"stroke", "fill", "color"}) {
        for (const char quote : {'\'', '"'}) {
            list.emplace_back(fmt::format("{}={}black{}", key, quote, quote),
                              fmt::format("{}=\"currentColor\"", key));
        }
    }
    list.emplace_back("xlink:href='#", fmt::format("href='#{}.", name));
    list.emplace_back(" id='", fmt::format(" id='{}.", name));
    list.emplace_back(" id=\"", fmt::format(" id=\"{}.", name));
    list.emplace_back(" font-family=\"sans-serif\"", "");
    return list;
}

void replace_all(std::string& text, const Replacement& replacement) {
    std::size_t place = 0;
    while ((place = text.find(replacement.first, place)) != std::string::npos) {
        text.replace(place, replacement.first.size(), replacement.second);
        place += replacement.second.size();
    }
}

// Without the stretches from `begin` to the next `end`.
void cut(std::string& text, std::string_view begin, std::string_view end) {
    std::size_t from = 0;
    while ((from = text.find(begin)) != std::string::npos) {
        const std::size_t to = text.find(end, from);
        if (to == std::string::npos) return;
        text.erase(from, to + end.size() - from);
    }
}

// Without gnuplot's groups that hold nothing.
void cut_empty_groups(std::string& svg) {
    constexpr std::string_view empty = ">\n</g>\n";
    std::size_t place = 0;
    while ((place = svg.find("<g fill=", place)) != std::string::npos) {
        const std::size_t close = svg.find('>', place);
        if (svg.compare(close, empty.size(), empty) == 0) {
            svg.erase(place, close + empty.size() - place);
        } else {
            place = close;
        }
    }
}

// Tags with the replacements made. Text between them is the user's; gnuplot leaves its ">" raw.
std::string with_tags_replaced(const std::string& svg, const std::vector<Replacement>& list) {
    std::string result;
    std::size_t place = 0;
    while (place < svg.size()) {
        const std::size_t open = svg.find('<', place);
        if (open == std::string::npos) break;
        const std::size_t close = svg.find('>', open);
        if (close == std::string::npos) break;
        std::string between = svg.substr(place, open - place);
        replace_all(between, {">", "&gt;"});
        result += between;
        std::string tag = svg.substr(open, close + 1 - open);
        for (const Replacement& replacement : list) replace_all(tag, replacement);
        result += tag;
        place = close + 1;
    }
    return result + svg.substr(place);
}

}  // namespace

std::string inline_svg(const std::string& svg, const std::string& name, const SvgText& text) {
    const std::size_t box = svg.find("viewBox=\""), canvas = svg.find("<g id=\"gnuplot_canvas\"");
    const std::size_t end = svg.rfind("</svg>");
    const std::string view = svg.substr(box, svg.find('"', box + 9) + 1 - box);
    std::string body = svg.substr(canvas, end - canvas);
    cut(body, "<filter", "</filter>");
    cut_empty_groups(body);
    body = with_tags_replaced(body, replacements(name));
    return fmt::format(
        "<svg class=\"plot\" {0} role=\"img\" aria-labelledby=\"{1}.title\" "
        "aria-describedby=\"{1}.text\">\n<title id=\"{1}.title\">{2}</title>\n<desc "
        "id=\"{1}.text\">{3}</desc>\n{4}</svg>\n",
        view, name, html(text.title), html(text.description), body);
}

}  // namespace weft::lab
