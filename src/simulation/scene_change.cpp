#include "simulation/scene_change.h"

#include <functional>
#include <memory>
#include <string>

#include "cloth/same_mesh.h"
#include "weft/error.h"

namespace weft {

namespace {

void require_same(bool same, const std::string& key) {
    if (same) return;
    throw scene_error(key, "another than the running one",
                      "the same in the middle of a run; begin another");
}

// Whether both are there and the same, or neither is.
template <typename Value, typename Same>
bool same_value(const std::shared_ptr<const Value>& a, const std::shared_ptr<const Value>& b,
                const Same& same) {
    return a == b || (a && b && same(*a, *b));
}

}  // namespace

SceneChange scene_change(const SceneDescription& from, const SceneDescription& to) {
    require_same(same_value(from.cloth.mesh, to.cloth.mesh, same_mesh), "cloth.mesh");
    if (!from.cloth.mesh) {
        const GridDescription &a = from.cloth.grid, &b = to.cloth.grid;
        require_same(a.resolution == b.resolution, "cloth.resolution");
        require_same(a.size == b.size, "cloth.size");
        require_same(a.plane == b.plane, "cloth.plane");
        require_same(a.origin == b.origin, "cloth.origin");
    }
    require_same(same_value(from.start.state, to.start.state, std::equal_to<>{}), "start.state");
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
