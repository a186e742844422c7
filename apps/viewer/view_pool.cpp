#include "viewer/view_pool.h"

#include <mutex>
#include <utility>
#include <vector>

namespace weft::viewer {

namespace {

// The newest, the one being filled, and those a window may hold for a moment.
constexpr std::size_t most_kept = 4;

}  // namespace

struct ViewPool::Shelf {
    std::mutex mutex;
    std::vector<std::unique_ptr<FlightView>> views;

    Shelf() { views.reserve(most_kept); }

    void put(std::unique_ptr<FlightView> view) {
        const std::scoped_lock lock(mutex);
        if (views.size() < most_kept) views.push_back(std::move(view));
    }
};

ViewPool::ViewPool() : shelf_(std::make_shared<Shelf>()) {}

std::shared_ptr<FlightView> ViewPool::take() {
    std::unique_ptr<FlightView> view;
    {
        const std::scoped_lock lock(shelf_->mutex);
        if (!shelf_->views.empty()) {
            view = std::move(shelf_->views.back());
            shelf_->views.pop_back();
        }
    }
    if (!view) view = std::make_unique<FlightView>();
    return {view.release(), [shelf = shelf_](FlightView* returned) {
                shelf->put(std::unique_ptr<FlightView>(returned));
            }};
}

}  // namespace weft::viewer
