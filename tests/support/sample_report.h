// Sections of made-up numbers with every kind of block, and with text that is hard on HTML, CSV and
// gnuplot: what the report is tested on without measuring anything.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "io/video_encoder.h"
#include "lab/report/report.h"
#include "render/image.h"
#include "weft/integrators.h"

namespace weft::test {

constexpr const char* odd_text =
    R"(odd <b>&amp;</b> "double" 'single' {/Bold x}_y^z \n $HOME @a %d)";

/// Errors of all methods against the step, each by its stated order; rk2 has points that a
/// logarithmic axis cannot show.
inline lab::Plot sample_orders() {
    using Style = lab::Series::Style;
    lab::Plot plot{.id = "errors",
                   .title = "Error against the step",
                   .x_label = "step [s]",
                   .y_label = "error [m]",
                   .log_x = true,
                   .log_y = true,
                   .series = {},
                   .text = "The error of every method falls by its order."};
    std::size_t n = 0;
    for (const IntegratorInfo& info : integrator_catalogue()) {
        lab::Series series{
            std::string(info.name), {}, Style::line_and_marks, std::string(info.name)};
        for (int k = 0; k < 7; ++k) {
            const double dt = 0.01 / std::pow(2.0, k);
            series.points.push_back(
                {dt, (1.0 + 0.4 * static_cast<double>(n)) * std::pow(dt, info.order)});
        }
        if (info.name == "rk2") {
            series.points[2][1] = 0.0;
            series.points[3][1] = std::numeric_limits<double>::infinity();
            series.points[4][1] = std::nan("");
        }
        plot.series.push_back(series);
        ++n;
    }
    plot.series.push_back({"slope 1", {{1e-4, 1e-5}, {1e-2, 1e-3}}, Style::dashed, "neutral"});
    plot.series.push_back({"slope 4", {{1e-3, 1e-9}, {1e-2, 1e-5}}, Style::dashed, "neutral"});
    plot.labels = {{1e-3, 1e-9, odd_text}, {-1.0, 1.0, "cannot stand on this axis"}};
    return plot;
}

inline lab::Plot sample_energies() {
    using Style = lab::Series::Style;
    lab::Plot plot{.id = "energy",
                   .title = odd_text,
                   .x_label = odd_text,
                   .y_label = "energy [J]",
                   .series = {{"kinetic", {}, Style::line}, {odd_text, {}, Style::line}},
                   .text = odd_text};
    for (int k = 0; k <= 5000; ++k) {
        const double t = 0.002 * k;
        plot.series[0].points.push_back({t, 3.0 + std::sin(40.0 * t)});
        plot.series[1].points.push_back({t, 3.0 - std::sin(40.0 * t)});
    }
    return plot;
}

inline lab::Plot sample_region() {
    lab::Plot plot{.id = "region",
                   .title = "Stability regions ω Δt",
                   .x_label = "real part of λ Δt",
                   .y_label = "imaginary part of λ Δt",
                   .equal_axes = true,
                   .series = {},
                   .text = "Circles."};
    for (const char* method : {"forward-euler", "rk4"}) {
        lab::Series series{method, {}, lab::Series::Style::line, method};
        const double radius = method == std::string("rk4") ? 2.0 : 1.0;
        for (int k = 0; k <= 90; ++k) {
            const double angle = 3.14159265358979 * k / 45.0;
            series.points.push_back({radius * (std::cos(angle) - 1.0), radius * std::sin(angle)});
        }
        plot.series.push_back(series);
    }
    plot.series.push_back(
        {"the scene", {{-0.1, 0.5}, {-0.1, -0.5}}, lab::Series::Style::marks, "neutral"});
    return plot;
}

inline lab::Plot sample_without_points() {
    return {.id = "nothing",
            .title = "Nothing to draw",
            .x_label = "x",
            .y_label = "y",
            .log_y = true,
            .series = {{"none", {{1.0, -1.0}, {2.0, std::nan("")}}}},
            .text = "No point can be drawn."};
}

/// Numbers of all sizes, text, and cells without a value.
inline lab::Table sample_table() {
    const double infinity = std::numeric_limits<double>::infinity();
    return {
        .id = "limits",
        .caption = std::string("A row is a method. With `code` and ") + odd_text,
        .columns = {{"method"}, {"limit [s]"}, {"ratio", 6}, {"evaluations"}, {"note, \"quoted\""}},
        .rows = {{"rk4", 0.0123456789, 1.0000012, 10.0, {}},
                 {"verlet",
                  1.5e-7,
                  {},
                  9.0,
                  "a long note that says why this method has no ratio, "
                  "in more words than fit on a line"},
                 {"forward-euler", {}, infinity, 1234567.0, odd_text},
                 {"rk3", -2.5, -infinity, 100.0, {}},
                 {"rk2", 0.5, std::nan(""), -20.0, {}}}};
}

inline Image sample_picture(int width, int height, int shift) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.rgba.push_back(static_cast<std::uint8_t>((x + shift) % 256));
            image.rgba.push_back(static_cast<std::uint8_t>(y % 256));
            image.rgba.push_back(120);
            image.rgba.push_back(255);
        }
    }
    return image;
}

inline void write_sample_png(const std::filesystem::path& path, int width, int height) {
    const std::vector<std::uint8_t> bytes = encode_png(sample_picture(width, height, 0));
    std::filesystem::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

inline void write_sample_video(const std::filesystem::path& path) {
    std::filesystem::create_directories(path.parent_path());
    VideoEncoder encoder(path, "mp4", {320, 240}, 25.0);
    for (int frame = 0; frame < 10; ++frame) encoder.write(sample_picture(320, 240, 8 * frame));
    encoder.commit();
}

/// Three sections; `scale` makes the findings of two scenes differ. Pictures and the video are
/// written into `media`, unless that is empty.
inline std::vector<lab::Section> sample_sections(const std::filesystem::path& media, double scale) {
    lab::Section order{.experiment = "order",
                       .title = "Order of accuracy",
                       .question = "How fast does the error fall?",
                       .method = "Runs with steps halved.\n\nA second paragraph with `dt`.",
                       .blocks = {lab::Paragraph{"See `rk4`.\n\nAnd more."}, sample_orders(),
                                  sample_table(), sample_without_points()},
                       .answer = "Every method has its stated order, with 4.00 for `rk4`.",
                       .command = "weft lab order \"a <b> & 'c'.toml\"",
                       .skipped = {},
                       .findings = {{"order of rk4", 4.0 * scale, ""}, {"fastest", scale, "s"}}};
    lab::Section energy = order;
    energy.experiment = "energy";
    energy.title = odd_text;
    energy.question = odd_text;
    energy.blocks = {sample_energies(), sample_region()};
    energy.answer = odd_text;
    energy.findings = {{odd_text, std::numeric_limits<double>::infinity(), "J"}};
    if (!media.empty()) {
        write_sample_png(media / "strip.png", 1280, 240);
        write_sample_png(media / "small.png", 160, 120);
        write_sample_video(media / "film.mp4");
        energy.blocks.push_back(lab::Media{"strip", media / "strip.png", "A strip", "Colours."});
        energy.blocks.push_back(lab::Media{"small", media / "small.png", "A picture", odd_text});
        energy.blocks.push_back(
            lab::Media{"film", media / "film.mp4", "A film", "Moving colours."});
    }
    lab::Section look{.experiment = "look",
                      .title = "What it looks like",
                      .question = "What does it look like?",
                      .method = {},
                      .blocks = {},
                      .answer = {},
                      .command = "weft lab look sheet",
                      .skipped = "There is no OpenGL on this machine.",
                      .findings = {}};
    return {order, energy, look};
}

inline lab::ReportHead sample_head() {
    return {.title = "Sheet held at two corners",
            .scene = "sheet",
            .command = "weft lab sheet --quick",
            .facts = {"sheet: 1600 particles, 2 of them held, 9204 springs, 1600 kg",
                      "sheet: fastest mode 79.4 rad/s with damping ratio 0; no air", odd_text},
            .quick = true};
}

}  // namespace weft::test
