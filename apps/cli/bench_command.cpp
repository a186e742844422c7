#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bench/suite/suite.h"
#include "cli/bench_plot.h"
#include "cli/bench_report.h"
#include "cli/commands.h"
#include "cli/implicit_frame_report.h"
#include "cli/interrupt.h"
#include "cli/motion_report.h"

namespace weft {

namespace {

// What is timed now: one line, updated in place at a terminal, and gone before a line of the table;
// elsewhere the table itself shows how far it is.
class BenchProgress {
public:
    BenchProgress(std::size_t parts, bool enabled)
        : parts_(parts), enabled_(enabled && isatty(STDERR_FILENO) != 0) {}
    ~BenchProgress() { clear(); }
    BenchProgress(const BenchProgress&) = delete;
    BenchProgress& operator=(const BenchProgress&) = delete;

    void show(const std::string& what) {
        ++part_;
        if (!enabled_) return;
        fmt::print(stderr, "\r{}/{}  {}\x1b[K", part_, parts_, what);
        std::fflush(stderr);
    }
    void clear() const {
        if (!enabled_) return;
        fmt::print(stderr, "\r\x1b[K");
        std::fflush(stderr);
    }

private:
    std::size_t parts_, part_ = 0;
    bool enabled_;
};

template <typename Group>
std::string shown_label(const Group& group) {
    for (const auto& entry : group.entries) {
        if (entry.shown) return entry.label.text();
    }
    return {};
}

// Times a plan, part after part, and prints the tables as they grow; an interrupt ends it early.
class BenchRun {
public:
    BenchRun(const bench::Plan& plan, const bench::PlanOptions& options, bool json)
        : plan_(plan),
          options_(options),
          json_(json),
          progress_(plan.groups.size() + plan.frames.size() + plan.motions.size(), !json) {}

    void time_all() {
        machine_ = bench::measure_machine();
        print(machine_text(machine_));
        time_steps();
        time_frames();
        time_motions();
    }

    [[nodiscard]] const std::vector<bench::Row>& rows() const { return rows_; }
    /// What could not be timed; empty: all could.
    [[nodiscard]] const std::string& failure() const { return failure_; }
    /// { "machine": {...}, "rows": [...] }, docs/cli.md.
    [[nodiscard]] nlohmann::ordered_json json() const {
        return {{"machine", machine_json(machine_)}, {"rows", json_rows_}};
    }

private:
    void print(const std::string& text) const {
        if (json_) return;
        progress_.clear();
        fmt::print("{}", text);
        std::fflush(stdout);
    }

    void failed(const bench::Label& label, const std::string& note) {
        if (failure_.empty()) failure_ = label.text() + ": " + note;
    }

    void time_steps() {
        if (!plan_.groups.empty()) print(bench_table_head());
        for (const bench::Group& group : plan_.groups) {
            if (interrupted()) return;
            progress_.show(shown_label(group));
            for (const bench::Row& row :
                 bench::time_group(group, machine_, options_.least_seconds(), interrupted)) {
                print(bench_table_line(row));
                json_rows_.push_back(row_json(row));
                rows_.push_back(row);
                if (row.diverged) failed(row.label, row.note);
            }
        }
    }

    void time_frames() {
        if (!plan_.frames.empty() && !interrupted()) print(frame_table_head());
        for (const bench::FrameGroup& group : plan_.frames) {
            if (interrupted()) return;
            progress_.show(shown_label(group));
            for (const bench::FrameRow& row : bench::time_frames(group, interrupted)) {
                print(frame_table_line(row));
                json_rows_.push_back(frame_json(row));
                if (!row.note.empty()) failed(row.label, row.note);
            }
        }
    }

    // A method that cannot make the motion is a result, not a failure.
    void time_motions() {
        if (plan_.motions.empty() || interrupted()) return;
        const bench::MotionReference reference = bench::motion_reference();
        print(motion_table_head(reference));
        for (const bench::MotionEntry& entry : plan_.motions) {
            progress_.show(entry.label.text());
            const auto row =
                bench::time_motion(entry, reference, plan_.motion_repeats, interrupted);
            if (!row) return;
            print(motion_table_line(*row));
            json_rows_.push_back(motion_json(*row, reference));
        }
    }

    const bench::Plan& plan_;
    const bench::PlanOptions& options_;
    bool json_;
    BenchProgress progress_;
    bench::Machine machine_;
    std::vector<bench::Row> rows_;
    nlohmann::ordered_json json_rows_ = nlohmann::ordered_json::array();
    std::string failure_;
};

}  // namespace

int bench_command(const BenchOptions& options) {
    const bench::PlanOptions plan_options{options.quick, options.large, options.filter,
                                          options.repeats};
    const int threads = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
    const bench::Plan plan = bench::make_plan(plan_options, threads);
    std::optional<BenchPlot> plot;
    if (!options.plot.empty()) plot.emplace(options.plot);
    if (plan.needs_copies) plan.copies->start();
    watch_for_interrupt();
    BenchRun run(plan, plan_options, options.json);
    run.time_all();
    if (interrupted()) return exit_interrupted;
    if (options.json) fmt::print("{}\n", run.json().dump(2));
    if (plot) {
        plot->draw(run.rows(), !options.filter.empty());
        if (!options.json) fmt::print("{}\n", options.plot);
    }
    if (run.failure().empty()) return exit_done;
    fmt::print(stderr, "weft: {}\n", run.failure());
    return exit_diverged;
}

}  // namespace weft
