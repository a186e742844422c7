// The table of fabrics.
#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "weft/scene.h"

namespace weft {
namespace {

TEST(Fabrics, AreSixEachOnce) {
    std::set<std::string_view> names;
    for (const FabricInfo& fabric : fabric_catalogue()) names.insert(fabric.name);
    EXPECT_EQ(names,
              (std::set<std::string_view>{"silk", "cotton", "wool", "denim", "leather", "flag"}));
    EXPECT_EQ(fabric_catalogue().size(), 6U);
}

TEST(Fabrics, FlagIsTheDefaultMaterial) {
    const MaterialDescription material;
    for (const FabricInfo& fabric : fabric_catalogue()) {
        if (fabric.name != material.fabric) continue;
        EXPECT_EQ(fabric.mass_per_area, material.mass_per_area);
        EXPECT_EQ(fabric.structural.stiffness, material.structural.stiffness);
        EXPECT_EQ(fabric.structural.damping, material.structural.damping);
        EXPECT_EQ(fabric.shear.stiffness, material.shear.stiffness);
        EXPECT_EQ(fabric.shear.damping, material.shear.damping);
        EXPECT_EQ(fabric.bend.stiffness, material.bend.stiffness);
        EXPECT_EQ(fabric.bend.damping, material.bend.damping);
        return;
    }
    FAIL() << material.fabric;
}

TEST(Fabrics, StretchingWavesRunAt22To115MetresPerSecond) {
    for (const FabricInfo& fabric : fabric_catalogue()) {
        const double speed_squared = fabric.structural.stiffness / fabric.mass_per_area;
        EXPECT_GE(speed_squared, 499.0) << fabric.name;
        EXPECT_LE(speed_squared, 13001.0) << fabric.name;
        EXPECT_LT(fabric.bend.stiffness, fabric.shear.stiffness) << fabric.name;
        EXPECT_LT(fabric.shear.stiffness, fabric.structural.stiffness) << fabric.name;
        EXPECT_DOUBLE_EQ(fabric.structural.damping, 1e-4 * fabric.structural.stiffness);
    }
}

}  // namespace
}  // namespace weft
