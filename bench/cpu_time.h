// cpu_time.h — what the process has used of the processor, for benchmarks that measure themselves.
#pragma once

#include <ctime>

namespace kadr::bench {

/// s since the start, all threads.
inline double cpu_time() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace kadr::bench
