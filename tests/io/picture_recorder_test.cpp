// Pictures and videos as files, read back by ffprobe and ffmpeg.
#include "io/picture_recorder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

#include "io/video_encoder.h"
#include "render/off_screen.h"
#include "support/file_size_limit.h"
#include "support/recording.h"
#include "weft/error.h"

namespace weft {
namespace {

using test::FileSizeLimit;
using test::ScratchDirectory;
using test::WavingCloth;

constexpr std::array<int, 2> size{320, 180};

RecordingPlan picture_plan(const WavingCloth& cloth, const std::filesystem::path& directory) {
    RecordingPlan plan = test::plan_of(cloth, directory, 12);
    plan.render.size = size;
    return plan;
}

std::vector<std::filesystem::path> record(std::string_view format, WavingCloth& cloth,
                                          const std::filesystem::path& directory,
                                          std::size_t frames) {
    const auto recorder = make_recorder(format);
    recorder->begin(picture_plan(cloth, directory));
    for (std::size_t i = 0; i < frames; ++i) recorder->frame(cloth.frame(i));
    return recorder->finish();
}

std::string output_of(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string text;
    std::array<char, 4096> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe.get()))
        text.append(block.data(), count);
    return text;
}

/// What ffprobe says of the one stream of a video, its frames counted by decoding.
nlohmann::json stream_of(const std::filesystem::path& file) {
    return nlohmann::json::parse(
        output_of("ffprobe -v error -count_frames -show_streams "
                  "-show_format -of json '" +
                  file.string() + "'"));
}

/// Another PATH while it lives.
class SearchPath {
public:
    explicit SearchPath(const std::string& value) : before_(std::getenv("PATH")) {
        setenv("PATH", value.c_str(), 1);
    }
    ~SearchPath() { setenv("PATH", before_.c_str(), 1); }
    SearchPath(const SearchPath&) = delete;
    SearchPath& operator=(const SearchPath&) = delete;

private:
    std::string before_;
};

class Video : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Formats, Video, testing::Values("mp4", "webm", "gif"),
                         [](const auto& format) { return std::string(format.param); });

class AnyPicture : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Formats, AnyPicture, testing::Values("png", "mp4", "webm", "gif"),
                         [](const auto& format) { return std::string(format.param); });

TEST_P(Video, HasEveryFrameAtItsSizeAndRate) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(21, 15);
    cloth.frames_per_second = 25.0;
    const auto files = record(GetParam(), cloth, scratch.path(), 12);
    const std::string name = std::string("wave.") + GetParam();
    ASSERT_EQ(files, (std::vector{scratch / name}));
    EXPECT_EQ(scratch.names(), std::set{name});
    const auto probe = stream_of(files[0]);
    ASSERT_EQ(probe["streams"].size(), 1U);
    const auto& stream = probe["streams"][0];
    EXPECT_EQ(stream["nb_read_frames"], "12");
    EXPECT_EQ(stream["width"], 320);
    EXPECT_EQ(stream["height"], 180);
    EXPECT_EQ(stream["r_frame_rate"], "25/1");
    EXPECT_NEAR(std::stod(probe["format"]["duration"].get<std::string>()), 12 / 25.0, 0.021);
}

TEST_P(Video, OneFrameIsAVideo) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(9, 7);
    const auto files = record(GetParam(), cloth, scratch.path(), 1);
    EXPECT_EQ(stream_of(files.at(0))["streams"][0]["nb_read_frames"], "1");
}

TEST_P(Video, LongerThanTheFramesThatTheGifPaletteCounts) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(9, 7);
    const auto files = record(GetParam(), cloth, scratch.path(), 60);
    EXPECT_EQ(stream_of(files.at(0))["streams"][0]["nb_read_frames"], "60");
}

TEST_P(Video, ShowsWhatTheRendererDrew) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(21, 15);
    RecordingPlan plan = picture_plan(cloth, scratch.path());
    plan.render.texture = "flag";
    const auto recorder = make_recorder(GetParam());
    recorder->begin(plan);
    for (std::size_t i = 0; i < 3; ++i) recorder->frame(cloth.frame(i));
    const auto files = recorder->finish();
    const std::string first = (scratch / "first.png").string();
    output_of("ffmpeg -v error -i '" + files.at(0).string() + "' -frames:v 1 '" + first + "'");
    const Image shown = load_texture(first);
    OffScreenRenderer renderer(cloth.surface, plan.render);
    const Image& drawn = renderer.draw(cloth.frame(0));
    ASSERT_EQ(shown.rgba.size(), drawn.rgba.size());
    double difference = 0.0;
    for (std::size_t i = 0; i < shown.rgba.size(); ++i)
        difference += std::abs(static_cast<double>(shown.rgba[i]) - drawn.rgba[i]);
    EXPECT_LT(difference / static_cast<double>(shown.rgba.size()), 4.0);  // of 255
}

TEST(Mp4, KeepsAFractionalFrameRate) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(9, 7);
    cloth.frames_per_second = 31.25;
    const auto stream = stream_of(record("mp4", cloth, scratch.path(), 10).at(0))["streams"][0];
    EXPECT_EQ(stream["r_frame_rate"], "125/4");
    EXPECT_EQ(stream["nb_read_frames"], "10");
    EXPECT_EQ(stream["codec_name"], "h264");
    EXPECT_EQ(stream["pix_fmt"], "yuv420p");
    EXPECT_EQ(stream["color_space"], "bt709");
}

TEST(Gif, KeepsItsDurationAboveFiftyFramesPerSecond) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(9, 7);
    cloth.frames_per_second = 120.0;
    const auto probe = stream_of(record("gif", cloth, scratch.path(), 60).at(0));
    EXPECT_EQ(probe["streams"][0]["nb_read_frames"], "25");
    EXPECT_NEAR(std::stod(probe["format"]["duration"].get<std::string>()), 0.5, 0.021);
}

TEST(Png, MakesAFolderOfNumberedPictures) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(9, 7);
    const auto files = record("png", cloth, scratch.path(), 3);
    const auto folder = scratch / "wave.png-frames";
    EXPECT_EQ(files, (std::vector{folder / "wave.0000.png", folder / "wave.0001.png",
                                  folder / "wave.0002.png"}));
    EXPECT_EQ(scratch.names(), std::set<std::string>{"wave.png-frames"});
    const Image first = load_texture(files[0].string()), last = load_texture(files[2].string());
    EXPECT_EQ(first.width, 320);
    EXPECT_EQ(first.height, 180);
    EXPECT_NE(first.rgba, last.rgba);
}

TEST_P(AnyPicture, LeavesNothingWhenItIsNotFinished) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(9, 7);
    {
        const auto recorder = make_recorder(GetParam());
        recorder->begin(picture_plan(cloth, scratch.path()));
        for (std::size_t i = 0; i < 3; ++i) recorder->frame(cloth.frame(i));
        for (const std::string& name : scratch.names()) EXPECT_TRUE(name.starts_with(".")) << name;
        EXPECT_EQ(scratch.names().size(), 1U);
    }
    EXPECT_TRUE(scratch.names().empty());
}

TEST_P(AnyPicture, BadTextureIsAFileErrorAndLeavesNothing) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(9, 7);
    RecordingPlan plan = picture_plan(cloth, scratch.path());
    plan.render.texture = (scratch / "missing.png").string();
    try {
        make_recorder(GetParam())->begin(plan);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_EQ(error.place().file, plan.render.texture);
    }
    EXPECT_TRUE(scratch.names().empty());
}

TEST_P(AnyPicture, MissingDirectoryIsAFileError) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(9, 7);
    try {
        make_recorder(GetParam())->begin(picture_plan(cloth, scratch / "missing"));
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_NE(error.place().file.find("missing/wave."), std::string::npos);
        EXPECT_NE(error.message().find("No such file or directory"), std::string::npos);
    }
}

TEST_P(AnyPicture, FullDiskIsAFileErrorAndLeavesNothing) {
    test::small_texture();  // is made on the first call: not once the disk is full
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(21, 15);
    for (const rlim_t bytes : {rlim_t{0}, rlim_t{1'000}, rlim_t{4'000}}) {
        const FileSizeLimit limit(bytes);
        try {
            record(GetParam(), cloth, scratch.path(), 12);
            FAIL() << "no error at " << bytes << " bytes";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::file);
            // The limit also holds for ffmpeg's messages; with none of them left its status tells.
            const std::string_view reason = bytes > 0 || GetParam() == std::string_view("png")
                                                ? "File too large"
                                                : "exit status";
            EXPECT_NE(error.message().find(reason), std::string::npos) << error.what();
        }
        EXPECT_TRUE(scratch.names().empty()) << bytes;
    }
}

TEST(FailingVideo, KilledFfmpegIsAFileError) {
    const ScratchDirectory scratch, programs;
    test::write_text(programs / "ffmpeg", "#!/bin/sh\nkill -9 $$\n");
    std::filesystem::permissions(programs / "ffmpeg", std::filesystem::perms{0755});
    const SearchPath path(programs.path().string());
    VideoEncoder encoder(scratch / "wave.mp4", "mp4", size, 30.0);
    try {
        encoder.commit();
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.message(), "ffmpeg failed: ended by signal 9");
    }
}

TEST_P(Video, FolderInTheWayIsAFileError) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(9, 7);
    const std::string name = std::string("wave.") + GetParam();
    std::filesystem::create_directory(scratch / name);
    EXPECT_THROW(record(GetParam(), cloth, scratch.path(), 2), Error);
    EXPECT_EQ(scratch.names(), std::set{name});
}

TEST_P(Video, MissingFfmpegIsAFileErrorThatSaysWhatToDo) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(9, 7);
    const SearchPath nowhere("");
    try {
        make_recorder(GetParam())->begin(picture_plan(cloth, scratch.path()));
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_EQ(error.message(), "needs the program ffmpeg, which is not found");
        EXPECT_NE(error.detail().find("apt install ffmpeg"), std::string::npos);
        EXPECT_NE(error.detail().find("png"), std::string::npos);
    }
    EXPECT_TRUE(scratch.names().empty());
}

/// A program named ffmpeg that gives up after the first bytes.
void write_failing_ffmpeg(const std::filesystem::path& file) {
    test::write_text(file,
                     "#!/bin/sh\n/usr/bin/head -c 1000 > /dev/null\necho first line >&2\n"
                     "echo 'Unknown encoder libx264' >&2\nexit 1\n");
    std::filesystem::permissions(file, std::filesystem::perms{0755});
}

TEST(FailingVideo, FailingFfmpegIsAFileErrorInItsOwnWords) {
    const ScratchDirectory scratch, programs;
    write_failing_ffmpeg(programs / "ffmpeg");
    WavingCloth cloth = test::waving_grid(9, 7);
    const SearchPath path(programs.path().string());
    try {
        record("mp4", cloth, scratch.path(), 20);  // far more than the socket holds
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_EQ(error.message(), "ffmpeg failed: Unknown encoder libx264");
        EXPECT_NE(error.detail().find("first line"), std::string::npos);
        EXPECT_EQ(error.place().file, (scratch / "wave.mp4").string());
    }
    EXPECT_TRUE(scratch.names().empty());
}

void ignore_interrupt(int) {}

/// Runs in a child process: Ctrl-C reaches the whole process group between two pictures.
[[noreturn]] void encode_and_interrupt(const std::filesystem::path& file) {
    setpgid(0, 0);
    std::signal(SIGINT, ignore_interrupt);
    Image image{size[0], size[1], {}};
    image.rgba.resize(4U * 320U * 180U, 0x80);
    try {
        VideoEncoder encoder(file, "mp4", size, 30.0);
        for (int i = 0; i < 10; ++i) {
            encoder.write(image);
            if (i == 4) {
                kill(0, SIGINT);
                usleep(300'000);
            }
        }
        encoder.commit();
    } catch (const Error&) {
        _exit(1);
    }
    _exit(0);
}

TEST(InterruptedVideo, SurvivesCtrlC) {
    const ScratchDirectory scratch;
    const pid_t child = fork();
    if (child == 0) encode_and_interrupt(scratch / "wave.mp4");
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(stream_of(scratch / "wave.mp4")["streams"][0]["nb_read_frames"], "10");
}

TEST(FrameRate, IsTheSimplestFraction) {
    EXPECT_EQ(frame_rate_fraction(30.0), "30/1");
    EXPECT_EQ(frame_rate_fraction(31.25), "125/4");
    EXPECT_EQ(frame_rate_fraction(29.97), "2997/100");
    EXPECT_EQ(frame_rate_fraction(30000.0 / 1001.0), "30000/1001");
    EXPECT_EQ(frame_rate_fraction(0.1), "1/10");
    EXPECT_EQ(frame_rate_fraction(1.0 / 3.0), "1/3");
}

TEST(WritePicture, DrawsOneFrameWithTheStageOfTheFirst) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(21, 15);
    const RecordingPlan plan = picture_plan(cloth, scratch.path());
    const Frame first{0, 0.0, cloth.rest, {}, {}};
    write_picture(scratch / "x.png", plan, first, cloth.frame(9));
    const Image picture = load_texture((scratch / "x.png").string());
    EXPECT_EQ(picture.width, 320);
    OffScreenRenderer renderer(cloth.surface, plan.render);
    renderer.set_first_frame(first);
    EXPECT_EQ(picture.rgba, renderer.draw(cloth.frame(9)).rgba);
    EXPECT_EQ(scratch.names(), std::set<std::string>{"x.png"});
}

TEST(WritePicture, ShowsTheObstaclesOfThePlan) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(21, 15);
    RecordingPlan plan = picture_plan(cloth, scratch.path());
    const Frame first{0, 0.0, cloth.rest, {}, {}};
    write_picture(scratch / "without.png", plan, first, first);
    plan.obstacles = {{SphereObstacle{{0.8, 0.5, 0.9}, 0.3}, 0.4, 0.005},
                      {PlaneObstacle{{0.0, 0.2, 0.0}, {0.0, 1.0, 0.0}}, 0.4, 0.005}};
    write_picture(scratch / "with.png", plan, first, first);
    const Image picture = load_texture((scratch / "with.png").string());
    EXPECT_NE(picture.rgba, load_texture((scratch / "without.png").string()).rgba);
    OffScreenRenderer renderer(cloth.surface, plan.render, plan.obstacles);
    EXPECT_EQ(picture.rgba, renderer.draw(first).rgba);
}

TEST(WritePicture, UnwritableNameIsAFileError) {
    const ScratchDirectory scratch;
    WavingCloth cloth = test::waving_grid(5, 5);
    const RecordingPlan plan = picture_plan(cloth, scratch.path());
    EXPECT_THROW(write_picture(scratch / "missing" / "x.png", plan, cloth.frame(0), cloth.frame(0)),
                 Error);
}

}  // namespace
}  // namespace weft
