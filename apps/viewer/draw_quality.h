// How much drawing may cost: chooses between levels of effort by what they take on this machine.
// No OpenGL.
#pragma once

#include <cstddef>
#include <vector>

namespace weft::viewer {

/// Level 0 is the best. A level that takes longer than the limit is left for the next within a few
/// samples; the one above is tried again when it can be expected to fit, and each time it did not
/// fit after all the wait before the next trial doubles. So the picture does not flicker between
/// two levels.
class DrawQuality {
public:
    /// @param levels at least 1.  @param first the level to begin with.
    /// @param limit for drawing [ms]; panels and showing the frame take as much again.
    explicit DrawQuality(std::size_t levels, std::size_t first = 0, double limit = 14.0);

    /// What drawing at the present level took.  @param time of the sample, rising [s].
    void add(double time, double milliseconds);

    [[nodiscard]] std::size_t level() const { return level_; }
    /// The median of the last samples at this level [ms]; 0 before there is one.
    [[nodiscard]] double typical() const;
    /// Whether the last sample was near the limit or beyond: one should look at every frame.
    [[nodiscard]] bool pressed() const;

private:
    void learn_ratio(double typical);
    void go_to(std::size_t level, double time);

    double limit_;
    std::size_t level_;
    std::vector<double> samples_;  ///< the latest at this level [ms]
    std::vector<double> ratios_;   ///< [level] its cost over that of the next
    double left_at_ = 0.0;         ///< cost for which the level above was left; 0: learnt [ms]
    double changed_ = 0.0, risen_;
    double patience_;  ///< before a level above is tried [s]
};

}  // namespace weft::viewer
