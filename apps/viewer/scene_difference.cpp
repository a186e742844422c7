// Scenes are compared as JSON, key by key of the scene file: no key can be forgotten.
#include "viewer/scene_difference.h"

#include <string>
#include <variant>

#include "io/scene_json.h"

namespace weft::viewer {

namespace {

using Json = nlohmann::ordered_json;

Json part(const Json& object, const std::string& key) {
    return object.is_object() && object.contains(key) ? object.at(key) : Json();
}

bool other_files(const SceneDescription& a, const SceneDescription& b) {
    return a.cloth.mesh != b.cloth.mesh || a.start.state != b.start.state;
}

Json cloth_of(const Json& scene) {
    return Json::array({part(scene, "cloth"), part(scene, "start"),
                        part(part(scene, "integrator"), "precision"),
                        part(part(scene, "output"), "frames_per_second")});
}

Json physics_of(Json scene) {
    scene.erase("name");
    scene.erase("render");
    if (scene.contains("output")) {
        scene["output"].erase("duration");
        scene["output"].erase("formats");
    }
    return scene;
}

Json shape_of(const Json& json, const SceneDescription& scene) {
    const Json material = part(json, "material");
    Json shape = Json::array({part(json, "cloth"), part(json, "pins"), part(json, "render"),
                              part(material, "mass_per_area"), part(material, "particle_mass"),
                              part(part(material, "bend"), "layout")});
    const Json obstacles = part(json, "obstacles");
    for (std::size_t n = 0; n < scene.obstacles.size(); ++n) {
        const bool plane = std::holds_alternative<PlaneObstacle>(scene.obstacles[n].shape);
        shape.push_back(plane && n < obstacles.size() ? obstacles[n] : Json());
    }
    return shape;
}

}  // namespace

SceneDifference difference(const SceneDescription& from, const SceneDescription& to) {
    const Json a = scene_to_json(from), b = scene_to_json(to);
    const bool files = other_files(from, to);
    return {.cloth = files || cloth_of(a) != cloth_of(b),
            .physics = files || physics_of(a) != physics_of(b),
            .shape = files || shape_of(a, from) != shape_of(b, to),
            .obstacles = part(a, "obstacles") != part(b, "obstacles")};
}

}  // namespace weft::viewer
