#include "integrators/spring_colours.h"

#include <algorithm>
#include <utility>

namespace weft {

namespace {

constexpr std::uint32_t none = 0xffffffff;

bool is_free(const SpringNetwork& network, std::uint32_t slot) {
    return network.inverse_masses[slot] > 0.0;
}

// First fit, a colour at a time: take(item, colour) says whether the item joins the colour. Gives
// what first fit item by item would, since a colour is offered to all in the one order.
template <typename Item, typename Take>
void first_fit(std::vector<Item> left, std::vector<Item>& sorted, std::vector<std::size_t>& first,
               const Take& take) {
    first.assign(1, 0);
    for (std::uint32_t colour = 0; !left.empty(); ++colour) {
        std::size_t kept = 0;
        for (const Item& item : left) {
            if (take(item, colour)) {
                sorted.push_back(item);
            } else {
                left[kept++] = item;
            }
        }
        left.resize(kept);
        first.push_back(sorted.size());
    }
}

}  // namespace

ColouredSprings colour_springs(const SpringNetwork& network) {
    std::vector<SpringNetwork::Spring> springs;
    for (const SpringNetwork::Spring& s : network.springs) {
        if (is_free(network, s.p) || is_free(network, s.q)) springs.push_back(s);
    }
    std::vector<std::uint32_t> last(network.inverse_masses.size(), none);  // [slot] colour taken
    ColouredSprings coloured;
    first_fit(std::move(springs), coloured.springs, coloured.first,
              [&](const SpringNetwork::Spring& s, std::uint32_t colour) {
                  if (last[s.p] == colour || last[s.q] == colour) return false;
                  if (is_free(network, s.p)) last[s.p] = colour;
                  if (is_free(network, s.q)) last[s.q] = colour;
                  return true;
              });
    return coloured;
}

ColouredParticles colour_particles(const SpringNetwork& network) {
    const SpringRows<float> rows(network, free_slots(network));
    std::vector<std::uint32_t> row_of(network.inverse_masses.size(), none);
    for (std::uint32_t row = 0; row < rows.slots.size(); ++row) row_of[rows.slots[row]] = row;
    std::vector<std::uint32_t> colours(network.inverse_masses.size(), none);
    ColouredParticles coloured;
    first_fit(rows.slots, coloured.slots, coloured.first,
              [&](std::uint32_t slot, std::uint32_t colour) {
                  const std::uint32_t row = row_of[slot];
                  for (std::uint32_t e = rows.first[row]; e < rows.first[row + 1]; ++e) {
                      if (colours[rows.entries[e].other] == colour) return false;
                  }
                  colours[slot] = colour;
                  return true;
              });
    return coloured;
}

template <typename Real>
SpringRows<Real>::SpringRows(const SpringNetwork& network, std::vector<std::uint32_t> particles)
    : slots(std::move(particles)), first(slots.size() + 1, 0) {
    std::vector<std::uint32_t> row_of(network.inverse_masses.size(), none);
    for (std::uint32_t row = 0; row < slots.size(); ++row) row_of[slots[row]] = row;
    const auto for_ends = [&](const auto& visit) {
        for (const SpringNetwork::Spring& s : network.springs) {
            if (row_of[s.p] != none) visit(row_of[s.p], s.q, s);
            if (row_of[s.q] != none) visit(row_of[s.q], s.p, s);
        }
    };
    for_ends([&](std::uint32_t row, std::uint32_t, const auto&) { ++first[row + 1]; });
    for (std::size_t row = 0; row < slots.size(); ++row) first[row + 1] += first[row];
    entries.resize(first.back());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for_ends([&](std::uint32_t row, std::uint32_t other, const SpringNetwork::Spring& s) {
        entries[next[row]++] = {other, static_cast<Real>(s.rest_length),
                                static_cast<Real>(s.stiffness), static_cast<Real>(s.damping)};
    });
}

std::vector<std::uint32_t> free_slots(const SpringNetwork& network) {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t s = 0; s < network.inverse_masses.size(); ++s) {
        if (is_free(network, s)) slots.push_back(s);
    }
    return slots;
}

bool has_dashpots(const SpringNetwork& network) {
    return std::any_of(network.springs.begin(), network.springs.end(),
                       [](const SpringNetwork::Spring& s) { return s.damping > 0.0; });
}

template struct SpringRows<float>;
template struct SpringRows<double>;

}  // namespace weft
