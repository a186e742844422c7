// The part of the panel for what the cloth rests on.
#pragma once

#include "viewer/controls.h"
#include "viewer/workbench.h"

namespace weft::viewer {

void obstacle_section(Workbench& bench, const Act& act);

}  // namespace weft::viewer
