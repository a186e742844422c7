// A state in strips: where its numbers stand, and that all of them come back.
#include "forces/grid_strips.h"

#include <gtest/gtest.h>

#include <numeric>

namespace weft::test {
namespace {

constexpr std::size_t rows = 3;

struct Size {
    std::size_t columns, stride, lanes;
};

// Every number another one.
Vec3Array<float> numbers(std::size_t size, float first) {
    Vec3Array<float> array(size);
    for (std::size_t s = 0; s < size; ++s) {
        const float n = first + 3.0F * static_cast<float>(s);
        array.set(s, {n, n + 1.0F, n + 2.0F});
    }
    return array;
}

class GridStripsOf : public testing::TestWithParam<Size> {
protected:
    const Size size_ = GetParam();
    const Vec3Array<float> x_ = numbers(rows * size_.stride, 1.0F),
                           v_ = numbers(rows * size_.stride, 1e6F),
                           a_ = numbers(rows * size_.stride, 2e6F);
    const std::vector<float> masses_ = std::vector<float>(rows * size_.stride, 0.5F);
    GridStripState<float> state_{size_.columns, rows, size_.stride, size_.lanes};

    void take(bool accelerations) {
        state_.take(x_.view(), v_.view(), masses_.data(),
                    accelerations ? a_.view() : ConstVec3View<float>{});
    }
    // The number of an array in one lane of a vector.
    [[nodiscard]] float at(std::size_t lines, std::size_t j, std::size_t vector, std::size_t array,
                           std::size_t lane) const {
        const GridStrips<float>& strips = state_.strips();
        return strips.blocks[j * strips.row_size + (vector * lines + array) * size_.lanes + lane];
    }
};

TEST_P(GridStripsOf, LanesFollowStripsOfTheRow) {
    take(false);
    const std::size_t length = state_.strips().length;
    EXPECT_EQ(length, (size_.columns + size_.lanes - 1) / size_.lanes);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t vector = 0; vector < length + 2; ++vector) {
            for (std::size_t lane = 0; lane < size_.lanes; ++lane) {
                const std::size_t column = lane * length + vector;
                // Beyond the last strip, where springs have no stiffness, stands nothing.
                const bool there =
                    column < size_.columns && (vector < length || lane + 1 < size_.lanes);
                const std::size_t slot = j * size_.stride + column;
                EXPECT_EQ(at(7, j, vector, 0, lane), there ? x_[slot].x : 0.0F);
                EXPECT_EQ(at(7, j, vector, 5, lane), there ? v_[slot].z : 0.0F);
            }
        }
    }
}

TEST_P(GridStripsOf, GiveBackWhatTheyTook) {
    for (const bool accelerations : {false, true}) {
        take(accelerations);
        Vec3Array<float> x(x_.size()), v(x_.size()), a(x_.size());
        state_.give(x.view(), v.view(), accelerations ? a.view() : Vec3View<float>{});
        EXPECT_EQ(state_.strips().blocks, nullptr);
        for (std::size_t j = 0; j < rows; ++j) {
            for (std::size_t i = 0; i < size_.stride; ++i) {
                const std::size_t s = j * size_.stride + i;
                const bool there = i < size_.columns;  // padding stays zero
                EXPECT_EQ(x[s], there ? x_[s] : Vec3<float>{});
                EXPECT_EQ(v[s], there ? v_[s] : Vec3<float>{});
                EXPECT_EQ(a[s], there && accelerations ? a_[s] : Vec3<float>{});
            }
        }
    }
}

TEST_P(GridStripsOf, PutAParticleWhereverItStands) {
    take(false);
    const std::size_t length = state_.strips().length;
    for (std::size_t i = 0; i < size_.columns; ++i) {
        const auto number = static_cast<float>(i);
        state_.put(size_.stride + i, {-1.0F - number, 0.0F, 0.0F}, {0.0F, 0.5F + number, 0.0F});
    }
    for (std::size_t i = 0; i < size_.columns; ++i) {
        const std::size_t lane = i / length, vector = i % length;
        EXPECT_EQ(at(7, 1, vector, 0, lane), -1.0F - static_cast<float>(i));
        EXPECT_EQ(at(7, 1, vector, 4, lane), 0.5F + static_cast<float>(i));
        if (lane == 0 || vector >= 2) continue;
        EXPECT_EQ(at(7, 1, length + vector, 0, lane - 1), -1.0F - static_cast<float>(i));
    }
}

TEST_P(GridStripsOf, RowsAreNoWholePagesApart) {
    for (const bool accelerations : {false, true}) {
        take(accelerations);
        EXPECT_NE(state_.strips().row_size * sizeof(float) % 4096, 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, GridStripsOf,
                         testing::Values(Size{16, 16, 4}, Size{17, 32, 4}, Size{40, 48, 8},
                                         Size{62, 64, 16}, Size{100, 112, 16}, Size{992, 992, 16}),
                         [](const auto& size) {
                             return std::to_string(size.param.columns) + "_columns_" +
                                    std::to_string(size.param.lanes) + "_lanes";
                         });

}  // namespace
}  // namespace weft::test
