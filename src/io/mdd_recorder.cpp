// Point cache MDD. Its table of times stands before the frames, so room for the planned ones is
// left; where fewer come, what is left over is taken out at the end.
#include "io/mdd_recorder.h"

#include <algorithm>

#include "io/byte_order.h"
#include "weft/error.h"

namespace weft {

namespace {

constexpr std::size_t fixed_head = 8;

}  // namespace

void MddRecorder::begin(const RecordingPlan& plan) {
    plan_ = plan;
    planned_ = std::max<std::size_t>(plan.frame_count, 1);
    cache_.emplace(plan.directory / (plan.stem + ".mdd"));
    companions_.emplace(plan);
    write_head(planned_);
}

void MddRecorder::write_head(std::size_t time_slots) {
    Bytes head;
    append_big(head, static_cast<std::int32_t>(times_.size()));
    append_big(head, static_cast<std::int32_t>(plan_.surface->particle_count));
    for (const float time : times_) append_big(head, time);
    head.resize(fixed_head + 4 * time_slots);
    cache_->write(head);
}

void MddRecorder::frame(const Frame& frame) {
    if (times_.size() == planned_)
        throw file_error(cache_->path().string(), "more frames came than were planned");
    if (times_.empty()) companions_->write_mesh(frame);
    points_.write_positions(*cache_, frame);
    times_.push_back(static_cast<float>(frame.time));
}

std::vector<std::filesystem::path> MddRecorder::finish() {
    if (times_.size() < planned_)
        cache_->remove_range(fixed_head + 4 * times_.size(), fixed_head + 4 * planned_);
    cache_->seek(0);
    write_head(times_.size());
    cache_->close();
    // Both caches say the same; the script takes the PC2 where this run wrote one.
    const auto pc2 = plan_.directory / (plan_.stem + ".pc2");
    const auto opened = companions_->is_of_this_run(pc2) ? pc2 : cache_->path();
    companions_->close(opened.filename().string(), times_.size());
    cache_->commit();
    auto files = companions_->commit();
    files.insert(files.begin(), cache_->path());
    return files;
}

}  // namespace weft
