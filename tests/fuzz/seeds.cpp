#include "fuzz/seeds.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "io/npy_format.h"

namespace weft::fuzz {

namespace {

std::vector<Seed> scenes(const std::string& directory, Seed::Kind kind) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        if (entry.path().extension() == ".toml") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<Seed> found;
    for (const std::filesystem::path& path : paths) {
        std::ifstream file(path, std::ios::binary);
        found.push_back({kind, ".toml", {std::istreambuf_iterator<char>(file), {}}});
    }
    return found;
}

template <typename Number>
void append(std::string& bytes, Number number, bool big_endian) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    if (big_endian != (std::endian::native == std::endian::big)) {
        std::reverse(std::begin(raw), std::end(raw));
    }
    bytes.append(raw, sizeof number);
}

constexpr float corners[5][5] = {
    {0, 0, 0, 0, 0}, {1, 0, 0, 1, 0}, {1, 1, 0, 1, 1}, {0, 1, 0, 0, 1}, {2, 0.5F, -0.25F, 1, 1}};

std::string ply_header(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment a square and a triangle\nelement vertex 5\nproperty float x\nproperty "
           "float y\nproperty float z\nproperty float s\nproperty float t\nelement face "
           "2\nproperty "
           "list uchar int vertex_indices\nend_header\n";
}

std::string binary_ply(bool big_endian) {
    std::string bytes = ply_header(big_endian ? "binary_big_endian" : "binary_little_endian");
    for (const auto& corner : corners) {
        for (const float number : corner) append(bytes, number, big_endian);
    }
    for (const std::vector<std::int32_t>& face :
         {std::vector<std::int32_t>{0, 1, 2, 3}, std::vector<std::int32_t>{1, 4, 2}}) {
        append(bytes, static_cast<std::uint8_t>(face.size()), big_endian);
        for (const std::int32_t index : face) append(bytes, index, big_endian);
    }
    return bytes;
}

std::string numpy_state(std::string_view element) {
    const Bytes head = npy_head(element, "2, 4, 3");
    std::string bytes(reinterpret_cast<const char*>(head.data()), head.size());
    for (int n = 0; n < 24; ++n) {
        if (element == "<f8") append(bytes, 0.25 * n, false);
        if (element == "<f4") append(bytes, 0.25F * static_cast<float>(n), false);
    }
    return bytes;
}

}  // namespace

std::vector<Seed> seeds() {
    std::vector<Seed> all = scenes(WEFT_SOURCE_DIR "/scenes", Seed::Kind::scene);
    for (Seed& seed : scenes(WEFT_SOURCE_DIR "/scenes/invalid", Seed::Kind::invalid_scene)) {
        all.push_back(std::move(seed));
    }
    const auto add = [&](const char* ending, std::string bytes) {
        all.push_back({Seed::Kind::data, ending, std::move(bytes)});
    };
    add(".obj",
        "# a square, a triangle and a pentagon\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
        "v 2 0.5 -2.5e-1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\no cloth\ng front\n"
        "f 1/1/1 2/2/1 3/3/1 4/4/1\nf 2//1 5//1 3//1\nf -5 -4 -1 -3 -2\n");
    add(".ply", ply_header("ascii") +
                    "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n2 0.5 -0.25 1 1\n"
                    "4 0 1 2 3\n3 1 4 2\n");
    add(".ply", binary_ply(false));
    add(".ply", binary_ply(true));
    add(".npy", numpy_state("<f8"));
    add(".npy", numpy_state("<f4"));
    return all;
}

}  // namespace weft::fuzz
