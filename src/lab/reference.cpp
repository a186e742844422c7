#include "lab/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "lab/kinks.h"

namespace weft::lab {

namespace {

constexpr int most_columns = 10;           // of the tableau
constexpr double looser = 10.0;            // tolerance of the solution that estimates the error
constexpr int first_columns = 5;           // of the first step
constexpr double first_length = 0.01;      // [s]
constexpr double shortest_length = 1e-11;  // [s]

// Column j splits a step into 2, 4, 6, ... parts; j counts from 1.
constexpr int parts(int column) {
    return 2 * column;
}

// Evaluations of a step with so many columns: the first slope is shared.
constexpr double work(int columns) {
    double sum = 1.0;
    for (int j = 1; j <= columns; ++j) sum += parts(j);
    return sum;
}

struct Motion {
    Vec3Array<double> x, v;
};

// to = from + factor * by
void add_to(const Vec3Array<double>& from, double factor, const Vec3Array<double>& by,
            Vec3Array<double>& to) {
    for (std::size_t n = 0; n < to.data_size(); ++n) {
        to.data()[n] = from.data()[n] + factor * by.data()[n];
    }
}

class Extrapolation {
public:
    Extrapolation(Specimen& specimen, double tolerance, const Watch& watch)
        : specimen_(specimen), tolerance_(tolerance), watch_(watch) {
        const std::size_t slots = specimen.cloth().layout.slot_count();
        for (Motion* motion : {&before_, &now_, &start_slope_}) {
            *motion = {Vec3Array<double>(slots), Vec3Array<double>(slots)};
        }
        table_.resize(most_columns, {Vec3Array<double>(slots), Vec3Array<double>(slots)});
        slope_ = Vec3Array<double>(slots);
    }

    // @return false where a step would have to be too short.
    bool advance(ParticleState<double>& state, double t_end) {
        while (state.time < t_end - shortest_length) {
            const double left = t_end - state.time;
            const bool last = length_ >= 0.99 * left;
            const double intended = length_;
            if (last) length_ = left;
            if (!step(state)) return false;
            // A step cut short by the end says nothing against longer ones.
            if (last && state.time >= t_end - shortest_length) {
                length_ = std::max(length_, intended);
            }
        }
        state.time = t_end;
        return true;
    }

    std::size_t evaluations = 0, steps = 0;

private:
    // Of the present step, of `columns` columns: its error in tolerances, the length that would
    // just meet them, and the work per length.
    struct Estimate {
        double error = 0.0, length = 0.0, cost = 0.0;
    };

    bool step(ParticleState<double>& state) {
        evaluate(state.time, state.x, state.v, start_slope_.v);
        start_slope_.x = state.v;
        while (true) {
            const int used = try_step(state);
            if (used > 0) {
                state.x = table_[0].x;
                state.v = table_[0].v;
                state.time += length_;
                specimen_.system().constrain(state.time, state.x.view(), state.v.view());
                ++steps;
                choose_next(used);
                return true;
            }
            if (length_ < shortest_length) return false;
        }
    }

    // Adds columns until the error is met, or will not be: the column that met it, or 0 with a
    // shorter length to try.
    int try_step(const ParticleState<double>& state) {
        const double h = length_;
        int tried = 0;
        for (int j = 1; j <= std::min(target_ + 1, most_columns); ++j) {
            add_column(state, h, j);
            if (j == 1) continue;
            estimates_[at(j)] = estimate(h, j);
            const double error = estimates_[at(j)].error;
            if (!std::isfinite(error)) {
                length_ = 0.1 * h;
                return 0;
            }
            if (j >= target_ - 1 && error <= 1.0) return j;
            if (j < target_ - 1) continue;
            tried = j;
            if (error > gain_after(j)) break;
        }
        shorten(h, tried);
        return 0;
    }

    // What the columns to come would divide the error by in the asymptotic range.
    [[nodiscard]] double gain_after(int column) const {
        double gain = 1.0;
        for (int j = column + 1; j <= std::min(target_ + 1, most_columns); ++j) {
            const double ratio = static_cast<double>(parts(j)) / parts(1);
            gain *= ratio * ratio;
        }
        return gain;
    }

    void shorten(double h, int tried) {
        target_ = std::clamp(tried, 2, target_);
        if (target_ > 2 && estimates_[at(target_ - 1)].cost < 0.8 * estimates_[at(target_)].cost) {
            --target_;
        }
        length_ = std::min(estimates_[at(target_)].length, 0.7 * h);
    }

    // Order and length of the next step: least work per length (HNW II.9, eqs. 9.27 to 9.30).
    void choose_next(int used) {
        const auto cost = [&](int j) { return estimates_[at(j)].cost; };
        int next = used;
        if (used > 2 && cost(used - 1) < 0.8 * cost(used)) {
            next = used - 1;
        } else if (used == 2 || cost(used) < 0.9 * cost(used - 1)) {
            next = used + 1;
        }
        next = std::clamp(next, 3, most_columns - 1);
        length_ = next <= used ? estimates_[at(next)].length
                               : estimates_[at(used)].length * work(next) / work(used);
        target_ = next;
    }

    Estimate estimate(double h, int column) {
        double squares = 0.0, largest = 0.0;
        const auto add = [&](const Vec3Array<double>& better, const Vec3Array<double>& worse) {
            for (std::size_t n = 0; n < better.data_size(); ++n) {
                const double difference = better.data()[n] - worse.data()[n];
                squares += difference * difference;
                largest = std::max(largest, std::abs(better.data()[n]));
            }
        };
        add(table_[0].x, table_[1].x);
        add(table_[0].v, table_[1].v);
        constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
        const double allowed = std::max(tolerance_, rounding * largest);
        const double rms = std::sqrt(squares / static_cast<double>(specimen_.particle_count()));
        const double error = rms / allowed;
        const double power = 1.0 / (2.0 * column - 1.0);
        const double factor = 0.94 * std::pow(0.65 / std::max(error, 1e-30), power);
        const double least = std::pow(0.02, power);
        const double length = h * std::clamp(factor, least / 4.0, 1.0 / least);
        return {error, length, work(column) / length};
    }

    // The midpoint rule with parts(column) parts, and from it and the columns before a better
    // result in table_[0]; table_[1] is then the second best (Aitken, Neville).
    void add_column(const ParticleState<double>& state, double h, int column) {
        const std::size_t last = static_cast<std::size_t>(column) - 1;
        midpoint_rule(state, h, parts(column), table_[last]);
        for (std::size_t l = last; l > 0; --l) {
            const double ratio = static_cast<double>(parts(column)) / parts(static_cast<int>(l));
            const double weight = 1.0 / (ratio * ratio - 1.0);
            extrapolate(table_[l].x, weight, table_[l - 1].x);
            extrapolate(table_[l].v, weight, table_[l - 1].v);
        }
    }

    static void extrapolate(const Vec3Array<double>& fine, double weight,
                            Vec3Array<double>& coarse) {
        for (std::size_t n = 0; n < fine.data_size(); ++n) {
            const double better = fine.data()[n];
            coarse.data()[n] = better + weight * (better - coarse.data()[n]);
        }
    }

    // Gragg's: its error expands in even powers of h / count.
    void midpoint_rule(const ParticleState<double>& state, double h, int count, Motion& result) {
        watch_();
        const double part = h / count;
        before_.x = state.x;
        before_.v = state.v;
        add_to(before_.x, part, start_slope_.x, now_.x);
        add_to(before_.v, part, start_slope_.v, now_.v);
        for (int n = 1; n <= count; ++n) {
            const double t = n == count ? state.time + h : state.time + n * part;
            specimen_.system().constrain(t, now_.x.view(), now_.v.view());
            evaluate(t, now_.x, now_.v, slope_);
            if (n == count) break;
            add_to(before_.x, 2.0 * part, now_.v, before_.x);
            add_to(before_.v, 2.0 * part, slope_, before_.v);
            std::swap(before_, now_);
        }
        smooth(part, result);
        specimen_.system().constrain(state.time + h, result.x.view(), result.v.view());
    }

    // (now + before + part * slope of now) / 2: takes out what oscillates from part to part.
    void smooth(double part, Motion& result) {
        for (std::size_t n = 0; n < now_.x.data_size(); ++n) {
            const double v = now_.v.data()[n];
            result.x.data()[n] = 0.5 * (now_.x.data()[n] + before_.x.data()[n] + part * v);
            result.v.data()[n] = 0.5 * (v + before_.v.data()[n] + part * slope_.data()[n]);
        }
    }

    void evaluate(double t, const Vec3Array<double>& x, const Vec3Array<double>& v,
                  Vec3Array<double>& a) {
        specimen_.system().acceleration(t, x.view(), v.view(), a.view());
        ++evaluations;
    }

    static std::size_t at(int column) { return static_cast<std::size_t>(column); }

    Specimen& specimen_;
    double tolerance_;
    const Watch& watch_;
    Motion before_, now_, start_slope_;
    Vec3Array<double> slope_;
    std::vector<Motion> table_;
    std::array<Estimate, most_columns + 1> estimates_{};  // [column]
    double length_ = first_length;
    int target_ = first_columns;
};

// @return false where it ended early.
bool advance(Specimen& specimen, Extrapolation& method, ParticleState<double>& state,
             double t_end) {
    for (const double kink : kinks_between(specimen.scene(), state.time, t_end)) {
        if (!method.advance(state, kink)) return false;
    }
    return method.advance(state, t_end);
}

}  // namespace

Reference reference_solution(Specimen& specimen, const ParticleState<double>& start, double t_end,
                             double tolerance, const Watch& watch) {
    Reference reference;
    reference.state = start;
    Extrapolation best(specimen, tolerance, watch);
    reference.converged = advance(specimen, best, reference.state, t_end);
    reference.evaluations = best.evaluations;
    reference.steps = best.steps;
    ParticleState<double> second = start;
    Extrapolation check(specimen, looser * tolerance, watch);
    reference.converged = advance(specimen, check, second, t_end) && reference.converged;
    reference.error = rms_distance(specimen.cloth(), reference.state, second);
    return reference;
}

}  // namespace weft::lab
