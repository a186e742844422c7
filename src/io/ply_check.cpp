#include "io/ply_check.h"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <system_error>

#include "io/ply_header.h"
#include "io/printable.h"
#include "weft/error.h"

namespace weft {

namespace {

/// Where in the file a check is, for messages.
struct BodyPlace {
    const std::string& file;
    const PlyElement& element;
    std::uint64_t index;  ///< which of the elements, from 0

    [[nodiscard]] Error error(const std::string& message, int line = 0) const {
        return {ErrorKind::file,
                {.file = file, .line = line},
                fmt::format("{} {}: {}", printable(element.name), index, message)};
    }
    [[nodiscard]] Error too_short() const {
        return error(
            fmt::format("the file ends here: the header says that {} follow", element.count));
    }
};

/// Walks through a binary body.
class BinaryBody {
public:
    BinaryBody(std::string_view body, PlyFormat format) : body_(body), format_(format) {}

    void take(const BodyPlace& place) {
        for (const PlyProperty& property : place.element.properties) {
            std::uint64_t numbers = 1;
            if (property.count_type) numbers = take_count(*property.count_type, place);
            skip(numbers, property.type->size, place);
        }
    }
    /// The bytes from `begin` to where the walk is.
    [[nodiscard]] std::string_view since(std::size_t begin) const {
        return body_.substr(begin, at_ - begin);
    }
    [[nodiscard]] std::size_t position() const { return at_; }

private:
    void skip(std::uint64_t numbers, std::size_t size, const BodyPlace& place) {
        if (numbers > (body_.size() - at_) / size) throw place.too_short();
        at_ += static_cast<std::size_t>(numbers) * size;
    }

    std::uint64_t take_count(const PlyType& type, const BodyPlace& place) {
        const std::size_t begin = at_;
        skip(1, type.size, place);
        std::uint64_t count = 0;
        for (std::size_t k = 0; k < type.size; ++k) {
            const std::size_t from_top = format_ == PlyFormat::big_endian ? k : type.size - 1 - k;
            count = count << 8 | static_cast<unsigned char>(body_[begin + from_top]);
        }
        const bool negative = type.is_signed && (count >> (8 * type.size - 1) & 1) != 0;
        if (negative) throw place.error("a list has a negative count");
        return count;
    }

    std::string_view body_;
    PlyFormat format_;
    std::size_t at_ = 0;
};

/// Walks through an ascii body: an element a line, blank lines left out.
class AsciiBody {
public:
    AsciiBody(std::string_view body, int line) : body_(body), line_number_(line) {}

    /// @return the line of the element, without its end.
    std::string_view take(const BodyPlace& place) {
        const std::string_view line = next_line(place);
        words_ = line;
        for (const PlyProperty& property : place.element.properties) {
            std::uint64_t numbers = 1;
            if (property.count_type) numbers = take_count(place);
            for (; numbers > 0; --numbers) check_number(*property.type, place);
        }
        if (!take_word().empty())
            throw place.error("the line holds more numbers than the header says", line_number_);
        return line;
    }

private:
    std::string_view next_line(const BodyPlace& place) {
        for (;;) {
            if (at_ >= body_.size()) throw place.too_short();
            const std::size_t end = std::min(body_.find('\n', at_), body_.size());
            std::string_view line = body_.substr(at_, end - at_);
            at_ = end + 1;
            ++line_number_;
            if (const std::size_t last = line.find_last_not_of(" \t\r");
                last != std::string_view::npos) {
                line = line.substr(0, last + 1);
                return line.substr(line.find_first_not_of(" \t\r"));
            }
        }
    }

    std::string_view take_word() {
        words_.remove_prefix(std::min(words_.find_first_not_of(" \t"), words_.size()));
        const std::string_view word = words_.substr(0, words_.find_first_of(" \t"));
        words_.remove_prefix(word.size());
        return word;
    }

    std::string_view needed_word(const BodyPlace& place) {
        const std::string_view word = take_word();
        if (word.empty())
            throw place.error("the line holds fewer numbers than the header says", line_number_);
        return word;
    }

    std::uint64_t take_count(const BodyPlace& place) {
        const std::string_view word = needed_word(place);
        std::uint32_t count = 0;
        const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), count);
        if (status != std::errc{} || end != word.data() + word.size())
            throw place.error(fmt::format("{} is not the count of a list", printable(word)),
                              line_number_);
        return count;
    }

    void check_number(const PlyType& type, const BodyPlace& place) {
        const std::string_view word = needed_word(place);
        const char* const last = word.data() + word.size();
        std::int64_t whole = 0;
        double value = 0.0;
        const auto [end, status] = type.whole ? std::from_chars(word.data(), last, whole)
                                              : std::from_chars(word.data(), last, value);
        if (end != last || status == std::errc::invalid_argument)
            throw place.error(
                fmt::format("{} is not a number of type {}", printable(word), type.name),
                line_number_);
        // The library reads whole numbers into 32 bits and would wrap larger ones.
        if (status != std::errc{} || whole > 0xffffffffLL || whole < -0x80000000LL)
            throw place.error(fmt::format("{} is out of range", printable(word)), line_number_);
    }

    std::string_view body_, words_;
    std::size_t at_ = 0;
    int line_number_;
};

}  // namespace

std::string check_ply(std::string_view bytes, const std::string& file) {
    const PlyHeader header = read_ply_header(bytes, file);
    const std::string_view body = bytes.substr(header.size);
    std::string vertices, faces;
    AsciiBody ascii(body, header.lines);
    BinaryBody binary(body, header.format);
    for (const PlyElement& element : header.elements) {
        std::string unread;
        std::string& kept =
            element.name == "vertex" ? vertices : (element.name == "face" ? faces : unread);
        const std::size_t begin = binary.position();
        for (std::uint64_t k = 0; k < element.count; ++k) {
            const BodyPlace place{file, element, k};
            if (header.format == PlyFormat::ascii)
                kept.append(ascii.take(place)).append("\n");
            else
                binary.take(place);
        }
        kept += binary.since(begin);
    }
    return plain_ply_header(header) + vertices + faces;
}

}  // namespace weft
