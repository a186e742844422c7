# One set of compiler flags for every target. Floating point is fixed once: no contraction, no
# fast-math, so that the same scene gives the same bits in every build (docs/architecture.md).
# -fno-math-errno and -fno-trapping-math change no result; they let loops with sqrt vectorise.
add_library(weft_flags INTERFACE)
target_compile_features(weft_flags INTERFACE cxx_std_20)
target_compile_options(weft_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
    -ffp-contract=off -fno-math-errno -fno-trapping-math
    $<$<CONFIG:Release>:-O3>)
# GCC 12 sees overlapping copies in std::string's operator+ where there are none (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(weft_flags INTERFACE -Wno-restrict)
endif()
if(WEFT_SANITIZE)
    # Instrumented, moved-from variants look uninitialised to GCC 12 (it warns of false positives
    # with -fsanitize in its own manual).
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(weft_flags INTERFACE -Wno-maybe-uninitialized)
    endif()
    target_compile_options(weft_flags INTERFACE
        -fsanitize=${WEFT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(weft_flags INTERFACE -fsanitize=${WEFT_SANITIZE})
endif()
