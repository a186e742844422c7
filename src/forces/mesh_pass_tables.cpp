#include "forces/mesh_pass_tables.h"

#include <array>
#include <tuple>
#include <utility>

#include "math/simd_targets.h"

namespace weft {

namespace {

// Lists of items one after the other: first counted, then filled.
template <typename Item>
struct Lists {
    std::vector<std::uint32_t>
        first;  // [list + 1]; while filling, where each list's next item goes
    std::vector<Item> items;

    explicit Lists(std::size_t count) : first(count + 1, 0) {}
    void count_one(std::size_t list) { ++first[list + 1]; }
    void begin_filling() {
        for (std::size_t n = 1; n < first.size(); ++n) first[n] += first[n - 1];
        items.resize(first.back());
    }
    void add(std::size_t list, const Item& item) { items[first[list]++] = item; }
    void end_filling() {
        for (std::size_t n = first.size() - 1; n > 0; --n) first[n] = first[n - 1];
        first[0] = 0;
    }
    [[nodiscard]] std::size_t length(std::size_t list) const {
        return first[list + 1] - first[list];
    }
};

// Where the lists of slices begin, `per_slot` lists a slot.
template <typename Item>
std::vector<std::uint32_t> starts_of(const Lists<Item>& lists, std::size_t per_slot,
                                     std::size_t slots, std::size_t lanes) {
    std::vector<std::uint32_t> starts{0};
    for (std::size_t begin = 0; begin < slots; begin += lanes) {
        for (std::size_t n = 0; n < per_slot; ++n) {
            std::size_t longest = 0;
            for (std::size_t s = begin; s < std::min(begin + lanes, slots); ++s) {
                longest = std::max(longest, lists.length(s * per_slot + n));
            }
            starts.push_back(starts.back() + static_cast<std::uint32_t>(longest));
        }
    }
    return starts;
}

// Calls visit(place, slot, item) for every place of the sliced lists, whole slices; item is nullptr
// in padding.
template <typename Item, typename Visit>
void for_each_place(const Lists<Item>& lists, std::size_t per_slot, std::size_t slots,
                    std::size_t lanes, const std::vector<std::uint32_t>& starts,
                    const Visit& visit) {
    for (std::size_t list = 0; list + 1 < starts.size(); ++list) {
        const std::size_t vectors = starts[list + 1] - starts[list];
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::size_t slot = list / per_slot * lanes + lane;
            const std::size_t own = slot * per_slot + list % per_slot;
            const std::size_t length = slot < slots ? lists.length(own) : 0;
            for (std::size_t n = 0; n < vectors; ++n) {
                visit((starts[list] + n) * lanes + lane, slot,
                      n < length ? &lists.items[lists.first[own] + n] : nullptr);
            }
        }
    }
}

template <typename Real>
struct Neighbour {
    std::uint32_t slot = 0;
    Real tension = 0, width = 0;

    bool operator<(const Neighbour& other) const {
        return std::tie(slot, tension, width) < std::tie(other.slot, other.tension, other.width);
    }
};

// Calls visit(slot, other slot, kind, spring, constants) for both ends of every spring with force.
template <typename Visit>
void for_each_end(const ClothModel& cloth, const Visit& visit) {
    cloth.for_each_spring_with_slots(
        [&](const Spring& spring, const SpringConstants& constants, std::size_t p, std::size_t q) {
            if (constants.stiffness == 0.0 && constants.damping == 0.0) return;
            const auto kind = static_cast<std::size_t>(spring.kind);
            visit(p, q, kind, spring, constants);
            visit(q, p, kind, spring, constants);
        });
}

// Every slot's neighbours, a list for each kind of spring, by rising slot.
template <typename Real>
Lists<Neighbour<Real>> neighbour_lists(const ClothModel& cloth) {
    Lists<Neighbour<Real>> lists(cloth.layout.slot_count() * spring_kind_count);
    for_each_end(cloth,
                 [&](std::size_t p, std::size_t, std::size_t kind, const Spring&,
                     const SpringConstants&) { lists.count_one(p * spring_kind_count + kind); });
    lists.begin_filling();
    for_each_end(cloth, [&](std::size_t p, std::size_t q, std::size_t kind, const Spring& spring,
                            const SpringConstants& constants) {
        lists.add(
            p * spring_kind_count + kind,
            {static_cast<std::uint32_t>(q),
             static_cast<Real>(constants.stiffness * spring.rest_length / double{root_scale<Real>}),
             static_cast<Real>(spring.width_factor)});
    });
    lists.end_filling();
    for (std::size_t list = 0; list + 1 < lists.first.size(); ++list) {
        std::sort(lists.items.begin() + lists.first[list],
                  lists.items.begin() + lists.first[list + 1]);
    }
    return lists;
}

// The triangles' corners as slots, those of the same lowest slot together, else as they were.
std::vector<std::array<std::uint32_t, 3>> sorted_triangles(const ClothModel& cloth) {
    Lists<std::array<std::uint32_t, 3>> by_lowest(cloth.layout.slot_count());
    const auto for_each = [&](const auto& visit) {
        for (const auto& triangle : cloth.surface.triangles) {
            std::array<std::uint32_t, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                corners[k] =
                    static_cast<std::uint32_t>(cloth.slot(cloth.surface.particle(triangle[k])));
            }
            visit(*std::min_element(corners.begin(), corners.end()), corners);
        }
    };
    for_each([&](std::size_t lowest, const auto&) { by_lowest.count_one(lowest); });
    by_lowest.begin_filling();
    for_each([&](std::size_t lowest, const auto& corners) { by_lowest.add(lowest, corners); });
    return std::move(by_lowest.items);
}

}  // namespace

template <typename Real>
MeshSpringTables<Real>::MeshSpringTables(const ClothModel& cloth, std::size_t lanes) {
    const std::size_t slots = cloth.layout.slot_count();
    const Lists<Neighbour<Real>> lists = neighbour_lists<Real>(cloth);
    neighbours.starts = starts_of(lists, spring_kind_count, slots, lanes);
    const std::size_t places = neighbours.starts.back() * lanes;
    neighbours.items = LineAligned<std::uint32_t>(places);
    tensions = LineAligned<Real>(places);
    const bool weighted = std::any_of(lists.items.begin(), lists.items.end(),
                                      [](const auto& item) { return item.width != Real{1}; });
    if (weighted) widths = LineAligned<Real>(places);
    for_each_place(lists, spring_kind_count, slots, lanes, neighbours.starts,
                   [&](std::size_t place, std::size_t slot, const Neighbour<Real>* item) {
                       // A spring from a particle to itself has no force.
                       neighbours.items[place] =
                           item != nullptr ? item->slot : static_cast<std::uint32_t>(slot);
                       if (item == nullptr) return;
                       tensions[place] = item->tension;
                       if (weighted) widths[place] = item->width;
                   });
}

MeshTriangleTables::MeshTriangleTables(const ClothModel& cloth, std::size_t lanes) {
    const std::vector<std::array<std::uint32_t, 3>> sorted = sorted_triangles(cloth);
    const std::size_t padded = (sorted.size() + lanes - 1) / lanes * lanes;
    corners = LineAligned<std::uint32_t>(3 * padded);
    const std::size_t slots = cloth.layout.slot_count();
    Lists<std::uint32_t> lists(slots);
    for (const auto& triangle : sorted) {
        for (const std::uint32_t s : triangle) lists.count_one(s);
    }
    lists.begin_filling();
    for (std::size_t t = 0; t < padded; ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const bool real = t < sorted.size();
            const std::uint32_t slot = real ? sorted[t][k] : sorted.back()[0];
            corners[(t / lanes * 3 + k) * lanes + t % lanes] = slot;
            if (real) lists.add(slot, static_cast<std::uint32_t>(t));
        }
    }
    lists.end_filling();
    triangles.starts = starts_of(lists, 1, slots, lanes);
    triangles.items = LineAligned<std::uint32_t>(triangles.starts.back() * lanes);
    for_each_place(lists, 1, slots, lanes, triangles.starts,
                   [&](std::size_t place, std::size_t, const std::uint32_t* item) {
                       triangles.items[place] = item != nullptr ? *item : none;
                   });
}

template struct MeshSpringTables<float>;
template struct MeshSpringTables<double>;

}  // namespace weft
