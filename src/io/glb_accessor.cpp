// Numbers out of a binary glTF file: container, buffer views, accessors.
#include "io/glb_accessor.h"

#include <fmt/format.h>

#include <cstring>

namespace weft {

namespace {

constexpr std::uint32_t magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr std::size_t type_uint8 = 5121, type_uint16 = 5123, type_uint32 = 5125, type_float = 5126;
/// Zeros that no byte of the file stands for (sparse accessors) must not fill the memory.
constexpr std::size_t most_numbers = std::size_t{1} << 26;

std::size_t components_of(std::string_view type) {
    return type == "VEC3" ? 3 : type == "VEC2" ? 2 : 1;
}

bool has_type(const nlohmann::json& accessor, std::string_view type) {
    return accessor.contains("type") && accessor["type"] == type;
}

std::uint32_t word(const Bytes& bytes, std::size_t offset) {
    return number_at<std::endian::little, std::uint32_t>(bytes, offset);
}

}  // namespace

GlbContainer::GlbContainer(const std::filesystem::path& path) : file_(path) {
    const Bytes head = file_.read(0, 20);
    if (word(head, 0) != magic) throw error("not a binary glTF file: it does not begin with glTF");
    if (word(head, 4) != 2)
        throw error(fmt::format("glTF version {} is not known: 2 is", word(head, 4)));
    if (word(head, 8) != file_.size())
        throw error(fmt::format("has {} bytes: its head names {}", file_.size(), word(head, 8)));
    if (word(head, 16) != json_chunk) throw error("its first chunk is not JSON");
    const std::uint64_t json_bytes = word(head, 12);
    const Bytes text = file_.read(20, json_bytes);
    json_ = nlohmann::json::parse(reinterpret_cast<const char*>(text.data()),
                                  reinterpret_cast<const char*>(text.data()) + text.size(), nullptr,
                                  false);
    if (!json_.is_object()) throw error("its JSON cannot be read");
    if (20 + json_bytes == file_.size()) return;
    const Bytes chunk = file_.read(20 + json_bytes, 8);
    if (word(chunk, 4) != binary_chunk) throw error("its second chunk is not binary data");
    binary_begin_ = 28 + json_bytes;
    binary_size_ = word(chunk, 0);
    if (binary_size_ > file_.size() - binary_begin_) throw error("its binary chunk is cut off");
}

const nlohmann::json& GlbContainer::item(const char* list, std::size_t index) const {
    const auto found = json_.find(list);
    if (found == json_.end() || !found->is_array() || index >= found->size() ||
        !(*found)[index].is_object())
        throw error(fmt::format("has no {}[{}]", list, index));
    return (*found)[index];
}

std::size_t GlbContainer::number(const nlohmann::json& object, const char* key) const {
    const auto found = object.is_object() ? object.find(key) : object.end();
    if (!object.is_object() || found == object.end() || !found->is_number_unsigned())
        throw error(fmt::format("\"{}\" must be a whole number of at least 0", key));
    return found->get<std::size_t>();
}

std::size_t GlbContainer::number_or(const nlohmann::json& object, const char* key,
                                    std::size_t otherwise) const {
    return object.is_object() && object.contains(key) ? number(object, key) : otherwise;
}

std::size_t GlbContainer::count(std::size_t accessor) const {
    return number(item("accessors", accessor), "count");
}

/// The elements that `user` (an accessor, or a part of a sparse one) takes from its buffer view.
Bytes GlbContainer::view_bytes(const nlohmann::json& user, const Layout& layout) const {
    const nlohmann::json& view = item("bufferViews", number(user, "bufferView"));
    if (number(view, "buffer") != 0) throw error("data outside the file are not read");
    const std::uint64_t length = number(view, "byteLength"),
                        begin = number_or(view, "byteOffset", 0);
    const std::uint64_t offset = number_or(user, "byteOffset", 0);
    const std::uint64_t stride = number_or(view, "byteStride", layout.element_bytes);
    if (begin > binary_size_ || length > binary_size_ - begin)
        throw error("a buffer view reaches beyond the binary chunk");
    if (layout.count == 0) return {};
    const bool fits = stride >= layout.element_bytes && stride <= 256 && offset <= length &&
                      layout.element_bytes <= length - offset &&
                      layout.count - 1 <= (length - offset - layout.element_bytes) / stride;
    if (!fits) throw error("an accessor reaches beyond its buffer view");
    Bytes bytes = file_.read(binary_begin_ + begin + offset,
                             (layout.count - 1) * stride + layout.element_bytes);
    if (stride == layout.element_bytes) return bytes;
    for (std::size_t i = 1; i < layout.count; ++i)
        std::memmove(&bytes[i * layout.element_bytes], &bytes[i * stride], layout.element_bytes);
    bytes.resize(layout.count * layout.element_bytes);
    return bytes;
}

std::vector<float> GlbContainer::floats(std::size_t accessor, std::string_view type) const {
    const nlohmann::json& object = item("accessors", accessor);
    const std::size_t components = components_of(type);
    if (number(object, "componentType") != type_float || !has_type(object, type))
        throw error(fmt::format("accessors[{}] must hold {} of floats", accessor, type));
    const std::size_t elements = count(accessor);
    if (elements > most_numbers / components)
        throw error(fmt::format("accessors[{}] with {} elements is too large", accessor, elements));
    std::vector<float> values(elements * components);
    if (object.contains("bufferView")) {
        const Bytes bytes = view_bytes(object, {elements, 4 * components});
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = number_at<std::endian::little, float>(bytes, 4 * i);
    }
    if (object.contains("sparse")) apply_sparse(object["sparse"], components, values);
    return values;
}

void GlbContainer::apply_sparse(const nlohmann::json& sparse, std::size_t components,
                                std::vector<float>& values) const {
    const std::size_t changed = number(sparse, "count");
    if (!sparse.contains("indices") || !sparse.contains("values"))
        throw error("a sparse accessor needs indices and values");
    const auto places = integers_of(sparse["indices"], changed);
    const Bytes bytes = view_bytes(sparse["values"], {changed, 4 * components});
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] >= values.size() / components)
            throw error(fmt::format("a sparse accessor changes element {} of {}", places[i],
                                    values.size() / components));
        for (std::size_t k = 0; k < components; ++k)
            values[places[i] * components + k] =
                number_at<std::endian::little, float>(bytes, 4 * (i * components + k));
    }
}

std::vector<std::uint32_t> GlbContainer::integers(std::size_t accessor) const {
    const nlohmann::json& object = item("accessors", accessor);
    if (!has_type(object, "SCALAR") || object.contains("sparse"))
        throw error(fmt::format("accessors[{}] must hold plain SCALAR numbers", accessor));
    return integers_of(object, count(accessor));
}

std::vector<std::uint32_t> GlbContainer::integers_of(const nlohmann::json& user,
                                                     std::size_t count) const {
    const std::size_t type = number(user, "componentType");
    if (type != type_uint8 && type != type_uint16 && type != type_uint32)
        throw error(fmt::format("component type {} is no whole number of at least 0", type));
    const std::size_t size = type == type_uint8 ? 1 : type == type_uint16 ? 2 : 4;
    const Bytes bytes = view_bytes(user, {count, size});
    std::vector<std::uint32_t> values;
    for (std::size_t at = 0; at < bytes.size(); at += size)
        values.push_back(size == 1   ? number_at<std::endian::little, std::uint8_t>(bytes, at)
                         : size == 2 ? number_at<std::endian::little, std::uint16_t>(bytes, at)
                                     : number_at<std::endian::little, std::uint32_t>(bytes, at));
    return values;
}

}  // namespace weft
