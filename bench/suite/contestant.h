// What takes part in a timing.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "bench/peers/plain_sheet.h"
#include "weft/scene.h"

namespace weft::bench {

/// One timing.
struct Measurement {
    double seconds = 0.0;
    double steps = 0.0;         ///< made in that time; 0: not counted in steps of weft's kind
    double frames = 0.0;        ///< of 1/60 s; 0: not timed by the frame
    std::optional<double> sag;  ///< of the lower edge's middle below its place at rest [m]
};

/// Ready to be timed again and again: what is not stepping was done when it was made.
class Contestant {
public:
    virtual ~Contestant() = default;
    /// Runs for about `least_seconds` or longer.
    /// @throws Error (diverged).
    virtual Measurement measure(double least_seconds) = 0;
};

/// How many pieces of work last about `least_seconds` or longer: tried out, as the first ones are
/// slow from cold pages and caches.
/// @param seconds_of does that many and says how long it took.
int pieces_lasting(double least_seconds, const std::function<double(int pieces)>& seconds_of);

/// weft on a scene with a given step, timed by whole frames.
std::unique_ptr<Contestant> make_stepping(const SceneDescription& scene, int threads);

/// A peer, at sheet_step.
std::unique_ptr<Contestant> make_stepping(std::unique_ptr<SteppedPeer> peer);

/// Two seconds of the sheet at 60 frames a second from its start, each time anew: by weft on the
/// sheet's scene, and by a peer whose step is a frame.
std::unique_ptr<Contestant> make_two_seconds(const PlainSheet& sheet,
                                             const SceneDescription& scene);
std::unique_ptr<Contestant> make_two_seconds(
    const PlainSheet& sheet, std::unique_ptr<SteppedPeer> (*make)(const PlainSheet&));

}  // namespace weft::bench
