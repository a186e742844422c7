// Recorders that draw: a folder of PNG files, or a video.
#include "io/picture_recorder.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "io/output_file.h"
#include "io/output_folder.h"
#include "io/video_encoder.h"
#include "render/off_screen.h"

namespace weft {

void write_png(OutputFile& file, const Image& image) {
    const std::vector<std::uint8_t> png = encode_png(image);
    file.write(std::as_bytes(std::span(png)));
    file.commit();
}

namespace {

class PngRecorder final : public Recorder {
public:
    [[nodiscard]] FrameNeeds needs() const override { return {.velocities = false}; }

    void begin(const RecordingPlan& plan) override {
        stem_ = plan.stem;
        renderer_.emplace(*plan.surface, plan.render, plan.obstacles);
        folder_.emplace(plan.directory / (plan.stem + ".png-frames"));
    }

    void frame(const Frame& frame) override {
        names_.push_back(fmt::format("{}.{:04}.png", stem_, names_.size()));
        OutputFile file = folder_->open(names_.back());
        write_png(file, renderer_->draw(frame));
    }

    std::vector<std::filesystem::path> finish() override {
        folder_->commit();
        std::vector<std::filesystem::path> files;
        for (const std::string& name : names_) files.push_back(folder_->file(name));
        return files;
    }

private:
    std::string stem_;
    std::optional<OffScreenRenderer> renderer_;
    std::optional<OutputFolder> folder_;
    std::vector<std::string> names_;
};

class VideoRecorder final : public Recorder {
public:
    explicit VideoRecorder(std::string_view format) : format_(format) {}

    [[nodiscard]] FrameNeeds needs() const override { return {.velocities = false}; }

    void begin(const RecordingPlan& plan) override {
        path_ = plan.directory / fmt::format("{}.{}", plan.stem, format_);
        renderer_.emplace(*plan.surface, plan.render, plan.obstacles);
        encoder_.emplace(path_, format_, plan.render.size, plan.frames_per_second);
    }

    void frame(const Frame& frame) override { encoder_->write(renderer_->draw(frame)); }

    std::vector<std::filesystem::path> finish() override {
        encoder_->commit();
        return {path_};
    }

private:
    std::string format_;
    std::filesystem::path path_;
    std::optional<OffScreenRenderer> renderer_;
    std::optional<VideoEncoder> encoder_;
};

}  // namespace

std::unique_ptr<Recorder> make_picture_recorder(std::string_view format) {
    if (format == "png") return std::make_unique<PngRecorder>();
    return std::make_unique<VideoRecorder>(format);
}

void write_picture(const std::filesystem::path& path, const RecordingPlan& plan, const Frame& first,
                   const Frame& frame) {
    OutputFile file(path);  // first, since it may be refused and drawing takes long
    OffScreenRenderer renderer(*plan.surface, plan.render, plan.obstacles);
    renderer.set_first_frame(first);
    write_png(file, renderer.draw(frame));
}

}  // namespace weft
