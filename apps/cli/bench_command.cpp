#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

#include "bench/suite/suite.h"
#include "cli/bench_plot.h"
#include "cli/bench_report.h"
#include "cli/commands.h"
#include "cli/interrupt.h"

namespace weft {

namespace {

// What is timed now: one line, updated in place at a terminal, and gone before a line of the table;
// elsewhere the table itself shows how far it is.
class BenchProgress {
public:
    BenchProgress(std::size_t groups, bool enabled)
        : groups_(groups), enabled_(enabled && isatty(STDERR_FILENO) != 0) {}
    ~BenchProgress() { clear(); }
    BenchProgress(const BenchProgress&) = delete;
    BenchProgress& operator=(const BenchProgress&) = delete;

    void show(std::size_t group, const std::string& what) const {
        if (!enabled_) return;
        fmt::print(stderr, "\r{}/{}  {}\x1b[K", group + 1, groups_, what);
        std::fflush(stderr);
    }
    void clear() const {
        if (!enabled_) return;
        fmt::print(stderr, "\r\x1b[K");
        std::fflush(stderr);
    }

private:
    std::size_t groups_;
    bool enabled_;
};

std::string shown_label(const bench::Group& group) {
    for (const bench::Entry& entry : group.entries) {
        if (entry.shown) return entry.label.text();
    }
    return {};
}

// Times all groups, and prints the table as it grows; an interrupt ends it early.
std::vector<bench::Row> time_plan(const bench::Plan& plan, const bench::Machine& machine,
                                  const bench::PlanOptions& options, bool json) {
    std::vector<bench::Row> all;
    const BenchProgress progress(plan.groups.size(), !json);
    if (!json) fmt::print("{}\n{}", machine_text(machine), bench_table_head());
    for (std::size_t n = 0; n < plan.groups.size() && !interrupted(); ++n) {
        const bench::Group& group = plan.groups[n];
        progress.show(n, shown_label(group));
        for (bench::Row& row :
             bench::time_group(group, machine, options.least_seconds(), interrupted)) {
            progress.clear();
            if (!json) fmt::print("{}", bench_table_line(row));
            all.push_back(std::move(row));
        }
        std::fflush(stdout);
    }
    return all;
}

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
    const bench::Machine machine = bench::measure_machine();
    const std::vector<bench::Row> rows = time_plan(plan, machine, plan_options, options.json);
    if (interrupted()) return exit_interrupted;
    if (options.json) fmt::print("{}\n", bench_json(machine, rows).dump(2));
    if (plot) {
        plot->draw(rows, !options.filter.empty());
        if (!options.json) fmt::print("{}\n", options.plot);
    }
    for (const bench::Row& row : rows) {
        if (!row.diverged) continue;
        fmt::print(stderr, "weft: {}: {}\n", row.label.text(), row.note);
        return exit_diverged;
    }
    return exit_done;
}

}  // namespace weft
