// operator new that counts. In a file of its own: seen beside its callers, half of it inlined, g++
// takes free() for a mismatch.
#pragma once

namespace weft::test {

void start_counting_allocations();

/// How many there were since, on all threads.
long stop_counting_allocations();

}  // namespace weft::test
