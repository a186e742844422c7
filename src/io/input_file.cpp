// A file to read from anywhere: POSIX reads at a place.
#include "io/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace weft {

InputFile::InputFile(std::filesystem::path path) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) throw error(fmt::format("cannot read: {}", std::strerror(errno)));
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
        ::close(descriptor_);
        throw error("cannot read: not a regular file");
    }
    size_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::InputFile(InputFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_) {}

InputFile::~InputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

Bytes InputFile::read(std::uint64_t offset, std::uint64_t count) const {
    if (offset > size_ || count > size_ - offset)
        throw error(
            fmt::format("is cut off: byte {} is needed, the file has {}", offset + count, size_));
    Bytes bytes(count);
    for (std::uint64_t done = 0; done < count;) {
        const ssize_t got = ::pread(descriptor_, bytes.data() + done, count - done,
                                    static_cast<off_t>(offset + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw error(fmt::format("cannot read: {}", std::strerror(errno)));
        if (got == 0) throw error("became shorter while it was read");
        done += static_cast<std::uint64_t>(got);
    }
    return bytes;
}

}  // namespace weft
