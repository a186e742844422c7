// The queue between simulation and recorders: order, threads, and what a failing recorder leaves.
#include "io/recording_queue.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <thread>

#include "weft/error.h"

namespace weft {

namespace {

// What a recorder was told, and where it is to fail.
struct Log {
    std::size_t begins = 0, finishes = 0, destroyed = 0;
    std::vector<std::size_t> frames;
    std::set<std::thread::id> threads;
};

enum class Fails { never, in_begin, in_third_frame, in_finish };

class LoggingRecorder final : public Recorder {
public:
    LoggingRecorder(Log& log, Fails fails, std::string file)
        : log_(log), fails_(fails), file_(std::move(file)) {}
    ~LoggingRecorder() override {
        ++log_.destroyed;
        log_.threads.insert(std::this_thread::get_id());
    }
    void begin(const RecordingPlan&) override {
        log_.threads.insert(std::this_thread::get_id());
        ++log_.begins;
        if (fails_ == Fails::in_begin) throw file_error(file_, "cannot begin");
    }
    void frame(const Frame& frame) override {
        log_.threads.insert(std::this_thread::get_id());
        if (fails_ == Fails::in_third_frame && log_.frames.size() == 2) {
            throw file_error(file_, "disk full");
        }
        log_.frames.push_back(frame.index);
    }
    std::vector<std::filesystem::path> finish() override {
        if (fails_ == Fails::in_finish) throw file_error(file_, "cannot rename");
        ++log_.finishes;
        return {file_, "shared.obj"};
    }
    [[nodiscard]] std::vector<std::string> warnings() const override {
        return {file_ + " thinned"};
    }

private:
    Log& log_;
    Fails fails_;
    std::string file_;
};

std::vector<std::unique_ptr<Recorder>> two_recorders(Log& first, Fails fails, Log& second) {
    std::vector<std::unique_ptr<Recorder>> recorders;
    recorders.push_back(std::make_unique<LoggingRecorder>(first, fails, "a"));
    recorders.push_back(std::make_unique<LoggingRecorder>(second, Fails::never, "b"));
    return recorders;
}

// @return how many frames were taken before push() said to stop.
std::size_t push_frames(RecordingQueue& queue, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) {
        queue.next().index = n;
        if (!queue.push()) return n;
    }
    return count;
}

TEST(RecordingQueue, GivesEveryFrameInOrderOnOneOtherThread) {
    Log first, second;
    {
        RecordingQueue queue(two_recorders(first, Fails::never, second), {});
        EXPECT_EQ(push_frames(queue, 50), 50U);
        queue.finish();
        EXPECT_EQ(queue.files(),
                  (std::vector<std::filesystem::path>{"a", "shared.obj", "b"}));  // each once
        EXPECT_EQ(queue.warnings(), (std::vector<std::string>{"a thinned", "b thinned"}));
    }
    for (const Log* log : {&first, &second}) {
        ASSERT_EQ(log->frames.size(), 50U);
        for (std::size_t n = 0; n < 50; ++n) EXPECT_EQ(log->frames[n], n);
        EXPECT_EQ(log->finishes, 1U);
        EXPECT_EQ(log->destroyed, 1U);
        EXPECT_EQ(log->threads.size(), 1U);
        EXPECT_EQ(log->threads.count(std::this_thread::get_id()), 0U);
    }
}

TEST(RecordingQueue, SaysAtOnceThatARecorderCannotBegin) {
    Log first, second;
    try {
        RecordingQueue queue(two_recorders(first, Fails::in_begin, second), {});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "a: cannot begin");
    }
    EXPECT_EQ(first.destroyed, 1U);
    EXPECT_EQ(second.destroyed, 1U);
    EXPECT_EQ(second.finishes, 0U);
}

TEST(RecordingQueue, StopsWhereARecorderFailsAndEndsTheOthersWell) {
    Log first, second;
    RecordingQueue queue(two_recorders(first, Fails::in_third_frame, second), {});
    EXPECT_LT(push_frames(queue, 1000), 1000U);
    EXPECT_THROW(queue.finish(), Error);
    EXPECT_EQ(first.frames.size(), 2U);
    EXPECT_EQ(first.finishes, 0U);
    EXPECT_EQ(second.frames.size(), 3U);  // the frame that failed is whole for the others
    EXPECT_EQ(second.finishes, 1U);
    EXPECT_EQ(queue.files(), (std::vector<std::filesystem::path>{"b", "shared.obj"}));
}

TEST(RecordingQueue, EndsTheOthersWhereOneCannotFinish) {
    Log first, second;
    RecordingQueue queue(two_recorders(first, Fails::in_finish, second), {});
    EXPECT_EQ(push_frames(queue, 4), 4U);
    EXPECT_THROW(queue.finish(), Error);
    EXPECT_EQ(second.finishes, 1U);
    EXPECT_EQ(first.destroyed, 1U);
}

TEST(RecordingQueue, DiscardsWithoutFinish) {
    Log first, second;
    {
        RecordingQueue queue(two_recorders(first, Fails::never, second), {});
        EXPECT_EQ(push_frames(queue, 2), 2U);
    }
    EXPECT_EQ(first.finishes, 0U);
    EXPECT_EQ(first.destroyed, 1U);
}

}  // namespace

}  // namespace weft
