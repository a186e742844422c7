// The parts of the experiment on rest and blow-up: each asks for its runs, and tells what they came
// to once they are made.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/section.h"
#include "lab/seed_sheet.h"
#include "lab/settle/rest_batch.h"

namespace weft::lab {

/// How long the runs on the comparison's sheet last [s]: beyond its printed 15 s.
inline double settle_duration(bool quick) {
    return quick ? 16.0 : 30.0;
}
/// The damping that the tables call moderate: 0.5 /s on every particle, c = 2 ms k in every spring.
inline constexpr double moderate_drag = 0.5, moderate_dashpots = 2e-3;

/// Adds a run on the comparison's sheet.
std::size_t add_seed_run(RestBatch& batch, const SeedSheet& sheet, std::string_view method,
                         double time_step, double duration);

/// "3.2 s", or "not within 30 s".
std::string time_text(const std::optional<double>& time, double duration);
Cell time_cell(const std::optional<double>& time);

/// The comparison's table 2 on its own sheet, with what it does not print filled in both ways.
class SeedTable {
public:
    SeedTable(RestBatch& batch, const std::vector<std::string_view>& methods, bool quick);

    /// Table 2 beside ours, and all runs.
    void tell(const RestBatch& batch, Section& section) const;
    /// When each is wrecked, undamped at the step that the comparison implies; and whether times to
    /// rest tell methods apart.
    [[nodiscard]] std::string sentence(const RestBatch& batch) const;

private:
    struct Run {
        SeedSheet sheet;
        double time_step;
        std::string_view method;
        std::size_t place;
    };
    [[nodiscard]] const RestRun& run_of(const RestBatch& batch, bool damped, double time_step,
                                        std::string_view method) const;
    [[nodiscard]] Table printed(const RestBatch& batch) const;
    [[nodiscard]] Table all(const RestBatch& batch) const;

    std::vector<Run> runs_;
    double duration_;
};

/// "Verlet wrecked first, then Forward Euler, Runge-Kutta last or never": what the authors print.
bool in_printed_order(const RestRun& verlet, const RestRun& euler, const RestRun& kutta);

/// One thing changed at a time, over a range: mass, dashpots, step.
class SettleSweeps {
public:
    SettleSweeps(RestBatch& batch, bool quick);

    void tell(const RestBatch& batch, Section& section) const;
    /// Which dashpots give the printed order.
    [[nodiscard]] std::string sentence(const RestBatch& batch) const;
    /// Of the steps at which both Verlet and Euler with the new velocity are wrecked: how many, and
    /// at how many Verlet is first.
    struct Race {
        int both = 0, verlet_first = 0;
    };
    [[nodiscard]] Race race(const RestBatch& batch) const;

private:
    struct Sweep {
        std::vector<std::string> updates;
        std::vector<double> values;                    ///< what is varied
        std::vector<std::vector<std::size_t>> places;  ///< [value][update]
    };
    template <typename SheetOf>
    Sweep sweep(RestBatch& batch, std::vector<std::string> updates, std::vector<double> values,
                const SheetOf& sheet_and_step) const;
    [[nodiscard]] Plot plot(const RestBatch& batch, const Sweep& sweep) const;

    double duration_;
    Sweep masses_, dashpots_, steps_;
};

/// Why the authors saw what they saw: what each misprint and slip does, undamped and damped.
class SettleCauses {
public:
    SettleCauses(RestBatch& batch, bool quick);

    /// @param race how far the order of Verlet and Euler with the new velocity is chance.
    void tell(const RestBatch& batch, SettleSweeps::Race race, Section& section) const;
    /// Which misprints and slips give the printed order, and whose wrinkles Verlet's are.
    [[nodiscard]] std::string sentence(const RestBatch& batch, SettleSweeps::Race race) const;

private:
    enum class Role { verlet, euler, kutta, exact };
    struct Run {
        SeedSheet sheet;
        std::string update;
        Role role;
        std::size_t place;
        double duration;
    };
    struct Four {
        const RestRun *verlet, *euler, *kutta, *exact;
    };
    void add(RestBatch& batch, const SeedSheet& sheet, std::string_view update, Role role,
             double time_step, double duration);
    void add_updates(RestBatch& batch, const SeedSheet& sheet, bool quick);
    [[nodiscard]] Four base(const RestBatch& batch, const SeedSheet& sheet) const;
    [[nodiscard]] Four with(const RestBatch& batch, const Run& run) const;
    [[nodiscard]] std::string verdict(const RestBatch& batch, const Run& run,
                                      SettleSweeps::Race race) const;
    [[nodiscard]] Table causes(const RestBatch& batch, SettleSweeps::Race race) const;
    [[nodiscard]] Plot wrinkles(const RestBatch& batch) const;

    std::vector<Run> runs_;
    double duration_;
};

/// The same question to the study's own scene, where it is another than the comparison's sheet.
class SettleScene {
public:
    /// Adds nothing where the scene is the comparison's sheet.
    SettleScene(RestBatch& batch, const SceneDescription& scene,
                const std::vector<std::string_view>& methods, bool quick);

    void tell(const RestBatch& batch, Section& section) const;
    /// Empty where the scene is the comparison's sheet.
    [[nodiscard]] std::string sentence(const RestBatch& batch) const;

private:
    struct Run {
        std::string_view method;
        double time_step, limit;  ///< [s]; predicted: 0: none
        std::size_t place;
    };
    std::vector<Run> runs_;
    double duration_ = 0.0, asked_duration_ = 0.0;
    bool moved_ = false;  ///< by wind or pins
};

}  // namespace weft::lab
