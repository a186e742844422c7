#include "math/parallel.h"

#include <thread>

namespace weft {

namespace {

int hardware_threads() {
    const unsigned threads = std::thread::hardware_concurrency();
    return threads > 0 ? static_cast<int>(threads) : 1;
}

}  // namespace

ThreadTeam::ThreadTeam(int threads)
    : size_(threads > 0 ? threads : hardware_threads()), arena_(size_) {
    if (size_ > hardware_threads()) {
        limit_.emplace(oneapi::tbb::global_control::max_allowed_parallelism,
                       static_cast<std::size_t>(size_));
    }
}

}  // namespace weft
