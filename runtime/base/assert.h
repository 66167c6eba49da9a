// assert.h — the check of our own promises.
//
// A user's mistake is a diagnostic, a calculation without an answer is a Result; only a fault of
// Kadr itself ends here. The check stays in release builds: a wrong block breaks a spindle.
#pragma once

namespace kadr {

/// Prints the broken promise with its location and ends the program. Never returns.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line,
                                   const char* why);

}  // namespace kadr

#define KADR_ASSERT(condition, why)                                        \
    do {                                                                   \
        if (!(condition)) [[unlikely]]                                     \
            ::kadr::assertion_failed(#condition, __FILE__, __LINE__, why); \
    } while (false)
