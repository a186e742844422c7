#include "bench/suite/label.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace weft::bench {

namespace {

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream stream{std::string(text)};
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

}  // namespace

std::string Label::text() const {
    return fmt::format("{} {}x{} {} {} thread{}", name, columns, rows,
                       precision == Precision::f32 ? "single" : "double", threads,
                       threads == 1 ? "" : "s");
}

bool Label::has_words(std::string_view filter) const {
    const std::vector<std::string> words = words_of(text());
    return std::ranges::all_of(words_of(filter), [&](const std::string& wanted) {
        return std::ranges::find(words, wanted) != words.end();
    });
}

}  // namespace weft::bench
