// Pictures of a cloth as files: png, mp4, webm, gif.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "weft/recorder.h"

namespace weft {

class OutputFile;
struct Image;

/// Writes a picture as PNG and puts the file in its place.
/// @throws Error (file).
void write_png(OutputFile& file, const Image& image);

/// A recorder that draws every frame. NAME.mp4, NAME.webm and NAME.gif are made through the ffmpeg
/// program; "png" makes a folder NAME.png-frames with NAME.0000.png and so on.
/// begin() throws Error (file) where ffmpeg or OpenGL is missing or the texture cannot be read.
/// @param format "png", "mp4", "webm" or "gif".
std::unique_ptr<Recorder> make_picture_recorder(std::string_view format);

/// Draws one frame into a PNG file.
/// @param plan surface, render and obstacles are read; @param first frame 0: it places mast, ground
/// and camera.
/// @throws Error (file).
void write_picture(const std::filesystem::path& path, const RecordingPlan& plan, const Frame& first,
                   const Frame& frame);

}  // namespace weft
