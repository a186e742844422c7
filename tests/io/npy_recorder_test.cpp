// NumPy recordings, byte by byte.
#include <gtest/gtest.h>

#include "support/recording.h"

namespace weft {
namespace {

using test::file_text;
using test::little_at;
using test::record;
using test::ScratchDirectory;

/// Checks the head of a NumPy file of format 1.0; returns where the numbers begin.
std::size_t expect_head(const std::string& bytes, const std::string& element,
                        const std::string& shape) {
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t length = little_at<std::uint16_t>(bytes, 8);
    EXPECT_EQ((10 + length) % 64, 0U);
    const std::string head = bytes.substr(10, length);
    const std::string expected =
        "{'descr': '" + element + "', 'fortran_order': False, 'shape': (" + shape + "), }";
    EXPECT_EQ(head.substr(0, expected.size()), expected);
    EXPECT_EQ(head.find_first_not_of(' ', expected.size()), head.size() - 1);
    EXPECT_EQ(head.back(), '\n');
    return 10 + length;
}

template <typename Real>
void expect_vectors(const std::string& bytes, std::size_t begin, std::size_t frames,
                    test::WavingCloth& cloth, std::span<const Vec3d> Frame::*vectors) {
    const std::size_t particles = cloth.surface.particle_count;
    ASSERT_EQ(bytes.size(), begin + 3 * sizeof(Real) * particles * frames);
    std::size_t at = begin;
    for (std::size_t i = 0; i < frames; ++i) {
        const Frame frame = cloth.frame(i);
        for (const Vec3d& vector : frame.*vectors)
            for (const double value : {vector.x, vector.y, vector.z}) {
                ASSERT_EQ(little_at<Real>(bytes, at), static_cast<Real>(value));
                at += sizeof(Real);
            }
    }
}

template <typename Real>
void expect_recording(const ScratchDirectory& scratch, test::WavingCloth& cloth,
                      std::size_t frames) {
    const std::string element = sizeof(Real) == 4 ? "<f4" : "<f8";
    const std::string shape =
        std::to_string(frames) + ", " + std::to_string(cloth.surface.particle_count) + ", 3";
    const std::string positions = file_text(scratch / "wave.positions.npy");
    const std::string velocities = file_text(scratch / "wave.velocities.npy");
    const std::string times = file_text(scratch / "wave.times.npy");
    expect_vectors<Real>(positions, expect_head(positions, element, shape), frames, cloth,
                         &Frame::positions);
    expect_vectors<Real>(velocities, expect_head(velocities, element, shape), frames, cloth,
                         &Frame::velocities);
    const std::size_t begin = expect_head(times, "<f8", std::to_string(frames) + ",");
    ASSERT_EQ(times.size(), begin + 8 * frames);
    for (std::size_t i = 0; i < frames; ++i)
        EXPECT_EQ(little_at<double>(times, begin + 8 * i), cloth.frame(i).time);
}

TEST(NpyRecorder, SinglePrecision) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(6, 4);
    const auto files = record("npy", cloth, scratch.path(), 5, 5);
    EXPECT_EQ(files, (std::vector{scratch / "wave.positions.npy", scratch / "wave.velocities.npy",
                                  scratch / "wave.times.npy"}));
    expect_recording<float>(scratch, cloth, 5);
}

TEST(NpyRecorder, DoublePrecisionKeepsEveryBit) {
    ScratchDirectory scratch;
    auto cloth = test::waving_sleeve(6, 4);
    record("npy", cloth, scratch.path(), 5, 5);
    expect_recording<double>(scratch, cloth, 5);
}

TEST(NpyRecorder, FewerFramesThanPlannedCountTruly) {
    ScratchDirectory scratch;
    auto cloth = test::waving_grid(3, 3);
    record("npy", cloth, scratch.path(), 1'000'000, 1);
    expect_recording<float>(scratch, cloth, 1);
}

}  // namespace
}  // namespace weft
