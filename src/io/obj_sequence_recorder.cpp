// A folder with one OBJ file a frame.
#include "io/obj_sequence_recorder.h"

#include <fmt/format.h>

#include "io/obj_writer.h"

namespace weft {

void ObjSequenceRecorder::begin(const RecordingPlan& plan) {
    plan_ = plan;
    folder_.emplace(plan.directory / (plan.stem + ".obj-frames"));
}

void ObjSequenceRecorder::frame(const Frame& frame) {
    names_.push_back(fmt::format("{}.{:04}.obj", plan_.stem, names_.size()));
    OutputFile file = folder_->open(names_.back());
    const std::string comment = fmt::format("# time {} s\n", frame.time);
    write_obj(file, comment, *plan_.surface, frame.positions, frame.normals);
    file.commit();
}

std::vector<std::filesystem::path> ObjSequenceRecorder::finish() {
    folder_->commit();
    std::vector<std::filesystem::path> files;
    for (const std::string& name : names_) files.push_back(folder_->file(name));
    return files;
}

}  // namespace weft
