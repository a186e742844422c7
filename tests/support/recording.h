// What tests of recorders share: a directory that goes away, a recording made of a formula, and
// bytes read without any of weft's own readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "render/image.h"
#include "support/waving_cloth.h"
#include "weft/recorder.h"

namespace weft::test {

/// A new, empty directory, removed with all that is in it.
class ScratchDirectory {
public:
    ScratchDirectory() {
        std::string name = (std::filesystem::temp_directory_path() / "weft-test-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch directory");
        path_ = name;
        std::filesystem::permissions(path_, std::filesystem::perms{0755});
    }
    ~ScratchDirectory() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
        return path_ / name;
    }
    /// Names of everything inside, hidden files included.
    [[nodiscard]] std::set<std::string> names() const {
        std::set<std::string> result;
        for (const auto& entry : std::filesystem::directory_iterator(path_))
            result.insert(entry.path().filename().string());
        return result;
    }

private:
    std::filesystem::path path_;
};

inline std::string file_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_text(const std::filesystem::path& path, std::string_view text) {
    std::ofstream file(path, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

/// The number whose bytes stand at `offset`, as this (little-endian) machine has it.
template <typename T>
T little_at(std::string_view bytes, std::size_t offset) {
    if (offset + sizeof(T) > bytes.size()) throw std::out_of_range("number beyond the end");
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

/// The number whose bytes stand at `offset` in reverse.
template <typename T>
T big_at(std::string_view bytes, std::size_t offset) {
    if (offset + sizeof(T) > bytes.size()) throw std::out_of_range("number beyond the end");
    char reversed[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) reversed[i] = bytes[offset + sizeof(T) - 1 - i];
    T value;
    std::memcpy(&value, reversed, sizeof(T));
    return value;
}

/// A PNG file of 2 x 2 pixels; made once and small, so that tests of files need not paint a flag.
inline std::string small_texture() {
    static const ScratchDirectory directory;
    static const std::string path = [] {
        const Image image{.width = 2, .height = 2, .rgba = std::vector<std::uint8_t>(16, 0xc0)};
        const auto bytes = encode_png(image);
        write_text(directory / "small.png",
                   {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        return (directory / "small.png").string();
    }();
    return path;
}

inline RecordingPlan plan_of(const WavingCloth& cloth, const std::filesystem::path& directory,
                             std::size_t frames) {
    RecordingPlan plan;
    plan.directory = directory;
    plan.stem = "wave";
    plan.title = "Waving cloth";
    plan.surface = &cloth.surface;
    plan.frame_count = frames;
    plan.frames_per_second = cloth.frames_per_second;
    plan.precision = cloth.single ? Precision::f32 : Precision::f64;
    plan.render.texture = small_texture();
    return plan;
}

/// Records `came` of `planned` frames as wave.*.
inline std::vector<std::filesystem::path> record(std::string_view format, WavingCloth& cloth,
                                                 const std::filesystem::path& directory,
                                                 std::size_t planned, std::size_t came) {
    const auto recorder = make_recorder(format);
    recorder->begin(plan_of(cloth, directory, planned));
    for (std::size_t i = 0; i < came; ++i) recorder->frame(cloth.frame(i));
    return recorder->finish();
}

}  // namespace weft::test
