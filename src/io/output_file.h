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
    explicit OutputFile(std::filesystem::path path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);
    void seek(std::uint64_t offset);     ///< from the start; for headers known only at the end
    void commit();                       ///< flush, close, rename

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_, temporary_;
    std::FILE* file_ = nullptr;
};

}  // namespace weft
