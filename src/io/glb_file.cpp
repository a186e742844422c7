// Binary glTF recordings read back: the mesh at rest plus its morph targets, weighted over time.
#include "io/glb_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "io/glb_accessor.h"

namespace weft {

namespace {

using nlohmann::json;

constexpr std::size_t triangles_mode = 4;
constexpr double most_frames = 1e6;

class GlbMotion final : public RecordedMotion {
public:
    explicit GlbMotion(const std::filesystem::path& path) : glb_(path) {
        find_animation();
        read_mesh();
        if (sampler_ != nullptr) read_animation();
    }

    void read(std::size_t frame, std::vector<Vec3d>& positions) const override;

private:
    void find_animation();
    [[nodiscard]] const json& primitive() const;
    void read_mesh();
    void read_triangles(const json& primitive);
    void merge_vertices(const std::vector<float>& rest);
    void read_animation();
    void set_frame_rate();
    void add_shape(std::size_t target, double weight, std::vector<Vec3d>& positions) const;
    /// Keyframe before a moment, and how far it is to the next, 0 to 1.
    [[nodiscard]] std::pair<std::size_t, double> key_before(double time) const;

    GlbContainer glb_;
    std::size_t mesh_ = 0;
    const json* animation_ = nullptr;
    const json* sampler_ = nullptr;
    bool stepwise_ = false;
    std::size_t vertex_count_ = 0;
    std::vector<Vec3d> rest_;                  ///< [particle], [m]
    std::vector<std::uint32_t> first_vertex_;  ///< [particle]
    std::vector<std::size_t> targets_;         ///< accessors of position differences
    std::vector<float> times_, weights_;       ///< [key] [s]; [key][target]
};

const json& part(const GlbContainer& glb, const json& object, const char* key) {
    if (!object.is_object() || !object.contains(key))
        throw glb.error(fmt::format("\"{}\" is missing", key));
    return object[key];
}

const json& element(const GlbContainer& glb, const json& object, const char* key,
                    std::size_t index) {
    const json& list = part(glb, object, key);
    if (!list.is_array() || index >= list.size())
        throw glb.error(fmt::format("\"{}\" has no element {}", key, index));
    return list[index];
}

void GlbMotion::find_animation() {
    const json& root = glb_.json();
    const std::size_t animations = root.contains("animations") && root["animations"].is_array()
                                       ? root["animations"].size()
                                       : 0;
    for (std::size_t i = 0; i < animations; ++i) {
        const json& animation = glb_.item("animations", i);
        for (const json& channel : part(glb_, animation, "channels")) {
            const json& target = part(glb_, channel, "target");
            if (part(glb_, target, "path") != "weights") continue;
            mesh_ = glb_.number(glb_.item("nodes", glb_.number(target, "node")), "mesh");
            animation_ = &animation;
            sampler_ = &element(glb_, animation, "samplers", glb_.number(channel, "sampler"));
            return;
        }
    }
}

const json& GlbMotion::primitive() const {
    return element(glb_, glb_.item("meshes", mesh_), "primitives", 0);
}

void GlbMotion::read_mesh() {
    const json& mesh = primitive();
    if (glb_.number_or(mesh, "mode", triangles_mode) != triangles_mode)
        throw glb_.error("its mesh is not made of triangles");
    const json& attributes = part(glb_, mesh, "attributes");
    const auto rest = glb_.floats(glb_.number(attributes, "POSITION"), "VEC3");
    vertex_count_ = rest.size() / 3;
    if (vertex_count_ == 0) throw glb_.error("its mesh has no vertices");
    surface.uvs.assign(vertex_count_, {0.0F, 0.0F});
    if (attributes.contains("TEXCOORD_0")) {
        const auto uvs = glb_.floats(glb_.number(attributes, "TEXCOORD_0"), "VEC2");
        if (uvs.size() != 2 * vertex_count_)
            throw glb_.error("texture co-ordinates and positions differ in number");
        for (std::size_t v = 0; v < vertex_count_; ++v)
            surface.uvs[v] = {uvs[2 * v], 1.0F - uvs[2 * v + 1]};
    }
    merge_vertices(rest);
    read_triangles(mesh);
    frame_count = 1;
}

void GlbMotion::merge_vertices(const std::vector<float>& rest) {
    std::map<std::array<float, 3>, std::uint32_t> particle_at;
    for (std::uint32_t vertex = 0; vertex < vertex_count_; ++vertex) {
        const std::size_t at = 3 * std::size_t{vertex};
        const std::array place{rest[at], rest[at + 1], rest[at + 2]};
        if (!std::ranges::all_of(place, [](float x) { return std::isfinite(x); }))
            throw glb_.error(fmt::format("the position of vertex {} is not finite", vertex));
        const auto next = static_cast<std::uint32_t>(rest_.size());
        const auto [entry, is_new] = particle_at.emplace(place, next);
        if (is_new) {
            rest_.push_back({place[0], place[1], place[2]});
            first_vertex_.push_back(vertex);
        }
        surface.vertex_particle.push_back(entry->second);
    }
    surface.particle_count = rest_.size();
}

void GlbMotion::read_triangles(const json& primitive) {
    std::vector<std::uint32_t> corners;
    if (primitive.contains("indices")) {
        corners = glb_.integers(glb_.number(primitive, "indices"));
    } else {
        for (std::uint32_t vertex = 0; vertex < vertex_count_; ++vertex) corners.push_back(vertex);
    }
    if (corners.empty() || corners.size() % 3 != 0)
        throw glb_.error(fmt::format("{} corners do not make triangles", corners.size()));
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const std::array triangle{corners[i], corners[i + 1], corners[i + 2]};
        for (const std::uint32_t vertex : triangle)
            if (vertex >= vertex_count_)
                throw glb_.error(
                    fmt::format("a triangle names vertex {} of {}", vertex, vertex_count_));
        surface.triangles.push_back(triangle);
        surface.faces.push_back({triangle[0], triangle[1], triangle[2], Surface::no_vertex});
    }
}

void GlbMotion::read_animation() {
    const std::string interpolation = sampler_->value("interpolation", "LINEAR");
    if (interpolation != "LINEAR" && interpolation != "STEP")
        throw glb_.error(
            fmt::format("{} animations are not read: LINEAR and STEP are", interpolation));
    stepwise_ = interpolation == "STEP";
    const json& mesh = primitive();
    for (const json& target : part(glb_, mesh, "targets")) {
        targets_.push_back(glb_.number(target, "POSITION"));
        if (glb_.count(targets_.back()) != vertex_count_)
            throw glb_.error(fmt::format("morph target {} has {} vertices: the mesh has {}",
                                         targets_.size() - 1, glb_.count(targets_.back()),
                                         vertex_count_));
    }
    times_ = glb_.floats(glb_.number(*sampler_, "input"), "SCALAR");
    weights_ = glb_.floats(glb_.number(*sampler_, "output"), "SCALAR");
    if (times_.empty() || weights_.size() != times_.size() * targets_.size())
        throw glb_.error(
            fmt::format("{} keyframes of {} morph targets need as many weights: {} are there",
                        times_.size(), targets_.size(), weights_.size()));
    for (std::size_t key = 0; key < times_.size(); ++key)
        if (!std::isfinite(times_[key]) || (key > 0 && times_[key] <= times_[key - 1]))
            throw glb_.error(fmt::format("the time of keyframe {} does not rise", key));
    set_frame_rate();
}

void GlbMotion::set_frame_rate() {
    const double span = double{times_.back()} - double{times_.front()};
    if (times_.size() > 1) frames_per_second = static_cast<double>(times_.size() - 1) / span;
    // weft's own files say how they were recorded: thinned ones have fewer keyframes than frames.
    if (animation_->contains("extras") && (*animation_)["extras"].is_object()) {
        const json& rate = (*animation_)["extras"].value("frames_per_second", json());
        if (rate.is_number() && rate.get<double>() > 0.0) frames_per_second = rate.get<double>();
    }
    const double frames = std::round(span * frames_per_second) + 1.0;
    if (!(frames <= most_frames))
        throw glb_.error(fmt::format("{} s at {} frames per second are too many frames: at most {}",
                                     span, frames_per_second, most_frames));
    frame_count = static_cast<std::size_t>(frames);
}

std::pair<std::size_t, double> GlbMotion::key_before(double time) const {
    // Keyframe times are floats: a moment this near to one is meant to be on it.
    const double tolerance = 1e-3 / frames_per_second;
    const auto after = std::upper_bound(times_.begin(), times_.end(), time + tolerance);
    if (after == times_.begin()) return {0, 0.0};
    const auto key = static_cast<std::size_t>(after - times_.begin()) - 1;
    if (after == times_.end() || time - double{times_[key]} <= tolerance || stepwise_)
        return {key, 0.0};
    return {key, (time - double{times_[key]}) / (double{times_[key + 1]} - double{times_[key]})};
}

void GlbMotion::add_shape(std::size_t target, double weight, std::vector<Vec3d>& positions) const {
    const auto moves = glb_.floats(targets_[target], "VEC3");
    for (std::size_t particle = 0; particle < positions.size(); ++particle) {
        const std::size_t at = 3 * std::size_t{first_vertex_[particle]};
        positions[particle] += weight * Vec3d{moves[at], moves[at + 1], moves[at + 2]};
    }
}

void GlbMotion::read(std::size_t frame, std::vector<Vec3d>& positions) const {
    positions = rest_;
    if (times_.empty()) return;
    const double time = double{times_.front()} + static_cast<double>(frame) / frames_per_second;
    const auto [key, blend] = key_before(time);
    for (std::size_t target = 0; target < targets_.size(); ++target) {
        double weight = (1.0 - blend) * double{weights_[key * targets_.size() + target]};
        if (blend > 0.0) weight += blend * double{weights_[(key + 1) * targets_.size() + target]};
        if (weight != 0.0) add_shape(target, weight, positions);
    }
}

}  // namespace

std::unique_ptr<RecordedMotion> open_glb(const std::filesystem::path& path) {
    try {
        return std::make_unique<GlbMotion>(path);
    } catch (const json::exception& problem) {
        throw file_error(path.string(),
                         std::string("its JSON has the wrong shape: ") + problem.what());
    }
}

}  // namespace weft
