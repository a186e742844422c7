#include "io/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <system_error>

#include "io/printable.h"
#include "weft/error.h"

namespace weft {

namespace {

constexpr std::array<PlyType, 8> types{{{"char", "int8", 1, true, true},
                                        {"uchar", "uint8", 1, true, false},
                                        {"short", "int16", 2, true, true},
                                        {"ushort", "uint16", 2, true, false},
                                        {"int", "int32", 4, true, true},
                                        {"uint", "uint32", 4, true, false},
                                        {"float", "float32", 4, false, true},
                                        {"double", "float64", 8, false, true}}};

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// What a property of a vertex or a face is for.
std::string_view role_of(std::string_view element, const PlyProperty& property) {
    const std::string_view name = property.name;
    if (element == "face")
        return property.count_type && is_one_of(name, {"vertex_indices", "vertex_index"})
                   ? "vertex_indices"
                   : "other";
    if (property.count_type) return "other";
    if (is_one_of(name, {"x", "y", "z"})) return name;
    if (is_one_of(name, {"s", "u", "texture_u", "tx"})) return "s";
    if (is_one_of(name, {"t", "v", "texture_v", "ty"})) return "t";
    return "other";
}

class HeaderReader {
public:
    HeaderReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    PlyHeader read();

private:
    [[nodiscard]] Error error(const std::string& message) const {
        return {ErrorKind::file, {.file = file_, .line = header_.lines}, message};
    }
    std::vector<std::string_view> next_line();
    void read_format(const std::vector<std::string_view>& words);
    void read_element(const std::vector<std::string_view>& words);
    void read_property(const std::vector<std::string_view>& words);
    [[nodiscard]] const PlyType* type_named(std::string_view name) const;
    void check_elements() const;
    void check_roles(const PlyElement& element) const;

    std::string_view bytes_;
    const std::string& file_;
    PlyHeader header_;
};

/// The words of the next line; takes it off the front of bytes_.
std::vector<std::string_view> HeaderReader::next_line() {
    const std::string_view rest = bytes_.substr(header_.size);
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) throw file_error(file_, "the header has no end_header line");
    header_.size += end + 1;
    ++header_.lines;
    std::vector<std::string_view> words;
    for (std::size_t at = 0; (at = rest.substr(0, end).find_first_not_of(" \t\r", at)) < end;) {
        const std::size_t stop = std::min(rest.find_first_of(" \t\r\n", at), end);
        words.push_back(rest.substr(at, stop - at));
        at = stop;
    }
    return words;
}

void HeaderReader::read_format(const std::vector<std::string_view>& words) {
    constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian",
                                                    "binary_big_endian"};
    const auto* const name =
        words.size() == 3 ? std::find(names.begin(), names.end(), words[1]) : names.end();
    if (name == names.end() || words[0] != "format" || words[2] != "1.0")
        throw error(fmt::format("the second line must be \"format\" with one of {} and 1.0",
                                fmt::join(names, ", ")));
    header_.format = static_cast<PlyFormat>(name - names.begin());
}

void HeaderReader::read_element(const std::vector<std::string_view>& words) {
    PlyElement element;
    const std::string_view count = words.size() == 3 ? words[2] : "";
    const auto [end, status] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (count.empty() || status != std::errc{} || end != count.data() + count.size())
        throw error("an element has a name and a count");
    element.name = words[1];
    if (header_.find(element.name))
        throw error(fmt::format("the element {} stands here twice", printable(element.name)));
    header_.elements.push_back(element);
}

const PlyType* HeaderReader::type_named(std::string_view name) const {
    for (const PlyType& type : types)
        if (name == type.name || name == type.other_name) return &type;
    throw error(fmt::format("{} is not a type of PLY", printable(name)));
}

void HeaderReader::read_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) throw error("a property stands before the first element");
    const bool list = words.size() == 5 && words[1] == "list";
    if (!list && words.size() != 3) throw error("a property has a type and a name");
    PlyProperty property;
    property.name = words.back();
    property.type = type_named(words[words.size() - 2]);
    if (list) property.count_type = type_named(words[2]);
    if (list && !property.count_type->whole) throw error("the count of a list is a whole number");
    header_.elements.back().properties.push_back(property);
}

/// Each role at most once, and those that make a mesh exactly once.
void HeaderReader::check_roles(const PlyElement& element) const {
    const bool is_face = element.name == "face";
    std::vector<std::string_view> roles;
    for (const PlyProperty& property : element.properties) {
        const std::string_view role = role_of(element.name, property);
        if (role == "other") continue;
        if (std::find(roles.begin(), roles.end(), role) != roles.end())
            throw file_error(
                file_, fmt::format("element {} has two properties for {}", element.name, role));
        if (is_face && !property.type->whole)
            throw file_error(file_, "vertex_indices must be whole numbers");
        roles.push_back(role);
    }
    const auto needed = is_face ? std::vector<std::string_view>{"vertex_indices"}
                                : std::vector<std::string_view>{"x", "y", "z"};
    for (const std::string_view role : needed)
        if (std::find(roles.begin(), roles.end(), role) == roles.end())
            throw file_error(file_,
                             fmt::format("element {} has no property {}", element.name, role));
}

void HeaderReader::check_elements() const {
    for (const std::string_view name : {"vertex", "face"}) {
        const PlyElement* element = header_.find(name);
        if (!element || element->count == 0)
            throw file_error(file_,
                             name == "face" ? "the mesh has no faces" : "the mesh has no vertices");
        check_roles(*element);
    }
    for (const PlyElement& element : header_.elements) {
        // In ascii every number takes a digit and a blank, the very last one perhaps no blank.
        std::size_t least = 0;
        for (const PlyProperty& property : element.properties) {
            const PlyType* first = property.count_type ? property.count_type : property.type;
            least += header_.format == PlyFormat::ascii ? 2 : first->size;
        }
        const std::size_t room = bytes_.size() - header_.size + 1;
        if (element.count > room / std::max<std::size_t>(least, 1))
            throw file_error(file_,
                             fmt::format("{} elements {} do not fit in the file's {} bytes",
                                         element.count, printable(element.name), bytes_.size()));
    }
}

PlyHeader HeaderReader::read() {
    if (!bytes_.starts_with("ply\n") && !bytes_.starts_with("ply\r\n"))
        throw file_error(file_, "not a PLY file: the first line must be \"ply\"");
    next_line();
    auto words = next_line();
    while (!words.empty() && (words[0] == "comment" || words[0] == "obj_info")) words = next_line();
    read_format(words);
    for (words = next_line(); words.empty() || words[0] != "end_header"; words = next_line()) {
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
        if (words[0] == "element")
            read_element(words);
        else if (words[0] == "property")
            read_property(words);
        else
            throw error(fmt::format("{} is not known in a PLY header", printable(words[0])));
    }
    check_elements();
    return header_;
}

}  // namespace

const PlyElement* PlyHeader::find(std::string_view element) const {
    for (const PlyElement& candidate : elements)
        if (candidate.name == element) return &candidate;
    return nullptr;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& file) {
    return HeaderReader(bytes, file).read();
}

std::string plain_ply_header(const PlyHeader& header) {
    constexpr std::array<std::string_view, 3> formats{"ascii", "binary_little_endian",
                                                      "binary_big_endian"};
    std::string text =
        fmt::format("ply\nformat {} 1.0\n", formats[static_cast<std::size_t>(header.format)]);
    for (const std::string_view name : {"vertex", "face"}) {
        const PlyElement& element = *header.find(name);
        text += fmt::format("element {} {}\n", name, element.count);
        for (const PlyProperty& property : element.properties)
            text +=
                property.count_type
                    ? fmt::format("property list {} {} {}\n", property.count_type->name,
                                  property.type->name, role_of(name, property))
                    : fmt::format("property {} {}\n", property.type->name, role_of(name, property));
    }
    return text + "end_header\n";
}

}  // namespace weft
