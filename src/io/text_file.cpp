#include "io/text_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "weft/error.h"

namespace weft {

std::string read_text_file(const std::string& path, std::size_t limit) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw file_error(path, "cannot be read: it is a directory");
    }
    const auto refuse = [&] {
        const std::string reason = std::generic_category().message(errno);
        throw file_error(path, "cannot be read: " + reason);
    };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               &std::fclose);
    if (!file) refuse();
    // Read until the end instead of asking for the size, which a pipe does not have.
    std::string text;
    std::string block(65536, '\0');
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
        text.append(block, 0, count);
        if (text.size() > limit) {
            throw file_error(path, fmt::format("cannot be read: it is larger than {} MiB",
                                               limit / (1024 * 1024)));
        }
    }
    if (std::ferror(file.get())) refuse();
    return text;
}

}  // namespace weft
