// What is done once a frame or once a run: copying, measuring, hashing, building. items_per_second
// is particles a second.
#include <benchmark/benchmark.h>

#include "bench/suite/scenes.h"
#include "weft/simulation.h"

namespace weft::bench {

namespace {

// A sheet that has begun to hang, so that no measure is that of a sheet at rest.
class Measures : public benchmark::Fixture {
public:
    void SetUp(const benchmark::State& state) override {
        const int size = static_cast<int>(state.range(0));
        const auto precision = state.range(1) == 0 ? Precision::f32 : Precision::f64;
        simulation_.emplace(sheet_scene({.columns = size, .rows = size}, {.precision = precision}));
        (void)simulation_->advance_frame();
    }
    void TearDown(const benchmark::State& /*state*/) override { simulation_.reset(); }

protected:
    void count(benchmark::State& state) const {
        state.SetItemsProcessed(state.iterations() *
                                static_cast<std::int64_t>(simulation_->particle_count()));
    }
    std::optional<Simulation> simulation_;
};

BENCHMARK_DEFINE_F(Measures, capture)(benchmark::State& state) {
    FrameBuffer buffer;
    for (auto _ : state) simulation_->capture(buffer);
    count(state);
}
BENCHMARK_DEFINE_F(Measures, energy)(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(simulation_->energy());
    count(state);
}
BENCHMARK_DEFINE_F(Measures, largest_strain)(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(simulation_->largest_strain());
    count(state);
}
BENCHMARK_DEFINE_F(Measures, state_hash)(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(simulation_->state_hash());
    count(state);
}
BENCHMARK_DEFINE_F(Measures, compute_normals)(benchmark::State& state) {
    FrameBuffer buffer;
    simulation_->capture(buffer);
    for (auto _ : state) {
        compute_normals(simulation_->surface(), buffer.positions, buffer.normals);
        benchmark::DoNotOptimize(buffer.normals.data());
    }
    count(state);
}
BENCHMARK_DEFINE_F(Measures, construction)(benchmark::State& state) {
    const SceneDescription scene = simulation_->scene();
    for (auto _ : state) benchmark::DoNotOptimize(Simulation(scene).particle_count());
    count(state);
}

void sizes(benchmark::internal::Benchmark* measures) {
    measures->ArgNames({"size", "f64"})
        ->Unit(benchmark::kMillisecond)
        ->ArgsProduct({{40, 256}, {0, 1}});
}
BENCHMARK_REGISTER_F(Measures, capture)->Apply(sizes);
BENCHMARK_REGISTER_F(Measures, energy)->Apply(sizes);
BENCHMARK_REGISTER_F(Measures, largest_strain)->Apply(sizes);
BENCHMARK_REGISTER_F(Measures, state_hash)->Apply(sizes);
BENCHMARK_REGISTER_F(Measures, compute_normals)->Apply(sizes);
BENCHMARK_REGISTER_F(Measures, construction)->Apply(sizes);

}  // namespace

}  // namespace weft::bench
