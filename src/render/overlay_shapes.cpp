// Filling the lists of lines and points.
#include "render/overlay_shapes.h"

#include <algorithm>
#include <cmath>

namespace weft {

namespace {

using Colour = std::array<std::uint8_t, 4>;

constexpr Colour wire{20, 26, 38, 255};
constexpr Colour particle_colour{255, 244, 214, 255};
constexpr Colour normal_foot{0, 74, 62, 255}, normal_tip{60, 214, 168, 255};
constexpr Colour pin_colour{255, 190, 0, 255};
constexpr Colour wind_tail{176, 64, 208, 90}, wind_head{176, 64, 208, 240};

/// Reads a frame's positions in float, from whichever list it has.
class Places {
public:
    explicit Places(const Frame& frame)
        : exact_(frame.positions.data()),
          rounded_(frame.rounded_positions.empty() ? nullptr : frame.rounded_positions.data()) {}

    glm::vec3 operator[](std::size_t particle) const {
        if (rounded_ == nullptr) return to_glm(exact_[particle]);
        const Vec3f& p = rounded_[particle];
        return {p.x, p.y, p.z};
    }

private:
    const Vec3d* exact_;
    const Vec3f* rounded_;
};

std::size_t particle_count(const Frame& frame) {
    return std::max(frame.positions.size(), frame.rounded_positions.size());
}

/// Makes room for `count` more, at once and not over and over.
void reserve_more(OverlayList& list, std::size_t count) {
    if (list.capacity() < list.size() + count)
        list.reserve(std::max(list.size() + count, 2 * list.capacity()));
}

/// The ends of springs. Bending springs run beside the structural ones that they span, as far as
/// the frame's normals say where that is; else they would hide them.
class SpringEnds {
public:
    explicit SpringEnds(const Frame& frame) : places_(frame), normals_(frame.normals) {}

    std::array<glm::vec3, 2> operator()(const DrawnSpring& spring) const {
        const glm::vec3 p = places_[spring.p], q = places_[spring.q];
        if (spring.kind != bend || normals_.empty()) return {p, q};
        const Vec3f &a = normals_[spring.p], &b = normals_[spring.q];
        const glm::vec3 normal{a.x + b.x, a.y + b.y, a.z + b.z};
        const glm::vec3 aside = 0.5F * beside * glm::cross(normal, q - p);
        return {p + aside, q + aside};
    }

private:
    static constexpr std::uint8_t bend = 2;
    static constexpr float beside = 0.07F;  // of its length

    Places places_;
    std::span<const Vec3f> normals_;
};

bool is_drawn(SpringKinds kinds, std::uint8_t kind) {
    return kind == 0 ? kinds.structural : (kind == 1 ? kinds.shear : kinds.bend);
}

/// colour_of_strain() by table, since a sheet has hundreds of thousands of springs.
class StrainColours {
public:
    explicit StrainColours(float range) : scale_(half / range) {
        for (int i = 0; i <= 2 * half; ++i)
            table_[static_cast<std::size_t>(i)] =
                colour_of_strain(static_cast<float>(i - half) / static_cast<float>(half), 1.0F);
    }
    [[nodiscard]] Colour operator()(float strain) const {
        const float place = std::clamp(strain * scale_, -1.0F * half, 1.0F * half);
        // What is no number is shown as the worst, as there.
        const int nearest = place == place ? static_cast<int>(place + half + 0.5F) : 2 * half;
        return table_[static_cast<std::size_t>(nearest)];
    }

private:
    static constexpr int half = 127;
    float scale_;
    std::array<Colour, 2 * half + 1> table_{};
};

}  // namespace

std::vector<std::array<std::uint32_t, 2>> edges_of(const Surface& surface) {
    std::vector<std::array<std::uint32_t, 2>> edges;
    edges.reserve(4 * surface.faces.size());
    for (const auto& face : surface.faces) {
        const std::size_t corners = face[3] == Surface::no_vertex ? 3 : 4;
        for (std::size_t i = 0; i < corners; ++i) {
            const std::uint32_t p = surface.particle(face[i]);
            const std::uint32_t q = surface.particle(face[(i + 1) % corners]);
            if (p != q) edges.push_back({std::min(p, q), std::max(p, q)});
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

void add_wireframe(std::span<const std::array<std::uint32_t, 2>> edges, const Frame& frame,
                   OverlayList& lines) {
    const Places places(frame);
    reserve_more(lines, 2 * edges.size());
    for (const auto& [p, q] : edges) {
        lines.push_back({places[p], wire});
        lines.push_back({places[q], wire});
    }
}

void add_springs_by_strain(std::span<const DrawnSpring> springs, SpringKinds kinds,
                           const Frame& frame, float strain_range, OverlayList& lines) {
    const SpringEnds ends(frame);
    const StrainColours colours(strain_range);
    reserve_more(lines, 2 * springs.size());
    for (const DrawnSpring& spring : springs) {
        if (!is_drawn(kinds, spring.kind)) continue;
        const auto [p, q] = ends(spring);
        const Colour colour = colours(glm::distance(p, q) / spring.rest_length - 1.0F);
        lines.push_back({p, colour});
        lines.push_back({q, colour});
    }
}

void add_springs_by_kind(std::span<const DrawnSpring> springs, SpringKinds kinds,
                         const Frame& frame, OverlayList& lines) {
    const SpringEnds ends(frame);
    reserve_more(lines, 2 * springs.size());
    for (const DrawnSpring& spring : springs) {
        if (!is_drawn(kinds, spring.kind)) continue;
        const Colour colour = colour_of_kind(spring.kind);
        const auto [p, q] = ends(spring);
        lines.push_back({p, colour});
        lines.push_back({q, colour});
    }
}

void add_particles(const Frame& frame, OverlayList& points) {
    const Places places(frame);
    const std::size_t count = particle_count(frame);
    reserve_more(points, count);
    for (std::size_t p = 0; p < count; ++p) points.push_back({places[p], particle_colour});
}

void add_normals(const Frame& frame, float length, OverlayList& lines) {
    const Places places(frame);
    reserve_more(lines, 2 * frame.normals.size());
    for (std::size_t p = 0; p < frame.normals.size(); ++p) {
        const Vec3f& n = frame.normals[p];
        lines.push_back({places[p], normal_foot});
        lines.push_back({places[p] + length * glm::vec3(n.x, n.y, n.z), normal_tip});
    }
}

void add_pins(std::span<const std::uint32_t> pinned, const Frame& frame, OverlayList& points) {
    const Places places(frame);
    reserve_more(points, pinned.size());
    for (const std::uint32_t p : pinned) points.push_back({places[p], pin_colour});
}

void add_wind(const Box& around, glm::vec3 velocity, float seconds, OverlayList& lines) {
    const glm::vec3 way = seconds * velocity;
    if (!(glm::length(way) > 0.0F)) return;
    const glm::vec3 sides = around.high - around.low;
    const float longest = std::max({sides.x, sides.y, sides.z});
    const glm::vec3 low = around.low - 0.2F * longest, high = around.high + 0.2F * longest;
    std::array<int, 3> counts{};
    for (int axis = 0; axis < 3; ++axis) {
        const float parts = 3.0F * (high[axis] - low[axis]) / std::max(longest, 1e-6F);
        counts[static_cast<std::size_t>(axis)] = std::clamp(static_cast<int>(parts + 0.5F), 1, 4);
    }
    for (int i = 0; i <= counts[0]; ++i)
        for (int j = 0; j <= counts[1]; ++j)
            for (int k = 0; k <= counts[2]; ++k) {
                const glm::vec3 share{static_cast<float>(i) / static_cast<float>(counts[0]),
                                      static_cast<float>(j) / static_cast<float>(counts[1]),
                                      static_cast<float>(k) / static_cast<float>(counts[2])};
                const glm::vec3 middle = glm::mix(low, high, share);
                const std::size_t tail = lines.size();
                add_arrow(middle - 0.5F * way, middle + 0.5F * way, wind_head, lines);
                lines[tail].colour = wind_tail;
            }
}

void add_arrow(glm::vec3 from, glm::vec3 to, Colour colour, OverlayList& lines) {
    lines.push_back({from, colour});
    lines.push_back({to, colour});
    const float length = glm::distance(from, to);
    if (!(length > 0.0F)) return;
    const glm::vec3 along = (to - from) / length;
    const glm::vec3 other = std::abs(along.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 first = glm::normalize(glm::cross(along, other));
    const glm::vec3 second = glm::cross(along, first);
    const glm::vec3 neck = to - 0.24F * length * along;
    for (const glm::vec3& barb : {first, -first, second, -second}) {
        lines.push_back({to, colour});
        lines.push_back({neck + 0.09F * length * barb, colour});
    }
}

}  // namespace weft
