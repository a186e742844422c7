// Compiled with -O3 -march=native -ffast-math: these loops ask what the machine can do, not what a
// portable program does. Plain arrays and functions only, so that no code of this file is taken for
// another's by the linker.
#include "bench/peers/machine.h"

#include <time.h>
#include <unistd.h>

#include <cstdlib>

namespace weft::bench {

namespace {

#if defined(__AVX512F__)
constexpr int vector_bytes = 64;
#elif defined(__AVX__)
constexpr int vector_bytes = 32;
#else
constexpr int vector_bytes = 16;
#endif
using Floats [[gnu::vector_size(vector_bytes)]] = float;
using Doubles [[gnu::vector_size(vector_bytes)]] = double;

double now() {
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

volatile double sink;

// Ten chains hide a latency of four or five cycles on two ports, and fit sixteen registers.
constexpr int chains = 10;
constexpr double flops_a_round = 2.0 * chains;  // a lane

template <typename Vector, typename Real>
[[gnu::noinline]] void multiply_add(long rounds, Real factor, Real addend) {
    const Vector m = Vector{} + factor, c = Vector{} + addend;
    Vector a0 = c, a1 = a0 + c, a2 = a1 + c, a3 = a2 + c, a4 = a3 + c;  // no two chains equal
    Vector a5 = a4 + c, a6 = a5 + c, a7 = a6 + c, a8 = a7 + c, a9 = a8 + c;
    for (long n = 0; n < rounds; ++n) {
        a0 = a0 * m + c;
        a1 = a1 * m + c;
        a2 = a2 * m + c;
        a3 = a3 * m + c;
        a4 = a4 * m + c;
        a5 = a5 * m + c;
        a6 = a6 * m + c;
        a7 = a7 * m + c;
        a8 = a8 * m + c;
        a9 = a9 * m + c;
    }
    const Vector sum = a0 + a1 + a2 + a3 + a4 + a5 + a6 + a7 + a8 + a9;
    sink = static_cast<double>(sum[0]);
}

// The best of several tries: another program can only slow a try down.
template <typename Work>
double best_rate(double amount, const Work& work) {
    constexpr int tries = 7;
    constexpr double shortest = 0.01;  // [s]
    const auto time = [&](long rounds) {
        const double start = now();
        work(rounds);
        return now() - start;
    };
    long rounds = 1;
    double best = time(rounds);
    while (best < shortest) {
        rounds *= best > 0.1 * shortest ? 2 : 8;
        best = time(rounds);
    }
    for (int n = 1; n < tries; ++n) {
        const double seconds = time(rounds);
        if (seconds < best) best = seconds;
    }
    return amount * static_cast<double>(rounds) / best;
}

template <typename Vector, typename Real>
double peak() {
    constexpr double lanes = static_cast<double>(vector_bytes / sizeof(Real));
    return 1e-9 * best_rate(flops_a_round * lanes, [](long rounds) {
               multiply_add<Vector, Real>(rounds, Real(0.999), Real(0.001));
           });
}

[[gnu::noinline]] void update(float* a, std::size_t count, float b, float c) {
    float* array = static_cast<float*>(__builtin_assume_aligned(a, 64));
    for (std::size_t n = 0; n < count; ++n) array[n] = b * array[n] + c;
}

std::size_t cache(int name, std::size_t otherwise) {
    const long size = sysconf(name);
    return size > 0 ? static_cast<std::size_t>(size) : otherwise;
}

}  // namespace

double peak_single() {
    return peak<Floats, float>();
}

double peak_double() {
    return peak<Doubles, double>();
}

double update_bandwidth(std::size_t bytes) {
    const std::size_t count = bytes / sizeof(float) / 64 * 64;
    auto* array = static_cast<float*>(std::aligned_alloc(64, count * sizeof(float)));
    if (array == nullptr) return 0.0;
    for (std::size_t n = 0; n < count; ++n) array[n] = 1.0f;
    const double moved = 2.0 * static_cast<double>(count * sizeof(float));
    const double rate = best_rate(moved, [&](long passes) {
        for (long n = 0; n < passes; ++n) update(array, count, 0.999f, 0.001f);
    });
    sink = static_cast<double>(array[count / 2]);
    std::free(array);
    return 1e-9 * rate;
}

std::size_t first_level_cache() {
    return cache(_SC_LEVEL1_DCACHE_SIZE, std::size_t{32} << 10);
}

std::size_t second_level_cache() {
    return cache(_SC_LEVEL2_CACHE_SIZE, std::size_t{1} << 20);
}

}  // namespace weft::bench
