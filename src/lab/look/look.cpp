// The experiment on looks: film strips, a video, and how far apart the pictures are in numbers.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "lab/experiment.h"
#include "lab/look/look_show.h"
#include "weft/error.h"

namespace weft::lab {

namespace {

constexpr std::array<int, 2> strip_tile{240, 180}, small_strip_tile{200, 150}, video_tile{248, 164},
    small_video_tile{248, 140};

std::string sentence(const Flown& flown) {
    std::size_t failed = 0;
    double near = std::numeric_limits<double>::infinity(), far = -1.0;
    std::string nearest, farthest;
    for (std::size_t n = 0; n < flown.flights.size(); ++n) {
        if (flown.flights[n].failed) ++failed;
        const double distance = flown.last_distance(n);
        if (distance < near) {
            near = distance;
            nearest = flown.set.flights[n].plan.method;
        }
        if (distance > far) {
            far = distance;
            farthest = flown.set.flights[n].plan.method;
        }
    }
    std::string text =
        fmt::format("After {:.3g} s of {} {} of {} methods still show a cloth", flown.set.end(),
                    flown.set.name, flown.flights.size() - failed, flown.flights.size());
    if (nearest.empty()) return text;
    return text + fmt::format(
                      "; {} is nearest to the reference (rms {:.2g} m) and {} farthest "
                      "({:.2g} m)",
                      nearest, near, farthest, far);
}

std::string flag_sentence(const Flown& flag) {
    const LookFlight &same = flag.flights[0], &own = flag.flights[1], &verlet = flag.flights[2];
    std::string text = same.failed ? fmt::format(
                                         "on the flag Forward Euler at Verlet's step fails after "
                                         "{:.2g} s",
                                         *same.failed)
                                   : "on the flag Forward Euler holds at Verlet's step";
    if (own.failed || verlet.failed) return text;
    return text + fmt::format(
                      ", and at its own step its wrinkles are {:.3g} degrees beside "
                      "Verlet's {:.3g}",
                      own.wrinkles.back(), verlet.wrinkles.back());
}

std::string sheet_sentence(const Flown& sheet) {
    std::string text;
    for (std::size_t n = 0; n < 3; ++n) {
        const LookFlight& flight = sheet.flights[n];
        text += fmt::format("{}{} {}", n == 0 ? "on the comparison's sheet " : ", ",
                            sheet.set.flights[n].plan.method,
                            flight.failed ? fmt::format("fails after {:.2g} s", *flight.failed)
                                          : fmt::format("ends with {:.3g} degrees of wrinkles",
                                                        flight.wrinkles.back()));
    }
    return text + fmt::format(" (exact: {:.3g})", sheet.reference->wrinkles.back());
}

const char* const method_text =
    "Each method flies the same cloth from the same start, and pictures are taken at the same "
    "times "
    "by the same camera. On the scene explicit methods take half their automatic step, as cloth "
    "that "
    "stretches becomes stiffer; implicit ones and those by springs take the step that is automatic "
    "for them. Beside the look stand two measures: how far the particles are from those of a "
    "reference, the fourth-order Runge-Kutta method with much shorter steps, and how wrinkled the "
    "cloth is. Implicit methods solve their systems to a millionth of the cloth's size. Motion of "
    "cloth is sensitive: from some time on distances say only that two "
    "motions are different, not which is better; wrinkles can still be compared. The papers' own "
    "scenes follow: the flag of the first (its figures 2.1 and 2.2) and the sheet of the "
    "comparison (figures 3, 4 and 5), there with the step of 16 ms that its table 1 implies.";

void tell(Section& section, const Flown& flown, const Laboratory& laboratory) {
    if (!flown.set.cut.empty()) section.blocks.emplace_back(Paragraph{flown.set.cut});
    const bool many = flown.flights.size() > 8;
    section.blocks.emplace_back(
        film_strip(flown, many ? small_strip_tile : strip_tile, laboratory));
    section.blocks.emplace_back(distance_plot(flown));
    section.blocks.emplace_back(wrinkle_plot(flown));
    section.blocks.emplace_back(flight_table(flown));
}

void tell_video(Section& section, const Flown& flown, const Laboratory& laboratory) {
    try {
        section.blocks.emplace_back(
            flight_video(flown, laboratory.quick() ? small_video_tile : video_tile, laboratory));
    } catch (const Error& error) {
        section.blocks.emplace_back(
            Paragraph{fmt::format("There is no video of all methods: {}.", error.what())});
    }
}

}  // namespace

Section measure_look(Laboratory& laboratory) {
    Section section;
    section.method = method_text;
    section.skipped = why_no_pictures();
    if (!section.skipped.empty()) return section;
    const bool quick = laboratory.quick();
    const std::vector<Flown> all = fly_all(
        laboratory, {own_look(laboratory.scene(), laboratory.methods(), quick), flag_look(quick),
                     sheet_look(), video_look(laboratory.methods(), quick)});
    tell(section, all[0], laboratory);
    tell_video(section, all[3], laboratory);
    tell(section, all[1], laboratory);
    tell(section, all[2], laboratory);
    for (std::size_t n = 0; n < all[0].flights.size(); ++n) {
        const double distance = all[0].last_distance(n);
        if (std::isnan(distance)) continue;
        section.findings.push_back(
            {fmt::format("distance of {} from the reference", all[0].set.flights[n].plan.method),
             distance, "m"});
    }
    section.answer =
        sentence(all[0]) + "; " + flag_sentence(all[1]) + "; " + sheet_sentence(all[2]) + ".";
    return section;
}

}  // namespace weft::lab
