#include "io/gnuplot.h"

#include <spawn.h>
#include <sys/mman.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace weft {

namespace {

// A file in memory: it takes any amount without a reader, so that nobody waits for anybody.
class MemoryFile {
public:
    explicit MemoryFile(const char* name) : descriptor_(memfd_create(name, MFD_CLOEXEC)) {}
    ~MemoryFile() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] int descriptor() const { return descriptor_; }

    bool write(const std::string& text) const {
        std::size_t written = 0;
        while (written < text.size()) {
            const ssize_t count = pwrite(descriptor_, text.data() + written, text.size() - written,
                                         static_cast<off_t>(written));
            if (count <= 0) return false;
            written += static_cast<std::size_t>(count);
        }
        return true;
    }
    [[nodiscard]] std::string read() const {
        std::string text;
        std::array<char, 65536> block{};
        ssize_t count = 0;
        while ((count = pread(descriptor_, block.data(), block.size(),
                              static_cast<off_t>(text.size()))) > 0) {
            text.append(block.data(), static_cast<std::size_t>(count));
        }
        return text;
    }

private:
    int descriptor_;
};

// posix_spawn's error, 0 for none.
int spawn(pid_t& process, const MemoryFile& input, const MemoryFile& output,
          const MemoryFile& messages) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input.descriptor(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, messages.descriptor(), STDERR_FILENO);
    // gnuplot does not write to its arguments.
    std::array<char*, 3> arguments{const_cast<char*>("gnuplot"), const_cast<char*>("-d"), nullptr};
    const int problem =
        posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return problem;
}

}  // namespace

GnuplotRun run_gnuplot(const std::string& script) {
    const MemoryFile input("script"), output("plot"), messages("messages");
    GnuplotRun run;
    if (!input.write(script)) return run;
    pid_t process = -1;
    if (spawn(process, input, output, messages) != 0) return run;
    while (waitpid(process, &run.status, 0) < 0) {
        if (errno != EINTR) break;
    }
    run.output = output.read();
    run.messages = messages.read();
    return run;
}

}  // namespace weft
