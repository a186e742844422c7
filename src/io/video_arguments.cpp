// How ffmpeg is asked for each kind of video.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "io/video_encoder.h"

namespace weft {

namespace {

using Arguments = std::vector<std::string>;

// Colours of an HD video. Without the filter's matrix ffmpeg would convert by the rule of SD video
// and players would show reds and greens slightly off.
const Arguments hd_colours{"-vf",
                           "scale=out_color_matrix=bt709:out_range=tv",
                           "-pix_fmt",
                           "yuv420p",
                           "-colorspace",
                           "bt709",
                           "-color_primaries",
                           "bt709",
                           "-color_trc",
                           "bt709",
                           "-color_range",
                           "tv"};

Arguments codec_arguments(std::string_view format, double frames_per_second) {
    Arguments arguments;
    if (format == "gif") {
        // A gif counts time in hundredths of a second, and browsers slow down what is shorter than
        // two of them. One palette for all comes from the first frames: a palette from all of them
        // would hold the whole video in memory.
        const std::string rate = frames_per_second > 50.0 ? "fps=50," : "";
        arguments = {"-filter_complex",
                     rate +
                         "split[shown][counted];[counted]trim=end_frame=24,palettegen[palette];"
                         "[shown][palette]paletteuse=dither=sierra2_4a:diff_mode=rectangle",
                     "-loop", "0"};
    } else if (format == "webm") {
        arguments = hd_colours;
        arguments.insert(arguments.end(), {"-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0",
                                           "-deadline", "good", "-cpu-used", "4", "-row-mt", "1"});
    } else {
        arguments = hd_colours;
        arguments.insert(arguments.end(), {"-c:v", "libx264", "-preset", "medium", "-crf", "18",
                                           "-movflags", "+faststart"});
    }
    return arguments;
}

}  // namespace

std::string frame_rate_fraction(double frames_per_second) {
    // Continued fraction: each turn gives the next better fraction with a small denominator.
    std::int64_t numerator = 1, denominator = 0, earlier_numerator = 0, earlier_denominator = 1;
    double rest = frames_per_second;
    for (int turn = 0; turn < 24; ++turn) {
        const double whole = std::floor(rest);
        const auto digit = static_cast<std::int64_t>(whole);
        earlier_numerator = std::exchange(numerator, digit * numerator + earlier_numerator);
        earlier_denominator = std::exchange(denominator, digit * denominator + earlier_denominator);
        const double value = static_cast<double>(numerator) / static_cast<double>(denominator);
        if (std::abs(value - frames_per_second) <= 1e-9 * frames_per_second || rest == whole) break;
        rest = 1.0 / (rest - whole);
    }
    return fmt::format("{}/{}", numerator, denominator);
}

std::vector<std::string> encoder_arguments(std::string_view format, std::array<int, 2> size,
                                           double frames_per_second,
                                           const std::filesystem::path& output) {
    Arguments arguments{"ffmpeg",
                        "-hide_banner",
                        "-loglevel",
                        "error",
                        "-nostdin",
                        "-xerror",
                        "-y",
                        "-f",
                        "rawvideo",
                        "-pixel_format",
                        "rgba",
                        "-video_size",
                        fmt::format("{}x{}", size[0], size[1]),
                        "-framerate",
                        frame_rate_fraction(frames_per_second),
                        "-i",
                        "pipe:0",
                        "-an"};
    for (std::string& argument : codec_arguments(format, frames_per_second))
        arguments.push_back(std::move(argument));
    // "file:" keeps a name with a colon or a leading dash from meaning anything else.
    for (std::string argument : {std::string("-f"), std::string(format), "file:" + output.string()})
        arguments.push_back(std::move(argument));
    return arguments;
}

}  // namespace weft
