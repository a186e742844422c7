// Ctrl-C: asks the run to end after the current frame.
#pragma once

namespace weft {

/// From now on the first SIGINT or SIGTERM is noted and the second ends the program at once.
void watch_for_interrupt();

/// Whether a signal came.
bool interrupted();

}  // namespace weft
