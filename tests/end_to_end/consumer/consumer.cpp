// Runs a few frames of the shipped flag with the installed library and prints the state hash.
#include <weft/weft.h>

#include <cinttypes>
#include <cstdio>

int main() try {
    weft::SceneDescription scene = weft::load_scene("flag");
    scene.cloth.grid.resolution = {16, 11};
    weft::Simulation simulation(scene, 2);
    for (int frame = 0; frame < 3; ++frame) {
        if (const weft::FrameReport report = simulation.advance_frame(); !report.ok()) {
            std::fprintf(stderr, "%s\n", report.divergence->message.c_str());
            return 1;
        }
    }
    std::printf("%016" PRIx64 "\n", simulation.state_hash());
} catch (const weft::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
