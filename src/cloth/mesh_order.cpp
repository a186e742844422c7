#include "cloth/mesh_order.h"

#include <algorithm>

namespace weft {

namespace {

// Who is joined to whom.
class Neighbours {
public:
    Neighbours(std::size_t particle_count, std::span<const Spring> springs)
        : first_(particle_count + 1, 0), neighbours_(2 * springs.size()) {
        for (const Spring& spring : springs) {
            ++first_[spring.p + 1];
            ++first_[spring.q + 1];
        }
        for (std::size_t p = 0; p < particle_count; ++p) first_[p + 1] += first_[p];
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (const Spring& spring : springs) {
            neighbours_[next[spring.p]++] = spring.q;
            neighbours_[next[spring.q]++] = spring.p;
        }
    }

    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t p) const {
        return {neighbours_.data() + first_[p], neighbours_.data() + first_[p + 1]};
    }
    [[nodiscard]] bool before(std::uint32_t p, std::uint32_t q) const {
        const std::uint32_t springs_p = first_[p + 1] - first_[p];
        const std::uint32_t springs_q = first_[q + 1] - first_[q];
        return springs_p != springs_q ? springs_p < springs_q : p < q;
    }

private:
    std::vector<std::uint32_t> first_, neighbours_;
};

// Particles in the order in which breadth-first searches reach them.
class Search {
public:
    explicit Search(const Neighbours& neighbours, std::size_t particle_count)
        : neighbours_(neighbours), reached_(particle_count, false) {
        order_.reserve(particle_count);
    }

    [[nodiscard]] bool reached(std::uint32_t p) const { return reached_[p]; }
    [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

    // Reaches all that hangs together with `start`; returns the last, one of the farthest.
    std::uint32_t from(std::uint32_t start) {
        std::size_t next = order_.size();
        reach(start);
        while (next < order_.size()) {
            const std::size_t first = order_.size();
            for (const std::uint32_t q : neighbours_.of(order_[next++])) {
                if (!reached_[q]) reach(q);
            }
            std::sort(order_.begin() + static_cast<std::ptrdiff_t>(first), order_.end(),
                      [&](std::uint32_t p, std::uint32_t q) { return neighbours_.before(p, q); });
        }
        return order_.back();
    }

    // Forgets the last search, which reached all after the first `count`.
    void back_to(std::size_t count) {
        for (std::size_t n = count; n < order_.size(); ++n) reached_[order_[n]] = false;
        order_.resize(count);
    }

private:
    void reach(std::uint32_t p) {
        reached_[p] = true;
        order_.push_back(p);
    }

    const Neighbours& neighbours_;
    std::vector<char> reached_;
    std::vector<std::uint32_t> order_;
};

}  // namespace

std::vector<std::uint32_t> mesh_order(std::size_t particle_count, std::span<const Spring> springs) {
    const Neighbours neighbours(particle_count, springs);
    Search search(neighbours, particle_count);
    for (std::uint32_t p = 0; p < particle_count; ++p) {
        if (search.reached(p)) continue;
        const std::size_t before = search.order().size();
        const std::uint32_t far = search.from(p);  // anywhere; from its end, rings are narrow
        search.back_to(before);
        search.from(far);
    }
    std::vector<std::uint32_t> slots(particle_count);
    auto slot = static_cast<std::uint32_t>(particle_count);
    for (const std::uint32_t p : search.order()) slots[p] = --slot;
    return slots;
}

}  // namespace weft
