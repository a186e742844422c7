// A file that appears whole or not at all: POSIX files under a temporary name.
#include "io/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include "weft/error.h"

namespace weft {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view action, int reason) {
    throw file_error(path.string(),
                     fmt::format("{}: {}", action, std::generic_category().message(reason)));
}

// Bytes after which the system is told to begin writing, so that close() has little left to wait
// for.
constexpr std::uint64_t bytes_kept_back = std::uint64_t{4} << 20;

// Does not wait, and failing changes nothing: close() waits and reports.
void begin_writing_to_disk(std::FILE* file) {
#ifdef __linux__
    sync_file_range(fileno(file), 0, 0, SYNC_FILE_RANGE_WRITE);
#else
    (void)file;
#endif
}

void read_at(std::FILE* file, std::uint64_t offset, std::span<std::byte> bytes,
             const std::filesystem::path& path) {
    if (fseeko(file, static_cast<off_t>(offset), SEEK_SET) != 0) fail(path, "cannot seek", errno);
    if (std::fread(bytes.data(), 1, bytes.size(), file) != bytes.size())
        fail(path, "cannot read back", std::ferror(file) != 0 ? errno : EIO);
}

}  // namespace

std::filesystem::path temporary_name(const std::filesystem::path& path) {
    static std::atomic<unsigned> counter{0};
    std::filesystem::path name;
    do {
        name = path.parent_path() /
               fmt::format(".{}.{}-{}.part", path.filename().string(), getpid(), counter++);
    } while (std::filesystem::exists(std::filesystem::symlink_status(name)));
    return name;
}

OutputFile::OutputFile(std::filesystem::path path, std::filesystem::path named_in_errors)
    : path_(std::move(path)),
      named_in_errors_(named_in_errors.empty() ? path_ : std::move(named_in_errors)) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path_, ignored))
        fail(named_in_errors_, "cannot write", EISDIR);
    // A name that cannot be looked at cannot be written either: open() has the reason.
    try {
        temporary_ = temporary_name(path_);
    } catch (const std::filesystem::filesystem_error& error) {
        fail(named_in_errors_, "cannot write", error.code().value());
    }
    const int descriptor = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(named_in_errors_, "cannot write", errno);
    file_ = fdopen(descriptor, "w+b");
    if (file_ == nullptr) {
        const int reason = errno;
        ::close(descriptor);
        ::unlink(temporary_.c_str());
        fail(named_in_errors_, "cannot write", reason);
    }
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      named_in_errors_(std::move(other.named_in_errors_)),
      temporary_(std::exchange(other.temporary_, {})),
      file_(std::exchange(other.file_, nullptr)) {}

OutputFile::~OutputFile() {
    if (file_ != nullptr) std::fclose(file_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::write(std::span<const std::byte> bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
        fail(named_in_errors_, "cannot write", errno);
    kept_back_ += bytes.size();
    if (kept_back_ < bytes_kept_back) return;
    begin_writing_to_disk(file_);
    kept_back_ = 0;
}

void OutputFile::write(std::string_view text) {
    write(std::as_bytes(std::span(text)));
}

void OutputFile::seek(std::uint64_t offset) {
    if (fseeko(file_, static_cast<off_t>(offset), SEEK_SET) != 0)
        fail(named_in_errors_, "cannot write", errno);
}

void OutputFile::remove_range(std::uint64_t begin, std::uint64_t end) {
    if (fseeko(file_, 0, SEEK_END) != 0) fail(named_in_errors_, "cannot write", errno);
    const auto size = static_cast<std::uint64_t>(ftello(file_));
    std::vector<std::byte> block(std::size_t{1} << 20);
    for (std::uint64_t from = end; from < size; from += block.size()) {
        const auto count =
            static_cast<std::size_t>(std::min<std::uint64_t>(size - from, block.size()));
        const std::span part = std::span(block).first(count);
        read_at(file_, from, part, named_in_errors_);
        seek(from - (end - begin));
        write(part);
    }
    const std::uint64_t shorter = size - (end - begin);
    if (std::fflush(file_) != 0) fail(named_in_errors_, "cannot write", errno);
    if (ftruncate(fileno(file_), static_cast<off_t>(shorter)) != 0)
        fail(named_in_errors_, "cannot write", errno);
    seek(shorter);
}

void OutputFile::close() {
    if (file_ == nullptr) return;
    // Some file systems report a full disk only when the data really goes there.
    const bool flushed = std::fflush(file_) == 0 && fsync(fileno(file_)) == 0;
    const int flush_reason = errno;
    const bool closed = std::fclose(std::exchange(file_, nullptr)) == 0;
    if (!flushed) fail(named_in_errors_, "cannot write", flush_reason);
    if (!closed) fail(named_in_errors_, "cannot write", errno);
}

void OutputFile::commit() {
    close();
    if (::rename(temporary_.c_str(), path_.c_str()) != 0)
        fail(named_in_errors_, "cannot rename", errno);
    temporary_.clear();
}

std::filesystem::file_time_type OutputFile::last_write_time() const {
    std::error_code problem;
    const auto time = std::filesystem::last_write_time(temporary_, problem);
    if (problem) fail(named_in_errors_, "cannot write", problem.value());
    return time;
}

}  // namespace weft
