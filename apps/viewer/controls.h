// Small controls that the panels share.
#pragma once

#include <functional>
#include <string>

#include "viewer/key_bindings.h"
#include "viewer/theme.h"
#include "viewer/window_layout.h"

namespace weft::viewer {

/// What a button stands for is done as if its key had been pressed.
using Act = std::function<void(BoundAction)>;

enum class Icon {
    play,
    pause,
    step,
    step_back,
    reset,
    record,
    stop,
    camera,
    help,
    slower,
    faster,
    undo,
    redo,
    cross
};

/// A square button with a drawn sign. @return whether it was pressed.
bool icon_button(Icon icon, const char* id, const std::string& tooltip, bool enabled = true,
                 ImU32 colour = colours::text);
float icon_width();  ///< of such a button [screen units]
bool text_button(const char* label, bool enabled = true, float width = 0.0F);
/// A button with the colour of what one most likely wants.
bool main_button(const char* label);

/// How much room a tick with its label takes after something in the same line [screen units].
float tick_width(const char* label);

/// Whether the mouse rests long enough for an explanation.
bool mouse_rests();
void show_tooltip(const std::string& text);
/// Explains the last item once the mouse rests on it.
void tooltip_of_last(const std::string& text);
/// Ends the line with a text at the panel's right edge.
void text_at_right(const std::string& text, ImU32 colour = colours::text);
void coloured_text(ImU32 colour, const std::string& text);  ///< wrapped
/// A row of a table of facts.
void fact(const char* name, const std::string& value, ImU32 colour = colours::text);

/// A window of ImGui that stays where the layout puts it.  @return whether anything of it is seen.
bool begin_panel(const char* name, const Place& place, bool scrolls = true);
void end_panel();
/// The heading of a part that can be folded.
bool section(const char* name, bool open_at_first);

}  // namespace weft::viewer
