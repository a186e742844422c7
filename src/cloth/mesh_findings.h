// Remarks on a mesh, for people: what its report counts, in words and with the first places.
#pragma once

#include <span>
#include <vector>

#include "cloth/mesh_cloth.h"
#include "cloth/mesh_topology.h"
#include "cloth/mesh_weld.h"

namespace weft {

/// What the steps of building a mesh cloth found. Faces are those of the mesh, from 0.
struct MeshFindings {
    const Mesh& mesh;
    const MeshWeld& weld;
    std::span<const std::uint32_t> twins;  ///< [face of the mesh]
    std::span<const ParticleFace> faces;   ///< those kept
    std::span<const double> face_areas;    ///< [kept face], 0 for a face without area
    const EdgeTable& table;
    std::span<const std::uint32_t> pieces;  ///< lowest particle of each
};

/// Fills in the counts and the lines of the report.
void report_findings(const MeshFindings& found, std::span<const Vec3d> positions,
                     MeshReport& report);

}  // namespace weft
