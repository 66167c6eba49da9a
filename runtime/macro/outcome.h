// outcome.h — what a line of a program has come to.
#pragma once

#include <cstdint>

namespace kadr::macro {

enum class Outcome : std::uint8_t {
    Block,    // that was to be filled holds one
    Nothing,  // go on
    Failed,   // and the reason has been reported
    Wait,     // the line is run again when the blocks before are executed
};

/// Whether the line goes on behind a part of it that has come to this.
constexpr bool goes_on(Outcome done) { return done == Outcome::Block || done == Outcome::Nothing; }

}  // namespace kadr::macro
