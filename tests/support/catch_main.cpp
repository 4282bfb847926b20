// Catch2's main takes seconds to compile: it is built once and linked into every test program.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
