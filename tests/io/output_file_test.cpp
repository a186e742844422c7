// OutputFile and OutputFolder: whole or not at all.
#include "io/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "io/output_folder.h"
#include "support/recording.h"
#include "weft/error.h"

namespace weft {
namespace {

using test::file_text;
using test::ScratchDirectory;

TEST(OutputFile, StandsUnderItsNameOnlyOnceCommitted) {
    ScratchDirectory scratch;
    OutputFile file(scratch / "a.txt");
    file.write("hello");
    EXPECT_FALSE(std::filesystem::exists(scratch / "a.txt"));
    file.commit();
    EXPECT_EQ(file_text(scratch / "a.txt"), "hello");
    EXPECT_EQ(scratch.names(), std::set<std::string>{"a.txt"});
}

TEST(OutputFile, LeavesTheEarlierFileAloneUnlessCommitted) {
    ScratchDirectory scratch;
    test::write_text(scratch / "a.txt", "earlier");
    { OutputFile(scratch / "a.txt").write("half"); }
    EXPECT_EQ(file_text(scratch / "a.txt"), "earlier");
    EXPECT_EQ(scratch.names(), std::set<std::string>{"a.txt"});
    OutputFile file(scratch / "a.txt");
    file.write("later");
    file.commit();
    EXPECT_EQ(file_text(scratch / "a.txt"), "later");
}

TEST(OutputFile, SeekOverwritesInPlace) {
    ScratchDirectory scratch;
    OutputFile file(scratch / "a.txt");
    file.write("0000 frames");
    file.seek(2);
    file.write("17");
    file.commit();
    EXPECT_EQ(file_text(scratch / "a.txt"), "0017 frames");
}

TEST(OutputFile, RemoveRangeMovesTheRestUp) {
    // Three blocks of a megabyte and a bit, so that the move takes more than one piece.
    ScratchDirectory scratch;
    const std::string rest(3'500'000, 'x');
    OutputFile file(scratch / "a.txt");
    file.write("head-----");
    file.write(rest);
    file.write("end");
    file.remove_range(4, 9);
    file.write("!");
    file.commit();
    EXPECT_EQ(file_text(scratch / "a.txt"), "head" + rest + "end!");
}

TEST(OutputFile, TwoOfTheSameNameDoNotMeet) {
    ScratchDirectory scratch;
    OutputFile first(scratch / "a.txt"), second(scratch / "a.txt");
    first.write("first");
    second.write("second");
    second.commit();
    first.commit();
    EXPECT_EQ(file_text(scratch / "a.txt"), "first");
    EXPECT_EQ(scratch.names(), std::set<std::string>{"a.txt"});
}

TEST(OutputFile, MovesWithItsFile) {
    ScratchDirectory scratch;
    OutputFile first(scratch / "a.txt");
    first.write("one ");
    OutputFile second(std::move(first));
    second.write("file");
    second.commit();
    EXPECT_EQ(file_text(scratch / "a.txt"), "one file");
}

TEST(OutputFile, HasThePermissionsOfAnyNewFile) {
    ScratchDirectory scratch;
    const mode_t mask = umask(022);
    OutputFile file(scratch / "a.txt");
    file.commit();
    umask(mask);
    struct stat status {};
    ASSERT_EQ(stat((scratch / "a.txt").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0644U);
}

TEST(OutputFile, MissingDirectoryIsAFileErrorWithItsReason) {
    try {
        OutputFile file("/no/such/directory/a.txt");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_EQ(error.place().file, "/no/such/directory/a.txt");
        EXPECT_EQ(error.message(), "cannot write: No such file or directory");
    }
}

TEST(OutputFile, DirectoryOfThatNameIsAFileError) {
    ScratchDirectory scratch;
    std::filesystem::create_directory(scratch / "a.txt");
    EXPECT_THROW(OutputFile(scratch / "a.txt"), Error);
    EXPECT_EQ(scratch.names(), std::set<std::string>{"a.txt"});
}

TEST(OutputFolder, AppearsWhenCommittedAndReplacesAnEarlierOne) {
    ScratchDirectory scratch;
    std::filesystem::create_directory(scratch / "frames");
    test::write_text(scratch / "frames/old.txt", "old");
    {
        OutputFolder folder(scratch / "frames");
        test::write_text(folder.file("new.txt"), "new");
        EXPECT_TRUE(std::filesystem::exists(scratch / "frames/old.txt"));
        EXPECT_FALSE(std::filesystem::exists(scratch / "frames/new.txt"));
        folder.commit();
        EXPECT_EQ(folder.file("new.txt"), scratch / "frames/new.txt");
    }
    EXPECT_EQ(file_text(scratch / "frames/new.txt"), "new");
    EXPECT_FALSE(std::filesystem::exists(scratch / "frames/old.txt"));
    EXPECT_EQ(scratch.names(), std::set<std::string>{"frames"});
}

TEST(OutputFolder, LeavesNothingUnlessCommitted) {
    ScratchDirectory scratch;
    {
        OutputFolder folder(scratch / "frames");
        test::write_text(folder.file("new.txt"), "new");
    }
    EXPECT_TRUE(scratch.names().empty());
}

TEST(OutputFolder, FileOfThatNameIsAFileError) {
    ScratchDirectory scratch;
    test::write_text(scratch / "frames", "a file");
    EXPECT_THROW(OutputFolder(scratch / "frames"), Error);
    EXPECT_EQ(scratch.names(), std::set<std::string>{"frames"});
}

}  // namespace
}  // namespace weft
