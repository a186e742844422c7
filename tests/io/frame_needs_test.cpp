// Recorders look at nothing in a frame beyond what they say they need.
#include <gtest/gtest.h>

#include <algorithm>

#include "io/recording_queue.h"
#include "support/recording.h"

namespace weft::test {
namespace {

// A frame with what is needed only, as Simulation::capture() makes it.
Frame reduced(Frame frame, FrameNeeds needs, std::vector<Vec3f>& rounded) {
    rounded.clear();
    for (const Vec3d& x : frame.positions) rounded.push_back(vec3_cast<float>(x));
    if (needs.rounded_positions) frame.rounded_positions = rounded;
    if (!needs.positions) frame.positions = {};
    if (!needs.velocities) frame.velocities = {};
    if (!needs.normals) frame.normals = {};
    return frame;
}

void record_reduced(std::string_view format, WavingCloth& cloth,
                    const std::filesystem::path& directory, std::size_t frames) {
    const auto recorder = make_recorder(format);
    std::vector<Vec3f> rounded;
    recorder->begin(plan_of(cloth, directory, frames));
    for (std::size_t i = 0; i < frames; ++i) {
        recorder->frame(reduced(cloth.frame(i), recorder->needs(), rounded));
    }
    recorder->finish();
}

std::vector<std::filesystem::path> files_below(const std::filesystem::path& directory) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
        if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(directory));
    }
    std::sort(files.begin(), files.end());
    return files;
}

// More points than a recorder turns into bytes at once (75 x 61 = 4575), and a mesh in double.
TEST(FrameNeeds, AreEnoughForTheSameFiles) {
    for (WavingCloth cloth : {waving_grid(75, 61), waving_sleeve(8, 5)}) {
        for (const std::string_view format : {"glb", "pc2", "mdd", "npy", "obj", "ply"}) {
            SCOPED_TRACE(format);
            const ScratchDirectory whole, needed;
            record(format, cloth, whole.path(), 3, 3);
            record_reduced(format, cloth, needed.path(), 3);
            const auto files = files_below(whole.path());
            ASSERT_FALSE(files.empty());
            EXPECT_EQ(files_below(needed.path()), files);
            for (const std::filesystem::path& file : files) {
                EXPECT_EQ(file_text(needed.path() / file), file_text(whole.path() / file)) << file;
            }
        }
    }
}

TEST(FrameNeeds, OfAQueueAreThoseOfAllItsRecorders) {
    const WavingCloth cloth = waving_grid(4, 3);
    const auto needs = [&](const std::vector<std::string>& formats) {
        const ScratchDirectory scratch;
        return RecordingQueue(make_recorders(formats), plan_of(cloth, scratch.path(), 2)).needs();
    };
    const FrameNeeds caches = needs({"pc2", "mdd"});
    EXPECT_TRUE(caches.rounded_positions);
    EXPECT_FALSE(caches.positions || caches.velocities || caches.normals);
    const FrameNeeds more = needs({"pc2", "npy", "glb"});
    EXPECT_TRUE(more.rounded_positions && more.positions && more.velocities && more.normals);
}

}  // namespace
}  // namespace weft::test
