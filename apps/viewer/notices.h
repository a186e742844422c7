// What the window says over the cloth: a divergence, messages, the help.
#pragma once

#include "viewer/controls.h"
#include "viewer/workbench.h"

namespace weft::viewer {

/// Where the scene's own method diverged: where, why, and a button that mends it.
void divergence_notice(const Place& cloth, Workbench& bench);
/// @return whether messages are shown, so that their time must be watched.
bool message_list(const Place& cloth, Messages& messages);
void help_overlay(bool& is_open, const Fonts& fonts);

}  // namespace weft::viewer
