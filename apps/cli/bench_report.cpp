#include "cli/bench_report.h"

#include <fmt/format.h>

namespace weft {

namespace {

using Json = nlohmann::ordered_json;

std::string number(const std::optional<double>& value, int decimals) {
    return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

Json json_of(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json json_of(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

const char* precision_name(Precision precision) {
    return precision == Precision::f32 ? "single" : "double";
}

}  // namespace

std::string machine_text(const bench::Machine& machine) {
    std::string text = fmt::format(
        "{}, hardware threads: {}; kernels: {}; built with {}\n"
        "one thread: multiply-adds {:.0f} GFLOP/s single, {:.0f} double; update bandwidth",
        machine.processor, machine.threads, machine.instruction_set, machine.compiler,
        machine.peak_single, machine.peak_double);
    for (const bench::Machine::Bandwidth& bandwidth : machine.bandwidths) {
        text += fmt::format("{} {:.0f} GB/s {}", &bandwidth == machine.bandwidths.data() ? "" : ",",
                            bandwidth.gb_per_s, bandwidth.where);
    }
    return text + "\n";
}

std::string bench_table_head() {
    return fmt::format("{:<32} {:>9} {:<6} {:>3} {:>12} {:>8} {:>8} {:>8}\n", "", "columns", "pre-",
                       "thr", "ns/particle", "ratio to", "", "fraction") +
           fmt::format("{:<32} {:>9} {:<6} {:>3} {:>12} {:>8} {:>8} {:>8}\n", "case", "x rows",
                       "cision", "ds", "-step", "textbook", "GFLOP/s", "of peak");
}

std::string bench_table_line(const bench::Row& row) {
    const bench::Label& label = row.label;
    std::string line = fmt::format("{:<32} {:>9} {:<6} {:>3} ", label.name,
                                   fmt::format("{}x{}", label.columns, label.rows),
                                   precision_name(label.precision), label.threads);
    if (!row.note.empty()) return line + row.note + "\n";
    line += fmt::format("{:>12} {:>8} {:>8} {:>8}", number(row.ns_per_particle_step, 2),
                        number(row.ratio_to_textbook, 2), number(row.gflops, 1),
                        number(row.fraction_of_peak, 3));
    if (row.ms_per_frame) line += fmt::format("  {:.3f} ms a frame", *row.ms_per_frame);
    if (row.sag) line += fmt::format(", sag {:.4f} m", *row.sag);
    return line + "\n";
}

nlohmann::ordered_json label_json(const bench::Label& label) {
    return {{"case", label.name},
            {"columns", label.columns},
            {"rows", label.rows},
            {"precision", precision_name(label.precision)},
            {"threads", label.threads}};
}

nlohmann::ordered_json row_json(const bench::Row& row) {
    Json json = label_json(row.label);
    json["ns_per_particle_step"] = json_of(row.ns_per_particle_step);
    json["ratio_to_textbook"] = json_of(row.ratio_to_textbook);
    json["gflops"] = json_of(row.gflops);
    json["fraction_of_peak"] = json_of(row.fraction_of_peak);
    json["ms_per_frame"] = json_of(row.ms_per_frame);
    json["sag"] = json_of(row.sag);
    json["note"] = json_of(row.note);
    return json;
}

nlohmann::ordered_json machine_json(const bench::Machine& machine) {
    Json bandwidths = Json::array();
    for (const bench::Machine::Bandwidth& bandwidth : machine.bandwidths) {
        bandwidths.push_back({{"where", bandwidth.where},
                              {"bytes", bandwidth.bytes},
                              {"gb_per_s", bandwidth.gb_per_s}});
    }
    return {{"processor", machine.processor},
            {"hardware_threads", machine.threads},
            {"instruction_set", machine.instruction_set},
            {"compiler", machine.compiler},
            {"peak_gflops", {{"single", machine.peak_single}, {"double", machine.peak_double}}},
            {"update_bandwidth", bandwidths},
            {"peers", {{"boost", json_of(machine.boost)}, {"bullet", json_of(machine.bullet)}}}};
}

}  // namespace weft
