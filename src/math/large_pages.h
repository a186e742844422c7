// Memory in large pages: a sweep over a large state otherwise waits for the addresses of its pages.
#pragma once

#include <cstddef>

namespace weft {

/// Size and alignment of a large page of x86 and of most others [bytes].
inline constexpr std::size_t large_page = std::size_t{2} << 20;

/// Asks the system to put memory that nobody wrote to yet into large pages. It may not, and nothing
/// but time depends on it.
/// @param data at a multiple of large_page.
void use_large_pages(void* data, std::size_t bytes);

}  // namespace weft
