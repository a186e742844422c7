#include "forces/wind.h"

#include <cmath>

#include "math/random.h"

namespace weft {

namespace {

double drawn_factor(const GustDescription& gust, std::uint64_t component, std::int64_t draw) {
    const double uniform = random_uniform(gust.seed, component, static_cast<std::uint64_t>(draw));
    return 1.0 + gust.spread * (2.0 * uniform - 1.0);
}

double gust_factor(const GustDescription& gust, std::uint64_t component, double time) {
    const double phase = time / gust.period;
    const double draw = std::floor(phase);
    const double s = phase - draw;
    const auto index = static_cast<std::int64_t>(draw);
    const double from = drawn_factor(gust, component, index);
    const double to = drawn_factor(gust, component, index + 1);
    return from + (to - from) * (s * s * (3.0 - 2.0 * s));
}

}  // namespace

Vec3d wind_velocity(const WindDescription& wind, double time) {
    if (wind.gust.model == GustModel::none) return wind.velocity;
    return {wind.velocity.x * gust_factor(wind.gust, 0, time),
            wind.velocity.y * gust_factor(wind.gust, 1, time),
            wind.velocity.z * gust_factor(wind.gust, 2, time)};
}

}  // namespace weft
