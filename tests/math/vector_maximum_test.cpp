// The longest of weighted sums of vectors: every instruction set, what is not finite, threads.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "math/parallel.h"
#include "math/random.h"
#include "math/vector_maximum.h"

namespace weft::test {
namespace {

template <typename Real>
Vec3Array<Real> random_vectors(std::size_t size, std::uint64_t seed) {
    Vec3Array<Real> array(size);
    for (std::size_t n = 0; n < size; ++n) {
        const auto component = [&](std::uint64_t k) {
            return static_cast<Real>(random_uniform(seed, k, n) - 0.5);
        };
        array.set(n, {component(0), component(1), component(2)});
    }
    return array;
}

template <typename Real>
double computed(const VectorMaximum<Real>& maximum, std::size_t set) {
    std::vector<double> maxima(VectorMaximum<Real>::block_count(maximum.size()));
    return maximum.compute(static_cast<InstructionSet>(set), maxima);
}

template <typename Real>
class VectorMaxima : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(VectorMaxima, Precisions);

TYPED_TEST(VectorMaxima, AreThoseOfTheSumsInDouble) {
    constexpr std::array<double, 8> first{1.0, -0.5, 0.25, 3.0, 0.0, 1.0 / 3, 0.0, -0.75};
    constexpr std::array<double, 8> second{0.0, 1.0, 0.125, 0.0, 0.0, -2.0, 1.0 / 7, 0.5};
    for (const std::size_t size : {1u, 5u, 17u, 1000u, 9001u}) {
        std::vector<Vec3Array<TypeParam>> in;
        for (std::uint64_t i = 0; i < 10; ++i) in.push_back(random_vectors<TypeParam>(size, i));
        for (std::size_t count = 1; count <= 8; ++count) {
            for (const bool divided : {false, true}) {
                VectorMaximum<TypeParam> maximum;
                for (std::size_t i = 0; i < count; ++i) maximum.add(in[i], first[i], second[i]);
                if (divided) maximum.over(in[8], 1.5, in[9], 2.5);
                double expected = 0.0;
                for (std::size_t n = 0; n < size; ++n) {
                    Vec3d a{}, b{};
                    for (std::size_t i = 0; i < count; ++i) {
                        a += first[i] * vec3_cast<double>(in[i][n]);
                        b += second[i] * vec3_cast<double>(in[i][n]);
                    }
                    const Vec3d u = 1.5 * vec3_cast<double>(in[8][n]);
                    const Vec3d w = 2.5 * vec3_cast<double>(in[9][n]);
                    const double divisor = divided ? std::max(1.0, dot(u, u) + dot(w, w)) : 1.0;
                    expected = std::max(expected, std::max(dot(a, a), dot(b, b)) / divisor);
                }
                for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
                    EXPECT_NEAR(computed(maximum, set), expected,
                                (sizeof(TypeParam) == 4 ? 1e-5 : 1e-14) * expected);
                }
            }
        }
    }
}

TYPED_TEST(VectorMaxima, AreInfiniteWhereOneVectorIsNotFinite) {
    using Limits = std::numeric_limits<TypeParam>;
    const auto sound = random_vectors<TypeParam>(5000, 1), u = random_vectors<TypeParam>(5000, 2);
    for (const TypeParam bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
        for (const std::size_t place : {0u, 77u, 4095u, 4096u, 4999u}) {
            auto broken = sound;
            broken.set(place, {TypeParam{0}, bad, TypeParam{0}});
            for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
                VectorMaximum<TypeParam> maximum;
                maximum.add(sound, 1.0).add(broken, 0.0, 1.0);
                EXPECT_TRUE(std::isinf(computed(maximum, set))) << place;
                maximum.over(u, 1.0, u, 1.0);
                EXPECT_TRUE(std::isinf(computed(maximum, set))) << place;
            }
        }
    }
}

TYPED_TEST(VectorMaxima, AreTheSameOnAnyThreads) {
    const auto a = random_vectors<TypeParam>(60'001, 1), b = random_vectors<TypeParam>(60'001, 2);
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        const auto on = [&](int threads) {
            ThreadTeam team(threads);
            double result = 0.0;
            team.run([&] {
                VectorMaximum<TypeParam> maximum;
                maximum.add(a, 0.3, 1.0).add(b, 0.7);
                result = computed(maximum, set);
            });
            return result;
        };
        const double alone = on(1);
        for (const int threads : {2, 3, 4}) EXPECT_EQ(on(threads), alone);
    }
}

}  // namespace
}  // namespace weft::test
