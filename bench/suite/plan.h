// What `weft bench` times: entries, in groups that are timed in turn, and two studies of their own.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/suite/contestant.h"
#include "bench/suite/implicit_frame.h"
#include "bench/suite/label.h"
#include "bench/suite/motion.h"
#include "bench/suite/pinned_copies.h"

namespace weft::bench {

struct Entry {
    Label label;
    std::function<std::unique_ptr<Contestant>()> make;  ///< null: not built in, `note` says why
    double flops_per_step = 0.0;                        ///< 0: not counted
    bool against_textbook = false;  ///< the same forces: the ratio to the textbook makes sense
    bool shown = true;              ///< false: timed along for the ratios, no row of the table
    std::string note;
};

/// The label's name of the yardstick.
inline constexpr std::string_view textbook_name = "textbook";

/// Contestants of one size and number of threads, timed in turn.
struct Group {
    std::vector<Entry> entries;
    int repeats = 3;
};

struct PlanOptions {
    bool quick = false;            ///< one repeat, up to 256 x 256 (implicit frames: 97 x 97)
    bool large = false;            ///< 64 x 64 to 4096 x 4096 besides
    std::string filter{};          ///< words that a label's text must all have
    std::optional<int> repeats{};  ///< of every timing
    [[nodiscard]] double least_seconds() const { return quick ? 0.01 : 0.03; }  ///< of a timing
};

struct Plan {
    std::vector<Group> groups;
    std::vector<FrameGroup> frames;    ///< implicit_frame.h
    std::vector<MotionEntry> motions;  ///< motion.h
    int motion_repeats = 3;
    /// For rows of copies; not started. Lives as long as the entries.
    std::shared_ptr<PinnedCopies> copies = std::make_shared<PinnedCopies>();
    bool needs_copies = false;
};

/// @param threads all hardware threads.
/// @throws Error (usage) where the filter leaves nothing.
Plan make_plan(const PlanOptions& options, int threads);

}  // namespace weft::bench
