// Point caches read back: both formats are a head and an array [frame, particle, 3] of floats.
#include "io/point_cache_file.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <unordered_map>
#include <utility>

#include "io/byte_order.h"
#include "io/input_file.h"
#include "io/mesh_file.h"

namespace weft {

namespace {

template <std::endian order>
class PointCache final : public RecordedMotion {
public:
    PointCache(InputFile file, std::uint64_t head_bytes)
        : file_(std::move(file)), head_bytes_(head_bytes) {}

    void read(std::size_t frame, std::vector<Vec3d>& positions) const override {
        const std::uint64_t frame_bytes = 12 * std::uint64_t{surface.particle_count};
        const Bytes bytes = file_.read(head_bytes_ + frame * frame_bytes, frame_bytes);
        positions.resize(surface.particle_count);
        for (std::size_t particle = 0; particle < positions.size(); ++particle) {
            const auto component = [&](std::size_t axis) -> double {
                return number_at<order, float>(bytes, 12 * particle + 4 * axis);
            };
            positions[particle] = {component(0), component(1), component(2)};
        }
    }

private:
    InputFile file_;
    std::uint64_t head_bytes_;
};

/// A vertex for every pair of position and texture co-ordinate that a face uses.
Surface surface_of(const Mesh& mesh) {
    Surface surface;
    surface.particle_count = mesh.positions.size();
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    for (const Mesh::Face& face : mesh.faces) {
        std::array<std::uint32_t, 4> vertices;
        vertices.fill(Surface::no_vertex);
        for (std::size_t corner = 0; corner < static_cast<std::size_t>(face.corners); ++corner) {
            const std::uint32_t position = face.position[corner];
            const std::uint32_t uv = mesh.uvs.empty() ? 0 : face.uv[corner];
            const auto next = static_cast<std::uint32_t>(surface.uvs.size());
            const auto [entry, is_new] = known.emplace(std::uint64_t{position} << 32 | uv, next);
            if (is_new) {
                surface.vertex_particle.push_back(position);
                surface.uvs.push_back(mesh.uvs.empty() ? std::array{0.0F, 0.0F} : mesh.uvs[uv]);
            }
            vertices[corner] = entry->second;
        }
        surface.faces.push_back(vertices);
        surface.triangles.push_back({vertices[0], vertices[1], vertices[2]});
        if (face.corners == 4) surface.triangles.push_back({vertices[0], vertices[2], vertices[3]});
    }
    return surface;
}

/// What CacheCompanions notes in the head of the mesh; nothing where another program wrote it.
std::optional<double> noted_frame_rate(const std::filesystem::path& mesh) {
    constexpr std::string_view key = "# frames_per_second ";
    std::ifstream file(mesh);
    for (std::string line; std::getline(file, line) && line.starts_with('#');) {
        double rate = 0.0;
        if (!line.starts_with(key)) continue;
        std::from_chars(line.data() + key.size(), line.data() + line.size(), rate);
        if (std::isfinite(rate) && rate > 0.0) return rate;
    }
    return {};
}

/// The rate that a table of times implies; nothing where it is no rising table.
std::optional<double> rate_of(const std::vector<float>& times) {
    if (times.size() < 2) return {};
    const double span = double{times.back()} - double{times.front()};
    if (!std::isfinite(span) || span <= 0.0) return {};
    return static_cast<double>(times.size() - 1) / span;
}

struct CacheHead {
    std::uint64_t bytes = 0;
    std::int32_t particles = 0, frames = 0;
};

void check_size(const InputFile& file, const CacheHead& head) {
    if (head.particles < 1 || head.frames < 1)
        throw file.error(
            fmt::format("its head names {} particles and {} frames: at least 1 of each is needed",
                        head.particles, head.frames));
    const std::uint64_t expected = head.bytes + 12 * static_cast<std::uint64_t>(head.particles) *
                                                    static_cast<std::uint64_t>(head.frames);
    if (file.size() != expected)
        throw file.error(fmt::format("has {} bytes: {} particles and {} frames make {}",
                                     file.size(), head.particles, head.frames, expected));
}

template <std::endian order>
std::unique_ptr<RecordedMotion> open_cache(InputFile file, const CacheHead& head,
                                           std::optional<double> table_rate) {
    const std::filesystem::path mesh_path =
        std::filesystem::path(file.path()).replace_extension(".obj");
    Surface surface = surface_of(load_mesh(mesh_path));
    if (surface.particle_count != static_cast<std::size_t>(head.particles))
        throw file.error(fmt::format("moves {} particles, but {} has {} vertices", head.particles,
                                     mesh_path.string(), surface.particle_count));
    auto cache = std::make_unique<PointCache<order>>(std::move(file), head.bytes);
    cache->surface = std::move(surface);
    cache->frame_count = static_cast<std::size_t>(head.frames);
    const auto noted = noted_frame_rate(mesh_path);
    cache->frames_per_second = noted ? *noted : table_rate.value_or(30.0);
    return cache;
}

}  // namespace

std::unique_ptr<RecordedMotion> open_pc2(const std::filesystem::path& path) {
    InputFile file(path);
    const Bytes bytes = file.read(0, 32);
    Bytes signature;
    append_text(signature, std::string_view("POINTCACHE2\0", 12));
    if (!std::equal(signature.begin(), signature.end(), bytes.begin()))
        throw file.error("not a PC2 point cache: it does not begin with POINTCACHE2");
    const auto version = number_at<std::endian::little, std::int32_t>(bytes, 12);
    if (version != 1) throw file.error(fmt::format("PC2 version {} is not known: 1 is", version));
    const CacheHead head{.bytes = 32,
                         .particles = number_at<std::endian::little, std::int32_t>(bytes, 16),
                         .frames = number_at<std::endian::little, std::int32_t>(bytes, 28)};
    check_size(file, head);
    return open_cache<std::endian::little>(std::move(file), head, {});
}

std::unique_ptr<RecordedMotion> open_mdd(const std::filesystem::path& path) {
    InputFile file(path);
    const Bytes bytes = file.read(0, 8);
    const auto frames = number_at<std::endian::big, std::int32_t>(bytes, 0);
    const CacheHead head{.bytes = 8 + 4 * static_cast<std::uint64_t>(std::max(frames, 0)),
                         .particles = number_at<std::endian::big, std::int32_t>(bytes, 4),
                         .frames = frames};
    check_size(file, head);
    const Bytes table = file.read(8, head.bytes - 8);
    std::vector<float> times;
    for (std::size_t at = 0; at < table.size(); at += 4)
        times.push_back(number_at<std::endian::big, float>(table, at));
    return open_cache<std::endian::big>(std::move(file), head, rate_of(times));
}

}  // namespace weft
