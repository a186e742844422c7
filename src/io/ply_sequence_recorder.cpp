// A folder with one PLY file a frame.
#include "io/ply_sequence_recorder.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/byte_order.h"

namespace weft {

namespace {

std::string ply_head(const Surface& surface, double time) {
    return fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment time {} s\n"
        "element vertex {}\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\n"
        "property float s\nproperty float t\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        time, surface.vertex_count(), surface.faces.size());
}

void append_vertices(Bytes& bytes, const Surface& surface, const Frame& frame) {
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        const std::uint32_t particle = surface.particle(vertex);
        const auto point = vec3_cast<float>(frame.positions[particle]);
        const Vec3f normal = frame.normals[particle];
        const auto uv = surface.uvs[vertex];
        for (const float value :
             {point.x, point.y, point.z, normal.x, normal.y, normal.z, uv[0], uv[1]})
            append_little(bytes, value);
    }
}

void append_faces(Bytes& bytes, const Surface& surface) {
    for (const auto& face : surface.faces) {
        const bool triangle = face[3] == Surface::no_vertex;
        append_little(bytes, static_cast<std::uint8_t>(triangle ? 3 : 4));
        for (std::size_t corner = 0; corner < (triangle ? 3U : 4U); ++corner)
            append_little(bytes, static_cast<std::int32_t>(face[corner]));
    }
}

}  // namespace

void PlySequenceRecorder::begin(const RecordingPlan& plan) {
    plan_ = plan;
    folder_.emplace(plan.directory / (plan.stem + ".ply-frames"));
}

void PlySequenceRecorder::frame(const Frame& frame) {
    const Surface& surface = *plan_.surface;
    Bytes bytes;
    append_text(bytes, ply_head(surface, frame.time));
    bytes.reserve(bytes.size() + 32 * surface.vertex_count() + 17 * surface.faces.size());
    append_vertices(bytes, surface, frame);
    append_faces(bytes, surface);

    names_.push_back(fmt::format("{}.{:04}.ply", plan_.stem, names_.size()));
    OutputFile file = folder_->open(names_.back());
    file.write(bytes);
    file.commit();
}

std::vector<std::filesystem::path> PlySequenceRecorder::finish() {
    folder_->commit();
    std::vector<std::filesystem::path> files;
    for (const std::string& name : names_) files.push_back(folder_->file(name));
    return files;
}

}  // namespace weft
