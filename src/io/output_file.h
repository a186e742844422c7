// A file that appears whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string_view>

namespace weft {

/// Writes to a temporary name in the directory of `path`, and renames when committed. Destroyed
/// before commit(), it removes the temporary file. Every function throws Error (file) with the path
/// and the system's reason (full disk, no permission).
class OutputFile {
public:
    /// @param named_in_errors where the file will stand in the end, if that is not `path`.
    explicit OutputFile(std::filesystem::path path, std::filesystem::path named_in_errors = {});
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);
    void seek(std::uint64_t offset);  ///< from the start; for headers known only at the end
    /// Takes bytes [begin, end) out of what was written; what follows moves up and the file becomes
    /// shorter. For tables sized for more frames than came.
    void remove_range(std::uint64_t begin, std::uint64_t end);
    /// Flush and close, still under the temporary name. Recordings of several files close them all
    /// before they commit the first, so that a full disk leaves none.
    void close();
    void commit();  ///< close() where that was not done yet, then rename

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// When it was last written to, by the clock of its file system; not after commit().
    [[nodiscard]] std::filesystem::file_time_type last_write_time() const;

private:
    std::filesystem::path path_, named_in_errors_, temporary_;
    std::FILE* file_ = nullptr;
    std::uint64_t kept_back_ = 0;  ///< bytes written since the system was last told to write
};

/// `path` with a hidden name that no other file of its directory has, for what is not whole yet.
std::filesystem::path temporary_name(const std::filesystem::path& path);

}  // namespace weft
