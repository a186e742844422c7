#include "cloth/spring_network.h"

namespace weft {

SpringNetwork spring_network(const ClothModel& cloth) {
    SpringNetwork network;
    cloth.for_each_spring_with_slots(
        [&](const Spring& spring, const SpringConstants& constants, std::size_t p, std::size_t q) {
            if (constants.stiffness == 0.0 && constants.damping == 0.0) return;
            network.springs.push_back({static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(q),
                                       spring.rest_length, constants.stiffness, constants.damping});
        });
    network.inverse_masses.assign(cloth.layout.slot_count(), 0.0);
    cloth.layout.for_each([&](std::size_t p, std::size_t slot) {
        network.inverse_masses[slot] = 1.0 / cloth.masses[p];
    });
    for (const Pin& pin : cloth.pins) network.inverse_masses[cloth.slot(pin.particle)] = 0.0;
    return network;
}

}  // namespace weft
