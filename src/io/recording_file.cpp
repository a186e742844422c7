// Recordings read back: which reader, and from positions to frames.
#include "io/recording_file.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "io/glb_file.h"
#include "io/point_cache_file.h"
#include "weft/error.h"

namespace weft {

namespace {

struct Reader {
    std::string_view ending;
    std::unique_ptr<RecordedMotion> (*open)(const std::filesystem::path& path);
};

constexpr std::array readers{
    Reader{".pc2", open_pc2},
    Reader{".mdd", open_mdd},
    Reader{".glb", open_glb},
};

const Reader* reader_of(const std::filesystem::path& path) {
    for (const Reader& reader : readers)
        if (path.extension() == reader.ending) return &reader;
    return nullptr;
}

}  // namespace

bool is_recording(const std::filesystem::path& path) {
    return reader_of(path) != nullptr;
}

RecordingFile::RecordingFile(const std::filesystem::path& path) : path_(path) {
    const Reader* reader = reader_of(path);
    if (reader == nullptr)
        throw file_error(path.string(), "not a recording: its name must end in .pc2, .mdd or .glb");
    motion_ = reader->open(path);
    velocities_.resize(surface().particle_count);
    normals_.resize(surface().particle_count);
}

Frame RecordingFile::frame(std::size_t index) {
    if (index >= frame_count())
        throw Error(
            ErrorKind::usage, {.file = path_.string()},
            fmt::format("has no frame {}: frames 0 to {} are there", index, frame_count() - 1));
    motion_->read(index, positions_);
    for (std::size_t particle = 0; particle < positions_.size(); ++particle)
        if (!is_finite(positions_[particle]))
            throw file_error(path_.string(), fmt::format("frame {}: the position of particle {} is "
                                                         "not finite",
                                                         index, particle));
    compute_normals(surface(), positions_, normals_);
    return {index, static_cast<double>(index) / frames_per_second(), positions_, velocities_,
            normals_};
}

}  // namespace weft
