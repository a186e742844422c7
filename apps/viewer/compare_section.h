// The part of the panel that chooses methods to fly beside the scene's own.
#pragma once

#include "viewer/workbench.h"

namespace weft::viewer {

void compare_section(Workbench& bench);

/// Begins to compare with a method that differs much from the scene's, or ends the comparison.
void toggle_comparison(Workbench& bench);

}  // namespace weft::viewer
