// Animated meshes as binary glTF 2.0: 12 bytes of head, the JSON chunk, the binary chunk.
#include "io/glb_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>

#include "render/image.h"
#include "weft/error.h"
#include "weft/version.h"

namespace weft {

namespace {

constexpr std::uint32_t magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr std::uint64_t chunk_head = 8, file_head = 12;
constexpr std::uint64_t most_bytes = std::numeric_limits<std::uint32_t>::max();

/// glTF wants unit normals; where a frame has none (all triangles around have no area), up will do.
Vec3f unit_normal(Vec3f normal) {
    return normal == Vec3f{} ? Vec3f{0.0F, 1.0F, 0.0F} : normal;
}

bool outside_unit_square(const std::array<float, 2>& uv) {
    return !(uv[0] >= 0.0F && uv[0] <= 1.0F && uv[1] >= 0.0F && uv[1] <= 1.0F);
}

void widen(GlbBounds& bounds, Vec3f point, bool first) {
    const std::array<float, 3> values{point.x, point.y, point.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bounds.low[axis] = first ? values[axis] : std::min(bounds.low[axis], values[axis]);
        bounds.high[axis] = first ? values[axis] : std::max(bounds.high[axis], values[axis]);
    }
}

void append_vector(Bytes& bytes, Vec3f vector) {
    append_little(bytes, vector.x);
    append_little(bytes, vector.y);
    append_little(bytes, vector.z);
}

}  // namespace

void GlbRecorder::begin(const RecordingPlan& plan) {
    plan_ = plan;
    const Surface& surface = *plan.surface;
    const std::vector<std::uint8_t> picture = encode_png(load_texture(plan.render.texture));
    content_.title = plan.title;
    content_.generator = "weft " WEFT_VERSION;
    content_.vertex_count = surface.vertex_count();
    content_.index_count = 3 * surface.triangles.size();
    content_.picture_bytes = picture.size();
    content_.repeat_texture = std::ranges::any_of(surface.uvs, outside_unit_square);
    content_.frames_per_second = plan.frames_per_second;
    selection_.emplace(plan.frame_count, frames_that_fit(picture.size()));
    file_.emplace(plan.directory / (plan.stem + ".glb"));
    reserve_json();
    write_constant_part(picture);
}

std::size_t GlbRecorder::frames_that_fit(std::size_t picture_bytes) const {
    constexpr std::uint64_t json_bytes = std::uint64_t{1} << 20;  // more than 250 targets need
    const std::uint64_t frame_bytes = 24 * std::uint64_t{content_.vertex_count};
    const std::uint64_t others = json_bytes + picture_bytes +
                                 4 * std::uint64_t{content_.index_count} +
                                 8 * std::uint64_t{content_.vertex_count};
    if (others + 2 * frame_bytes > most_bytes)
        throw file_error((plan_.directory / (plan_.stem + ".glb")).string(),
                         fmt::format("{} vertices are too many for glTF, whose files end at 4 GiB",
                                     content_.vertex_count));
    return std::min<std::uint64_t>(most_targets + 1, (most_bytes - others) / frame_bytes);
}

void GlbRecorder::reserve_json() {
    // The longest JSON there can be: every planned frame, and numbers that print in most digits.
    constexpr float longest = -1.17549435e-38F;
    GlbContent widest = content_;
    const std::size_t shapes = selection_->kept_of_all();
    widest.bounds.assign(shapes, {{longest, longest, longest}, {longest, longest, longest}});
    widest.frame_index.assign(shapes, plan_.frame_count);
    widest.frames_recorded = plan_.frame_count;
    widest.first_time = widest.last_time = longest;
    json_room_ = glb_padded(glb_json(widest).size());
    file_->seek(file_head + chunk_head + json_room_ + chunk_head);
}

void GlbRecorder::write_binary(const Bytes& bytes) {
    file_->write(bytes);
    binary_bytes_ += bytes.size();
}

void GlbRecorder::write_constant_part(std::span<const std::uint8_t> picture) {
    const Surface& surface = *plan_.surface;
    Bytes bytes;
    bytes.reserve(12 * surface.triangles.size() + 8 * surface.uvs.size() + picture.size() + 4);
    for (const auto& triangle : surface.triangles)
        for (const std::uint32_t vertex : triangle) append_little(bytes, vertex);
    for (const auto& uv : surface.uvs) {
        append_little(bytes, uv[0]);
        append_little(bytes, 1.0F - uv[1]);
    }
    const auto raw = std::as_bytes(picture);
    bytes.insert(bytes.end(), raw.begin(), raw.end());
    bytes.resize(glb_padded(bytes.size()));
    write_binary(bytes);
}

void GlbRecorder::frame(const Frame& frame) {
    if (frames_seen_ >= std::max<std::size_t>(plan_.frame_count, 1))
        throw file_error(file_->path().string(), "more frames came than were planned");
    const std::size_t number = frames_seen_++;
    if (selection_->keep(number)) {
        held_.reset();
        write_shape(frame, number);
    } else {
        held_ = {.number = number,
                 .time = frame.time,
                 .positions = {frame.positions.begin(), frame.positions.end()},
                 .normals = {frame.normals.begin(), frame.normals.end()}};
    }
}

void GlbRecorder::write_shape(const Frame& frame, std::size_t number) {
    write_positions(frame.positions);
    write_normals(frame.normals);
    content_.frame_index.push_back(number);
    times_.push_back(static_cast<float>(frame.time));
}

void GlbRecorder::write_positions(std::span<const Vec3d> positions) {
    const bool is_rest = rest_positions_.empty();
    if (is_rest)
        for (const Vec3d& position : positions)
            rest_positions_.push_back(vec3_cast<float>(position));
    const Surface& surface = *plan_.surface;
    Bytes bytes;
    bytes.reserve(12 * surface.vertex_count());
    GlbBounds bounds;
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        const std::uint32_t particle = surface.particle(vertex);
        const Vec3f rest = rest_positions_[particle];
        // The difference from the rest position as the file has it: its rounding does not add up.
        const Vec3f point =
            is_rest ? rest : vec3_cast<float>(positions[particle] - vec3_cast<double>(rest));
        widen(bounds, point, vertex == 0);
        append_vector(bytes, point);
    }
    write_binary(bytes);
    content_.bounds.push_back(bounds);
}

void GlbRecorder::write_normals(std::span<const Vec3f> normals) {
    const bool is_rest = rest_normals_.empty();
    if (is_rest)
        for (const Vec3f& normal : normals) rest_normals_.push_back(unit_normal(normal));
    const Surface& surface = *plan_.surface;
    Bytes bytes;
    bytes.reserve(12 * surface.vertex_count());
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        const std::uint32_t particle = surface.particle(vertex);
        const Vec3f rest = rest_normals_[particle];
        append_vector(bytes, is_rest ? rest : unit_normal(normals[particle]) - rest);
    }
    write_binary(bytes);
}

void GlbRecorder::write_animation() {
    const std::size_t targets = times_.size() - 1;
    if (targets == 0) return;
    Bytes bytes;
    for (const float time : times_) append_little(bytes, time);
    for (std::size_t key = 1; key <= targets; ++key)
        append_little(bytes, static_cast<std::uint32_t>(key * targets + key - 1));
    for (std::size_t key = 1; key <= targets; ++key) append_little(bytes, 1.0F);
    write_binary(bytes);
}

std::vector<std::filesystem::path> GlbRecorder::finish() {
    if (held_)
        write_shape({.index = held_->number,
                     .time = held_->time,
                     .positions = held_->positions,
                     .velocities = {},
                     .normals = held_->normals},
                    held_->number);
    write_animation();
    content_.frames_recorded = frames_seen_;
    content_.first_time = times_.front();
    content_.last_time = times_.back();
    std::string text = glb_json(content_);
    assert(text.size() <= json_room_);
    text.resize(json_room_, ' ');

    const std::uint64_t total = file_head + 2 * chunk_head + json_room_ + binary_bytes_;
    Bytes head, binary_head;
    for (const std::uint64_t value :
         {std::uint64_t{magic}, std::uint64_t{2}, total, json_room_, std::uint64_t{json_chunk}})
        append_little(head, static_cast<std::uint32_t>(value));
    for (const std::uint64_t value : {binary_bytes_, std::uint64_t{binary_chunk}})
        append_little(binary_head, static_cast<std::uint32_t>(value));
    file_->seek(0);
    file_->write(head);
    file_->write(text);
    file_->write(binary_head);
    file_->commit();
    return {file_->path()};
}

std::vector<std::string> GlbRecorder::warnings() const {
    if (frames_seen_ <= content_.bounds.size()) return {};
    return {fmt::format("{}.glb: {} frames thinned to {} (at most {} morph targets, 4 GiB)",
                        plan_.stem, frames_seen_, content_.bounds.size(), most_targets)};
}

}  // namespace weft
