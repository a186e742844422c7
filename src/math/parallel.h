// Loops over threads. A loop's body must write only what its own range owns, and sum in an order
// that does not depend on where a range begins: then any number of threads gives the same bits.
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <cstddef>
#include <optional>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace weft {

/// The threads that one simulation may use. Loops inside run() share them.
class ThreadTeam {
public:
    /// @param threads at least 1; 0: all hardware threads.
    explicit ThreadTeam(int threads);

    [[nodiscard]] int size() const { return size_; }

    template <typename Function>
    void run(Function&& function) {
        arena_.execute(function);
    }

private:
    int size_;
    // Only for teams of more threads than the machine has: TBB takes the least of all limits that
    // live, so that a small team's would bind a large one.
    std::optional<oneapi::tbb::global_control> limit_;
    oneapi::tbb::task_arena arena_;
};

namespace detail {

// ThreadSanitizer does not see the ordering that the (uninstrumented) TBB library makes between
// the caller and its tasks: say it here, where every loop passes. What TBB's own headers do among
// themselves is left out in tools/tsan.supp.
struct TaskOrder {
#if defined(__SANITIZE_THREAD__)
    static void caller_before() { __tsan_release(&started); }
    static void task_before() { __tsan_acquire(&started); }
    static void task_after() { __tsan_release(&ended); }
    static void caller_after() { __tsan_acquire(&ended); }
    static inline char started = 0, ended = 0;
#else
    static void caller_before() {}
    static void task_before() {}
    static void task_after() {}
    static void caller_after() {}
#endif
};

}  // namespace detail

/// Calls body(begin, end) on ranges that cover [0, count), in parallel where that is worth it.
/// @param grain the smallest range worth a thread of its own.
template <typename Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
    if (count < 2 * grain || oneapi::tbb::this_task_arena::max_concurrency() < 2) {
        if (count > 0) body(std::size_t{0}, count);
        return;
    }
    using detail::TaskOrder;
    TaskOrder::caller_before();
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::size_t>(0, count, grain),
        [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
            TaskOrder::task_before();
            body(range.begin(), range.end());
            TaskOrder::task_after();
        },
        oneapi::tbb::static_partitioner{});
    TaskOrder::caller_after();
}

}  // namespace weft
