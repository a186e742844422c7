#include "simulation/scene_change.h"

#include <algorithm>
#include <string>

#include "weft/error.h"

namespace weft {

namespace {

void require_same(bool same, const std::string& key) {
    if (same) return;
    throw scene_error(key, "another than the running one",
                      "the same in the middle of a run; begin another");
}

bool same_faces(const Mesh& a, const Mesh& b) {
    const auto same = [](const Mesh::Face& f, const Mesh::Face& g) {
        return f.position == g.position && f.uv == g.uv && f.corners == g.corners;
    };
    return std::equal(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(), same);
}

// A file that was read again is the same mesh.
bool same_mesh(const SceneDescription& from, const SceneDescription& to) {
    const Mesh *const a = from.cloth.mesh.get(), *const b = to.cloth.mesh.get();
    if (a == b) return true;
    return a != nullptr && b != nullptr && a->positions == b->positions && a->uvs == b->uvs &&
           same_faces(*a, *b);
}

bool same_state(const StartDescription& from, const StartDescription& to) {
    const ClothState *const a = from.state.get(), *const b = to.state.get();
    return a == b || (a != nullptr && b != nullptr && *a == *b);
}

}  // namespace

SceneChange scene_change(const SceneDescription& from, const SceneDescription& to) {
    require_same(same_mesh(from, to), "cloth.mesh");
    if (!from.cloth.mesh) {
        const GridDescription &a = from.cloth.grid, &b = to.cloth.grid;
        require_same(a.resolution == b.resolution, "cloth.resolution");
        require_same(a.size == b.size, "cloth.size");
        require_same(a.plane == b.plane, "cloth.plane");
        require_same(a.origin == b.origin, "cloth.origin");
    }
    require_same(same_state(from.start, to.start), "start.state");
    require_same(from.start.time == to.start.time, "start.time");
    require_same(from.output.frames_per_second == to.output.frames_per_second,
                 "output.frames_per_second");
    require_same(from.integrator.precision == to.integrator.precision, "integrator.precision");
    SceneChange change;
    change.obstacles = from.obstacles != to.obstacles;
    change.integrator = from.integrator != to.integrator;
    change.forces = from.forces != to.forces || from.wind != to.wind ||
                    from.output.energy_balance != to.output.energy_balance;
    change.cloth = from.material != to.material || from.pins != to.pins;
    return change;
}

}  // namespace weft
