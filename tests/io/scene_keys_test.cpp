// The table of scene keys agrees with the defaults of scene.h, with the reader, the JSON writer and
// the reference in docs/.
#include "io/scene_keys.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "io/scene_json.h"
#include "io/scene_values.h"
#include "io/toml_value.h"
#include "render/image.h"
#include "support/scene_errors.h"
#include "weft/scene.h"

namespace weft {
namespace {

/// The shipped flag, with what the key needs to be there: an element of its list, of its shape.
SceneDescription scene_for(const SceneKey& row) {
    SceneDescription scene;
    if (const SceneList* list = list_of_scene_key(row.key)) list->renew(scene, 1);
    if (row.key.starts_with("obstacles[].plane.")) scene.obstacles[0].shape = PlaneObstacle{};
    return scene;
}

TEST(SceneKeys, StandOnce) {
    std::set<std::string_view> seen;
    for (const SceneKey& row : scene_keys()) {
        EXPECT_TRUE(seen.insert(row.key).second) << row.key;
        EXPECT_EQ(find_scene_key(row.key), &row);
    }
    EXPECT_EQ(seen.size(), 58U);
    EXPECT_EQ(find_scene_key("cloth"), nullptr);
}

TEST(SceneKeys, HaveTheDefaultsOfSceneDescription) {
    for (const SceneKey& row : scene_keys()) {
        if (row.fallback.empty()) continue;
        SceneDescription plain = scene_for(row);
        SceneDescription read = plain;
        read_scene_value(row, std::string(row.key), parse_toml_value(std::string(row.fallback), 1),
                         read, 0);
        EXPECT_EQ(scene_to_json(read), scene_to_json(plain)) << row.key;
        EXPECT_EQ(scene_value_json(row, read, 0), scene_value_json(row, plain, 0)) << row.key;
    }
}

TEST(SceneKeys, RefuseADateWithWhatTheTableAllows) {
    const TomlValue date = parse_toml_value("2024-05-01", 1);
    for (const SceneKey& row : scene_keys()) {
        if (row.key == "version") continue;
        SceneDescription scene = scene_for(row);
        const auto error =
            test::error_of([&] { read_scene_value(row, std::string(row.key), date, scene, 0); });
        ASSERT_TRUE(error) << row.key;
        EXPECT_EQ(error->message(), "2024-05-01 is not allowed: " + std::string(row.allowed));
    }
}

TEST(SceneKeys, NameEveryBuiltInTexture) {
    const std::string allowed(find_scene_key("render.texture")->allowed);
    for (const TextureInfo& texture : texture_catalogue()) {
        EXPECT_NE(allowed.find("\"" + std::string(texture.name) + "\""), std::string::npos)
            << texture.name;
    }
}

TEST(SceneKeys, AreFoundWhenMisspelt) {
    EXPECT_EQ(nearest_scene_key("cloth", "resolutoin"), "cloth.resolution");
    EXPECT_EQ(nearest_scene_key("", "colth"), "cloth");
    EXPECT_EQ(nearest_scene_key("wind.gust", "peroid"), "wind.gust.period");
    EXPECT_EQ(nearest_scene_key("pins[]", "selct"), "pins[].select");
    EXPECT_EQ(nearest_scene_key("obstacles[]", "spehre"), "obstacles[].sphere");
    EXPECT_EQ(nearest_scene_key("obstacles[].sphere", "raduis"), "obstacles[].sphere.radius");
    EXPECT_EQ(nearest_scene_key("obstacles[]", "radius"), "obstacles[].sphere.radius");
    EXPECT_EQ(nearest_scene_key("", "obstacle"), "obstacles");
    EXPECT_EQ(nearest_scene_key("cloth", "fabric"), "material.fabric");
    EXPECT_EQ(nearest_scene_key("", "time-step"), "integrator.time_step");
    EXPECT_EQ(nearest_scene_key("cloth", "zebra"), "");
}

TEST(SceneKeys, MakeSections) {
    const std::vector<std::string_view> gust{"model", "spread", "period", "seed"};
    EXPECT_EQ(names_in_section("wind.gust"), gust);
    const std::vector<std::string_view> pins{"select", "motion"};
    EXPECT_EQ(names_in_section("pins[]"), pins);
    const std::vector<std::string_view> obstacles{"sphere", "plane", "friction", "gap"};
    EXPECT_EQ(names_in_section("obstacles[]"), obstacles);
    const std::vector<std::string_view> sphere{"centre", "radius"};
    EXPECT_EQ(names_in_section("obstacles[].sphere"), sphere);
    EXPECT_EQ(names_in_section("").size(), 12U);
    EXPECT_TRUE(names_in_section("cloth.size").empty());
    EXPECT_TRUE(names_in_section("clo").empty());
}

TEST(SceneKeys, StandInTheirLists) {
    ASSERT_EQ(scene_lists().size(), 2U);
    EXPECT_EQ(list_of_scene_key("cloth.size"), nullptr);
    EXPECT_EQ(list_of_scene_key("pins[].select")->name, "pins");
    const SceneList* obstacles = list_of_scene_key("obstacles[].sphere.radius");
    ASSERT_NE(obstacles, nullptr);
    SceneDescription scene;
    scene.obstacles.push_back({PlaneObstacle{}, 1.0, 0.1});
    obstacles->renew(scene, 2);
    EXPECT_EQ(obstacles->size(scene), 2U);
    EXPECT_TRUE(std::holds_alternative<SphereObstacle>(scene.obstacles[0].shape));
    EXPECT_EQ(scene.obstacles[0].friction, 0.4);
}

TEST(SceneFormatDocument, HoldsTheTablesOfKeys) {
    std::ifstream file(WEFT_SOURCE_DIR "/docs/scene-format.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string begin = "<!-- scene keys: begin -->\n";
    const std::string end = "<!-- scene keys: end -->\n";
    const std::size_t from = text.find(begin);
    const std::size_t to = text.find(end);
    ASSERT_NE(from, std::string::npos);
    ASSERT_NE(to, std::string::npos);
    const std::size_t start = from + begin.size();
    EXPECT_EQ(text.substr(start, to - start), scene_keys_markdown())
        << "docs/scene-format.md is out of date: put the output of `weft list keys` between the "
           "two lines with \"scene keys:\".";
}

}  // namespace
}  // namespace weft
