// Whole steps of every integrator: one benchmark a method, size and precision, through Simulation.
// items_per_second is particle-steps a second.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/suite/scenes.h"
#include "weft/integrators.h"
#include "weft/simulation.h"

namespace weft::bench {

namespace {

void run_frames(benchmark::State& state, const SceneDescription& scene) {
    Simulation simulation(scene);
    const std::size_t before = simulation.step_count();
    for (auto _ : state) {
        if (simulation.advance_frame().ok()) continue;
        state.SkipWithError("diverged");
        break;
    }
    const std::size_t steps = simulation.step_count() - before;
    state.SetItemsProcessed(static_cast<std::int64_t>(steps * simulation.particle_count()));
}

void register_steps(std::string_view method, int size, Precision precision) {
    const PlainSheet sheet{.columns = size, .rows = size};
    const Stepping stepping{method, precision, 64};
    benchmark::RegisterBenchmark(
        fmt::format("step/{}/{}/{}", method, size, precision == Precision::f32 ? "f32" : "f64")
            .c_str(),
        [=](benchmark::State& state) { run_frames(state, sheet_scene(sheet, stepping)); })
        ->Unit(benchmark::kMillisecond);
}

void register_others() {
    const PlainSheet sheet{.columns = 256, .rows = 256};
    benchmark::RegisterBenchmark("step/mesh/256/f32", [=](benchmark::State& state) {
        run_frames(state, mesh_scene(sheet, {}));
    })->Unit(benchmark::kMillisecond);
    for (const bool wind : {false, true}) {
        benchmark::RegisterBenchmark(
            wind ? "step/flag/256/f32" : "step/flag-in-no-wind/256/f32",
            [=](benchmark::State& state) { run_frames(state, flag_scene(256, 256, wind, {})); })
            ->Unit(benchmark::kMillisecond);
    }
}

[[maybe_unused]] const bool registered = [] {
    for (const IntegratorInfo& info : integrator_catalogue()) {
        if (info.kind != IntegratorKind::explicit_steps) continue;
        for (const int size : {40, 256}) {
            for (const Precision precision : {Precision::f32, Precision::f64}) {
                register_steps(info.name, size, precision);
            }
        }
    }
    register_others();
    return true;
}();

}  // namespace

}  // namespace weft::bench
