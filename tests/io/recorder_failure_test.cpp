// Every file recorder when things go wrong: interrupted, disk full, directory not writable.
#include <gtest/gtest.h>
#include <unistd.h>

#include "support/file_size_limit.h"
#include "support/recording.h"
#include "weft/error.h"

namespace weft {
namespace {

using test::FileSizeLimit;
using test::ScratchDirectory;

/// While it lives, the process has no right to write into the directory, even where root runs it.
class ReadOnlyDirectory {
public:
    explicit ReadOnlyDirectory(const std::filesystem::path& path) : path_(path) {
        std::filesystem::permissions(path_, std::filesystem::perms{0555});
        if (geteuid() == 0 && seteuid(65534) != 0) throw std::runtime_error("seteuid");
    }
    ~ReadOnlyDirectory() {
        if (getuid() == 0 && seteuid(0) != 0) std::abort();
        std::filesystem::permissions(path_, std::filesystem::perms{0755});
    }
    ReadOnlyDirectory(const ReadOnlyDirectory&) = delete;
    ReadOnlyDirectory& operator=(const ReadOnlyDirectory&) = delete;

private:
    std::filesystem::path path_;
};

class FileRecorder : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Formats, FileRecorder,
                         testing::Values("glb", "pc2", "mdd", "npy", "obj", "ply"),
                         [](const auto& format) { return std::string(format.param); });

TEST_P(FileRecorder, LeavesNothingWhenItIsNotFinished) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(8, 8);
    {
        const auto recorder = make_recorder(GetParam());
        recorder->begin(test::plan_of(cloth, scratch.path(), 5));
        for (std::size_t i = 0; i < 3; ++i) recorder->frame(cloth.frame(i));
        EXPECT_FALSE(scratch.names().empty());
        for (const std::string& name : scratch.names()) EXPECT_TRUE(name.starts_with(".")) << name;
    }
    EXPECT_TRUE(scratch.names().empty());
}

TEST_P(FileRecorder, LeavesTheEarlierRecordingWhenItIsNotFinished) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(4, 4);
    test::record(GetParam(), cloth, scratch.path(), 2, 2);
    const auto before = scratch.names();
    {
        const auto recorder = make_recorder(GetParam());
        recorder->begin(test::plan_of(cloth, scratch.path(), 5));
        recorder->frame(cloth.frame(0));
    }
    EXPECT_EQ(scratch.names(), before);
}

TEST_P(FileRecorder, OneFrameIsARecording) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(4, 4);
    const auto files = test::record(GetParam(), cloth, scratch.path(), 30, 1);
    ASSERT_FALSE(files.empty());
    for (const auto& file : files) EXPECT_GT(std::filesystem::file_size(file), 0U) << file;
}

TEST_P(FileRecorder, FullDiskIsAFileErrorAndLeavesNothing) {
    test::small_texture();  // is made on the first call: not once the disk is full
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(60, 60);  // a frame has 43200 bytes or more
    // From a disk that takes nothing to one that fills up at the last byte of the third frame.
    for (const rlim_t bytes : {rlim_t{0}, rlim_t{100}, rlim_t{20'000}, rlim_t{120'000}}) {
        const FileSizeLimit limit(bytes);
        try {
            test::record(GetParam(), cloth, scratch.path(), 3, 3);
            FAIL() << "no error at " << bytes << " bytes";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::file);
            EXPECT_TRUE(error.place().file.starts_with(scratch.path().string())) << error.what();
            EXPECT_EQ(error.place().file.find(".part"), std::string::npos) << error.what();
            EXPECT_NE(error.message().find("File too large"), std::string::npos) << error.what();
        }
        EXPECT_TRUE(scratch.names().empty()) << bytes;
    }
}

TEST_P(FileRecorder, UnwritableDirectoryIsAFileError) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    const RecordingPlan plan = test::plan_of(cloth, scratch.path(), 3);
    const ReadOnlyDirectory read_only(scratch.path());
    try {
        make_recorder(GetParam())->begin(plan);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_TRUE(error.place().file.starts_with(scratch.path().string())) << error.what();
        EXPECT_NE(error.message().find("Permission denied"), std::string::npos) << error.what();
    }
}

TEST_P(FileRecorder, MissingDirectoryIsAFileError) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    EXPECT_THROW(make_recorder(GetParam())->begin(test::plan_of(cloth, scratch / "none", 3)),
                 Error);
    EXPECT_TRUE(scratch.names().empty());
}

}  // namespace
}  // namespace weft
