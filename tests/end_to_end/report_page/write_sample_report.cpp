// Writes reports of made-up numbers for the browser to open:
//     write_sample_report DIRECTORY
// DIRECTORY/one is of one scene, DIRECTORY/two compares two.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "lab/report/report.h"
#include "support/sample_report.h"

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::fprintf(stderr, "usage: write_sample_report DIRECTORY\n");
        return 2;
    }
    const std::filesystem::path directory = arguments[1];
    try {
        const auto one = directory / "one", two = directory / "two";
        weft::lab::ReportHead head = weft::test::sample_head();
        weft::lab::write_report(one, head,
                                {{"sheet", weft::test::sample_sections(one / "energy", 1.0)}});
        head.title = "Sheet beside flag";
        head.scene = "sheet, flag";
        head.quick = false;
        weft::lab::write_report(
            two, head,
            {{"sheet", weft::test::sample_sections(two / "sheet" / "energy", 1.0)},
             {"flag & <mast>", weft::test::sample_sections(two / "flag" / "energy", 0.8)}});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
