#include "bench/suite/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/peers/built_in.h"
#include "bench/peers/textbook.h"
#include "bench/suite/flops.h"
#include "bench/suite/scenes.h"
#include "weft/error.h"
#include "weft/integrators.h"

namespace weft::bench {

namespace {

constexpr std::array precisions{Precision::f32, Precision::f64};
constexpr int target_repeats = 5;  // the others have three
// weft's own work at the end of a frame is that of some steps: a frame must have many more.
constexpr int fewest_evaluations_in_frame = 32, fewest_in_target = 384;

// Methods timed on all threads at every size; the others up to 256 x 256.
bool is_principal(std::string_view method) {
    return method == "symplectic-euler" || method == "velocity-verlet" || method == "rk4";
}

class Planner {
public:
    Planner(const PlanOptions& options, int threads) : options_(options), threads_(threads) {}

    Plan plan() {
        for (const int size : {40, 100, 256, 512, 1024}) {
            if (options_.quick && size > 256) continue;
            for (const IntegratorInfo& info : integrator_catalogue()) {
                if (info.kind != IntegratorKind::explicit_steps) continue;
                add_one_thread(size, info);
                if (size <= 256 || is_principal(info.name)) add_all_threads(size, info);
            }
        }
        const IntegratorInfo& symplectic = *find_integrator("symplectic-euler");
        if (!options_.quick) add_one_thread(1000, symplectic);
        add_mesh(256, symplectic);
        add_flag(256);
        for (const int size : {40, 100}) {
            if (options_.quick && size > 40) continue;
            add_soft_body(size);
            add_hanging(size);
        }
        if (options_.large) {
            for (const int size : {64, 512, 2048, 4096}) add_large(size, symplectic);
        }
        add_frames();
        add_motions();
        return std::move(plan_);
    }

private:
    [[nodiscard]] Stepping stepping(const IntegratorInfo& info, int size, Precision precision,
                                    int threads, int fewest) const {
        const double guess = info.evaluations * static_cast<double>(size) * size *
                             (precision == Precision::f32 ? 3e-9 : 7e-9) / threads;  // [s] a step
        const double wanted = std::ceil(options_.least_seconds() / guess);
        const int least = std::max(1, fewest / info.evaluations);
        return {info.name, precision, static_cast<int>(std::clamp(wanted, double(least), 1e6))};
    }

    [[nodiscard]] Entry sheet_entry(std::string name, const PlainSheet& sheet,
                                    const IntegratorInfo& info, Precision precision,
                                    int threads) const {
        Entry entry;
        entry.label = {std::move(name), sheet.columns, sheet.rows, precision, threads};
        entry.flops_per_step = flops_per_step(sheet, info.evaluations);
        entry.against_textbook = true;
        return entry;
    }

    [[nodiscard]] Entry weft_entry(const PlainSheet& sheet, const IntegratorInfo& info,
                                   Precision precision, int threads) const {
        const int fewest =
            info.name == "symplectic-euler" ? fewest_in_target : fewest_evaluations_in_frame;
        const Stepping how = stepping(info, sheet.columns, precision, threads, fewest);
        Entry entry = sheet_entry(std::string(info.name), sheet, info, precision, threads);
        entry.make = [=] { return make_stepping(sheet_scene(sheet, how), threads); };
        return entry;
    }

    // Peers run in double and on one thread.
    [[nodiscard]] Entry peer_entry(std::string name, const PlainSheet& sheet,
                                   const IntegratorInfo& info, MakePeer make) const {
        Entry entry = sheet_entry(std::move(name), sheet, info, Precision::f64, 1);
        if (make != nullptr) entry.make = [=] { return make_stepping(make(sheet)); };
        if (make == nullptr) entry.note = "not built in: Boost not found";
        return entry;
    }

    [[nodiscard]] Group group_with_textbook(const PlainSheet& sheet) const {
        Group group;
        group.entries.push_back(peer_entry(std::string(textbook_name), sheet,
                                           *find_integrator("symplectic-euler"), make_textbook));
        group.entries.front().shown = false;
        return group;
    }

    void add_one_thread(int size, const IntegratorInfo& info) {
        const PlainSheet sheet{.columns = size, .rows = size};
        Group group = group_with_textbook(sheet);
        if (info.name == "symplectic-euler") {
            group.repeats = target_repeats;
            group.entries.front().shown = true;
        }
        for (const Precision precision : precisions) {
            group.entries.push_back(weft_entry(sheet, info, precision, 1));
        }
        if (info.name == "rk4") {
            group.repeats = target_repeats;
            group.entries.push_back(peer_entry("odeint rk4", sheet, info, odeint_rk4));
        } else if (info.name == "velocity-verlet") {
            group.entries.push_back(
                peer_entry("odeint velocity_verlet", sheet, info, odeint_velocity_verlet));
        }
        add(std::move(group));
    }

    void add_all_threads(int size, const IntegratorInfo& info) {
        if (threads_ < 2) return;
        const PlainSheet sheet{.columns = size, .rows = size};
        Group group = group_with_textbook(sheet);
        for (const Precision precision : precisions) {
            group.entries.push_back(weft_entry(sheet, info, precision, threads_));
            if (info.name == "symplectic-euler") {
                group.entries.push_back(copies_entry(sheet, info, precision));
            }
        }
        add(std::move(group));
    }

    [[nodiscard]] Entry copies_entry(const PlainSheet& sheet, const IntegratorInfo& info,
                                     Precision precision) const {
        const Stepping how = stepping(info, sheet.columns, precision, 1, fewest_in_target);
        const PinnedCopies::Job job{sheet.columns, sheet.rows, how.steps_per_frame, precision,
                                    static_cast<int>(&info - integrator_catalogue().data())};
        Entry entry = sheet_entry(fmt::format("pinned copies {}", info.name), sheet, info,
                                  precision, threads_);
        entry.make = [copies = plan_.copies, job] { return copies->make(job); };
        return entry;
    }

    void add_mesh(int size, const IntegratorInfo& info) {
        const PlainSheet sheet{.columns = size, .rows = size};
        Group group = group_with_textbook(sheet);
        group.repeats = target_repeats;
        for (const Precision precision : precisions) {
            const Stepping how = stepping(info, size, precision, 1, fewest_in_target);
            Entry entry = sheet_entry(fmt::format("mesh {}", info.name), sheet, info, precision, 1);
            entry.make = [=] { return make_stepping(mesh_scene(sheet, how), 1); };
            group.entries.push_back(std::move(entry));
        }
        add(std::move(group));
    }

    void add_flag(int size) {
        const IntegratorInfo& info = *find_integrator("velocity-verlet");
        Group group;
        group.repeats = target_repeats;
        for (const Precision precision : precisions) {
            for (const bool wind : {false, true}) {
                const Stepping how = stepping(info, size, precision, 1, fewest_in_target);
                Entry entry;
                entry.label = {wind ? "flag with wind" : "flag without wind", size, size, precision,
                               1};
                entry.make = [=] { return make_stepping(flag_scene(size, size, wind, how), 1); };
                group.entries.push_back(std::move(entry));
            }
        }
        add(std::move(group));
    }

    [[nodiscard]] static Entry two_seconds(std::string name, const PlainSheet& sheet) {
        Entry entry;
        entry.label = {std::move(name), sheet.columns, sheet.rows, Precision::f32, 1};
        return entry;
    }

    static Entry ours(std::string name, const PlainSheet& sheet, std::string_view method,
                      std::optional<double> time_step) {
        Entry entry = two_seconds(std::move(name), sheet);
        entry.make = [=] {
            return make_two_seconds(sheet, sheet_at_60_hertz(sheet, method, time_step));
        };
        return entry;
    }

    static Entry bullets(std::string name, const PlainSheet& sheet, MakePeer make) {
        Entry entry = two_seconds(std::move(name), sheet);
        if (make != nullptr) entry.make = [=] { return make_two_seconds(sheet, make); };
        if (make == nullptr) entry.note = "not built in: Bullet not found";
        return entry;
    }

    // With enough drag to hang still after two seconds, so that the sag is one of rest.
    void add_soft_body(int size) {
        const PlainSheet sheet{.columns = size, .rows = size, .drag = 1e-3};
        Group group;
        group.entries.push_back(ours("velocity-verlet at 60 Hz", sheet, "velocity-verlet", {}));
        group.entries.push_back(bullets("bullet soft body at 60 Hz", sheet, bullet_soft_body));
        add(std::move(group));
    }

    void add_hanging(int size) {
        const PlainSheet sheet = hanging_sheet(size);
        Group group;
        group.entries.push_back(ours("hanging auto", sheet, "auto", {}));
        for (const char* method : {"tr-bdf2", "implicit-euler"}) {
            group.entries.push_back(
                ours(fmt::format("hanging {}", method), sheet, method, 1.0 / 60.0));
        }
        group.entries.push_back(bullets("hanging bullet-deformable", sheet, bullet_deformable));
        add(std::move(group));
    }

    // Without the textbook, whose springs alone take 3 GB at 4096 x 4096, and one at a time.
    void add_large(int size, const IntegratorInfo& info) {
        const PlainSheet sheet{.columns = size, .rows = size};
        for (const Precision precision : precisions) {
            Entry entry = weft_entry(sheet, info, precision, 1);
            entry.label.name = fmt::format("growth {}", info.name);
            entry.against_textbook = false;
            Group group;
            group.entries.push_back(std::move(entry));
            add(std::move(group));
        }
    }

    void add_frames() {
        for (FrameGroup& group : frame_groups(options_.quick)) {
            if (options_.repeats) group.repeats = *options_.repeats;
            for (FrameEntry& entry : group.entries) {
                entry.shown = entry.label.has_words(options_.filter);
            }
            const bool any = std::ranges::any_of(group.entries, &FrameEntry::shown);
            std::erase_if(group.entries, [](const FrameEntry& entry) {
                return !entry.shown && entry.label.name != cholesky_frame_name;
            });
            if (any) plan_.frames.push_back(std::move(group));
        }
    }

    void add_motions() {
        plan_.motion_repeats = options_.repeats.value_or(options_.quick ? 1 : 3);
        for (MotionEntry& entry : motion_entries()) {
            if (entry.label.has_words(options_.filter)) plan_.motions.push_back(std::move(entry));
        }
    }

    void add(Group group) {
        const auto is_textbook = [](const Entry& e) { return e.label.name == textbook_name; };
        for (Entry& entry : group.entries) {
            entry.shown = entry.shown && entry.label.has_words(options_.filter);
        }
        std::erase_if(group.entries, [&](const Entry& e) { return !e.shown && !is_textbook(e); });
        // The yardstick alone is timed only where it was asked for.
        const auto needs_yardstick = [&](const Entry& e) {
            return e.shown && e.against_textbook && e.make != nullptr;
        };
        if (std::ranges::none_of(group.entries, needs_yardstick)) {
            std::erase_if(group.entries, is_textbook);
        }
        if (group.entries.empty()) return;
        if (options_.quick) group.repeats = 1;
        if (options_.repeats) group.repeats = *options_.repeats;
        for (const Entry& entry : group.entries) {
            plan_.needs_copies |= entry.label.name.starts_with("pinned copies");
        }
        plan_.groups.push_back(std::move(group));
    }

    const PlanOptions& options_;
    int threads_;
    Plan plan_;
};

}  // namespace

Plan make_plan(const PlanOptions& options, int threads) {
    Plan plan = Planner(options, threads).plan();
    if (!plan.groups.empty() || !plan.frames.empty() || !plan.motions.empty()) return plan;
    throw Error(ErrorKind::usage, {.key = fmt::format("--filter \"{}\"", options.filter)},
                "no case has all of these words",
                "Cases are named like \"rk4 256x256 single 1 thread\", \"textbook 40x40 double 1 "
                "thread\",\n\"mesh symplectic-euler\", \"flag with wind\", \"odeint\", \"bullet\", "
                "\"pinned copies\",\n\"implicit frame multigrid\", \"motion tr-bdf2 2\"; --quick "
                "has only those up to 256x256.");
}

}  // namespace weft::bench
