#include "lab/kinks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::lab {

namespace {

constexpr double resolved = 1e-9;  // kinks closer than this are one [s]

bool gusts(const SceneDescription& scene) {
    return scene.wind && scene.wind->gust.model != GustModel::none && scene.wind->gust.spread > 0.0;
}

// The first kink after `time`; infinity where there is none.
double next_kink(const SceneDescription& scene, double time) {
    double next = std::numeric_limits<double>::infinity();
    if (gusts(scene)) {
        const double period = scene.wind->gust.period;
        next = period * (std::floor((time + resolved) / period) + 1.0);
    }
    for (const PinDescription& pin : scene.pins) {
        for (const PinKeyframe& keyframe : pin.motion) {
            if (keyframe.time > time + resolved) next = std::min(next, keyframe.time);
        }
    }
    return next;
}

}  // namespace

std::vector<double> kinks_between(const SceneDescription& scene, double from, double to) {
    std::vector<double> kinks;
    for (double kink = next_kink(scene, from); kink < to - resolved;
         kink = next_kink(scene, kink)) {
        kinks.push_back(kink);
    }
    return kinks;
}

Stretch smooth_stretch(const SceneDescription& scene, double from, double length) {
    constexpr int most_gaps = 100;
    constexpr double margin = 0.05;  // of the gap, at both ends
    Stretch best{from, from};
    double begin = from;
    for (int n = 0; n < most_gaps; ++n) {
        const double end = next_kink(scene, begin);
        if (std::isinf(end)) return {begin, begin + length};
        const double usable = (1.0 - 2.0 * margin) * (end - begin);
        const double first = begin + margin * (end - begin);
        if (usable >= length) return {first, first + length};
        if (usable > best.length()) best = {first, first + usable};
        begin = end;
    }
    return best;
}

}  // namespace weft::lab
