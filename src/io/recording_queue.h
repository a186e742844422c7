// A bounded queue of frames between the simulation and its recorders.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "weft/recorder.h"

namespace weft {

/// Runs recorders on a thread of their own, so that a frame is simulated while the one before is
/// written. All of a recorder's calls come from that thread. A recorder that fails stops the
/// recording; the others end theirs with the frames so far.
class RecordingQueue {
public:
    /// Begins all recorders and waits for that.  @throws Error (file) where one cannot begin.
    RecordingQueue(std::vector<std::unique_ptr<Recorder>> recorders, const RecordingPlan& plan);
    /// Without finish(): discards what was recorded.
    ~RecordingQueue();
    RecordingQueue(const RecordingQueue&) = delete;
    RecordingQueue& operator=(const RecordingQueue&) = delete;

    /// What the recorders need of every frame, together.
    [[nodiscard]] FrameNeeds needs() const { return needs_; }
    /// A buffer to fill, when one is free.
    FrameBuffer& next();
    /// Hands the buffer last got from next() to the recorders.
    /// @return false where a recorder has failed; finish() then says why.
    bool push();

    /// Waits for all frames and ends the recordings. files() then says what stands.
    /// @throws Error (file) for the first recorder that failed, after the others have ended.
    void finish();

    [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
    /// Wall seconds the recorders worked.
    [[nodiscard]] double busy_seconds() const { return busy_seconds_; }

private:
    void work(const RecordingPlan& plan);
    bool begin_all(const RecordingPlan& plan);
    void record(const Frame& frame);
    void finish_all();
    void fail(std::exception_ptr error);
    template <typename Action>
    void for_each_recorder(const Action& action);

    std::vector<std::unique_ptr<Recorder>> recorders_;
    FrameNeeds needs_{.positions = false, .velocities = false, .normals = false};
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<FrameBuffer> buffers_;
    // Indices into buffers_, the oldest first: a buffer that rests has left the caches of the
    // thread that used it last.
    std::deque<std::size_t> free_, filled_;
    std::size_t filling_ = 0;
    std::size_t batch_;  ///< frames worth waking the thread for
    bool begun_ = false, closing_ = false, discard_ = false, failed_ = false;
    std::exception_ptr error_;
    std::vector<std::filesystem::path> files_;
    std::vector<std::string> warnings_;
    double busy_seconds_ = 0.0;
    std::thread thread_;
};

/// The recorders of these formats, each a row of format_catalogue().
std::vector<std::unique_ptr<Recorder>> make_recorders(const std::vector<std::string>& formats);

}  // namespace weft
