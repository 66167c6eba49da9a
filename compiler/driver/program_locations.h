// program_locations.h — where in a program the motion of a piece was asked for, as a person looks
// for it.
#pragma once

#include <cstdint>
#include <string>

#include "driver/execution.h"
#include "driver/session.h"

namespace kadr::driver {

/// A statement of a source, or a line of ISO-7bit text.
struct ProgramLocation {
    SourceRange statement;   // of a source; invalid: …
    std::uint32_t line = 0;  // … of the ISO-7bit text
    std::string called;      // file and line in a program that was called

    /// The order in which locations of equal weight are shown.
    bool operator<(const ProgramLocation& other) const {
        if (line != other.line) return line < other.line;
        if (statement.begin != other.statement.begin)
            return statement.begin < other.statement.begin;
        return called < other.called;
    }
};

/// What the library moves counts for the statement that called it.
class ProgramLocations {
  public:
    /// Both outlive this.
    ProgramLocations(const Execution& execution, const Session& session)
        : execution_(execution), session_(session) {}

    /// Of what a line of the ISO-7bit text, written for a statement, has moved.
    ProgramLocation find(std::uint32_t line, SourceId source) const;
    /// The same for the same location only.
    static std::string key_of(const ProgramLocation& location);

    /// "flange.kadr:41"
    std::string name_of(const ProgramLocation& location) const;
    /// The statement, its first line; empty for ISO-7bit text.
    std::string text_of(const ProgramLocation& location) const;

  private:
    SourceRange users_statement(std::uint32_t line, SourceId source) const;
    bool is_in_library(const SourceRange& range) const;

    const Execution& execution_;
    const Session& session_;
};

}  // namespace kadr::driver
