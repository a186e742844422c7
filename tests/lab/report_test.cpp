#include "lab/report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "lab/report/html_text.h"
#include "lab/report/report_files.h"
#include "lab/report/report_findings.h"
#include "lab/report/report_layout.h"
#include "support/sample_report.h"
#include "weft/error.h"

namespace weft::lab {
namespace {

namespace fs = std::filesystem;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// A section of one plot and one table.
std::vector<Section> short_sections() {
    std::vector<Section> sections = test::sample_sections({}, 1.0);
    sections.resize(1);
    sections[0].blocks = {test::sample_table(), test::sample_without_points()};
    return sections;
}

class ReportTest : public testing::Test {
protected:
    ReportTest() {
        std::string name = testing::TempDir() + "weft-report-XXXXXX";
        place_ = mkdtemp(name.data());
    }
    ~ReportTest() override { fs::remove_all(place_); }

    // Names of all files, hidden ones too, relative and sorted.
    [[nodiscard]] std::set<std::string> listing() const {
        std::set<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(place_)) {
            if (entry.is_regular_file()) names.insert(relative(entry.path(), place_).string());
        }
        return names;
    }

    fs::path place_;
};

TEST(HtmlText, NothingOfTheTextIsMarkup) {
    EXPECT_EQ(html("<a href=\"x\">&'\x01\x7f\n"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;\n");
    EXPECT_EQ(html_with_code("a `b<` c `d"), "a <code>b&lt;</code> c `d");
    EXPECT_EQ(html("Δt"), "Δt");
}

TEST(HtmlText, NumbersAreReadAsNumbers) {
    EXPECT_EQ(html_number(0.0123456, 4), "0.01235");
    EXPECT_EQ(html_number(-1.5, 4), "&minus;1.5");
    EXPECT_EQ(html_number(2.0, 3), "2");
    EXPECT_EQ(html_number(2.0001, 3), "2.00");
    EXPECT_EQ(html_number(12.3, 2), "12");
    EXPECT_EQ(html_number(0.016, 4), "0.016");
    EXPECT_EQ(html_number(1.2004e-7, 3), "1.20&times;10<sup>&minus;7</sup>");
    EXPECT_EQ(html_number(3.1e-7, 1), "3&times;10<sup>&minus;7</sup>");
    EXPECT_EQ(html_number(250000.0, 4), "250000");
    EXPECT_EQ(html_number(12345.678, 4), "12346");
    EXPECT_EQ(html_number(9999.7, 4), "10000");
    EXPECT_EQ(html_number(1.2e-7, 3), "1.2&times;10<sup>&minus;7</sup>");
    EXPECT_EQ(html_number(-3e20, 2), "&minus;3&times;10<sup>20</sup>");
    EXPECT_EQ(html_number(1.0 / 3.0, 2), "0.33");
    EXPECT_EQ(html_number(-0.0, 3), "0");
    EXPECT_EQ(html_number(infinity, 4), "&infin;");
    EXPECT_EQ(html_number(-infinity, 4), "&minus;&infin;");
    EXPECT_EQ(html_number(std::nan(""), 4), "not a number");
}

TEST(HtmlText, ExactNumbersReadBackAsTheSame) {
    for (const double value : {0.1, 1.0 / 3.0, 1e300, 5e-324, -2.5, 123456789.125}) {
        EXPECT_EQ(std::strtod(exact_number(value).c_str(), nullptr), value);
    }
    EXPECT_EQ(exact_number(0.1), "0.1");
    EXPECT_EQ(exact_number(infinity), "inf");
    EXPECT_EQ(exact_number(-std::nan("")), "nan");
}

TEST(HtmlText, DataIsWrittenInBase64) {
    const auto uri = [](std::string_view text) {
        Bytes bytes;
        for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
        return data_uri("a/b", bytes);
    };
    EXPECT_EQ(uri(""), "data:a/b;base64,");
    EXPECT_EQ(uri("f"), "data:a/b;base64,Zg==");
    EXPECT_EQ(uri("fo"), "data:a/b;base64,Zm8=");
    EXPECT_EQ(uri("foobar"), "data:a/b;base64,Zm9vYmFy");
    EXPECT_EQ(uri("\xff\xfe\xfd"), "data:a/b;base64,//79");
}

TEST(ReportFiles, CsvQuotesWhatItMustAndKeepsEveryDigit) {
    const Plot plot{
        .id = "p",
        .title = "",
        .x_label = "step [s]",
        .y_label = "error, \"rms\" [m]",
        .series = {{"a,b", {{0.1, 1.0 / 3.0}, {2.0, infinity}}}, {"", {{-1.0, std::nan("")}}}},
        .text = ""};
    EXPECT_EQ(plot_csv(plot),
              "series,step [s],\"error, \"\"rms\"\" [m]\"\r\n\"a,b\",0.1,0.3333333333333333\r\n"
              "\"a,b\",2,inf\r\n,-1,nan\r\n");
    const Table table{.id = "t",
                      .caption = "",
                      .columns = {{"method"}, {"limit [s]"}, {"note"}},
                      .rows = {{"rk4", 1e-7, {}}, {"two\nlines", {}, "say \"no\""}}};
    EXPECT_EQ(table_csv(table),
              "method,limit [s],note\r\nrk4,1e-07,\r\n\"two\nlines\",,\"say \"\"no\"\"\"\r\n");
}

TEST(ReportFiles, NamesOfFilesAreMadeOfPlainLetters) {
    EXPECT_EQ(file_name("work-precision"), "work-precision");
    EXPECT_EQ(file_name("../a b/ü"), "-..-a-b---");
    EXPECT_EQ(file_name(""), "-");
}

TEST(ReportFiles, TheSameIdTwiceNamesTwoFiles) {
    Section section{.experiment = "order",
                    .title = {},
                    .question = {},
                    .method = {},
                    .blocks = {test::sample_table(), test::sample_table(), Paragraph{"text"},
                               test::sample_region()},
                    .answer = {},
                    .command = {},
                    .skipped = {},
                    .findings = {}};
    const std::vector<SceneSections> scenes{{"a", {section}}, {"a", {section}}};
    const auto experiments = place_report("/nowhere", scenes);
    ASSERT_EQ(experiments.size(), 1u);
    ASSERT_EQ(experiments[0].sections.size(), 2u);
    const auto& blocks = experiments[0].sections[0].blocks;
    EXPECT_EQ(blocks[0].files, "a/order/limits");
    EXPECT_EQ(blocks[1].files, "a/order/limits-2");
    EXPECT_EQ(blocks[0].number, 1);
    EXPECT_EQ(blocks[1].number, 2);
    EXPECT_EQ(blocks[3].number, 1) << "figures are counted by themselves";
    EXPECT_EQ(experiments[0].sections[1].blocks[0].files, "a-2/order/limits");
    EXPECT_EQ(experiments[0].sections[1].blocks[0].number, 3);
    EXPECT_NE(blocks[0].anchor, blocks[1].anchor);
}

TEST(ReportFindings, TwoScenesStandSideBySideWithTheirRatio) {
    auto first = test::sample_sections({}, 2.0), second = test::sample_sections({}, 3.0);
    second[0].findings.push_back({"only here", 7.0, "m"});
    const std::vector<SceneSections> scenes{{"a", first}, {"b", second}};
    const Table table = findings_table(place_report("/nowhere", scenes), {"a", "b"});
    ASSERT_EQ(table.columns.size(), 6u);
    EXPECT_EQ(table.columns[5].name, "ratio b : a");
    ASSERT_EQ(table.rows.size(), 4u);
    EXPECT_EQ(table.rows[1],
              (std::vector<Cell>{"Order of accuracy", "fastest", "s", 2.0, 3.0, 1.5}));
    EXPECT_EQ(table.rows[2],
              (std::vector<Cell>{"Order of accuracy", "only here", "m", {}, 7.0, {}}));
    EXPECT_EQ(table.rows[3][5], Cell{}) << "infinity : infinity is nothing";
}

TEST_F(ReportTest, WritesThePageTheNumbersAndThePictures) {
    const auto files =
        write_report(place_, test::sample_head(), {{"sheet", test::sample_sections({}, 1.0)}});
    const std::set<std::string> expected{
        "report.html",       "lab.json",          "findings.csv",      "order/errors.csv",
        "order/errors.svg",  "order/errors.png",  "order/limits.csv",  "order/nothing.csv",
        "order/nothing.svg", "order/nothing.png", "energy/energy.csv", "energy/energy.svg",
        "energy/energy.png", "energy/region.csv", "energy/region.svg", "energy/region.png"};
    EXPECT_EQ(listing(), expected);
    EXPECT_EQ(files.size(), expected.size());
    EXPECT_EQ(files.back(), place_ / "report.html");
    const std::string page = read(place_ / "report.html");
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_NE(page.find("Made with <code>--quick</code>"), std::string::npos);
    EXPECT_NE(page.find("<b>Skipped.</b> There is no OpenGL on this machine."), std::string::npos);
    EXPECT_NE(page.find("weft lab order &quot;a &lt;b&gt; &amp; &#39;c&#39;.toml&quot;"),
              std::string::npos);
    EXPECT_EQ(page.find("http://"), page.find("http://www.w3.org"));
    EXPECT_EQ(page.find("https://"), std::string::npos);
}

TEST_F(ReportTest, JsonHoldsEveryNumberAndNothingThatIsNoJson) {
    write_report(place_, test::sample_head(), {{"sheet", test::sample_sections({}, 1.0)}});
    const auto json = nlohmann::json::parse(read(place_ / "lab.json"));
    EXPECT_EQ(json["scene"], "sheet");
    EXPECT_EQ(json["quick"], true);
    EXPECT_EQ(json["facts"].size(), 3u);
    ASSERT_EQ(json["sections"].size(), 3u);
    const auto& order = json["sections"][0];
    EXPECT_EQ(order["findings"][0],
              (nlohmann::json{{"name", "order of rk4"}, {"value", 4.0}, {"unit", ""}}));
    EXPECT_EQ(order["skipped"], nullptr);
    const auto& series = order["blocks"][1]["series"];
    EXPECT_EQ(series[7]["name"], "rk4");
    EXPECT_EQ(series[7]["points"][0][0], 0.01);
    EXPECT_EQ(series[5]["points"][2][1], 0.0) << "left out of the drawing, not of the numbers";
    EXPECT_EQ(series[5]["points"][3][1], nullptr);
    const auto& rows = order["blocks"][2]["rows"];
    EXPECT_EQ(rows[0][1], 0.0123456789);
    EXPECT_EQ(rows[1][2], nullptr);
    EXPECT_EQ(rows[2][2], "inf");
    EXPECT_EQ(rows[4][2], "nan");
    EXPECT_EQ(json["sections"][1]["findings"][0]["value"], nullptr);
    EXPECT_EQ(json["sections"][2]["skipped"], "There is no OpenGL on this machine.");
}

TEST_F(ReportTest, PicturesAndVideosAreInThePage) {
    auto sections = short_sections();
    const fs::path media = place_ / "order";
    test::write_sample_png(media / "small.png", 160, 120);
    std::ofstream(media / "film.mp4") << "not looked into";
    sections[0].blocks.push_back(Media{"small", media / "small.png", "A picture", "Blue & green."});
    sections[0].blocks.push_back(Media{"film", media / "film.mp4", "A film", "Moving."});
    write_report(place_, test::sample_head(), {{"sheet", sections}});
    const std::string page = read(place_ / "report.html");
    EXPECT_NE(page.find("<img src=\"data:image/png;base64,iVBORw0KGgo"), std::string::npos);
    EXPECT_NE(page.find("alt=\"Blue &amp; green.\" width=\"160\" height=\"120\">"),
              std::string::npos);
    EXPECT_NE(page.find("src=\"data:video/mp4;base64,bm90IGxvb2tlZCBpbnRv\""), std::string::npos);
    EXPECT_NE(page.find("<a href=\"order/film.mp4\">"), std::string::npos);
    const auto json = nlohmann::json::parse(read(place_ / "lab.json"));
    EXPECT_EQ(json["sections"][0]["blocks"][2]["file"], "order/small.png");
}

TEST_F(ReportTest, AReportThatCannotBeFinishedLeavesTheOldOneAsItWas) {
    auto sections = short_sections();
    write_report(place_, test::sample_head(), {{"sheet", sections}});
    const std::set<std::string> before = listing();
    const std::string page = read(place_ / "report.html"), json = read(place_ / "lab.json");
    auto changed = sections;
    changed[0].answer = "Another answer.";
    for (const char* name : {"missing.png", "table.xls"}) {
        if (std::string(name) == "table.xls") std::ofstream(place_ / name) << "x";
        auto broken = changed;
        broken[0].blocks.push_back(Media{"m", place_ / name, "", ""});
        try {
            write_report(place_, test::sample_head(), {{"sheet", broken}});
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::file);
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        }
        fs::remove(place_ / name);
        EXPECT_EQ(listing(), before);
        EXPECT_EQ(read(place_ / "report.html"), page);
        EXPECT_EQ(read(place_ / "lab.json"), json);
    }
    write_report(place_, test::sample_head(), {{"sheet", changed}});
    EXPECT_EQ(listing(), before);
    EXPECT_NE(read(place_ / "report.html").find("Another answer."), std::string::npos);
}

TEST_F(ReportTest, ADirectoryThatCannotBeMadeIsNamed) {
    std::ofstream(place_ / "file") << "x";
    try {
        write_report(place_ / "file" / "report", test::sample_head(), {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_NE(std::string(error.what()).find("file/report"), std::string::npos) << error.what();
    }
}

TEST_F(ReportTest, TheSameSectionsGiveTheSameFiles) {
    const std::vector<SceneSections> scenes{{"a", test::sample_sections({}, 1.0)},
                                            {"b", test::sample_sections({}, 2.0)}};
    write_report(place_ / "1", test::sample_head(), scenes);
    write_report(place_ / "2", test::sample_head(), scenes);
    std::size_t files = 0;
    for (const std::string& name : listing()) {
        if (!name.starts_with("1/")) continue;
        EXPECT_EQ(read(place_ / name), read(place_ / "2" / name.substr(2))) << name;
        ++files;
    }
    EXPECT_EQ(files, 3u + 2u * 13u);
}

}  // namespace
}  // namespace weft::lab
