// The table of parameters agrees with the scene file's keys, the shipped scenes and check_scene().
#include "viewer/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "io/scene_json.h"
#include "io/scene_keys.h"
#include "support/cloth_scenes.h"
#include "weft/integrators.h"

namespace weft::viewer {
namespace {

std::vector<SceneDescription> scenes() {
    std::vector<SceneDescription> all;
    for (const ShippedScene& scene : shipped_scenes()) all.push_back(load_scene(scene.name));
    return all;
}

bool applies(const Parameter& row, const SceneDescription& scene) {
    return row.applies == nullptr || row.applies(scene);
}

/// A scene to which the row applies: with air, gusts and a mass of either kind.
SceneDescription scene_for(const Parameter& row) {
    SceneDescription scene;
    if (row.key == "material.particle_mass") scene.material.particle_mass = 0.001;
    return scene;
}

TEST(Parameters, StandOnce) {
    std::set<std::string_view> keys, labels;
    for (const Parameter& row : parameters()) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_TRUE(labels.insert(row.label).second) << row.label;
        EXPECT_EQ(find_parameter(row.key), &row);
    }
    EXPECT_EQ(keys.size(), 27U);
    EXPECT_EQ(find_parameter("wind"), nullptr);
}

TEST(Parameters, OfASectionStandTogether) {
    std::set<std::string_view> sections;
    std::string_view section;
    for (const Parameter& row : parameters()) {
        if (row.section == section) continue;
        section = row.section;
        EXPECT_TRUE(sections.insert(section).second) << section;
    }
}

TEST(Parameters, AreKeysOfTheSceneFileWithTheirUnits) {
    for (const Parameter& row : parameters()) {
        std::string_view key = row.key;
        if (key.ends_with(".x") || key.ends_with(".y") || key.ends_with(".z")) key.remove_suffix(2);
        const SceneKey* const known = find_scene_key(key);
        ASSERT_NE(known, nullptr) << row.key;
        EXPECT_EQ(row.unit, known->unit) << row.key;
    }
}

TEST(Parameters, WriteTheKeyThatTheyAreNamedAfter) {
    for (const Parameter& row : parameters()) {
        SCOPED_TRACE(row.key);
        SceneDescription scene = scene_for(row);
        const double value = row.whole ? 7.0 : 0.5 * (row.low + row.high) + 0.001;
        const auto before = scene_to_json(scene).flatten();
        row.set(scene, value);
        EXPECT_EQ(row.get(scene), value);
        const auto after = scene_to_json(scene).flatten();
        std::string path = "/" + std::string(row.key);
        for (char& c : path) c = c == '.' ? '/' : c;
        for (const auto& [name, axis] : {std::pair{"/x", "/0"}, {"/y", "/1"}, {"/z", "/2"}}) {
            if (path.ends_with(name)) path.replace(path.size() - 2, 2, axis);
        }
        for (const auto& [place, now] : after.items()) {
            if (place == path) {
                EXPECT_EQ(now.get<double>(), value);
            } else if (before.contains(place)) {
                EXPECT_EQ(now, before.at(place)) << place;
            }
        }
        EXPECT_TRUE(after.contains(path)) << path;
    }
}

TEST(Parameters, HaveRangesThatTheirScalesCanShow) {
    for (const Parameter& row : parameters()) {
        EXPECT_LT(row.low, row.high) << row.key;
        EXPECT_TRUE(!row.logarithmic || row.low >= 0.0) << row.key;
        EXPECT_TRUE(!row.whole || row.low == std::round(row.low)) << row.key;
        EXPECT_EQ(row.automatic == nullptr, row.make_automatic == nullptr) << row.key;
    }
}

TEST(Parameters, OfEveryShippedSceneLieOnTheirSliders) {
    for (const SceneDescription& scene : scenes()) {
        for (const Parameter& row : parameters()) {
            if (!applies(row, scene) || (row.automatic && row.automatic(scene))) continue;
            EXPECT_GE(row.get(scene), row.low) << scene.stem << " " << row.key;
            EXPECT_LE(row.get(scene), row.high) << scene.stem << " " << row.key;
        }
    }
}

TEST(Parameters, OfEveryFabricLieOnTheirSliders) {
    for (const FabricInfo& fabric : fabric_catalogue()) {
        SceneDescription scene;
        scene.material.mass_per_area = fabric.mass_per_area;
        scene.material.structural = fabric.structural;
        scene.material.shear = fabric.shear;
        scene.material.bend = fabric.bend;
        for (const Parameter& row : parameters()) {
            if (!row.key.starts_with("material.") || !applies(row, scene)) continue;
            EXPECT_GT(row.get(scene), row.low) << fabric.name << " " << row.key;
            EXPECT_LT(row.get(scene), row.high) << fabric.name << " " << row.key;
        }
    }
}

TEST(Parameters, AreAllowedAtBothEndsOfTheirSliders) {
    for (const Parameter& row : parameters()) {
        for (const double value : {row.low, row.high}) {
            const ParameterChange change = with_parameter(scene_for(row), row, value);
            EXPECT_EQ(change.refusal, "") << row.key << " " << value;
            EXPECT_EQ(row.get(change.scene), value);
        }
    }
}

TEST(Parameters, ThatAreNotNumbersAreRefused) {
    for (const Parameter& row : parameters()) {
        for (const double value :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            const std::string refusal = with_parameter(scene_for(row), row, value).refusal;
            EXPECT_NE(refusal.find(" is not allowed: "), std::string::npos)
                << row.key << " " << value << " " << refusal;
        }
    }
}

TEST(Parameters, AreRefusedInTheWordsOfTheSceneCheck) {
    const auto refusal = [](const char* key, double value) {
        return with_parameter({}, *find_parameter(key), value).refusal;
    };
    EXPECT_EQ(refusal("material.structural.stiffness", -1.0),
              "material.structural.stiffness: -1 is not allowed: a finite number, 0 or more");
    EXPECT_EQ(refusal("cloth.resolution.x", 1.0),
              "cloth.resolution: [1, 41] is not allowed: two integers (columns, rows), each at "
              "least 2");
    EXPECT_EQ(refusal("wind.gust.spread", 1.0),
              "wind.gust.spread: 1 is not allowed: a number, at least 0 and below 1");
    EXPECT_NE(refusal("cloth.resolution.y", 1e30), "");
    EXPECT_EQ(refusal("wind.velocity.x", 50.0), "");  // beyond the slider, but allowed
}

TEST(Parameters, DependOnTheScene) {
    const auto shown = [](const char* key, const SceneDescription& scene) {
        return applies(*find_parameter(key), scene);
    };
    const SceneDescription flag;
    EXPECT_TRUE(shown("cloth.size.x", flag));
    EXPECT_TRUE(shown("material.mass_per_area", flag));
    EXPECT_FALSE(shown("material.particle_mass", flag));
    EXPECT_TRUE(shown("wind.gust.period", flag));
    SceneDescription other = flag;
    other.wind->gust.model = GustModel::none;
    EXPECT_TRUE(shown("wind.drag", other));
    EXPECT_FALSE(shown("wind.gust.period", other));
    other.wind.reset();
    EXPECT_FALSE(shown("wind.drag", other));
    EXPECT_FALSE(shown("wind.gust.period", other));
    other.material.particle_mass = 1.0;
    EXPECT_FALSE(shown("material.mass_per_area", other));
    EXPECT_TRUE(shown("material.particle_mass", other));
    other.cloth.mesh = std::make_shared<Mesh>();
    EXPECT_FALSE(shown("cloth.size.x", other));
    EXPECT_FALSE(shown("cloth.resolution.y", other));
}

TEST(Parameters, OfTheMethodAreThoseItReads) {
    const auto reads = [](const char* key, std::string_view method) {
        SceneDescription scene;
        scene.integrator.method = method;
        return applies(*find_parameter(key), scene);
    };
    for (const IntegratorInfo& info : integrator_catalogue()) {
        const std::string_view name = info.name;
        const bool solves = info.kind == IntegratorKind::implicit && name != "baraff-witkin";
        EXPECT_EQ(reads("integrator.tolerance", name),
                  solves || name == "dopri5" || name == "bosh3" || name == "projective-dynamics")
            << name;
        EXPECT_EQ(reads("integrator.iterations", name),
                  solves || name == "projective-dynamics" || name == "xpbd" || name == "vbd")
            << name;
        EXPECT_TRUE(reads("integrator.time_step", name));
    }
    EXPECT_TRUE(reads("integrator.tolerance", "auto"));
}

TEST(Parameters, OfTheMethodMayBeAutomatic) {
    for (const char* key :
         {"integrator.time_step", "integrator.tolerance", "integrator.iterations"}) {
        const Parameter& row = *find_parameter(key);
        SceneDescription scene;
        EXPECT_TRUE(row.automatic(scene)) << key;
        EXPECT_EQ(row.get(scene), 0.0);
        row.set(scene, 3.0);
        EXPECT_FALSE(row.automatic(scene));
        EXPECT_EQ(row.get(scene), 3.0);
        row.make_automatic(scene);
        EXPECT_TRUE(row.automatic(scene));
    }
}

TEST(Parameters, SayWhatStiffnessIsCountedPer) {
    SceneDescription scene;
    const Parameter& stiffness = *find_parameter("material.bend.stiffness");
    EXPECT_EQ(unit_of(stiffness, scene), "N/m of width");
    scene.material.stiffness_per = StiffnessPer::spring;
    EXPECT_EQ(unit_of(stiffness, scene), "N/m a spring");
    EXPECT_EQ(unit_of(*find_parameter("wind.velocity.z"), scene), "m/s");
}

TEST(Parameters, ThatMakeTheClothAnewBeginAtRest) {
    SceneDescription scene;
    scene.start.state = std::make_shared<const ClothState>();
    scene.start.time = 3.0;
    for (const Parameter& row : parameters()) {
        const ParameterChange change = with_parameter(scene_for(row), row, row.low);
        EXPECT_EQ(row.restarts, row.section == "Cloth") << row.key;
        if (!row.restarts) continue;
        SceneDescription changed = scene;
        row.set(changed, row.low);
        EXPECT_EQ(changed.start.state, nullptr);
        EXPECT_EQ(changed.start.time, 0.0);
    }
}

}  // namespace
}  // namespace weft::viewer
