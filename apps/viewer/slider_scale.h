// Between the place on a slider and a value. No window.
#pragma once

namespace weft::viewer {

struct SliderScale {
    double low = 0.0, high = 1.0;
    bool logarithmic = false;  ///< with 0 at the left end where `low` is 0

    /// From 0 to 1; values beyond the ends stand at the ends.
    [[nodiscard]] double place_of(double value) const;
    /// Rounded to three digits, as a hand places no better.  @param place from 0 to 1.
    [[nodiscard]] double value_at(double place) const;
};

/// To as many significant digits; 0 and what is not finite stay.
double rounded_to_digits(double value, int digits);

}  // namespace weft::viewer
