// What the window remembers: kept over a restart, and no file can hurt it.
#include "viewer/window_settings.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>

#include "support/recording.h"

namespace weft::viewer {
namespace {

/// An environment variable, put back when it goes.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        value == nullptr ? unsetenv(name) : setenv(name, value, 1);
    }
    ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    std::optional<std::string> old_;
};

WindowSettings loaded_from(std::string_view text) {
    const test::ScratchDirectory directory;
    test::write_text(directory / "window.json", text);
    return load_window_settings(directory / "window.json");
}

void expect_defaults(const WindowSettings& settings) {
    const WindowSettings plain;
    EXPECT_EQ(settings.size, plain.size);
    EXPECT_EQ(settings.position, plain.position);
    EXPECT_EQ(settings.maximised, plain.maximised);
    EXPECT_EQ(settings.panels, plain.panels);
    EXPECT_EQ(settings.wireframe, plain.wireframe);
    EXPECT_EQ(settings.pins, plain.pins);
    EXPECT_EQ(settings.springs, plain.springs);
    EXPECT_EQ(settings.recording_format, plain.recording_format);
    EXPECT_EQ(settings.recent, plain.recent);
}

TEST(WindowSettings, StandWhereXdgSays) {
    const Variable home("HOME", "/home/ann");
    {
        const Variable config("XDG_CONFIG_HOME", "/etc/ann");
        EXPECT_EQ(window_settings_path(), "/etc/ann/weft/window.json");
    }
    for (const char* ignored : {static_cast<const char*>(nullptr), "", "relative/path"}) {
        const Variable config("XDG_CONFIG_HOME", ignored);
        EXPECT_EQ(window_settings_path(), "/home/ann/.config/weft/window.json");
    }
    const Variable config("XDG_CONFIG_HOME", nullptr);
    const Variable nowhere("HOME", nullptr);
    EXPECT_EQ(window_settings_path(), "");
}

TEST(WindowSettings, AreReadAsTheyWereWritten) {
    const test::ScratchDirectory directory;
    const auto path = directory / "new" / "weft" / "window.json";  // directories are made
    const WindowSettings written{.size = {900, 600},
                                 .position = {30, 0},
                                 .maximised = true,
                                 .panels = false,
                                 .wireframe = true,
                                 .particles = true,
                                 .normals = true,
                                 .wind_arrows = true,
                                 .pins = false,
                                 .springs = 2,
                                 .recording_format = "pc2",
                                 .recent = {"flag", "/tmp/a \"b\"\\c.toml", "/tmp/\u00e4.glb"}};
    save_window_settings(written, path);
    const WindowSettings read = load_window_settings(path);
    EXPECT_EQ(read.size, written.size);
    EXPECT_EQ(read.position, written.position);
    EXPECT_TRUE(read.maximised && read.wireframe && read.particles && read.normals);
    EXPECT_TRUE(read.wind_arrows);
    EXPECT_FALSE(read.panels || read.pins);
    EXPECT_EQ(read.springs, 2);
    EXPECT_EQ(read.recording_format, "pc2");
    EXPECT_EQ(read.recent, written.recent);
}

TEST(WindowSettings, ReplaceTheOldFileAndLeaveNothingElse) {
    const test::ScratchDirectory directory;
    WindowSettings settings;
    for (const int springs : {1, 2}) {
        settings.springs = springs;
        save_window_settings(settings, directory / "window.json");
        EXPECT_EQ(load_window_settings(directory / "window.json").springs, springs);
    }
    EXPECT_EQ(directory.names(), (std::set<std::string>{"window.json"}));
}

TEST(WindowSettings, AreTheDefaultsWhereThereIsNoFile) {
    const test::ScratchDirectory directory;
    expect_defaults(load_window_settings(directory / "none.json"));
    expect_defaults(load_window_settings(directory.path()));  // a directory
    expect_defaults(load_window_settings(""));
}

TEST(WindowSettings, AreTheDefaultsWhereTheFileIsNonsense) {
    for (const std::string_view text :
         {"", "{", "\xff\xfe\x01", "[]", "null", "7", "{\"size\": [900, 600]",
          "{\"a\": {\"size\": [900, 600]}}", "size = 3"}) {
        SCOPED_TRACE(text);
        expect_defaults(loaded_from(text));
    }
}

TEST(WindowSettings, DamagedValuesBecomeTheirDefaultsOneByOne) {
    const WindowSettings settings = loaded_from(
        R"({"size": "large", "position": [10, 20], "maximised": 1, "panels": null,
            "wireframe": true, "pins": "no", "springs": 1.5, "recording_format": "avi",
            "recent": ["flag", 3, "", null, "flag", "sheet"], "unknown": {}})");
    EXPECT_EQ(settings.size, (std::array{1280, 720}));
    EXPECT_EQ(settings.position, (std::array{10, 20}));
    EXPECT_FALSE(settings.maximised);
    EXPECT_TRUE(settings.panels);
    EXPECT_TRUE(settings.wireframe);
    EXPECT_TRUE(settings.pins);
    EXPECT_EQ(settings.springs, 0);
    EXPECT_EQ(settings.recording_format, "mp4");
    EXPECT_EQ(settings.recent, (std::vector<std::string>{"flag", "sheet"}));
}

TEST(WindowSettings, SizesAndPlacesOutOfRangeAreNotBelieved) {
    for (const std::string_view size :
         {"[0, 0]", "[-900, 600]", "[1000000, 600]", "[900, 18446744073709551615]", "[900]",
          "[900, 600, 1]", "[900, 1e300]", "[900, 600.5]", "[199, 600]"}) {
        SCOPED_TRACE(size);
        const auto text = "{\"springs\": 3, \"size\": " + std::string(size) +
                          ", \"position\": [20, -18446744073709551615]}";
        const WindowSettings settings = loaded_from(text);
        EXPECT_EQ(settings.size, (std::array{1280, 720}));
        EXPECT_EQ(settings.position, (std::array{-1, -1}));
        EXPECT_EQ(settings.springs, 0);
    }
}

TEST(WindowSettings, AreQuietlyNotWrittenWhereTheyCannotBe) {
    const WindowSettings settings;
    save_window_settings(settings, "");
    save_window_settings(settings, "/proc/weft/window.json");  // no directory can be made there
    const test::ScratchDirectory directory;
    test::write_text(directory / "file", "");
    save_window_settings(settings, directory / "file/window.json");
    std::filesystem::create_directory(directory / "window.json");
    save_window_settings(settings, directory / "window.json");  // a directory is in the way
    EXPECT_EQ(directory.names(), (std::set<std::string>{"file", "window.json"}));
    if (geteuid() == 0) return;  // whom no permission stops
    ASSERT_EQ(chmod(directory.path().c_str(), 0555), 0);
    save_window_settings(settings, directory / "closed.json");
    chmod(directory.path().c_str(), 0755);
    EXPECT_EQ(directory.names(), (std::set<std::string>{"file", "window.json"}));
}

TEST(WindowSettings, PathsThatAreNotUtf8DoNotLoseTheRest) {
    const test::ScratchDirectory directory;
    const WindowSettings settings{.springs = 1, .recent = {"/tmp/\xff.toml", "flag"}};
    save_window_settings(settings, directory / "window.json");
    const WindowSettings read = load_window_settings(directory / "window.json");
    EXPECT_EQ(read.springs, 1);
    ASSERT_EQ(read.recent.size(), 2U);
    EXPECT_EQ(read.recent[1], "flag");
}

TEST(RecentFiles, HaveTheLatestFirstAndNoneTwice) {
    WindowSettings settings;
    for (const char* name : {"flag", "sheet", "flag", ""}) remember(settings, name);
    EXPECT_EQ(settings.recent, (std::vector<std::string>{"flag", "sheet"}));
    for (int n = 0; n < 30; ++n) remember(settings, "scene-" + std::to_string(n));
    ASSERT_EQ(settings.recent.size(), 10U);
    EXPECT_EQ(settings.recent.front(), "scene-29");
    EXPECT_EQ(settings.recent.back(), "scene-20");
}

TEST(RecentFiles, AreFoundFromAnotherDirectory) {
    const test::ScratchDirectory directory;
    test::write_text(directory / "towel.toml", "");
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(directory.path());
    WindowSettings settings;
    remember(settings, "./towel.toml");
    std::filesystem::current_path(before);
    ASSERT_EQ(settings.recent.size(), 1U);
    EXPECT_EQ(std::filesystem::canonical(settings.recent[0]),
              std::filesystem::canonical(directory / "towel.toml"));
}

}  // namespace
}  // namespace weft::viewer
