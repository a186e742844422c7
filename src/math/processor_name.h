// The processor's name, for reports of what was measured on it.
#pragma once

#include <string>

namespace weft {

/// As the operating system knows it; "unknown" where it does not say.
std::string processor_name();

}  // namespace weft
