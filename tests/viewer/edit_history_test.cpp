// Undo and redo: whole scenes come back, one gesture at a time.
#include "viewer/edit_history.h"

#include <gtest/gtest.h>

#include "io/scene_json.h"

namespace weft::viewer {
namespace {

SceneDescription with_drag(double drag) {
    SceneDescription scene;
    scene.wind->drag = drag;
    return scene;
}

void change(EditHistory& history, double drag, const std::string& what = "drag") {
    history.edit(with_drag(drag), what);
    history.end_gesture();
}

TEST(EditHistory, UndoneScenesAreEqualToWhatTheyWere) {
    SceneDescription scene;
    scene.pins = {{ParticleSelection{{0, 7}}, {{0.0, {0.1, 0.2, 0.3}}}}};
    scene.obstacles = {{SphereObstacle{{1.0, 2.0, 3.0}, 0.5}, 0.1, 0.01}};
    const auto before = scene_to_json(scene);
    EditHistory history(scene);
    scene.material.structural.stiffness = 999.0;
    scene.obstacles.clear();
    const auto after = scene_to_json(scene);
    history.edit(scene, "stiffness");
    EXPECT_NE(after, before);
    EXPECT_EQ(scene_to_json(history.scene()), after);
    history.undo();
    EXPECT_EQ(scene_to_json(history.scene()), before);
    ASSERT_EQ(history.scene().obstacles.size(), 1U);
    EXPECT_EQ(std::get<SphereObstacle>(history.scene().obstacles[0].shape).radius, 0.5);
    history.redo();
    EXPECT_EQ(scene_to_json(history.scene()), after);
}

TEST(EditHistory, AGestureIsOneUndo) {
    EditHistory history(with_drag(1.0));
    for (int n = 1; n <= 50; ++n) history.edit(with_drag(1.0 + 0.01 * n), "drag");
    history.end_gesture();
    for (int n = 1; n <= 50; ++n) history.edit(with_drag(2.0 + 0.01 * n), "drag");
    EXPECT_EQ(history.scene().wind->drag, 2.5);
    history.undo();
    EXPECT_EQ(history.scene().wind->drag, 1.5);
    history.undo();
    EXPECT_EQ(history.scene().wind->drag, 1.0);
    EXPECT_FALSE(history.can_undo());
}

TEST(EditHistory, AnotherThingIsAnotherUndoWithinAGesture) {
    EditHistory history(with_drag(1.0));
    history.edit(with_drag(2.0), "drag");
    history.edit(with_drag(3.0), "lift");
    history.edit(with_drag(4.0), "drag");
    history.undo();
    EXPECT_EQ(history.scene().wind->drag, 3.0);
}

TEST(EditHistory, UndoEndsAGesture) {
    EditHistory history(with_drag(1.0));
    change(history, 2.0);
    history.edit(with_drag(3.0), "drag");
    history.undo();
    history.edit(with_drag(4.0), "drag");
    history.undo();
    EXPECT_EQ(history.scene().wind->drag, 2.0);
}

TEST(EditHistory, SaysWhatItWouldUndo) {
    EditHistory history(with_drag(1.0));
    change(history, 2.0, "drag");
    change(history, 3.0, "wind velocity");
    EXPECT_EQ(history.undo_what(), "wind velocity");
    EXPECT_FALSE(history.can_redo());
    history.undo();
    EXPECT_EQ(history.undo_what(), "drag");
    EXPECT_EQ(history.redo_what(), "wind velocity");
}

TEST(EditHistory, AnEditDropsWhatCouldBeRedone) {
    EditHistory history(with_drag(1.0));
    change(history, 2.0);
    change(history, 3.0);
    history.undo();
    history.undo();
    change(history, 4.0);
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.scene().wind->drag, 4.0);
    history.undo();
    EXPECT_EQ(history.scene().wind->drag, 1.0);
}

TEST(EditHistory, NothingToUndoOrRedoChangesNothing) {
    EditHistory history(with_drag(1.0));
    history.undo();
    history.redo();
    EXPECT_EQ(history.scene().wind->drag, 1.0);
}

TEST(EditHistory, Keeps200States) {
    EditHistory history(with_drag(0.0));
    for (int n = 1; n <= 500; ++n) change(history, n);
    int undone = 0;
    for (; history.can_undo(); ++undone) history.undo();
    EXPECT_EQ(undone, 199);
    EXPECT_EQ(history.scene().wind->drag, 301.0);
    for (; history.can_redo(); --undone) history.redo();
    EXPECT_EQ(undone, 0);
    EXPECT_EQ(history.scene().wind->drag, 500.0);
}

TEST(EditHistory, KnowsWhetherThePresentSceneIsSaved) {
    EditHistory history(with_drag(1.0));
    EXPECT_TRUE(history.saved());
    change(history, 2.0);
    EXPECT_FALSE(history.saved());
    history.mark_saved();
    EXPECT_TRUE(history.saved());
    history.undo();
    EXPECT_FALSE(history.saved());
    history.redo();
    EXPECT_TRUE(history.saved());
    history.undo();
    change(history, 3.0);  // what was saved can no longer be reached
    EXPECT_FALSE(history.saved());
    history.undo();
    EXPECT_FALSE(history.saved());
}

TEST(EditHistory, WhatWasSavedInTheMiddleOfAGestureStays) {
    EditHistory history(with_drag(1.0));
    history.edit(with_drag(2.0), "drag");
    history.mark_saved();
    history.edit(with_drag(3.0), "drag");
    EXPECT_FALSE(history.saved());
    history.undo();
    EXPECT_TRUE(history.saved());
    EXPECT_EQ(history.scene().wind->drag, 2.0);
}

TEST(EditHistory, WhatWasSavedTooLongAgoIsForgotten) {
    EditHistory history(with_drag(0.0));
    for (int n = 1; n <= 250; ++n) change(history, n);
    while (history.can_undo()) history.undo();
    EXPECT_FALSE(history.saved());
}

}  // namespace
}  // namespace weft::viewer
