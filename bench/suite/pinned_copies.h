// What the hardware threads reach with nothing to share: processes of their own, each pinned to
// one hardware thread and stepping its own sheet on one thread. It bounds what sharing one sheet
// among them can reach.
#pragma once

#include <sys/types.h>

#include <memory>
#include <vector>

#include "bench/suite/contestant.h"

namespace weft::bench {

class PinnedCopies {
public:
    /// A sheet to step; sent as it is to the other processes.
    struct Job {
        int columns = 0, rows = 0, steps_per_frame = 0;
        Precision precision = Precision::f32;
        int method = 0;  ///< its place in integrator_catalogue()
    };

    PinnedCopies() = default;
    ~PinnedCopies();
    PinnedCopies(const PinnedCopies&) = delete;
    PinnedCopies& operator=(const PinnedCopies&) = delete;

    /// Starts a process for each hardware thread that this one may use. Call it while this process
    /// has one thread.
    /// @throws Error (file) where the system refuses.
    void start();
    [[nodiscard]] int count() const { return static_cast<int>(workers_.size()); }

    /// All copies step the same job. The object must live as long as this one is used.
    std::unique_ptr<Contestant> make(const Job& job);

private:
    friend class CopiesContestant;
    struct Worker {
        pid_t process = -1;
        int socket = -1;
    };
    void start_worker(int hardware_thread);
    void stop(Worker& worker);
    /// Sends the same command to all and waits for all answers.
    /// @throws Error (diverged) where one fails.
    void command(char what, const Job& job, int frames);

    std::vector<Worker> workers_;
};

}  // namespace weft::bench
