// Records two cloths that wave by formula in every format that other programs read back:
//     record_waving_cloth DIRECTORY
// grid.*: 40 frames of a grid in float at 30 frames/s. sleeve.*: 300 frames of a seamed mesh in
// double at 29.97 frames/s, of which the glb keeps 251.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "support/waving_cloth.h"
#include "weft/recorder.h"

namespace {

void record(weft::test::WavingCloth cloth, const std::filesystem::path& directory, const char* stem,
            std::size_t frames) {
    std::filesystem::create_directories(directory);
    weft::RecordingPlan plan;
    plan.directory = directory;
    plan.stem = stem;
    plan.title = std::string("Waving ") + stem;
    plan.surface = &cloth.surface;
    plan.frame_count = frames;
    plan.frames_per_second = cloth.frames_per_second;
    plan.precision = cloth.single ? weft::Precision::f32 : weft::Precision::f64;
    std::vector<std::unique_ptr<weft::Recorder>> recorders;
    for (const std::string_view format : {"glb", "pc2", "mdd", "npy", "obj", "ply"}) {
        recorders.push_back(weft::make_recorder(format));
        recorders.back()->begin(plan);
    }
    for (std::size_t i = 0; i < frames; ++i)
        for (const auto& recorder : recorders) recorder->frame(cloth.frame(i));
    for (const auto& recorder : recorders) {
        recorder->finish();
        for (const auto& warning : recorder->warnings()) std::printf("%s\n", warning.c_str());
    }
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::fprintf(stderr, "usage: record_waving_cloth DIRECTORY\n");
        return 2;
    }
    const std::filesystem::path directory = arguments[1];
    try {
        record(weft::test::waving_grid(31, 21), directory / "grid", "grid", 40);
        auto sleeve = weft::test::waving_sleeve(16, 9);
        sleeve.frames_per_second = 29.97;
        record(std::move(sleeve), directory / "sleeve", "sleeve", 300);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
