#include "viewer/playback.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/cloth_shape.h"

namespace weft::viewer {

Playback::Playback(const std::filesystem::path& recording, const RenderDescription& render)
    : path_(recording), file_(recording) {
    auto shape = std::make_shared<ClothShape>();
    shape->surface = file_.surface();
    shape->surface_number = new_surface_number();
    shape->edges = edges_of(shape->surface);
    shape->stage = plan_stage(shape->surface, frame().positions, render);
    shape_ = std::move(shape);
}

// Every frame is shown for as long as it lasts, the last one too.
void Playback::advance(double seconds) {
    if (!playing_) return;
    position_ += std::max(seconds, 0.0) * speed_ * frames_per_second();
    const auto count = static_cast<double>(frame_count());
    if (position_ < count) {
        index_ = static_cast<std::size_t>(position_);
    } else if (loop_) {
        position_ = std::fmod(position_, count);
        index_ = static_cast<std::size_t>(position_);
    } else {
        seek(frame_count() - 1);
        playing_ = false;
    }
}

void Playback::play(bool playing) {
    if (playing && !playing_ && index_ + 1 == frame_count()) seek(0);
    playing_ = playing;
}

void Playback::step(int frames) {
    playing_ = false;
    const std::size_t by = static_cast<std::size_t>(std::abs(static_cast<long long>(frames)));
    seek(frames < 0 ? index_ - std::min(index_, by) : index_ + by);
}

void Playback::seek(std::size_t frame) {
    index_ = std::min(frame, frame_count() - 1);
    position_ = static_cast<double>(index_);
}

Frame Playback::frame() {
    if (!frame_ || frame_->index != index_) frame_ = file_.frame(index_);
    return *frame_;
}

}  // namespace weft::viewer
