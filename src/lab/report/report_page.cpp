#include "lab/report/report_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "lab/report/html_text.h"
#include "lab/report/report_blocks.h"
#include "lab/report/report_findings.h"
#include "lab/report/report_style.h"
#include "weft/version.h"

namespace weft::lab {

namespace {

// What a page opened from anywhere may load: nothing but what is in it.
constexpr const char* policy =
    "default-src 'none'; img-src data:; media-src data:; style-src 'unsafe-inline'; "
    "script-src 'unsafe-inline'";

std::string page_head(const ReportHead& head) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<meta name=\"generator\" content=\"weft {}\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n<title>{}</title>\n"
        "<link rel=\"icon\" href=\"data:,\">\n<style>\n{}</style>\n</head>\n",
        WEFT_VERSION, policy, html(head.title), page_style());
}

std::string contents(std::span<const PlacedExperiment> experiments, bool comparison) {
    std::string text =
        "<nav id=\"contents\" aria-label=\"Contents\">\n<div>\n<p "
        "class=\"nav-title\">Contents</p>\n<ol>\n"
        "<li><a href=\"#summary\">The answers</a></li>\n";
    if (comparison) text += "<li><a href=\"#findings\">The numbers side by side</a></li>\n";
    for (const PlacedExperiment& experiment : experiments) {
        text += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", experiment.anchor,
                            html(experiment.sections.front().section->title));
    }
    return text + "</ol>\n</div>\n</nav>\n";
}

std::string banner(const ReportHead& head) {
    std::string text =
        fmt::format("<header id=\"top\">\n<p class=\"kicker\">weft laboratory</p>\n<h1>{}</h1>\n",
                    html(head.title));
    text += fmt::format("<p class=\"scene\">Scene: {}</p>\n", html(head.scene));
    if (head.quick) {
        text +=
            "<p class=\"quick\"><b>Made with <code>--quick</code>:</b> fewer and shorter runs. The "
            "numbers are rougher than those of a full study.</p>\n";
    }
    if (!head.facts.empty()) {
        text += "<ul class=\"facts\">\n";
        for (const std::string& fact : head.facts)
            text += "<li>" + html_with_code(fact) + "</li>\n";
        text += "</ul>\n";
    }
    return text + "</header>\n";
}

std::string command_html(const std::string& command) {
    if (command.empty()) return {};
    return "<p class=\"command-title\">Make it again:</p>\n<pre class=\"command\" "
           "tabindex=\"0\"><code>" +
           html(command) + "</code></pre>\n";
}

std::string short_answer(const Section& section) {
    if (!section.skipped.empty()) return "<em>Skipped.</em> " + html_with_code(section.skipped);
    return html_with_code(section.answer);
}

const PlacedSection* section_of(const PlacedExperiment& experiment, const std::string& scene) {
    const auto found = std::ranges::find(experiment.sections, scene, &PlacedSection::scene);
    return found == experiment.sections.end() ? nullptr : &*found;
}

// A row an experiment, a column a scene.
std::string summary(const ReportHead& head, std::span<const PlacedExperiment> experiments,
                    const std::vector<std::string>& scenes) {
    std::string text =
        "<section id=\"summary\" aria-labelledby=\"summary.heading\">\n<h2 "
        "id=\"summary.heading\">The "
        "answers</h2>\n<div class=\"scroll\" role=\"group\" tabindex=\"0\" "
        "aria-labelledby=\"summary.heading\">\n<table class=\"summary\">\n<thead>\n<tr><th "
        "scope=\"col\">Experiment</th>";
    for (const std::string& scene : scenes) {
        text +=
            fmt::format("<th scope=\"col\">{}</th>", scenes.size() == 1 ? "Answer" : html(scene));
    }
    text += "</tr>\n</thead>\n<tbody>\n";
    for (const PlacedExperiment& experiment : experiments) {
        text += fmt::format("<tr><th scope=\"row\"><a href=\"#{}\">{}</a></th>", experiment.anchor,
                            html(experiment.sections.front().section->title));
        for (const std::string& scene : scenes) {
            const PlacedSection* placed = section_of(experiment, scene);
            text += fmt::format("<td data-scene=\"{}\">{}</td>", html(scene),
                                placed == nullptr ? "" : short_answer(*placed->section));
        }
        text += "</tr>\n";
    }
    return text + "</tbody>\n</table>\n</div>\n" + command_html(head.command) + "</section>\n";
}

std::string findings(std::span<const PlacedExperiment> experiments,
                     const std::vector<std::string>& scenes) {
    return "<section id=\"findings\" aria-labelledby=\"findings.heading\">\n<h2 "
           "id=\"findings.heading\">The numbers side by side</h2>\n" +
           table_html(findings_table(experiments, scenes), "findings.table", 0) + "</section>\n";
}

// What an experiment did and found on one scene.
std::string measured(const PlacedSection& placed, const std::filesystem::path& directory,
                     bool with_method) {
    const Section& section = *placed.section;
    if (!section.skipped.empty()) {
        return "<p class=\"skipped\"><b>Skipped.</b> " + html_with_code(section.skipped) +
               "</p>\n" + command_html(section.command);
    }
    std::string text;
    if (with_method && !section.method.empty()) {
        text += "<div class=\"method\">\n" + paragraphs_html(section.method) + "</div>\n";
    }
    for (const PlacedBlock& block : placed.blocks) text += block_html(block, directory);
    text += "<p class=\"answer\"><b>Answer.</b> " + html_with_code(section.answer) + "</p>\n";
    return text + command_html(section.command);
}

std::string experiment_html(const PlacedExperiment& experiment,
                            const std::filesystem::path& directory, bool comparison) {
    const Section& first = *experiment.sections.front().section;
    std::string text = fmt::format(
        "<section id=\"{0}\" class=\"experiment\" aria-labelledby=\"{0}.heading\">\n<h2 "
        "id=\"{0}.heading\">{1}</h2>\n<p class=\"question\">{2}</p>\n",
        experiment.anchor, html(first.title), html_with_code(first.question));
    if (!comparison) {
        return text + measured(experiment.sections.front(), directory, true) + "</section>\n";
    }
    const bool same_method =
        std::ranges::all_of(experiment.sections, [&](const PlacedSection& placed) {
            return placed.section->skipped.empty() && placed.section->method == first.method;
        });
    if (same_method) {
        text += "<div class=\"method\">\n" + paragraphs_html(first.method) + "</div>\n";
    }
    text += "<div class=\"beside\">\n";
    for (const PlacedSection& placed : experiment.sections) {
        text += fmt::format(
            "<section id=\"{0}\" aria-labelledby=\"{1}.heading {0}.heading\">\n<h3 "
            "id=\"{0}.heading\">{2}</h3>\n",
            placed.anchor, experiment.anchor, html(placed.scene));
        text += measured(placed, directory, !same_method) + "</section>\n";
    }
    return text + "</div>\n</section>\n";
}

}  // namespace

std::string report_page(const std::filesystem::path& directory, const ReportHead& head,
                        std::span<const PlacedExperiment> experiments,
                        const std::vector<std::string>& scenes) {
    const bool comparison = scenes.size() > 1;
    std::string text = page_head(head);
    text += fmt::format("<body{}>\n<a class=\"skip\" href=\"#summary\">Skip to the answers</a>\n",
                        comparison ? " class=\"comparison\"" : "");
    text += contents(experiments, comparison);
    text += "<main>\n" + banner(head) + summary(head, experiments, scenes);
    if (comparison) text += findings(experiments, scenes);
    for (const PlacedExperiment& experiment : experiments) {
        text += experiment_html(experiment, directory, comparison);
    }
    text +=
        "<footer><p>All numbers: <a href=\"lab.json\">lab.json</a>, <a "
        "href=\"findings.csv\">findings.csv</a>. Written by weft " WEFT_VERSION
        ".</p></footer>\n</main>\n<script>\n";
    return text + std::string(page_script()) + "</script>\n</body>\n</html>\n";
}

}  // namespace weft::lab
