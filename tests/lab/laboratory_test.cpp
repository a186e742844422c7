// The laboratory keeps what is measured, gives results in order, and stops where it is told to.
#include "lab/laboratory.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <limits>

#include "weft/error.h"

namespace weft::lab {
namespace {

namespace fs = std::filesystem;

class LaboratoryTest : public ::testing::Test {
protected:
    LaboratoryTest()
        : directory_(
              fs::temp_directory_path() /
              ("weft-laboratory-" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        fs::remove_all(directory_);
    }
    ~LaboratoryTest() override { fs::remove_all(directory_); }

    [[nodiscard]] Laboratory laboratory(LabOptions options = {},
                                        SceneDescription scene = {}) const {
        Laboratory made(std::move(scene), directory_, std::move(options));
        made.begin_experiment("order", 1.0, 1);
        return made;
    }

    // Trials that give their square and count how often they are measured.
    std::vector<Trial> squares(int count) {
        std::vector<Trial> trials;
        for (int n = 0; n < count; ++n) {
            trials.push_back({"square of " + std::to_string(n),
                              [this, n](const Watch& watch) -> nlohmann::json {
                                  watch();
                                  ++measured_;
                                  return n * n;
                              },
                              static_cast<double>(n)});
        }
        return trials;
    }

    [[nodiscard]] std::vector<fs::path> kept_files() const {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(directory_ / "trials" / "order")) {
            files.push_back(entry.path());
        }
        return files;
    }

    fs::path directory_;
    std::atomic<int> measured_ = 0;
};

TEST_F(LaboratoryTest, GivesResultsInTheOrderOfTrialsOnAnyNumberOfThreads) {
    for (const int threads : {1, 2, 5}) {
        LabOptions options;
        options.threads = threads;
        fs::remove_all(directory_);
        const auto results = laboratory(options).run(squares(20));
        for (int n = 0; n < 20; ++n) EXPECT_EQ(results[static_cast<std::size_t>(n)], n * n);
    }
}

TEST_F(LaboratoryTest, MeasuresNothingTwice) {
    const auto first = laboratory().run(squares(4));
    const auto second = laboratory().run(squares(6));
    EXPECT_EQ(measured_, 6);
    EXPECT_EQ(second[3], first[3]);
}

TEST_F(LaboratoryTest, TakesNoResultOfAnotherSceneOrAnotherLength) {
    SceneDescription stiffer;
    stiffer.material.structural.stiffness *= 2.0;
    LabOptions quick;
    quick.quick = true;
    (void)laboratory().run(squares(1));
    (void)laboratory({}, stiffer).run(squares(1));
    (void)laboratory(quick).run(squares(1));
    EXPECT_EQ(measured_, 3);
}

TEST_F(LaboratoryTest, MeasuresAnewWhatIsNotWhole) {
    (void)laboratory().run(squares(1));
    ASSERT_EQ(kept_files().size(), 1u);
    std::ofstream(kept_files().front()) << R"({"trial": "square of 0", "finger)";
    EXPECT_EQ(laboratory().run(squares(1))[0], 0);
    EXPECT_EQ(measured_, 2);
}

TEST_F(LaboratoryTest, AnInterruptKeepsWhatIsFinished) {
    LabOptions options;
    options.threads = 1;
    options.stop = [this] { return measured_ == 3; };
    EXPECT_THROW((void)laboratory(options).run(squares(8)), Interrupted);
    EXPECT_EQ(kept_files().size(), 3u);
    (void)laboratory().run(squares(8));
    EXPECT_EQ(measured_, 8);
}

TEST_F(LaboratoryTest, AFailureEndsTheBatchAndIsTold) {
    std::vector<Trial> trials = squares(3);
    trials.push_back(
        {"fails",
         [](const Watch&) -> nlohmann::json { throw Error(ErrorKind::file, {}, "no room"); },
         100.0});
    try {
        (void)laboratory().run(trials);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.message(), "no room");
    }
}

TEST_F(LaboratoryTest, NumbersAreKeptToTheBitAndWhatIsNoneIsNull) {
    const double third = 1.0 / 3.0;
    const std::vector<Trial> trials{
        {"values", [&](const Watch&) -> nlohmann::json {
             return {third, 1e-300, std::numeric_limits<double>::infinity(), std::nan("")};
         }}};
    for (int again = 0; again < 2; ++again) {
        const nlohmann::json values = laboratory().run(trials)[0];
        EXPECT_EQ(values[0].get<double>(), third);
        EXPECT_EQ(values[1].get<double>(), 1e-300);
        EXPECT_TRUE(values[2].is_null());
        EXPECT_TRUE(values[3].is_null());
    }
}

TEST_F(LaboratoryTest, TellsHowFarItIsFromZeroToOne) {
    std::vector<double> fractions;
    LabOptions options;
    options.progress = [&](const LabProgress& progress) { fractions.push_back(progress.fraction); };
    Laboratory made(SceneDescription{}, directory_, options);
    made.begin_experiment("order", 0.25, 1);
    (void)made.run(squares(5));
    EXPECT_NEAR(fractions.back(), 0.25, 1e-12);
    made.begin_experiment("energy", 0.75, 2);
    (void)made.run(squares(2));
    EXPECT_NEAR(fractions.back(), 0.625, 1e-12);
    (void)made.run(squares(3));
    EXPECT_NEAR(fractions.back(), 1.0, 1e-12);
    EXPECT_TRUE(std::ranges::is_sorted(fractions));
}

TEST_F(LaboratoryTest, RanksTheMethodsAskedForInMenuOrder) {
    LabOptions options;
    options.methods = {"rk4", "verlet"};
    EXPECT_EQ(laboratory(options).methods(), (std::vector<std::string_view>{"verlet", "rk4"}));
    EXPECT_EQ(laboratory().methods().size(), 22u);
}

TEST_F(LaboratoryTest, ADirectoryThatCannotBeIsToldByName) {
    std::ofstream(directory_.string()) << "a file";
    try {
        (void)laboratory();
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_NE(std::string(error.what()).find(directory_.string()), std::string::npos);
    }
}

}  // namespace
}  // namespace weft::lab
