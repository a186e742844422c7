#include "lab/look/look_show.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/output_file.h"
#include "io/video_encoder.h"
#include "weft/integrators.h"

namespace weft::lab {

std::vector<StripRow> Flown::rows() const {
    std::vector<StripRow> rows;
    for (std::size_t n = 0; n < flights.size(); ++n) {
        rows.push_back({set.flights[n].title, &flights[n]});
    }
    return rows;
}

double Flown::distance(std::size_t flight, std::size_t shape) const {
    if (!reference || !set.flights[flight].compared || shape >= reference->shapes.size() ||
        shape >= flights[flight].shapes.size()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return rms_distance(flights[flight].shapes[shape], reference->shapes[shape]);
}

std::vector<Flown> fly_all(Laboratory& laboratory, std::vector<LookSet> sets) {
    std::vector<Trial> trials;
    for (const LookSet& set : sets) {
        for (const LookSpec& spec : set.flights) trials.push_back(look_trial(spec));
        if (set.reference) trials.push_back(look_trial(*set.reference));
    }
    // Trials of the same name are one: a reference that is shown as well.
    std::vector<Trial> single;
    for (const Trial& trial : trials) {
        if (std::ranges::find(single, trial.name, &Trial::name) == single.end()) {
            single.push_back(trial);
        }
    }
    const std::vector<nlohmann::json> results = laboratory.run(single);
    const auto result_of = [&](const LookSpec& spec) {
        const std::string name = look_trial(spec).name;
        const auto place = std::ranges::find(single, name, &Trial::name) - single.begin();
        return look_flight_from_json(results[static_cast<std::size_t>(place)]);
    };
    std::vector<Flown> all;
    for (LookSet& set : sets) {
        Flown flown{std::move(set), {}, {}};
        for (const LookSpec& spec : flown.set.flights) flown.flights.push_back(result_of(spec));
        if (flown.set.reference) flown.reference = result_of(*flown.set.reference);
        all.push_back(std::move(flown));
    }
    return all;
}

namespace {

std::string failures_of(const Flown& flown) {
    std::string text;
    for (std::size_t n = 0; n < flown.flights.size(); ++n) {
        if (!flown.flights[n].failed) continue;
        text += fmt::format("{}{} ended at {:.3g} s", text.empty() ? "" : "; ",
                            flown.set.flights[n].title, *flown.flights[n].failed);
    }
    return text.empty() ? "None failed." : text + ".";
}

/// The cloth of a set, and how its tiles are drawn.
class Studio {
public:
    Studio(const Flown& flown, std::array<int, 2> tile)
        : flown_(flown),
          rows_(flown.rows()),
          cloth_(build_cloth(flown.set.flights.front().scene)),
          start_(flown.flights.front().shapes.front()),
          render_(camera(tile)),
          painter_(cloth_.surface, render_, start_) {}

    Media strip(const Laboratory& laboratory) {
        const Image image =
            paint_strip(painter_, rows_, flown_.set.columns, [&] { laboratory.check_interrupt(); });
        Media media;
        media.id = flown_.set.id + "-strip";
        media.file = laboratory.media_directory() / (media.id + ".png");
        OutputFile file(media.file);
        const std::vector<std::uint8_t> png = encode_png(image);
        file.write(std::as_bytes(std::span(png)));
        file.commit();
        std::string times;
        for (const StripColumn& column : flown_.set.columns) {
            times += (times.empty() ? "" : ", ") + column.title;
        }
        media.caption = fmt::format(
            "Pictures of {}, a flight a row, at {}, all by one camera. Where a flight "
            "failed, the last picture that was a cloth stands in a red frame.",
            flown_.set.name, times);
        media.text = fmt::format("Film strip of {} flights of {}. {}", rows_.size(),
                                 flown_.set.name, failures_of(flown_));
        return media;
    }

    Media video(const Laboratory& laboratory) {
        const TileGrid grid(painter_.width(), painter_.height(), rows_.size());
        Media media;
        media.id = flown_.set.id;
        media.file = laboratory.media_directory() / (media.id + ".mp4");
        VideoEncoder encoder(media.file, "mp4", {grid.width(), grid.height()},
                             1.0 / flown_.set.frame_length);
        for (std::size_t n = 0; n < flown_.set.frames.size(); ++n) {
            encoder.write(grid.paint(painter_, rows_, n, [&] { laboratory.check_interrupt(); }));
        }
        encoder.commit();
        const auto& size = flown_.set.flights.front().scene.cloth.grid.resolution;
        media.caption = fmt::format(
            "Every method flies {} of {} x {} particles in the same wind for {:.3g} s: explicit "
            "methods at their automatic step, others at steps of their own.",
            flown_.set.name, size[0], size[1], flown_.set.end());
        media.text = fmt::format("Video of {} flags side by side, each flown by another method. {}",
                                 rows_.size(), failures_of(flown_));
        return media;
    }

private:
    [[nodiscard]] RenderDescription camera(std::array<int, 2> tile) const {
        RenderDescription render = flown_.set.flights.front().scene.render;
        render.size = tile;
        return with_common_camera(cloth_.surface, render, start_, rows_);
    }

    const Flown& flown_;
    std::vector<StripRow> rows_;
    ClothModel cloth_;
    const Shape& start_;
    RenderDescription render_;
    TilePainter painter_;
};

}  // namespace

Media film_strip(const Flown& flown, std::array<int, 2> tile, const Laboratory& laboratory) {
    return Studio(flown, tile).strip(laboratory);
}

Media flight_video(const Flown& flown, std::array<int, 2> tile, const Laboratory& laboratory) {
    return Studio(flown, tile).video(laboratory);
}

}  // namespace weft::lab
