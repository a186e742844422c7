#include "viewer/spooled_recorder.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "io/output_file.h"
#include "weft/error.h"

namespace weft::viewer {

namespace {

/// A file that vanishes with its last user, however that ends.
class Spool {
public:
    explicit Spool(std::filesystem::path beside) : beside_(std::move(beside)) {
        const std::filesystem::path name = temporary_name(beside_);
        const int file = open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        if (file < 0) fail("cannot write");
        unlink(name.c_str());
        file_ = fdopen(file, "w+b");
        if (file_ == nullptr) {
            close(file);
            fail("cannot write");
        }
    }
    ~Spool() {
        if (file_ != nullptr) std::fclose(file_);
    }
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;

    void write(std::span<const Vec3f> vectors) {
        if (std::fwrite(vectors.data(), sizeof(Vec3f), vectors.size(), file_) != vectors.size())
            fail("cannot write");
    }
    void rewind() {
        if (std::fflush(file_) != 0) fail("cannot write");
        std::rewind(file_);
    }
    void read(std::span<Vec3f> vectors) {
        if (std::fread(vectors.data(), sizeof(Vec3f), vectors.size(), file_) != vectors.size())
            fail("cannot read back");
    }

private:
    [[noreturn]] void fail(const char* what) const {
        throw file_error(beside_.string(),
                         std::string(what) + ": " + std::generic_category().message(errno));
    }

    std::filesystem::path beside_;  ///< named in errors
    std::FILE* file_ = nullptr;
};

class SpooledRecorder final : public Recorder {
public:
    explicit SpooledRecorder(std::string_view format) : format_(format) {}

    [[nodiscard]] FrameNeeds needs() const override {
        return {
            .positions = false, .velocities = false, .normals = true, .rounded_positions = true};
    }

    void begin(const RecordingPlan& plan) override {
        plan_ = plan;
        plan_.frame_count = 1;
        make_recorder(format_)->begin(plan_);  // what forbids the recording is to show now
        spool_ = std::make_unique<Spool>(plan.directory / file_name());
        frames_ = 0;
    }

    void frame(const Frame& frame) override {
        if (frame.rounded_positions.empty()) {
            rounded_.clear();
            for (const Vec3d& x : frame.positions) rounded_.push_back(vec3_cast<float>(x));
            spool_->write(rounded_);
        } else {
            spool_->write(frame.rounded_positions);
        }
        spool_->write(frame.normals);
        ++frames_;
    }

    std::vector<std::filesystem::path> finish() override {
        spool_->rewind();
        plan_.frame_count = frames_;
        recorder_ = make_recorder(format_);
        recorder_->begin(plan_);
        FrameBuffer buffer;
        const std::size_t particles = plan_.surface->particle_count;
        buffer.positions.resize(particles);
        buffer.normals.resize(particles);
        buffer.rounded_positions.resize(particles);
        for (std::size_t n = 0; n < frames_; ++n) {
            read(n, buffer);
            recorder_->frame(buffer.view());
        }
        spool_.reset();
        return recorder_->finish();
    }

    [[nodiscard]] std::vector<std::string> warnings() const override {
        return recorder_ ? recorder_->warnings() : std::vector<std::string>{};
    }

private:
    [[nodiscard]] std::string file_name() const { return plan_.stem + "." + format_; }

    void read(std::size_t number, FrameBuffer& buffer) {
        buffer.index = number;
        buffer.time = static_cast<double>(number) / plan_.frames_per_second;
        spool_->read(buffer.rounded_positions);
        spool_->read(buffer.normals);
        for (std::size_t p = 0; p < buffer.positions.size(); ++p)
            buffer.positions[p] = vec3_cast<double>(buffer.rounded_positions[p]);
    }

    std::string format_;
    RecordingPlan plan_;
    std::unique_ptr<Spool> spool_;
    std::vector<Vec3f> rounded_;
    std::size_t frames_ = 0;
    std::unique_ptr<Recorder> recorder_;  ///< once the number of frames is known
};

}  // namespace

std::unique_ptr<Recorder> make_spooled_recorder(std::string_view format) {
    return std::make_unique<SpooledRecorder>(format);
}

std::unique_ptr<Recorder> make_open_ended_recorder(std::string_view format) {
    // Those that leave room for every planned frame ahead of the first.
    constexpr std::array<std::string_view, 2> planned_formats{"glb", "mdd"};
    for (const std::string_view planned : planned_formats)
        if (format == planned) return make_spooled_recorder(format);
    return make_recorder(format);
}

}  // namespace weft::viewer
