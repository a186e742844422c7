// The experiment "order": how the error of every method falls with its step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "lab/experiment.h"
#include "lab/order/order_plot.h"
#include "lab/order/order_problems.h"

namespace weft::lab {

namespace {

constexpr double as_stated = 0.1;  // an order is as stated within so much

// A method on a problem.
struct Measured {
    std::string_view method;
    int stated = 0;
    Errors errors;
    OrderFit positions, velocities;

    [[nodiscard]] bool confirmed() const {
        return positions.points > 0 && std::abs(positions.order - stated) <= as_stated;
    }
};

struct Results {
    OrderProblem problem;
    std::vector<Measured> methods;  // empty where the problem has no end
};

Measured fitted(const OrderProblem& problem, const IntegratorInfo& info, Errors errors) {
    Measured measured{info.name, problem.stated(info), std::move(errors), {}, {}};
    const double floor = error_floor(problem.ends.reference_error, info);
    const double per_second = problem.ends.limit > 0.0 ? 1.0 / problem.ends.limit : 1.0;
    measured.positions = fit_order(measured.errors.of_positions(), floor);
    measured.velocities = fit_order(measured.errors.of_velocities(), floor * per_second);
    return measured;
}

std::vector<OrderProblem> problems_with_ends(Laboratory& laboratory) {
    std::vector<OrderProblem> problems = order_problems(laboratory.scene());
    std::vector<Trial> trials;
    for (const OrderProblem& problem : problems) {
        trials.push_back({"end of " + problem.key,
                          [&problem, quick = laboratory.quick()](const Watch& watch) {
                              const ClothModel cloth = build_cloth(problem.scene);
                              return stretch_to_json(cloth, find_ends(problem, quick, watch));
                          },
                          problem.smooth() ? 1.0 : 10.0});
    }
    const std::vector<nlohmann::json> ends = laboratory.run(trials);
    for (std::size_t n = 0; n < problems.size(); ++n) {
        problems[n].ends = stretch_from_json(build_cloth(problems[n].scene), ends[n]);
    }
    return problems;
}

Trial errors_trial(const OrderProblem& problem, const IntegratorInfo& info, std::size_t particles,
                   bool quick) {
    const StepCounts counts = step_counts(problem, info, particles, quick);
    const double steps = static_cast<double>(2 * counts.most * particles);
    const bool explicit_steps = info.kind == IntegratorKind::explicit_steps;
    return {fmt::format("{} on {} in {} to {} steps{}", info.name, problem.key, counts.first,
                        counts.most, counts.halfway ? " and between" : ""),
            [&problem, &info, counts](const Watch& watch) {
                Specimen specimen(problem.scene);
                const KnownEnd known{problem.ends.start, problem.ends.end};
                return errors_to_json(measure_errors(specimen, info.name, known, counts,
                                                     problem.ends.reference_error, watch));
            },
            steps * (explicit_steps ? 1.0 : 50.0)};
}

std::vector<Results> measure(Laboratory& laboratory, const std::vector<OrderProblem>& problems) {
    std::vector<Trial> trials;
    for (const OrderProblem& problem : problems) {
        if (!problem.ends.failure.empty()) continue;
        const std::size_t particles = build_cloth(problem.scene).particle_count;
        for (const std::string_view method : laboratory.methods()) {
            trials.push_back(
                errors_trial(problem, *find_integrator(method), particles, laboratory.quick()));
        }
    }
    const std::vector<nlohmann::json> found = laboratory.run(trials);
    std::vector<Results> results;
    std::size_t next = 0;
    for (const OrderProblem& problem : problems) {
        results.push_back({problem, {}});
        if (!problem.ends.failure.empty()) continue;
        for (const std::string_view method : laboratory.methods()) {
            results.back().methods.push_back(
                fitted(problem, *find_integrator(method), errors_from_json(found[next++])));
        }
    }
    return results;
}

// Why an order is not what is stated, from what was measured.
std::string reason(const OrderProblem& problem, const Measured& measured) {
    const auto& points = measured.errors.points;
    if (points.empty()) return "not measured: too much work with so many particles";
    if (measured.positions.points == 0) {
        return measured.errors.failure().empty() ? "no error above the reference's"
                                                 : measured.errors.failure();
    }
    if (measured.confirmed()) return {};
    if (measured.positions.points < 3) return "all other errors are below the reference's";
    if (problem.ends.edge_on > 0 && measured.stated > 2 &&
        measured.positions.order < measured.stated) {
        return fmt::format("the air met {} triangles edge-on, where its force has a kink",
                           problem.ends.edge_on);
    }
    std::string text =
        measured.positions.straight ? "not yet in the range of its order" : "no straight range";
    const std::size_t count = points.size();
    if (count >= 2 && points[count - 1].x > 0.0 && std::isfinite(points[count - 2].x)) {
        text += fmt::format(": slope {:.2f} between the two shortest steps",
                            std::log2(points[count - 2].x / points[count - 1].x));
    }
    return text;
}

std::string failed_steps(const Measured& measured) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Errors::Point& point : measured.errors.points) {
        if (!point.failure.empty()) shortest = std::min(shortest, point.step);
    }
    return std::isfinite(shortest) ? fmt::format("blew up at {:.2g} s and above", shortest) : "";
}

std::string note(const OrderProblem& problem, const Measured& measured) {
    const std::string why = reason(problem, measured), failed = failed_steps(measured);
    if (why.empty() || measured.positions.points == 0) return why.empty() ? failed : why;
    return failed.empty() ? why : why + "; " + failed;
}

Cell last_error(const Measured& measured) {
    if (measured.errors.points.empty()) return {};
    return measured.errors.points.back().x;
}

Cell order_cell(const OrderFit& fit) {
    return fit.points > 0 ? Cell{fit.order} : Cell{std::string("none")};
}

Table summary_table(const std::vector<Results>& results) {
    Table table{"orders",
                "Orders of the methods: stated, and measured on each problem.",
                {{"method", 0}, {"stated"}, {"stated, damped"}},
                {}};
    for (const Results& result : results) {
        if (!result.methods.empty()) table.columns.push_back({result.problem.title, 3});
    }
    for (std::size_t n = 0; n < results[0].methods.size(); ++n) {
        const IntegratorInfo& info = *find_integrator(results[0].methods[n].method);
        std::vector<Cell> row{std::string(info.name), static_cast<double>(info.order),
                              static_cast<double>(info.damped_order)};
        for (const Results& result : results) {
            if (!result.methods.empty()) row.push_back(order_cell(result.methods[n].positions));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table problem_table(const Results& result) {
    Table table{"fits-" + result.problem.key,
                fmt::format("Fits on {}: a row is a method. The order is the slope over the steps "
                            "from shortest to longest.",
                            result.problem.title),
                {{"method", 0},
                 {"stated"},
                 {"measured", 3},
                 {"shortest step [s]", 2},
                 {"longest step [s]", 2},
                 {"points"},
                 {"order of velocities", 3},
                 {"error at the shortest step [m]", 2},
                 {"note", 0}},
                {}};
    for (const Measured& measured : result.methods) {
        const OrderFit& fit = measured.positions;
        const bool found = fit.points > 0;
        table.rows.push_back({std::string(measured.method), static_cast<double>(measured.stated),
                              order_cell(fit), found ? Cell{fit.smallest} : Cell{},
                              found ? Cell{fit.largest} : Cell{}, static_cast<double>(fit.points),
                              order_cell(measured.velocities), last_error(measured),
                              note(result.problem, measured)});
    }
    return table;
}

Plot problem_plot(const Results& result) {
    std::vector<MethodErrors> lines;
    for (const Measured& measured : result.methods) {
        lines.push_back({measured.method, measured.errors.of_positions(), measured.positions});
    }
    return order_plot("error-" + result.problem.key,
                      fmt::format("Error against step: {}", result.problem.title),
                      "rms error of positions at the end [m]", lines);
}

// What the answer says of the smooth problems.
std::string smooth_answer(const std::vector<Results>& results) {
    double worst = 0.0;
    std::string where;
    std::size_t methods = 0, failed = 0;
    std::string failures;
    for (const Results& result : results) {
        if (!result.problem.smooth()) continue;
        methods = result.methods.size();
        for (const Measured& measured : result.methods) {
            const double off = std::abs(measured.positions.order - measured.stated);
            if (off > worst) {
                worst = off;
                where =
                    fmt::format("{}, {:.2f} for {}, on {}", measured.method,
                                measured.positions.order, measured.stated, result.problem.title);
            }
            if (measured.confirmed()) continue;
            failures += fmt::format("{}{} on {}", failed++ > 0 ? ", " : "", measured.method,
                                    result.problem.title);
        }
    }
    if (failed == 0) {
        return fmt::format(
            "On the smooth problems {} show the stated order within {:.2f} (furthest off: {})",
            methods == 1 ? "the method does" : fmt::format("all {} methods", methods),
            std::max(0.01, std::ceil(100.0 * worst) / 100.0), where);
    }
    return fmt::format(
        "On the smooth problems every method shows its stated order within {}, but "
        "not {}",
        as_stated, failures);
}

std::string scene_answer(const Results& scene) {
    if (scene.methods.empty()) {
        return "; on the scene it could not be measured: " + scene.problem.ends.failure + ".";
    }
    std::string others;
    std::size_t confirmed = 0, exact = 0, left_out = 0;
    for (const Measured& measured : scene.methods) {
        const OrderFit& fit = measured.positions;
        if (measured.confirmed()) {
            ++confirmed;
        } else if (measured.errors.points.empty()) {
            ++left_out;
        } else if (fit.points == 0 && measured.errors.failure().empty()) {
            ++exact;
        } else {
            others += fmt::format("{}{} {}", others.empty() ? "" : ", ", measured.method,
                                  fit.points > 0
                                      ? fmt::format("{:.2f} for {}", fit.order, measured.stated)
                                      : std::string("failed"));
        }
    }
    std::string text = fmt::format("; on the scene {} of {} do within {}", confirmed,
                                   scene.methods.size(), as_stated);
    if (!others.empty()) text += " (not " + others + ")";
    if (exact > 0)
        text += fmt::format(", {} {} as exact as the reference", exact, exact == 1 ? "is" : "are");
    if (left_out > 0) text += fmt::format(", {} would take too much work", left_out);
    return text + ".";
}

}  // namespace

Section measure_order(Laboratory& laboratory) {
    const std::vector<OrderProblem> problems = problems_with_ends(laboratory);
    const std::vector<Results> results = measure(laboratory, problems);
    Section section;
    section.method =
        "A method is of order p where its error is proportional to dt^p for short steps: half the "
        "step, an error 2^p times smaller, a straight line of slope p where both axes are "
        "logarithmic. Every method flies four problems with steps that are halved again and again "
        "(of order 4 and more, also two thirds as long); the error is the root mean square "
        "distance of the particles from the known solution at "
        "the "
        "end. Implicit systems are solved to 1e-12 m, methods that iterate do so until they "
        "converge (xpbd 20, vbd 40, projective-dynamics up to 200 iterations), and adaptive pairs "
        "take the steps they are given. The order is the slope of a least-squares line over the "
        "range in which it is straight: beginning with the shortest steps, four or more points "
        "between which slopes differ by at most 0.1 (three where there are no four). Errors below "
        "20 times that of the reference are left out.";
    section.blocks.emplace_back(summary_table(results));
    for (const Results& result : results) {
        section.blocks.emplace_back(Paragraph{result.problem.text()});
        if (result.methods.empty()) continue;
        section.blocks.emplace_back(problem_plot(result));
        section.blocks.emplace_back(problem_table(result));
    }
    const Results& scene = results.back();
    section.answer = smooth_answer(results) + scene_answer(scene);
    for (const Measured& measured : scene.methods) {
        if (measured.positions.points == 0) continue;
        section.findings.push_back({fmt::format("order of {} on the scene", measured.method),
                                    measured.positions.order, ""});
    }
    return section;
}

}  // namespace weft::lab
