#include "fuzz/damage.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "math/random.h"

namespace weft::fuzz {

namespace {

class Dice {
public:
    explicit Dice(std::uint64_t number) : number_(number) {}

    // Uniform in [0, sides).
    std::size_t roll(std::size_t sides) {
        return sides == 0 ? 0 : static_cast<std::size_t>(bits() % sides);
    }
    std::uint64_t bits() { return mix_bits(mix_bits(number_) ^ ++drawn_); }

private:
    std::uint64_t number_, drawn_ = 0;
};

constexpr std::array<std::string_view, 24> words{"0",
                                                 "-1",
                                                 "1e999",
                                                 "-1e-999",
                                                 "nan",
                                                 "inf",
                                                 "1e16",
                                                 "2147483648",
                                                 "255",
                                                 "4294967296",
                                                 "-9223372036854775809",
                                                 "\"",
                                                 "[",
                                                 "]",
                                                 "{",
                                                 "}",
                                                 "=",
                                                 "\n",
                                                 std::string_view("\0", 1),
                                                 "/",
                                                 "#",
                                                 "\xff\xfe",
                                                 "element vertex 999999999\n",
                                                 "true"};

// The number that stands at or after a place, its bounds.
std::pair<std::size_t, std::size_t> number_at(const std::string& bytes, std::size_t from) {
    const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    std::size_t begin = from;
    while (begin < bytes.size() && !digit(bytes[begin])) ++begin;
    std::size_t end = begin;
    while (end < bytes.size() && (digit(bytes[end]) || bytes[end] == '.')) ++end;
    return {begin, end};
}

void change(std::string& bytes, const std::string& other, Dice& dice) {
    const std::size_t at = dice.roll(bytes.size()), length = 1 + dice.roll(dice.roll(64) + 1);
    const std::string_view word = words[dice.roll(words.size())];
    switch (dice.roll(8)) {
        case 0:
            if (!bytes.empty()) bytes[at] = static_cast<char>(dice.bits());
            break;
        case 1:
            if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << dice.roll(8)));
            break;
        case 2:
            bytes.erase(at, length);
            break;
        case 3:
            bytes.insert(at, bytes.substr(dice.roll(bytes.size()), length));
            break;
        case 4:
            bytes.insert(at, word);
            break;
        case 5: {
            const auto [begin, end] = number_at(bytes, at);
            bytes.replace(begin, end - begin, word);
            break;
        }
        case 6:
            bytes.insert(at, other.substr(dice.roll(other.size()), length));
            break;
        default:
            if (dice.roll(8) == 0) bytes.resize(at);
    }
}

// How many of the seeds are sound scenes, and how many scenes.
std::pair<std::size_t, std::size_t> kinds(const std::vector<Seed>& seeds) {
    const auto count = [&](Seed::Kind last) {
        return static_cast<std::size_t>(std::count_if(
            seeds.begin(), seeds.end(), [&](const Seed& seed) { return seed.kind <= last; }));
    };
    return {count(Seed::Kind::scene), count(Seed::Kind::invalid_scene)};
}

}  // namespace

Seed damaged(const std::vector<Seed>& seeds, std::uint64_t number) {
    Dice dice(number);
    // Data and scenes that are sound are few beside those of scenes/invalid.
    const auto in = [&](std::size_t begin, std::size_t end) {
        return begin + dice.roll(end - begin);
    };
    const auto [sound, data] = kinds(seeds);
    const std::size_t kind = dice.roll(6), which = kind == 0  ? in(sound, data)
                                                   : kind < 3 ? in(0, sound)
                                                              : in(data, seeds.size());
    Seed seed = seeds[which];
    const std::string& other = seeds[dice.roll(seeds.size())].bytes;
    for (std::size_t left = 1 + dice.roll(dice.roll(8) + 1); left > 0; --left)
        change(seed.bytes, other, dice);
    return seed;
}

}  // namespace weft::fuzz
