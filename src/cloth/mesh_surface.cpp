#include "cloth/mesh_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

namespace weft {

namespace {

using Uv = std::array<float, 2>;

struct Box {
    Vec3d low, extent;
};

Box box_of(std::span<const Vec3d> positions) {
    Vec3d low = positions[0], high = positions[0];
    for (const Vec3d p : positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return {low, high - low};
}

enum class PlanarAxes { xy, xz, zy };

PlanarAxes choose_axes(Vec3d extent) {
    if (extent.z <= extent.x && extent.z <= extent.y) return PlanarAxes::xy;
    return extent.y <= extent.x ? PlanarAxes::xz : PlanarAxes::zy;
}

/// v follows y upward; on a mesh that lies, it falls along z, as seen from above.
std::vector<Uv> planar_uvs(std::span<const Vec3d> positions) {
    const auto [low, extent] = box_of(positions);
    const PlanarAxes axes = choose_axes(extent);
    const auto part = [](double x, double from, double size) {
        return size > 0 ? static_cast<float>((x - from) / size) : 0.0f;
    };
    std::vector<Uv> uvs;
    uvs.reserve(positions.size());
    for (const Vec3d p : positions) {
        const float x = part(p.x, low.x, extent.x), y = part(p.y, low.y, extent.y);
        const float z = part(p.z, low.z, extent.z);
        if (axes == PlanarAxes::xy) uvs.push_back({x, y});
        if (axes == PlanarAxes::xz) uvs.push_back({x, 1.0f - z});
        if (axes == PlanarAxes::zy) uvs.push_back({z, y});
    }
    return uvs;
}

/// A corner of a face: which particle, with which texture co-ordinate.
struct FaceCorner {
    std::uint32_t face, corner;
    Uv uv;
};

/// The corners of all faces in the order of their particles; those of particle p stand from
/// start[p] to start[p + 1], sorted by texture co-ordinate.
struct CornersByParticle {
    std::vector<std::size_t> start;
    std::vector<FaceCorner> corners;
};

CornersByParticle sort_corners(const Mesh& mesh, std::span<const ParticleFace> faces,
                               std::size_t particle_count) {
    CornersByParticle sorted;
    sorted.start.assign(particle_count + 1, 0);
    for (const ParticleFace& face : faces)
        for (std::uint32_t k = 0; k < face.corners; ++k) ++sorted.start[face.particle[k] + 1];
    std::partial_sum(sorted.start.begin(), sorted.start.end(), sorted.start.begin());
    sorted.corners.resize(sorted.start.back());
    std::vector<std::size_t> next(sorted.start.begin(), sorted.start.end() - 1);
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (std::uint32_t k = 0; k < faces[f].corners; ++k) {
            const Uv uv = mesh.uvs[mesh.faces[faces[f].source].uv[k]];
            sorted.corners[next[faces[f].particle[k]]++] = {f, k, uv};
        }
    for (std::size_t p = 0; p < particle_count; ++p)
        std::sort(sorted.corners.begin() + static_cast<std::ptrdiff_t>(sorted.start[p]),
                  sorted.corners.begin() + static_cast<std::ptrdiff_t>(sorted.start[p + 1]),
                  [](const FaceCorner& a, const FaceCorner& b) {
                      if (a.uv != b.uv) return a.uv < b.uv;
                      return a.face != b.face ? a.face < b.face : a.corner < b.corner;
                  });
    return sorted;
}

/// Makes the vertices and says which of them each corner of each face is.
std::vector<std::array<std::uint32_t, 4>> make_vertices(const Mesh& mesh,
                                                        std::span<const ParticleFace> faces,
                                                        Surface& surface) {
    std::vector<std::array<std::uint32_t, 4>> vertices(faces.size());
    const CornersByParticle sorted = sort_corners(mesh, faces, surface.particle_count);
    for (std::uint32_t p = 0; p < surface.particle_count; ++p)
        for (std::size_t k = sorted.start[p]; k < sorted.start[p + 1]; ++k) {
            const FaceCorner& corner = sorted.corners[k];
            if (k == sorted.start[p] || corner.uv != sorted.corners[k - 1].uv) {
                surface.vertex_particle.push_back(p);
                surface.uvs.push_back(corner.uv);
            }
            vertices[corner.face][corner.corner] =
                static_cast<std::uint32_t>(surface.uvs.size() - 1);
        }
    if (surface.uvs.size() == surface.particle_count) surface.vertex_particle.clear();
    return vertices;
}

}  // namespace

Surface build_mesh_surface(const Mesh& mesh, std::span<const ParticleFace> faces,
                           std::span<const Vec3d> positions) {
    Surface surface;
    surface.particle_count = positions.size();
    std::vector<std::array<std::uint32_t, 4>> seam_vertices;
    if (mesh.uvs.empty())
        surface.uvs = planar_uvs(positions);
    else
        seam_vertices = make_vertices(mesh, faces, surface);
    surface.faces.reserve(faces.size());
    surface.triangles.reserve(2 * faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        auto vertices = seam_vertices.empty() ? faces[f].particle : seam_vertices[f];
        if (faces[f].corners == 3) vertices[3] = Surface::no_vertex;
        surface.faces.push_back(vertices);
        const FaceTriangles triangles = cut_face(faces[f], positions);
        for (std::size_t t = 0; t < triangles.count; ++t) {
            const auto& corner = triangles.corner[t];
            surface.triangles.push_back(
                {vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]});
        }
    }
    return surface;
}

std::string_view planar_axes(std::span<const Vec3d> positions) {
    switch (choose_axes(box_of(positions).extent)) {
        case PlanarAxes::xy:
            return "x and y";
        case PlanarAxes::xz:
            return "x and z";
        case PlanarAxes::zy:
            break;
    }
    return "z and y";
}

std::vector<double> particle_areas(std::span<const ParticleFace> faces,
                                   std::span<const Vec3d> positions) {
    std::vector<double> areas(positions.size(), 0.0);
    for (const ParticleFace& face : faces) {
        const FaceTriangles triangles = cut_face(face, positions);
        for (std::size_t t = 0; t < triangles.count; ++t) {
            std::array<std::uint32_t, 3> p{};
            for (std::size_t k = 0; k < 3; ++k) p[k] = face.particle[triangles.corner[t][k]];
            const double area = 0.5 * length(cross(positions[p[1]] - positions[p[0]],
                                                   positions[p[2]] - positions[p[0]]));
            for (const std::uint32_t particle : p) areas[particle] += area / 3.0;
        }
    }
    return areas;
}

}  // namespace weft
