/// \file
/// Functions that are built for several instruction sets; the fastest that the processor has is called.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && defined(__linux__)
#define MAP_MATCHER_VECTOR_CLONES __attribute__((target_clones("arch=skylake-avx512", "avx2", "default")))
#else
#define MAP_MATCHER_VECTOR_CLONES
#endif
