#include "base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace kadr {

void assertion_failed(const char* condition, const char* file, int line, const char* why) {
    std::fprintf(stderr, "%s:%d: internal error: %s (%s)\n", file, line, why, condition);
    std::abort();
}

}  // namespace kadr
