// Weighted sums of arrays: all counts of inputs, every instruction set, in place, on threads.
#include <gtest/gtest.h>

#include <array>

#include "math/linear_combination.h"
#include "math/parallel.h"
#include "math/random.h"

namespace weft::test {
namespace {

template <typename Real>
Vec3Array<Real> random_array(std::size_t size, std::uint64_t seed) {
    Vec3Array<Real> array(size);
    for (std::size_t n = 0; n < array.data_size(); ++n) {
        array.data()[n] = static_cast<Real>(random_uniform(3, seed, n) - 0.5);
    }
    return array;
}

template <typename Real>
class LinearCombinations : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(LinearCombinations, Precisions);

TYPED_TEST(LinearCombinations, AreTheSumsInDouble) {
    constexpr std::array<double, 8> first{1.0, -0.5, 0.25, 3.0, 0.0, 1.0 / 3, 0.0, -0.75};
    constexpr std::array<double, 8> second{0.0, 1.0, 0.125, 0.0, 0.0, -2.0, 1.0 / 7, 0.5};
    for (const std::size_t size : {1u, 5u, 17u, 1000u}) {
        std::vector<Vec3Array<TypeParam>> inputs;
        for (std::uint64_t i = 0; i < 8; ++i) inputs.push_back(random_array<TypeParam>(size, i));
        for (std::size_t count = 1; count <= 8; ++count) {
            for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
                Vec3Array<TypeParam> a(size), b(size);
                LinearCombination<TypeParam> both(a, b);
                for (std::size_t i = 0; i < count; ++i) both.add(inputs[i], first[i], second[i]);
                both.compute(static_cast<InstructionSet>(set));
                for (std::size_t n = 0; n < a.data_size(); ++n) {
                    double x = 0.0, y = 0.0;
                    for (std::size_t i = 0; i < count; ++i) {
                        x += first[i] * static_cast<double>(inputs[i].data()[n]);
                        y += second[i] * static_cast<double>(inputs[i].data()[n]);
                    }
                    const double tolerance = sizeof(TypeParam) == 4 ? 1e-6 : 1e-15;
                    ASSERT_NEAR(static_cast<double>(a.data()[n]), x, tolerance);
                    ASSERT_NEAR(static_cast<double>(b.data()[n]), y, tolerance);
                }
            }
        }
    }
}

TYPED_TEST(LinearCombinations, MayOverwriteAnInput) {
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        auto x = random_array<TypeParam>(33, 1), v = random_array<TypeParam>(33, 2);
        const auto x0 = x, v0 = v;
        LinearCombination<TypeParam>(x, v)
            .add(x, 1.0)
            .add(v, 0.5, 0.5)
            .compute(static_cast<InstructionSet>(set));
        for (std::size_t n = 0; n < x.data_size(); ++n) {
            ASSERT_NEAR(x.data()[n], x0.data()[n] + TypeParam(0.5) * v0.data()[n], 1e-6);
            ASSERT_EQ(v.data()[n], TypeParam(0.5) * v0.data()[n]);
        }
    }
}

TYPED_TEST(LinearCombinations, GiveTheSameBitsOnAnyThreads) {
    const auto a = random_array<TypeParam>(200'001, 1), b = random_array<TypeParam>(200'001, 2);
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        const auto compute = [&](int threads) {
            ThreadTeam team(threads);
            Vec3Array<TypeParam> out(a.size());
            team.run([&] {
                LinearCombination<TypeParam>(out).add(a, 0.3).add(b, 0.7).compute(
                    static_cast<InstructionSet>(set));
            });
            return out;
        };
        const auto one = compute(1);
        for (const int threads : {2, 7}) {
            const auto many = compute(threads);
            for (std::size_t n = 0; n < one.data_size(); ++n) {
                ASSERT_EQ(one.data()[n], many.data()[n]) << n;
            }
        }
    }
}

}  // namespace
}  // namespace weft::test
