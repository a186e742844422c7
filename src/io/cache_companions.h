// What stands beside a point cache: the mesh it moves and the script that opens both in Blender.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/output_file.h"
#include "weft/recorder.h"

namespace weft {

/// NAME.obj (frame 0) and open_in_blender.py. Both point cache recorders write them; recorded
/// together they write the same mesh twice, and the script opens the PC2.
class CacheCompanions {
public:
    /// Opens the files. @throws Error (file).
    explicit CacheCompanions(const RecordingPlan& plan);

    void write_mesh(const Frame& first);  ///< @throws Error (file).
    /// Writes the script and closes both files under their temporary names.
    /// @param cache file name of the point cache.  @throws Error (file).
    void close(const std::string& cache, std::size_t frames);
    /// @return the files put in place.  @throws Error (file).
    std::vector<std::filesystem::path> commit();
    /// Whether `path` was last written since these files were opened.
    [[nodiscard]] bool is_of_this_run(const std::filesystem::path& path) const;

private:
    RecordingPlan plan_;
    OutputFile mesh_, script_;
    std::filesystem::file_time_type opened_;
};

}  // namespace weft
