#include "math/large_pages.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace weft {

void use_large_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
    (void)madvise(data, bytes / large_page * large_page, MADV_HUGEPAGE);
#endif
}

}  // namespace weft
