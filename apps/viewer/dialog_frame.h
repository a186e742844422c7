// What all dialogs have: a frame in the middle of the window, the rest dimmed.
#pragma once

namespace weft::viewer {

/// @param width in heights of text; less where the window is narrower.
/// @return whether to draw what is in it, and to end with end_dialog().
bool begin_dialog(const char* title, bool is_open, float width);
void end_dialog();
/// The text field that comes next is as wide as the dialog, and has the keyboard when that opens.
void take_keyboard();

}  // namespace weft::viewer
