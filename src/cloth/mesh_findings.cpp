#include "cloth/mesh_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "cloth/mesh_check.h"
#include "cloth/mesh_surface.h"

namespace weft {

namespace {

/// "1 face is", "3 faces are".
std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::size_t vertex_of(const MeshFindings& found, std::uint32_t particle) {
    return vertex_number(found.mesh, found.weld.first_vertex[particle]);
}

void report_cut_polygons(const MeshFindings& found, MeshReport& report) {
    const auto& sources = found.mesh.source_faces;
    std::size_t polygons = 0, first = 0;
    for (std::size_t f = 1; f < sources.size(); ++f)
        if (sources[f] == sources[f - 1] && (f < 2 || sources[f - 2] != sources[f]))
            if (++polygons == 1) first = f;
    if (polygons == 0) return;
    report.findings.push_back(
        fmt::format("{} more than four corners: cut into triangles, no shear springs; the first is "
                    "face {}",
                    counted(polygons, "face has", "faces have"), face_number(found.mesh, first)));
}

void report_vertices(const MeshFindings& found, MeshReport& report) {
    const auto& particle = found.weld.vertex_particle;
    report.welded_vertices = found.weld.welded_vertices;
    report.unused_vertices = found.weld.unused_vertices;
    if (report.welded_vertices > 0) {
        std::size_t v = 0;
        while (particle[v] == MeshWeld::unused || found.weld.first_vertex[particle[v]] == v) ++v;
        report.findings.push_back(fmt::format(
            "{} in the place of an earlier one: welded to it; the first is vertex {} (with "
            "vertex {})",
            counted(report.welded_vertices, "vertex is", "vertices are"),
            vertex_number(found.mesh, v), vertex_of(found, particle[v])));
    }
    if (report.unused_vertices > 0) {
        const auto first = std::find(particle.begin(), particle.end(), MeshWeld::unused);
        report.findings.push_back(fmt::format(
            "{} in no face: left out; the first is vertex {}",
            counted(report.unused_vertices, "vertex is", "vertices are"),
            vertex_number(found.mesh, static_cast<std::size_t>(first - particle.begin()))));
    }
}

void report_twins(const MeshFindings& found, MeshReport& report) {
    std::size_t first = 0;
    for (std::size_t f = 0; f < found.twins.size(); ++f)
        if (found.twins[f] != f && ++report.duplicate_faces == 1) first = f;
    if (report.duplicate_faces == 0) return;
    report.findings.push_back(fmt::format(
        "{} the corners of an earlier face: left out; the first is face {} (as face {})",
        counted(report.duplicate_faces, "face has", "faces have"), face_number(found.mesh, first),
        face_number(found.mesh, found.twins[first])));
}

void report_areas(const MeshFindings& found, MeshReport& report) {
    std::size_t first = 0;
    for (std::size_t f = 0; f < found.face_areas.size(); ++f)
        if (found.face_areas[f] == 0.0 && ++report.degenerate_faces == 1)
            first = found.faces[f].source;
    if (report.degenerate_faces == 0) return;
    report.findings.push_back(
        fmt::format("{} no area: springs, but no mass and no air force; the first is face {}",
                    counted(report.degenerate_faces, "face has", "faces have"),
                    face_number(found.mesh, first)));
}

bool faces_disagree(const MeshFindings& found, const MeshEdge& edge) {
    if (edge.uses != 2) return false;
    const auto uses = found.table.uses_of(edge);
    return found.faces[uses[0].face].particle[uses[0].corner] ==
           found.faces[uses[1].face].particle[uses[1].corner];
}

std::string ends_of(const MeshFindings& found, const MeshEdge& edge) {
    return fmt::format("vertices {} and {}", vertex_of(found, edge.ends.p),
                       vertex_of(found, edge.ends.q));
}

void report_edges(const MeshFindings& found, MeshReport& report) {
    const MeshEdge* crowded = nullptr;
    const MeshEdge* turned = nullptr;
    std::size_t turned_edges = 0;
    for (const MeshEdge& edge : found.table.edges) {
        if (edge.uses == 1) ++report.border_edges;
        if (edge.uses > 2 && ++report.non_manifold_edges == 1) crowded = &edge;
        if (faces_disagree(found, edge) && ++turned_edges == 1) turned = &edge;
    }
    if (crowded)
        report.findings.push_back(fmt::format(
            "{} in three or more faces: no bend spring crosses there; the first joins {}",
            counted(report.non_manifold_edges, "edge is", "edges are"), ends_of(found, *crowded)));
    if (turned)
        report.findings.push_back(fmt::format(
            "{} faces that show opposite sides: shading breaks there; the first joins {}",
            counted(turned_edges, "edge joins", "edges join"), ends_of(found, *turned)));
}

}  // namespace

void report_findings(const MeshFindings& found, std::span<const Vec3d> positions,
                     MeshReport& report) {
    report.vertices = found.mesh.positions.size();
    report.faces = found.mesh.faces.size();
    report.quads = static_cast<std::size_t>(
        std::count_if(found.mesh.faces.begin(), found.mesh.faces.end(),
                      [](const Mesh::Face& face) { return face.corners == 4; }));
    report.triangles = report.faces - report.quads;
    report.particles = positions.size();
    report.pieces = found.pieces.size();
    report_cut_polygons(found, report);
    report_vertices(found, report);
    report_twins(found, report);
    report_areas(found, report);
    report_edges(found, report);
    if (report.pieces > 1)
        report.findings.push_back(fmt::format("the mesh is in {} pieces; the second has vertex {}",
                                              report.pieces, vertex_of(found, found.pieces[1])));
    if (found.mesh.uvs.empty())
        report.findings.push_back(
            fmt::format("no texture co-ordinates: they follow {}", planar_axes(positions)));
}

}  // namespace weft
