// Point cache PC2: char[12] "POINTCACHE2", int32 version, int32 points, float first frame, float
// frames between samples, int32 samples; then the samples.
#include "io/pc2_recorder.h"

#include "io/byte_order.h"

namespace weft {

void Pc2Recorder::begin(const RecordingPlan& plan) {
    particles_ = plan.surface->particle_count;
    cache_.emplace(plan.directory / (plan.stem + ".pc2"));
    companions_.emplace(plan);
    write_head();
}

void Pc2Recorder::write_head() {
    Bytes head;
    append_text(head, std::string_view("POINTCACHE2\0", 12));
    append_little(head, std::int32_t{1});
    append_little(head, static_cast<std::int32_t>(particles_));
    append_little(head, 0.0F);
    append_little(head, 1.0F);
    append_little(head, static_cast<std::int32_t>(frames_));
    cache_->write(head);
}

void Pc2Recorder::frame(const Frame& frame) {
    if (frames_ == 0) companions_->write_mesh(frame);
    points_.write_positions(*cache_, frame);
    ++frames_;
}

std::vector<std::filesystem::path> Pc2Recorder::finish() {
    cache_->seek(0);
    write_head();
    cache_->close();
    companions_->close(cache_->path().filename().string(), frames_);
    cache_->commit();
    auto files = companions_->commit();
    files.insert(files.begin(), cache_->path());
    return files;
}

}  // namespace weft
