// The JSON part of a binary glTF file that holds a recording: one mesh, one morph target for each
// further frame, and an animation of their weights.
#include "io/glb_document.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace weft {

namespace {

using nlohmann::json;

// Numbers of the glTF 2.0 specification.
constexpr int type_uint32 = 5125, type_float = 5126;
constexpr int vertex_buffer = 34962, index_buffer = 34963;
constexpr int filter_linear = 9729, filter_mipmaps = 9987;
constexpr int wrap_repeat = 10497, wrap_clamp = 33071;

/// An array of one element; braces alone could mean the element itself.
json only(json element) {
    json array = json::array();
    array.push_back(std::move(element));
    return array;
}

/// Lays buffer views one after the other and numbers what it is given.
class Builder {
public:
    explicit Builder(const GlbContent& content) : content_(content) {
        root_["asset"] = {{"version", "2.0"}, {"generator", content.generator}};
    }

    std::string build();

private:
    std::size_t add_view(std::uint64_t bytes, json more = json::object()) {
        more["buffer"] = 0;
        more["byteOffset"] = offset_;
        more["byteLength"] = bytes;
        offset_ += glb_padded(bytes);
        root_["bufferViews"].push_back(std::move(more));
        return root_["bufferViews"].size() - 1;
    }
    std::size_t add_accessor(json accessor) {
        root_["accessors"].push_back(std::move(accessor));
        return root_["accessors"].size() - 1;
    }
    json add_shape(const GlbBounds& bounds);
    void add_picture();
    void add_mesh();
    void add_animation();

    const GlbContent& content_;
    json root_;
    json primitive_;
    std::uint64_t offset_ = 0;
};

json Builder::add_shape(const GlbBounds& bounds) {
    const std::uint64_t half = 12 * std::uint64_t{content_.vertex_count};
    const auto view = add_view(2 * half, {{"target", vertex_buffer}, {"byteStride", 12}});
    const json vectors = {{"bufferView", view},
                          {"componentType", type_float},
                          {"type", "VEC3"},
                          {"count", content_.vertex_count}};
    json positions = vectors, normals = vectors;
    positions["byteOffset"] = 0;
    positions["min"] = bounds.low;
    positions["max"] = bounds.high;
    normals["byteOffset"] = half;
    const auto position = add_accessor(std::move(positions));
    return {{"POSITION", position}, {"NORMAL", add_accessor(std::move(normals))}};
}

void Builder::add_picture() {
    const int wrap = content_.repeat_texture ? wrap_repeat : wrap_clamp;
    const auto view = add_view(content_.picture_bytes);
    root_["images"] = only({{"bufferView", view}, {"mimeType", "image/png"}, {"name", "cloth"}});
    root_["samplers"] = only({{"magFilter", filter_linear},
                              {"minFilter", filter_mipmaps},
                              {"wrapS", wrap},
                              {"wrapT", wrap}});
    root_["textures"] = only({{"source", 0}, {"sampler", 0}});
    root_["materials"] = only({{"name", "cloth"},
                               {"doubleSided", true},
                               {"pbrMetallicRoughness",
                                {{"baseColorTexture", {{"index", 0}}},
                                 {"metallicFactor", 0.0},
                                 {"roughnessFactor", 0.8}}}});
}

void Builder::add_mesh() {
    const auto index_view = add_view(4 * content_.index_count, {{"target", index_buffer}});
    const auto uv_view = add_view(8 * content_.vertex_count, {{"target", vertex_buffer}});
    add_picture();
    const auto indices = add_accessor({{"bufferView", index_view},
                                       {"componentType", type_uint32},
                                       {"type", "SCALAR"},
                                       {"count", content_.index_count}});
    const auto uvs = add_accessor({{"bufferView", uv_view},
                                   {"componentType", type_float},
                                   {"type", "VEC2"},
                                   {"count", content_.vertex_count}});
    primitive_ = {{"indices", indices}, {"material", 0}};
    primitive_["attributes"] = add_shape(content_.bounds.front());
    primitive_["attributes"]["TEXCOORD_0"] = uvs;

    json names = json::array();
    for (std::size_t shape = 1; shape < content_.bounds.size(); ++shape) {
        primitive_["targets"].push_back(add_shape(content_.bounds[shape]));
        names.push_back(fmt::format("frame {}", content_.frame_index[shape]));
    }
    json mesh = {{"name", content_.title}, {"primitives", only(primitive_)}};
    if (!names.empty()) mesh["extras"]["targetNames"] = names;
    root_["meshes"].push_back(mesh);
    root_["nodes"] = only({{"name", content_.title}, {"mesh", 0}});
    root_["scenes"] = only({{"name", content_.title}, {"nodes", only(0)}});
    root_["scene"] = 0;
}

/// Keyframe i has weight 1 at target i - 1 and 0 elsewhere, keyframe 0 only zeros; linear
/// interpolation then blends neighbouring frames.
void Builder::add_animation() {
    const std::size_t keys = content_.bounds.size(), targets = keys - 1;
    const auto time_view = add_view(4 * keys);
    const auto place_view = add_view(4 * targets), value_view = add_view(4 * targets);
    const auto times = add_accessor({{"bufferView", time_view},
                                     {"componentType", type_float},
                                     {"type", "SCALAR"},
                                     {"count", keys},
                                     {"min", only(content_.first_time)},
                                     {"max", only(content_.last_time)}});
    json weights = {{"componentType", type_float}, {"type", "SCALAR"}, {"count", keys * targets}};
    weights["sparse"] = {{"count", targets},
                         {"indices", {{"bufferView", place_view}, {"componentType", type_uint32}}},
                         {"values", {{"bufferView", value_view}}}};
    const auto output = add_accessor(std::move(weights));
    json animation;
    animation["name"] = content_.title;
    animation["samplers"] =
        only({{"input", times}, {"output", output}, {"interpolation", "LINEAR"}});
    const json target = {{"node", 0}, {"path", "weights"}};
    animation["channels"] = only({{"sampler", 0}, {"target", target}});
    animation["extras"] = {{"frames_per_second", content_.frames_per_second},
                           {"frames_recorded", content_.frames_recorded}};
    root_["animations"].push_back(std::move(animation));
}

std::string Builder::build() {
    add_mesh();
    if (content_.bounds.size() > 1) add_animation();
    root_["buffers"] = only({{"byteLength", offset_}});
    return root_.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string glb_json(const GlbContent& content) {
    return Builder(content).build();
}

}  // namespace weft
