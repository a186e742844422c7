#include "bench/suite/pinned_copies.h"

#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <optional>

#include "bench/suite/scenes.h"
#include "weft/error.h"
#include "weft/integrators.h"
#include "weft/simulation.h"

namespace weft::bench {

namespace {

constexpr char build = 'b', run = 'r', drop = 'd', done = 'k', failed = 'f';

struct Command {
    char what = 0;
    int frames = 0;
    PinnedCopies::Job job;
};

// The sockets keep messages whole. One to a process that is gone is refused, without a signal.
template <typename Message>
bool receive(int socket, Message& message) {
    ssize_t count = -1;
    do {
        count = recv(socket, &message, sizeof(Message), 0);
    } while (count < 0 && errno == EINTR);
    return count == static_cast<ssize_t>(sizeof(Message));
}

template <typename Message>
bool dispatch(int socket, const Message& message) {
    ssize_t count = -1;
    do {
        count = send(socket, &message, sizeof(Message), MSG_NOSIGNAL);
    } while (count < 0 && errno == EINTR);
    return count == static_cast<ssize_t>(sizeof(Message));
}

SceneDescription scene_of(const PinnedCopies::Job& job) {
    const auto method = static_cast<std::size_t>(job.method);
    return sheet_scene({.columns = job.columns, .rows = job.rows},
                       {.method = integrator_catalogue()[method].name,
                        .precision = job.precision,
                        .steps_per_frame = job.steps_per_frame});
}

bool obey(const Command& command, std::optional<Simulation>& simulation) try {
    if (command.what == build) simulation.emplace(scene_of(command.job), 1);
    if (command.what == drop) simulation.reset();
    for (int n = 0; n < command.frames; ++n) {
        if (!simulation->advance_frame().ok()) return false;
    }
    return true;
} catch (const std::exception&) {
    return false;
}

// A copy's whole life.
[[noreturn]] void serve(int hardware_thread, int socket) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    signal(SIGINT, SIG_IGN);  // Ctrl-C is for the process that asks
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(static_cast<std::size_t>(hardware_thread), &only);
    sched_setaffinity(0, sizeof(only), &only);
    std::optional<Simulation> simulation;
    Command command;
    while (receive(socket, command)) {
        if (!dispatch(socket, obey(command, simulation) ? done : failed)) break;
    }
    _exit(0);
}

[[noreturn]] void refuse(const char* action) {
    throw file_error("pinned copies", std::string(action) + ": " + std::strerror(errno));
}

}  // namespace

void PinnedCopies::start() {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof(allowed), &allowed) != 0) refuse("cannot ask for processors");
    for (int n = 0; n < CPU_SETSIZE; ++n) {
        if (CPU_ISSET(static_cast<std::size_t>(n), &allowed)) start_worker(n);
    }
}

void PinnedCopies::start_worker(int hardware_thread) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        refuse("cannot make a socket");
    }
    const pid_t process = fork();
    if (process == 0) {
        close(ends[0]);
        for (const Worker& other : workers_) close(other.socket);
        serve(hardware_thread, ends[1]);
    }
    close(ends[1]);
    workers_.push_back({process, ends[0]});
    if (process < 0) refuse("cannot start a process");
}

void PinnedCopies::stop(Worker& worker) {
    close(worker.socket);
    if (worker.process <= 0) return;
    kill(worker.process, SIGKILL);  // it may be in the middle of a job
    while (waitpid(worker.process, nullptr, 0) < 0 && errno == EINTR) {
    }
}

PinnedCopies::~PinnedCopies() {
    for (Worker& worker : workers_) stop(worker);
}

void PinnedCopies::command(char what, const Job& job, int frames) {
    bool good = true;
    for (const Worker& worker : workers_) {
        good = dispatch(worker.socket, Command{what, frames, job}) && good;
    }
    for (const Worker& worker : workers_) {
        char answer = failed;
        good = receive(worker.socket, answer) && answer == done && good;
    }
    if (!good) {
        throw Error(ErrorKind::diverged, {}, "a pinned copy diverged or ran out of memory");
    }
}

class CopiesContestant final : public Contestant {
public:
    CopiesContestant(PinnedCopies& copies, const PinnedCopies::Job& job)
        : copies_(copies), job_(job) {
        copies_.command(build, job_, 0);
    }
    ~CopiesContestant() override {
        try {
            copies_.command(drop, job_, 0);
        } catch (const Error&) {  // already told when it happened
        }
    }
    CopiesContestant(const CopiesContestant&) = delete;
    CopiesContestant& operator=(const CopiesContestant&) = delete;

    Measurement measure(double least_seconds) override {
        if (frames_ == 0) {
            frames_ = pieces_lasting(least_seconds, [this](int n) { return seconds_of(n); });
        }
        Measurement found;
        found.seconds = seconds_of(frames_);
        found.steps = static_cast<double>(copies_.count()) * frames_ * job_.steps_per_frame;
        return found;
    }

private:
    double seconds_of(int frames) {
        const auto start = std::chrono::steady_clock::now();
        copies_.command(run, job_, frames);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    PinnedCopies& copies_;
    PinnedCopies::Job job_;
    int frames_ = 0;
};

std::unique_ptr<Contestant> PinnedCopies::make(const Job& job) {
    return std::make_unique<CopiesContestant>(*this, job);
}

}  // namespace weft::bench
