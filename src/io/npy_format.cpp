// The head is a Python dictionary,
//     {'descr': '<f8', 'fortran_order': False, 'shape': (2, 1600, 3), }
// behind eight bytes of magic and version and the length of its text.
#include "io/npy_format.h"

#include <fmt/format.h>

#include <charconv>
#include <set>

namespace weft {

namespace {

constexpr std::string_view magic{"\x93NUMPY", 6};
/// A multiple of 64 with room for any shape.
constexpr std::size_t head_size = 128;
/// [bytes]; of a plain array it has some 60, more only where elements are records.
constexpr std::uint64_t longest_text = 4096;

/// Takes a dictionary apart, from its start.
class HeadParser {
public:
    HeadParser(std::string_view text, const InputFile& file) : rest_(text), file_(file) {}

    NpyHead parse() {
        NpyHead head;
        expect('{');
        while (!take('}')) {
            read_member(head);
            if (take(',')) continue;
            expect('}');
            break;
        }
        skip_space();
        if (!rest_.empty() || seen_.size() != 3) refuse();
        return head;
    }

private:
    void read_member(NpyHead& head) {
        const std::string key = quoted();
        expect(':');
        if (!seen_.insert(key).second) refuse();
        if (key == "descr") {
            head.element = quoted();
        } else if (key == "fortran_order") {
            head.fortran_order = boolean();
        } else if (key == "shape") {
            head.shape = tuple();
        } else {
            refuse();
        }
    }

    std::string quoted() {
        const char quote = take('"') ? '"' : '\'';
        if (quote == '\'') expect('\'');
        const std::size_t end = rest_.find(quote);
        if (end == std::string_view::npos) refuse();
        std::string text(rest_.substr(0, end));
        rest_.remove_prefix(end + 1);
        return text;
    }

    bool boolean() {
        skip_space();
        for (const std::string_view word : {"True", "False"}) {
            if (!rest_.starts_with(word)) continue;
            rest_.remove_prefix(word.size());
            return word == "True";
        }
        refuse();
    }

    std::vector<std::uint64_t> tuple() {
        std::vector<std::uint64_t> counts;
        expect('(');
        while (!take(')')) {
            skip_space();
            std::uint64_t count = 0;
            const char* end = rest_.data() + rest_.size();
            const auto [stop, error] = std::from_chars(rest_.data(), end, count);
            if (error != std::errc{}) refuse();
            rest_.remove_prefix(static_cast<std::size_t>(stop - rest_.data()));
            counts.push_back(count);
            if (take(',')) continue;
            expect(')');
            break;
        }
        return counts;
    }

    void skip_space() {
        while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\n')) rest_.remove_prefix(1);
    }

    bool take(char letter) {
        skip_space();
        if (!rest_.starts_with(letter)) return false;
        rest_.remove_prefix(1);
        return true;
    }

    void expect(char letter) {
        if (!take(letter)) refuse();
    }

    [[noreturn]] void refuse() const {
        throw file_.error(
            "its head is not that of a NumPy array: 'descr', 'fortran_order' and 'shape' are "
            "needed, and nothing else");
    }

    std::string_view rest_;
    const InputFile& file_;
    std::set<std::string> seen_;
};

}  // namespace

Bytes npy_head(std::string_view element, std::string_view shape) {
    std::string text =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", element, shape);
    constexpr std::size_t before_text = 10;
    text.resize(head_size - before_text - 1, ' ');
    text += '\n';
    Bytes head;
    append_text(head, magic);
    append_text(head, std::string_view("\x01\x00", 2));
    append_little(head, static_cast<std::uint16_t>(text.size()));
    append_text(head, text);
    return head;
}

void write_npy_vectors(OutputFile& file, std::span<const Vec3d> vectors) {
    static_assert(sizeof(Vec3d) == 24);
    if constexpr (std::endian::native == std::endian::little) {
        file.write(std::as_bytes(vectors));
    } else {
        Bytes bytes;
        bytes.reserve(vectors.size_bytes());
        for (const Vec3d& vector : vectors)
            for (const double component : {vector.x, vector.y, vector.z})
                append_little(bytes, component);
        file.write(bytes);
    }
}

NpyHead read_npy_head(const InputFile& file) {
    const std::uint64_t fixed = magic.size() + 2;
    const Bytes start = file.size() < fixed ? Bytes{} : file.read(0, fixed);
    if (start.empty() ||
        std::string_view(reinterpret_cast<const char*>(start.data()), magic.size()) != magic) {
        throw file.error("is not a NumPy file: it does not begin with \\x93NUMPY");
    }
    const auto version = std::to_integer<int>(start[magic.size()]);
    if (version < 1 || version > 3) {
        throw file.error(fmt::format("is of NumPy format {}; 1 to 3 can be read", version));
    }
    const std::uint64_t digits = version == 1 ? 2 : 4;
    const Bytes counted = file.read(fixed, digits);
    const std::uint64_t length = version == 1
                                     ? number_at<std::endian::little, std::uint16_t>(counted, 0)
                                     : number_at<std::endian::little, std::uint32_t>(counted, 0);
    if (length > longest_text) {
        throw file.error(
            fmt::format("its head has {} bytes; at most {} are allowed", length, longest_text));
    }
    const Bytes text = file.read(fixed + digits, length);
    NpyHead head =
        HeadParser({reinterpret_cast<const char*>(text.data()), text.size()}, file).parse();
    head.size = fixed + digits + length;
    return head;
}

}  // namespace weft
