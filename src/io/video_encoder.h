// Videos by the ffmpeg program: pictures go raw into its standard input.
#pragma once

#include <sys/types.h>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/image.h"

namespace weft {

/// A running ffmpeg. It writes under a temporary name, which commit() makes the final one;
/// destroyed before, it ends ffmpeg and removes the file. Not for use by two threads at once.
class VideoEncoder {
public:
    /// @param format "mp4", "webm" or "gif"; @param size of the pictures [pixels], even numbers.
    /// @throws Error (file) where ffmpeg is not found or the file cannot be written.
    VideoEncoder(std::filesystem::path path, std::string_view format, std::array<int, 2> size,
                 double frames_per_second);
    ~VideoEncoder();
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;

    /// @param image of the size given; alpha is dropped.
    /// @throws Error (file) with ffmpeg's own words where it has given up.
    void write(const Image& image);
    /// Lets ffmpeg finish, and renames. @throws Error (file).
    void commit();

private:
    void start(const std::vector<std::string>& arguments);
    void close_input();
    void wait();
    [[noreturn]] void fail();

    std::filesystem::path path_, temporary_;
    pid_t process_ = -1;  ///< -1: not running
    int input_ = -1;      ///< socket to ffmpeg's standard input; -1: closed
    int messages_ = -1;   ///< file in memory that takes ffmpeg's standard error
    int status_ = 0;      ///< how ffmpeg ended, as waitpid() tells it
    bool committed_ = false;
};

/// A frame rate as ffmpeg reads it without loss: the simplest fraction that equals it, "125/4" for
/// 31.25.
/// @param frames_per_second above 0, below a million.
std::string frame_rate_fraction(double frames_per_second);

/// The arguments of ffmpeg for a video, program name first, output file last.
std::vector<std::string> encoder_arguments(std::string_view format, std::array<int, 2> size,
                                           double frames_per_second,
                                           const std::filesystem::path& output);

}  // namespace weft
