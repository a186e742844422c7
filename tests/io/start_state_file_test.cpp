// The state a run begins with, in a NumPy file.
#include "io/start_state_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "io/byte_order.h"
#include "io/npy_format.h"
#include "support/cloth_scenes.h"
#include "support/recording.h"
#include "support/scene_errors.h"

namespace weft {
namespace {

std::string as_text(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A NumPy file of any head, with `count` numbers behind it: 0, 1, 2, ...
template <typename Number>
std::string npy(const std::string& head, std::size_t count) {
    Bytes bytes;
    append_text(bytes, std::string_view("\x93NUMPY\x01\x00", 8));
    append_little(bytes, static_cast<std::uint16_t>(head.size()));
    append_text(bytes, head);
    for (std::size_t n = 0; n < count; ++n) append_little(bytes, static_cast<Number>(n));
    return as_text(bytes);
}

const std::string good_head =
    "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 3), }        \n";

class StartStateFile : public testing::Test {
protected:
    ClothState loaded(const std::string& bytes) {
        test::write_text(path_, bytes);
        return load_start_state(path_);
    }
    /// The message without the path; empty where there is no error.
    std::string refusal(const std::string& bytes) {
        const auto error = test::error_of([&] { loaded(bytes); });
        if (!error) return {};
        EXPECT_EQ(error->kind(), ErrorKind::file);
        EXPECT_EQ(error->place().file, path_.string());
        return error->message();
    }

    test::ScratchDirectory directory_;
    std::filesystem::path path_ = directory_ / "state.npy";
};

TEST_F(StartStateFile, HoldsPositionsThenVelocities) {
    const ClothState state = loaded(npy<double>(good_head, 12));
    EXPECT_EQ(state.positions, (std::vector<Vec3d>{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(state.velocities, (std::vector<Vec3d>{{6, 7, 8}, {9, 10, 11}}));
}

TEST_F(StartStateFile, MayBeOfSinglePrecisionAndWrittenInOtherWays) {
    const std::vector<Vec3d> velocities{{6, 7, 8}, {9, 10, 11}};
    for (const std::string head :
         {"{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2, 3), }",
          "{ \"shape\" : (2,2,3,) , \"fortran_order\":False,\"descr\":\"<f4\" }\n\n"}) {
        EXPECT_EQ(loaded(npy<float>(head, 12)).velocities, velocities) << head;
    }
    // Format 2.0 has four bytes for the length of its head.
    std::string longer = npy<double>(good_head, 12);
    longer[6] = 2;
    longer.insert(10, 2, '\0');
    EXPECT_EQ(loaded(longer).velocities, velocities);
}

TEST_F(StartStateFile, ComesBackToTheBit) {
    ClothState state;
    for (std::size_t p = 0; p < 1000; ++p) {
        state.positions.push_back(1e-300 * test::random_vector(3, p));
        state.velocities.push_back(1e300 * test::random_vector(4, p));
    }
    state.positions[0] = {-0.0, std::numeric_limits<double>::denorm_min(), 0.1};
    OutputFile file(path_);
    write_start_state(file, state);
    file.commit();
    EXPECT_EQ(std::filesystem::file_size(path_), 128U + 48'000U);
    const ClothState read = load_start_state(path_);
    EXPECT_EQ(read.positions, state.positions);
    EXPECT_EQ(read.velocities, state.velocities);
    EXPECT_TRUE(std::signbit(read.positions[0].x));
}

TEST_F(StartStateFile, IsRefusedWhereTheHeadIsDamaged) {
    EXPECT_EQ(refusal(""), "is not a NumPy file: it does not begin with \\x93NUMPY");
    EXPECT_EQ(refusal("version = 1\n"), "is not a NumPy file: it does not begin with \\x93NUMPY");
    std::string newer = npy<double>(good_head, 12);
    newer[6] = 4;
    EXPECT_EQ(refusal(newer), "is of NumPy format 4; 1 to 3 can be read");
    EXPECT_EQ(refusal(npy<double>(good_head, 12).substr(0, 40)),
              "is cut off: byte 81 is needed, the file has 40");
    EXPECT_EQ(refusal(npy<double>(good_head, 12).substr(0, 9)),
              "is cut off: byte 10 is needed, the file has 9");
    const std::string damaged =
        "its head is not that of a NumPy array: 'descr', 'fortran_order' and 'shape' are needed, "
        "and nothing else";
    for (const std::string head :
         {"", "{}", "{'descr': '<f8', 'fortran_order': False}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 3)",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 3)} x",
          "{'descr': '<f8', 'fortran_order': 0, 'shape': (2, 2, 3)}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': [2, 2, 3]}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, -2, 3)}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2 2 3)}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 99999999999999999999, 3)}",
          "{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (2, 2, 3)}",
          "{'descr': '<f8', 'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 3)}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 3), 'more': True}",
          "{'descr: <f8, fortran_order: False, shape: (2, 2, 3)}"}) {
        EXPECT_EQ(refusal(npy<double>(head, 12)), damaged) << head;
    }
    EXPECT_EQ(refusal(npy<double>(good_head + std::string(5000, ' '), 12)),
              "its head has 5071 bytes; at most 4096 are allowed");
}

TEST_F(StartStateFile, IsRefusedWhereItIsAnotherArray) {
    const auto with = [&](const std::string& old, const std::string& other) {
        std::string head = good_head;
        head.replace(head.find(old), old.size(), other);
        return refusal(npy<double>(head, 12));
    };
    EXPECT_EQ(with("<f8", ">f8"),
              "has elements of type \">f8\"; \"<f8\" or \"<f4\" (float64, float32) is needed");
    EXPECT_EQ(with("<f8", "<i8"),
              "has elements of type \"<i8\"; \"<f8\" or \"<f4\" (float64, float32) is needed");
    EXPECT_EQ(with("False", "True"), "is in Fortran order; C order is needed");
    const std::string needed = "; (2, particles, 3) is needed: positions, then velocities";
    EXPECT_EQ(with("(2, 2, 3)", "(4, 3)"), "has the shape (4, 3)" + needed);
    EXPECT_EQ(with("(2, 2, 3)", "(1, 4, 3)"), "has the shape (1, 4, 3)" + needed);
    EXPECT_EQ(with("(2, 2, 3)", "(2, 3, 2)"), "has the shape (2, 3, 2)" + needed);
    EXPECT_EQ(with("(2, 2, 3)", "(2, 0, 3)"), "has the shape (2, 0, 3)" + needed);
    EXPECT_EQ(with("(2, 2, 3)", "()"), "has the shape ()" + needed);
}

TEST_F(StartStateFile, IsRefusedWhereItsSizeIsNotThatOfItsShape) {
    EXPECT_EQ(refusal(npy<double>(good_head, 11)),
              "has 88 bytes behind its head; a state of 2 particles has 48 bytes each");
    EXPECT_EQ(refusal(npy<double>(good_head, 18)),
              "has 144 bytes behind its head; a state of 2 particles has 48 bytes each");
    const std::string huge =
        "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 18446744073709551615, 3), }";
    EXPECT_EQ(refusal(npy<double>(huge, 12)),
              "has 96 bytes behind its head; a state of 18446744073709551615 particles has 48 "
              "bytes each");
}

TEST_F(StartStateFile, IsRefusedWhereANumberIsNotFinite) {
    std::string bytes = npy<double>(good_head, 12);
    const double infinite = std::numeric_limits<double>::infinity();
    const auto put_at = [&](std::size_t number) {
        std::string changed = bytes;
        std::memcpy(changed.data() + bytes.size() - 96 + 8 * number, &infinite, 8);
        return refusal(changed);
    };
    EXPECT_EQ(put_at(4), "the position of particle 1 is not finite");
    EXPECT_EQ(put_at(6), "the velocity of particle 0 is not finite");
}

TEST_F(StartStateFile, IsReadByASceneRelativeToIt) {
    std::filesystem::create_directory(directory_ / "sub");
    test::write_text(
        directory_ / "sub/two-by-two.npy",
        npy<double>("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 4, 3)}", 24));
    const std::string cloth = "version = 1\n[cloth]\nresolution = [2, 2]\n";
    const std::string scene_path = (directory_ / "s.toml").string();
    test::write_text(scene_path, cloth + "[start]\nstate = \"sub/two-by-two.npy\"\ntime = 0.5\n");
    const SceneDescription scene = load_scene(scene_path);
    EXPECT_EQ(scene.start.state_path, (directory_ / "sub/two-by-two.npy").string());
    ASSERT_NE(scene.start.state, nullptr);
    EXPECT_EQ(scene.start.state->velocities[3], (Vec3d{21, 22, 23}));
    EXPECT_EQ(scene.start.time, 0.5);
    // On the command line, relative to the current directory; here absolute.
    const std::vector<SceneOverride> set{{"start.state", scene.start.state_path}};
    EXPECT_NE(parse_scene(cloth, "/elsewhere/s.toml", set).start.state, nullptr);
    // The cloth must have as many particles.
    const std::vector<SceneOverride> finer{{"cloth.resolution", "[3, 3]"}};
    const auto other = test::error_of([&] { load_scene(scene_path, finer); });
    ASSERT_TRUE(other);
    EXPECT_EQ(std::string(other->what()),
              scene_path +
                  ":5:9: start.state: a state of 4 particles is not allowed: 9 in a grid of 3 x 3");
    // An error of the array names its file, not the scene's.
    test::write_text(directory_ / "sub/two-by-two.npy", "nothing");
    const auto error = test::error_of([&] { load_scene(scene_path); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::file);
    EXPECT_EQ(error->place().file, scene.start.state_path);
}

}  // namespace
}  // namespace weft
