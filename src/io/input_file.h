// A file to read from anywhere, with every read checked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/byte_order.h"
#include "weft/error.h"

namespace weft {

/// An open file. Every function throws Error (file) with the path and the reason.
class InputFile {
public:
    explicit InputFile(std::filesystem::path path);
    ~InputFile();
    InputFile(InputFile&& other) noexcept;
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    InputFile& operator=(InputFile&&) = delete;

    /// @throws Error (file) also where the file ends before offset + count.
    [[nodiscard]] Bytes read(std::uint64_t offset, std::uint64_t count) const;

    [[nodiscard]] std::uint64_t size() const { return size_; }  ///< [bytes]
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// The error that this file is not what it should be.
    [[nodiscard]] Error error(const std::string& reason) const {
        return file_error(path_.string(), reason);
    }

private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace weft
