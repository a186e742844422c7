// Running ffmpeg as a child process, without a shell.
#include "io/video_encoder.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "io/output_file.h"
#include "weft/error.h"

namespace weft {

namespace {

constexpr const char* other_formats =
    "Install it (apt install ffmpeg), or choose other formats: png for pictures; glb, pc2, mdd, "
    "npy, "
    "obj, ply for the cloth itself.";

/// What posix_spawn needs beside the arguments; freed when it goes.
class SpawnSettings {
public:
    SpawnSettings(int standard_input, int standard_error) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_adddup2(&actions_, standard_input, STDIN_FILENO);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, standard_error, STDERR_FILENO);
        posix_spawnattr_init(&attributes_);
        // A process group of its own: Ctrl-C is for weft alone, which then ends the video properly.
        posix_spawnattr_setpgroup(&attributes_, 0);
        sigset_t none;
        sigemptyset(&none);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    }
    ~SpawnSettings() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
    [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

std::string system_reason(int error) {
    return std::generic_category().message(error);
}

/// Makes the empty file that ffmpeg will overwrite: reasons against it show before the first frame.
void make_empty_file(const std::filesystem::path& temporary, const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw file_error(path.string(), "cannot write: " + system_reason(EISDIR));
    const int file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) throw file_error(path.string(), "cannot write: " + system_reason(errno));
    close(file);
}

std::string last_line(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \r\n");
    if (end == std::string::npos) return {};
    const std::size_t start = text.find_last_of("\r\n", end);
    return text.substr(start == std::string::npos ? 0 : start + 1,
                       start == std::string::npos ? end + 1 : end - start);
}

std::string ending(int status) {
    return WIFSIGNALED(status) ? "ended by signal " + std::to_string(WTERMSIG(status))
                               : "exit status " + std::to_string(WEXITSTATUS(status));
}

std::string read_all(int file) {
    std::string text;
    std::array<char, 4096> block{};
    off_t offset = 0;
    ssize_t count = 0;
    while ((count = pread(file, block.data(), block.size(), offset)) > 0) {
        text.append(block.data(), static_cast<std::size_t>(count));
        offset += count;
    }
    return text;
}

}  // namespace

VideoEncoder::VideoEncoder(std::filesystem::path path, std::string_view format,
                           std::array<int, 2> size, double frames_per_second)
    : path_(std::move(path)) {
    try {
        temporary_ = temporary_name(path_);
    } catch (const std::filesystem::filesystem_error& error) {
        throw file_error(path_.string(), "cannot write: " + error.code().message());
    }
    make_empty_file(temporary_, path_);
    try {
        start(encoder_arguments(format, size, frames_per_second, temporary_));
    } catch (const Error&) {
        unlink(temporary_.c_str());
        throw;
    }
}

void VideoEncoder::start(const std::vector<std::string>& arguments) {
    // A socket instead of a pipe: sending can then be told not to raise SIGPIPE.
    std::array<int, 2> ends{-1, -1};
    messages_ = memfd_create("ffmpeg-messages", MFD_CLOEXEC);
    if (messages_ < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        const int reason = errno;
        if (messages_ >= 0) close(std::exchange(messages_, -1));
        throw file_error(path_.string(), "cannot start ffmpeg: " + system_reason(reason));
    }
    std::vector<char*> pointers;
    for (const std::string& argument : arguments)
        pointers.push_back(const_cast<char*>(argument.c_str()));  // spawn does not write to them
    pointers.push_back(nullptr);
    const SpawnSettings settings(ends[1], messages_);
    const int problem = posix_spawnp(&process_, pointers[0], settings.actions(),
                                     settings.attributes(), pointers.data(), environ);
    close(ends[1]);
    input_ = ends[0];
    if (problem == 0) return;
    process_ = -1;
    close_input();
    close(std::exchange(messages_, -1));
    if (problem == ENOENT) {
        throw file_error(path_.string(), "needs the program ffmpeg, which is not found",
                         other_formats);
    }
    throw file_error(path_.string(), "cannot start ffmpeg: " + system_reason(problem),
                     other_formats);
}

VideoEncoder::~VideoEncoder() {
    if (process_ > 0) {
        kill(process_, SIGKILL);
        wait();
    }
    close_input();
    if (messages_ >= 0) close(messages_);
    if (!committed_) unlink(temporary_.c_str());
}

void VideoEncoder::close_input() {
    if (input_ >= 0) close(std::exchange(input_, -1));
}

void VideoEncoder::wait() {
    while (waitpid(process_, &status_, 0) < 0) {
        if (errno != EINTR) break;
    }
    process_ = -1;
}

void VideoEncoder::fail() {
    close_input();
    if (process_ > 0) wait();
    const std::string messages = read_all(messages_);
    const std::string last = last_line(messages);
    throw file_error(path_.string(), "ffmpeg failed: " + (last.empty() ? ending(status_) : last),
                     messages);
}

void VideoEncoder::write(const Image& image) {
    const std::uint8_t* next = image.rgba.data();
    std::size_t left = image.rgba.size();
    while (left > 0) {
        const ssize_t sent = send(input_, next, left, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) fail();  // ffmpeg has closed its end, and says why
        next += sent;
        left -= static_cast<std::size_t>(sent);
    }
}

void VideoEncoder::commit() {
    close_input();
    wait();
    // ffmpeg's exit status is 0 after some failed writes, but then it has complained.
    if (!WIFEXITED(status_) || WEXITSTATUS(status_) != 0 || !last_line(read_all(messages_)).empty())
        fail();
    std::error_code problem;
    std::filesystem::rename(temporary_, path_, problem);
    if (problem) throw file_error(path_.string(), "cannot rename: " + problem.message());
    committed_ = true;
}

}  // namespace weft
