// The smallest complete program: a flag flies for one second and is recorded for Blender.
#include <weft/weft.h>

#include <cstdio>

int main() try {
    weft::SceneDescription scene;            // the shipped flag ...
    scene.wind->velocity = {8.0, 0.0, 1.0};  // ... in a stronger wind [m/s]
    scene.output.duration = 1.0;             // [s]

    weft::Simulation simulation(scene);
    const auto recorder = weft::make_recorder("pc2");
    recorder->begin({.directory = ".",
                     .stem = "hello",
                     .title = scene.name,
                     .surface = &simulation.surface(),
                     .frame_count = scene.frame_count() + 1,
                     .frames_per_second = scene.output.frames_per_second,
                     .render = scene.render});
    weft::FrameBuffer frame;
    for (std::size_t n = 0;; ++n) {
        simulation.capture(frame);
        recorder->frame(frame.view());
        if (n == scene.frame_count()) break;
        if (const weft::FrameReport report = simulation.advance_frame(); !report.ok()) {
            std::fprintf(stderr, "%s\n", report.divergence->message.c_str());
            return 1;
        }
    }
    for (const auto& file : recorder->finish()) std::printf("%s\n", file.c_str());
} catch (const weft::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
