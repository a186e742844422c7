// Numbers out of a binary glTF file, every access checked against the file's size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "io/input_file.h"

namespace weft {

/// A glb file: its JSON, and its binary part to be read piece by piece. Every function throws Error
/// (file) for what is missing, of another type or out of range.
class GlbContainer {
public:
    explicit GlbContainer(const std::filesystem::path& path);

    [[nodiscard]] const nlohmann::json& json() const { return json_; }
    /// An element of a top-level array, e.g. ("meshes", 0).
    [[nodiscard]] const nlohmann::json& item(const char* list, std::size_t index) const;
    /// A whole number of at least 0 in an object.
    [[nodiscard]] std::size_t number(const nlohmann::json& object, const char* key) const;
    [[nodiscard]] std::size_t number_or(const nlohmann::json& object, const char* key,
                                        std::size_t otherwise) const;
    [[nodiscard]] std::size_t count(std::size_t accessor) const;

    /// A float accessor, sparse or not, element after element.
    /// @param type "SCALAR", "VEC2", "VEC3"
    [[nodiscard]] std::vector<float> floats(std::size_t accessor, std::string_view type) const;
    /// A scalar accessor of whole numbers (8, 16 or 32 bits).
    [[nodiscard]] std::vector<std::uint32_t> integers(std::size_t accessor) const;

    [[nodiscard]] Error error(const std::string& reason) const { return file_.error(reason); }

private:
    /// Packed elements: where they lie, how large they are.
    struct Layout {
        std::size_t count = 0, element_bytes = 0;
    };
    [[nodiscard]] Bytes view_bytes(const nlohmann::json& user, const Layout& layout) const;
    [[nodiscard]] std::vector<std::uint32_t> integers_of(const nlohmann::json& user,
                                                         std::size_t count) const;
    void apply_sparse(const nlohmann::json& accessor, std::size_t components,
                      std::vector<float>& values) const;

    InputFile file_;
    nlohmann::json json_;
    std::uint64_t binary_begin_ = 0, binary_size_ = 0;
};

}  // namespace weft
