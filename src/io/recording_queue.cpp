#include "io/recording_queue.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft {

namespace {

// One written, one waiting, one filled; more where frames are small, so that a moment without the
// recorders' thread stops nothing.
std::size_t buffer_count(const RecordingPlan& plan) {
    constexpr std::size_t least = 3, most = 32, particles_of_all = std::size_t{1} << 18;
    const std::size_t particles = plan.surface != nullptr ? plan.surface->particle_count : 0;
    return std::clamp(particles_of_all / std::max<std::size_t>(particles, 1), least, most);
}

// Waking the thread costs as much as recording a small frame: many buffers let frames gather.
std::size_t batch_of(std::size_t buffers) {
    return std::max<std::size_t>(buffers / 8, 1);
}

}  // namespace

RecordingQueue::RecordingQueue(std::vector<std::unique_ptr<Recorder>> recorders,
                               const RecordingPlan& plan)
    : recorders_(std::move(recorders)),
      buffers_(buffer_count(plan)),
      batch_(batch_of(buffers_.size())) {
    for (const auto& recorder : recorders_) needs_ = needs_ | recorder->needs();
    for (std::size_t n = 0; n < buffers_.size(); ++n) free_.push_back(n);
    thread_ = std::thread([this, plan] { work(plan); });
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return begun_; });
    if (!failed_) return;
    lock.unlock();
    thread_.join();
    std::rethrow_exception(error_);
}

RecordingQueue::~RecordingQueue() {
    if (!thread_.joinable()) return;
    {
        const std::scoped_lock lock(mutex_);
        closing_ = discard_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

FrameBuffer& RecordingQueue::next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !free_.empty(); });
    filling_ = free_.front();
    free_.pop_front();
    return buffers_[filling_];
}

bool RecordingQueue::push() {
    bool good = false, worth_waking = false;
    {
        const std::scoped_lock lock(mutex_);
        filled_.push_back(filling_);
        worth_waking = filled_.size() >= batch_;
        good = !failed_;
    }
    if (worth_waking) changed_.notify_all();
    return good;
}

void RecordingQueue::finish() {
    {
        const std::scoped_lock lock(mutex_);
        closing_ = true;
    }
    changed_.notify_all();
    thread_.join();
    if (error_) std::rethrow_exception(error_);
}

void RecordingQueue::work(const RecordingPlan& plan) {
    const bool good = begin_all(plan);
    {
        const std::scoped_lock lock(mutex_);
        begun_ = true;
    }
    changed_.notify_all();
    while (good) {
        std::unique_lock lock(mutex_);
        const std::size_t wanted = filled_.empty() ? batch_ : 1;
        changed_.wait(lock, [&] { return closing_ || filled_.size() >= wanted; });
        if (discard_ || filled_.empty()) break;
        const std::size_t index = filled_.front();
        filled_.pop_front();
        lock.unlock();
        const auto start = std::chrono::steady_clock::now();
        record(buffers_[index].view());
        busy_seconds_ +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        lock.lock();
        free_.push_back(index);
        lock.unlock();
        changed_.notify_all();
    }
    if (good && !discard_) finish_all();
    recorders_.clear();  // on this thread: a picture recorder's OpenGL context lives here
}

void RecordingQueue::fail(std::exception_ptr error) {
    const std::scoped_lock lock(mutex_);
    if (!failed_) error_ = std::move(error);
    failed_ = true;
}

template <typename Action>
void RecordingQueue::for_each_recorder(const Action& action) {
    for (std::unique_ptr<Recorder>& recorder : recorders_) {
        if (!recorder) continue;
        try {
            action(*recorder);
        } catch (...) {
            recorder.reset();  // removes what it wrote
            fail(std::current_exception());
        }
    }
}

bool RecordingQueue::begin_all(const RecordingPlan& plan) {
    for_each_recorder([&](Recorder& recorder) { recorder.begin(plan); });
    if (failed_) recorders_.clear();
    return !failed_;
}

void RecordingQueue::record(const Frame& frame) {
    if (failed_) return;  // the recording ends with the frames before
    for_each_recorder([&](Recorder& recorder) { recorder.frame(frame); });
}

void RecordingQueue::finish_all() {
    for_each_recorder([&](Recorder& recorder) {
        for (const std::filesystem::path& file : recorder.finish()) {
            // Two caches share one mesh and one script.
            if (std::find(files_.begin(), files_.end(), file) == files_.end()) {
                files_.push_back(file);
            }
        }
        const std::vector<std::string> notes = recorder.warnings();
        warnings_.insert(warnings_.end(), notes.begin(), notes.end());
    });
}

std::vector<std::unique_ptr<Recorder>> make_recorders(const std::vector<std::string>& formats) {
    std::vector<std::unique_ptr<Recorder>> recorders;
    for (const std::string& format : formats) recorders.push_back(make_recorder(format));
    return recorders;
}

}  // namespace weft
