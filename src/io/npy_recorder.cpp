// NumPy arrays. The head names the number of frames, so it is written once to keep its place and
// again, equally long, at the end.
#include "io/npy_recorder.h"

#include <fmt/format.h>

#include "io/byte_order.h"
#include "io/npy_format.h"

namespace weft {

void NpyRecorder::begin(const RecordingPlan& plan) {
    particles_ = plan.surface->particle_count;
    precision_ = plan.precision;
    positions_.emplace(plan.directory / (plan.stem + ".positions.npy"));
    velocities_.emplace(plan.directory / (plan.stem + ".velocities.npy"));
    times_.emplace(plan.directory / (plan.stem + ".times.npy"));
    write_heads();
}

void NpyRecorder::write_heads() {
    const std::string_view element = precision_ == Precision::f32 ? "<f4" : "<f8";
    const std::string shape = fmt::format("{}, {}, 3", frames_, particles_);
    positions_->write(npy_head(element, shape));
    velocities_->write(npy_head(element, shape));
    times_->write(npy_head("<f8", fmt::format("{},", frames_)));
}

void NpyRecorder::write_vectors(OutputFile& file, std::span<const Vec3d> vectors) {
    if (precision_ == Precision::f32) {
        points_.write(file, vectors);
    } else {
        write_npy_vectors(file, vectors);
    }
}

void NpyRecorder::frame(const Frame& frame) {
    write_vectors(*positions_, frame.positions);
    write_vectors(*velocities_, frame.velocities);
    Bytes time;
    append_little(time, frame.time);
    times_->write(time);
    ++frames_;
}

std::vector<std::filesystem::path> NpyRecorder::finish() {
    std::vector<std::filesystem::path> files;
    for (OutputFile* file : {&*positions_, &*velocities_, &*times_}) file->seek(0);
    write_heads();
    for (OutputFile* file : {&*positions_, &*velocities_, &*times_}) file->close();
    for (OutputFile* file : {&*positions_, &*velocities_, &*times_}) {
        file->commit();
        files.push_back(file->path());
    }
    return files;
}

}  // namespace weft
