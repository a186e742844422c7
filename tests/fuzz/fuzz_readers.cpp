// The readers of scenes, meshes and states on damaged files: each ends in one that can be used, or
// in a weft::Error. Anything else, and any report of a sanitizer, ends the program with the file
// left beside it:
//     fuzz_readers [--cases N | --seconds S] [--from CASE]
// Cases are numbered, and the same for everyone: --from 1234 --cases 1 repeats one.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cloth/mesh_cloth.h"
#include "fuzz/damage.h"
#include "io/mesh_file.h"
#include "io/scene_toml.h"
#include "io/start_state_file.h"
#include "weft/error.h"
#include "weft/scene.h"

namespace weft::fuzz {

namespace {

constexpr unsigned longest_case = 30;  // [s]; a reader that takes longer hangs

struct Options {
    std::uint64_t first = 1, cases = 0;
    double seconds = 0.0;
};

void require_round_trip(const SceneDescription& scene, const std::string& path) {
    std::string saved, again;
    try {
        saved = scene_to_toml(scene);
        again = scene_to_toml(parse_scene(saved, path));
    } catch (const Error& error) {
        throw std::logic_error(std::string("saved, it is refused: ") + error.what());
    }
    if (saved != again) throw std::logic_error("saved, it is another scene");
}

// False: refused.
bool read(const std::string& path, const Seed& file) try {
    if (file.ending == ".toml") {
        const SceneDescription scene = parse_scene(file.bytes, path);
        check_scene(scene);
        require_round_trip(scene, path);
    } else if (file.ending == ".npy") {
        load_start_state(path);
    } else {
        build_mesh_cloth(load_mesh(path), path);
    }
    return true;
} catch (const Error&) {
    return false;
}

std::uint64_t number_of(const char* text) {
    return std::strtoull(text, nullptr, 10);
}

Options options_of(int count, char** arguments) {
    Options options;
    for (int n = 1; n + 1 < count; n += 2) {
        const std::string_view key = arguments[n];
        if (key == "--from") options.first = number_of(arguments[n + 1]);
        if (key == "--cases") options.cases = number_of(arguments[n + 1]);
        if (key == "--seconds") options.seconds = std::strtod(arguments[n + 1], nullptr);
    }
    if (options.cases == 0 && options.seconds <= 0.0) options.seconds = 20.0;
    return options;
}

int run(const Options& options) {
    using Clock = std::chrono::steady_clock;
    const std::vector<Seed> sound = seeds();
    const Clock::time_point start = Clock::now();
    const auto goes_on = [&](std::uint64_t done) {
        if (options.cases > 0) return done < options.cases;
        return std::chrono::duration<double>(Clock::now() - start).count() < options.seconds;
    };
    std::uint64_t done = 0, taken = 0;
    for (; goes_on(done); ++done) {
        const Seed file = damaged(sound, options.first + done);
        const std::string path = "fuzz-input" + file.ending;
        unlink(path.c_str());  // a file written over is flushed to the disk at once
        std::ofstream(path, std::ios::binary) << file.bytes;
        alarm(longest_case);
        try {
            taken += read(path, file) ? 1 : 0;
        } catch (const std::exception& failure) {
            fmt::print(stderr, "case {}, {}: {}\n", options.first + done, path, failure.what());
            return 1;
        }
        alarm(0);
    }
    for (const char* ending : {".toml", ".obj", ".ply", ".npy"}) {
        unlink((std::string("fuzz-input") + ending).c_str());
    }
    fmt::print("{} damaged files: {} taken, {} refused\n", done, taken, done - taken);
    // Were all refused or all taken, the damage would not reach what is to be tested.
    return taken > 0 && taken < done ? 0 : 1;
}

}  // namespace
}  // namespace weft::fuzz

int main(int count, char** arguments) {
    return weft::fuzz::run(weft::fuzz::options_of(count, arguments));
}
