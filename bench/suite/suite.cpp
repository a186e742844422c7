#include "bench/suite/suite.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "bench/peers/built_in.h"
#include "bench/peers/machine.h"
#include "bench/peers/textbook.h"
#include "bench/suite/median.h"
#include "math/processor_name.h"
#include "weft/error.h"
#include "weft/instruction_set.h"

namespace weft::bench {

namespace {

// An entry while its group is timed.
struct Runner {
    const Entry& entry;
    std::unique_ptr<Contestant> contestant{};
    std::vector<Measurement> measurements{};
    std::string failure{};

    void make() try {
        if (entry.make) contestant = entry.make();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::diverged) throw;
        failure = error.what();
    }

    void measure(double least_seconds) {
        if (!contestant) return;
        try {
            measurements.push_back(contestant->measure(least_seconds));
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::diverged) throw;
            failure = error.what();
            contestant.reset();
        }
    }

    [[nodiscard]] double median_of(const std::function<double(const Measurement&)>& value) const {
        std::vector<double> values;
        for (const Measurement& measurement : measurements) values.push_back(value(measurement));
        return median(std::move(values));
    }
};

double step_seconds(const Measurement& measurement) {
    return measurement.seconds / measurement.steps;
}

// The ratio within each repeat; then the median of these.
double ratio(const Runner& textbook, const Runner& runner) {
    std::vector<double> ratios;
    for (std::size_t n = 0; n < runner.measurements.size(); ++n) {
        ratios.push_back(step_seconds(textbook.measurements[n]) /
                         step_seconds(runner.measurements[n]));
    }
    return median(std::move(ratios));
}

Row row_of(const Runner& runner, const Runner* textbook, const Machine& machine) {
    const Entry& entry = runner.entry;
    Row row;
    row.label = entry.label;
    row.note = entry.note;
    if (!runner.failure.empty()) {
        row.note = runner.failure;
        row.diverged = true;
        return row;
    }
    if (!runner.contestant) return row;
    const Measurement& last = runner.measurements.back();
    if (last.frames > 0.0) {
        row.ms_per_frame =
            runner.median_of([](const Measurement& m) { return 1e3 * m.seconds / m.frames; });
    }
    row.sag = last.sag;
    if (last.steps == 0.0) return row;
    const double seconds = runner.median_of(step_seconds);
    row.ns_per_particle_step = 1e9 * seconds / (double(entry.label.columns) * entry.label.rows);
    if (entry.flops_per_step > 0.0) {
        row.gflops = 1e-9 * entry.flops_per_step / seconds;
        row.fraction_of_peak =
            *row.gflops / (machine.peak(entry.label.precision) * entry.label.threads);
    }
    if (entry.against_textbook && textbook != nullptr) {
        row.ratio_to_textbook = ratio(*textbook, runner);
    }
    return row;
}

std::vector<Row> rows_of(const std::vector<Runner>& runners, const Machine& machine) {
    const auto textbook = std::ranges::find_if(
        runners, [](const Runner& r) { return r.entry.label.name == textbook_name; });
    std::vector<Row> rows;
    for (const Runner& runner : runners) {
        if (!runner.entry.shown) continue;
        rows.push_back(row_of(runner, textbook == runners.end() ? nullptr : &*textbook, machine));
    }
    return rows;
}

}  // namespace

Machine measure_machine() {
    Machine machine;
    machine.processor = processor_name();
    machine.threads = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
    machine.instruction_set = instruction_set();
#ifdef __clang__
    machine.compiler = "clang " __clang_version__;
#else
    machine.compiler = "g++ " __VERSION__;
#endif
    machine.peak_single = peak_single();
    machine.peak_double = peak_double();
    const auto add = [&](const char* where, std::size_t bytes) {
        machine.bandwidths.push_back({where, bytes, update_bandwidth(bytes)});
    };
    add("first-level cache", first_level_cache() / 2);
    add("second-level cache", second_level_cache() / 2);
    add("8 MiB", std::size_t{8} << 20);
    add("128 MiB", std::size_t{128} << 20);
    machine.boost = boost_version_built_in();
    machine.bullet = bullet_version_built_in();
    return machine;
}

std::vector<Row> time_group(const Group& group, const Machine& machine, double least_seconds,
                            const std::function<bool()>& stop) {
    std::vector<Runner> runners;
    for (const Entry& entry : group.entries) {
        if (stop()) return {};
        runners.push_back({entry});
        runners.back().make();
    }
    for (int n = 0; n < group.repeats; ++n) {
        for (Runner& runner : runners) {
            if (stop()) return {};
            runner.measure(least_seconds);
        }
    }
    return rows_of(runners, machine);
}

}  // namespace weft::bench
