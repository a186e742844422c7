// Arrays of vectors: layout, padding, copies.
#include <gtest/gtest.h>

#include "math/vec3_array.h"

namespace weft::test {
namespace {

template <typename Real>
class Vec3Arrays : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Vec3Arrays, Precisions);

TYPED_TEST(Vec3Arrays, KeepEachComponentOnItsOwnCacheLines) {
    for (const std::size_t size : {1u, 7u, 8u, 16u, 17u, 496u, 504u, 512u, 1000u, 1008u, 4096u}) {
        Vec3Array<TypeParam> array(size);
        EXPECT_EQ(array.size(), size);
        EXPECT_GE(array.data_size(), 3 * size);
        EXPECT_LT(array.data_size() * sizeof(TypeParam),
                  3 * (size * sizeof(TypeParam) + 4096 + 6 * 64));
        const Vec3View<TypeParam> view = array.view();
        for (const TypeParam* component : {view.x, view.y, view.z}) {
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(component) % 64, 0u);
        }
    }
}

// A line behind the last of each component, for kernels that read on; and no whole pages from one
// component to the next, where the three would push each other out of the first-level cache.
TYPED_TEST(Vec3Arrays, LeaveALineBehindEachComponentAndNeverWholePages) {
    for (std::size_t size = 1; size < 5000; ++size) {
        const Vec3Array<TypeParam> array(size);
        const std::size_t stride = (array.data_size() / 3) * sizeof(TypeParam);
        ASSERT_EQ(static_cast<std::size_t>(array.view().y - array.view().x), array.data_size() / 3);
        ASSERT_GE(stride, size * sizeof(TypeParam) + 64) << size;
        ASSERT_NE(stride % 4096, 0u) << size;
    }
}

TYPED_TEST(Vec3Arrays, StartAtZeroAndKeepWhatIsSet) {
    Vec3Array<TypeParam> array(17);
    for (std::size_t n = 0; n < array.data_size(); ++n) EXPECT_EQ(array.data()[n], TypeParam{0});
    array.set(16, {1, 2, 3});
    array.view().add(16, {10, 20, 30});
    EXPECT_EQ(array[16], (Vec3<TypeParam>{11, 22, 33}));
    EXPECT_EQ(array[15], Vec3<TypeParam>{});
    array.fill_zero();
    EXPECT_EQ(array[16], Vec3<TypeParam>{});
}

TYPED_TEST(Vec3Arrays, AreCopiedByValue) {
    Vec3Array<TypeParam> a(5), empty;
    a.set(4, {1, 2, 3});
    Vec3Array<TypeParam> b = a, c(5), d(9);
    c = a;
    d = a;
    a.set(4, {9, 9, 9});
    for (const auto* copy : {&b, &c, &d}) {
        EXPECT_EQ(copy->size(), 5u);
        EXPECT_EQ((*copy)[4], (Vec3<TypeParam>{1, 2, 3}));
    }
    b = empty;
    EXPECT_EQ(b.size(), 0u);
    EXPECT_EQ(Vec3Array<TypeParam>(empty).size(), 0u);
}

}  // namespace
}  // namespace weft::test
