// What stands beside a point cache: OBJ and Blender script.
#include "io/cache_companions.h"

#include <fmt/format.h>

#include <system_error>

#include "io/blender_script.h"
#include "io/obj_writer.h"

namespace weft {

CacheCompanions::CacheCompanions(const RecordingPlan& plan)
    : plan_(plan),
      mesh_(plan.directory / (plan.stem + ".obj")),
      script_(plan.directory / "open_in_blender.py"),
      opened_(script_.last_write_time()) {}

void CacheCompanions::write_mesh(const Frame& first) {
    // A point cache does not say how fast it plays; recording_file.cpp reads this line back.
    const std::string comment = fmt::format(
        "# Frame 0 of a cloth recording; point caches beside it move its vertices.\n"
        "# frames_per_second {}\n",
        plan_.frames_per_second);
    std::vector<Vec3d> positions(first.positions.begin(), first.positions.end());
    for (const Vec3f& position : first.rounded_positions) {
        if (first.positions.empty()) positions.push_back(vec3_cast<double>(position));
    }
    write_obj(mesh_, comment, *plan_.surface, positions, {});
}

void CacheCompanions::close(const std::string& cache, std::size_t frames) {
    script_.write(blender_script({.title = plan_.title,
                                  .mesh = mesh_.path().filename().string(),
                                  .cache = cache,
                                  .points = plan_.surface->particle_count,
                                  .frames = frames,
                                  .frames_per_second = plan_.frames_per_second}));
    mesh_.close();
    script_.close();
}

std::vector<std::filesystem::path> CacheCompanions::commit() {
    mesh_.commit();
    script_.commit();
    return {mesh_.path(), script_.path()};
}

bool CacheCompanions::is_of_this_run(const std::filesystem::path& path) const {
    std::error_code problem;
    const auto written = std::filesystem::last_write_time(path, problem);
    return !problem && written >= opened_;
}

}  // namespace weft
