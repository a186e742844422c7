// The table of fabrics.
//
// Membrane stiffness is written as stiffness over density, E t / (mass per area) [m2/s2], the
// square of the speed of a stretching wave: silk 500, flag nylon 1000, wool 2000, cotton 5500,
// denim 10000, leather 13000 (ppf-contact-solver's calibration, which drapes and stretches textiles
// virtually and compares them with measured ranges). Shear is a third of it for woven cloth, whose
// threads turn at their crossings, and 0.38 for leather, which is isotropic (1 / (2 (1 + nu)), nu =
// 0.3). Bend springs stand for the rest: the fuller the cloth, the larger their share, and the
// largest for flag nylon, which is coated: without it, wind crumples a flag as finely as the grid
// allows. Every dashpot's damping is 1e-4 s times its stiffness, which calms the shortest waves and
// leaves folds alone.
#include <array>

#include "weft/scene.h"

namespace weft {

namespace {

constexpr FabricInfo fabric(std::string_view name, std::string_view description,
                            double mass_per_area, double stiffness, double shear, double bend) {
    const auto spring = [](double k) { return SpringMaterial{k, k / 1e4}; };
    return {.name = name,
            .description = description,
            .mass_per_area = mass_per_area,
            .structural = spring(stiffness),
            .shear = spring(shear),
            .bend = spring(bend)};
}

constexpr std::array fabrics{
    fabric("silk", "light and supple: scarves, gowns", 0.06, 30.0, 10.0, 0.3),
    fabric("cotton", "plain weave: shirts, sheets, curtains", 0.15, 825.0, 275.0, 16.5),
    fabric("wool", "soft and heavy: coats, blankets, capes", 0.3, 600.0, 200.0, 18.0),
    fabric("denim", "dense twill: trousers, workwear", 0.4, 4000.0, 1300.0, 200.0),
    fabric("leather", "thick hide, hardly stretches", 0.8, 10400.0, 3950.0, 1000.0),
    fabric("flag", "flag nylon: flies in a light wind", 0.12, 120.0, 40.0, 10.0),
};

}  // namespace

std::span<const FabricInfo> fabric_catalogue() {
    return fabrics;
}

}  // namespace weft
