// stop.h — what a debugger tells of a run that stands, as plain data: faces make text, JSON or
// messages of a protocol from it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/source.h"
#include "driver/debug/places.h"
#include "driver/trace.h"

namespace kadr::driver {

enum class StopReason : std::uint8_t {
    Entry,  // nothing was executed so far
    Place,  // in front of a break point
    Step,   // as far as the one who looks on wanted
    Pause,  // somebody has asked for it meanwhile
    Until,  // the program has ended in front of a place
    Alarm,  // an alarm, or an error of the Kadr program, has ended it
    End,    // it is through, or was ended by the one who looks on
};

/// Where a run stands: in front of a statement of a Kadr program, or of a line of ISO-7bit text.
/// Everything before is executed.
struct Stop {
    StopReason reason = StopReason::Step;
    PlaceId place;           // that it has come to
    SourceRange statement;   // that is next; not valid: …
    SourceRange entered_by;  // the call of a function that begins with it; not valid: none does
    /// … a line is. With a statement it is the line that comes next, as far as that is known.
    std::optional<TraceStep> line;

    bool is_at_statement() const { return statement.file.is_valid(); }
};

/// How it goes on. In front of a statement of a Kadr program steps are statements, in front of a
/// line they are lines.
enum class Resume : std::uint8_t {
    Continue,  // to the next place
    StepIn,
    StepOver,  // calls count as one step
    StepOut,   // behind the call of the function or program in which it stands
    End,       // the program ends here
};

/// A function of the Kadr program, or a program of the control, that has begun and not returned.
struct StackFrame {
    enum class Kind : std::uint8_t { Function, Program };
    Kind kind = Kind::Function;
    std::string name;  // of the main program of a text the file
    std::string file;
    std::uint64_t line = 0;  // that is next; of one that has called another, the call
    std::uint32_t column = 1;
    SourceRange range;  // of the Kadr program
};

/// Names variables while the run stands: those of a scope, or the parts of a value.
struct VariablesRef {
    std::uint32_t number = 0;  // 0: there are none
    bool is_valid() const { return number != 0; }
};

struct Scope {
    enum class Kind : std::uint8_t {
        Locals,           // of a function of the Kadr program
        Globals,          // of its file
        ProgramLocals,    // of a program of the control
        CommonVariables,  // of all programs of the control
        MachineValues,    // that the machine gives
        Position,         // in the programmed system
        MachinePosition,
        Codes,  // that act, by their modal groups
        State,  // feed, speed, tool, offsets
    };
    Kind kind = Kind::Locals;
    std::string name;
    VariablesRef variables;
};

struct Variable {
    std::string name;
    std::string type;    // as the program has it; empty: the name tells it
    std::string value;   // for a person
    VariablesRef parts;  // members, elements
    std::int64_t part_count = 0;
};

}  // namespace kadr::driver
