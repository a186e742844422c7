// A folder of files that appears whole or not at all.
#pragma once

#include <filesystem>
#include <string>

#include "io/output_file.h"

namespace weft {

/// Files are written into a temporary folder beside `path`, which takes that name when committed; a
/// folder of an earlier run is replaced. Destroyed before commit(), it removes what was written.
class OutputFolder {
public:
    /// @throws Error (file) where the folder cannot be made, or `path` is not a folder.
    explicit OutputFolder(std::filesystem::path path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// Opens the file `name` inside; errors name it as it will stand. @throws Error (file).
    [[nodiscard]] OutputFile open(const std::string& name) const;
    /// Where the file `name` is now, for programs that write it themselves; after commit() it is
    /// path() / name.
    [[nodiscard]] std::filesystem::path file(const std::string& name) const;
    /// @throws Error (file).
    void commit();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_, temporary_;
};

}  // namespace weft
