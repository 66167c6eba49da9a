// program_frame.h — a program that has begun and not returned: where it stands, what it has open,
// and the call that has begun it. Internal to macro.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "macro/control_variables.h"
#include "macro/program.h"
#include "macro/program_units.h"
#include "macro/text_macros.h"
#include "nc/kept_lines.h"

namespace kadr::macro {

/// A structure that was entered and not left yet.
struct OpenStructure {
    nc::Statement kind = nc::Statement::None;
    int loop = 0;
    ProgramLine head;
    ProgramLine end;
    std::optional<ProgramLine> otherwise;
    double last = 0;                          // For
    std::unique_ptr<nc::ControlLine> counts;  // … its head
    std::optional<std::int64_t> left;         // Loop with a count: passes, this one included
};

/// A section that is being repeated.
struct OpenRepeat {
    LinePosition begin;
    LinePosition end;     // reached: the section is through
    LinePosition behind;  // where the program goes on in the end
    std::int64_t left = 0;
    bool is_shape = false;  // of a cycle, whose blocks they are
};

/// An argument that was worked out where the call stands.
struct GivenValue {
    bool is_given = false;
    ControlValue value;
    std::string text;                        // of a text
    control::ControlFrame frame;             // of a frame
    ControlVariables::VariableRef variable;  // of a variable alone
    bool is_array = false;
    nc::Span span;
};

/// A call with everything that it needs to begin, as often as it is to.
struct PreparedCall {
    ProgramUnit* unit = nullptr;
    const nc::CallForm* form = nullptr;  // null: a statement without a code
    std::int64_t passes = 1;
    std::int64_t start = -1;            // number of the block where it begins
    std::vector<GivenValue> arguments;  // by their positions
    std::shared_ptr<Level> level;       // of a macro: arguments are set once
    std::optional<ProgramLine> from;    // of a section
    std::optional<LinePosition> to;
    std::shared_ptr<const nc::CallSite> site;
    bool is_modal = false;
    bool is_shape = false;  // its blocks are those of the shape along which a cycle works
    bool is_macro() const { return form != nullptr && form->kind == nc::CallForm::Kind::Macro; }
};

/// A variable of the caller for which a parameter stands.
struct ReturnedVariable {
    ControlVariables::VariableRef variable;
    ControlVariable before;  // the call
};

/// A modal call that is made at the positions of a pattern.
struct CallsAtPositions {
    PreparedCall call;
    std::uint32_t line = 0;    // Block::line of the pattern
    std::uint64_t number = 0;  // … in its text
    nc::ModalFunctions modal_before{};
    bool has_called = false;  // at the position where the tool stands
};

/// A program that runs: the main program, or one that was called.
struct RunningProgram {
    ProgramUnit* unit = nullptr;
    nc::TextBounds text;
    Level* level = nullptr;
    std::shared_ptr<Level> own_level;   // null: the caller's
    LinePosition here;                  // of the line that is next
    LinePosition goes_on;               // behind the line that is executed
    CompiledLine* next_line = nullptr;  // if the next line is kept
    std::vector<OpenStructure> structures;
    std::vector<OpenRepeat> repeats;
    std::size_t resume = 0;        // statements of the line that are executed already
    bool has_executed = false;     // something besides declarations
    bool has_given_words = false;  // of the line: its call is next
    std::shared_ptr<const nc::CallSite> site;
    SourceId site_number;   // of the site among the recent ones
    PreparedCall call;      // that has begun it
    std::int64_t left = 1;  // passes, this one included
    bool saves = false;
    nc::ModalFunctions modal_before{};
    bool is_definition = false;  // it declares what all programs have, and moves nothing
    bool is_called = false;      // the main program has arguments, and returns where it ends
    const ProgramInputs* inputs = nullptr;  // it is what the machine gives before the program
    bool is_in_code_call = false;           // codes that call programs mean what they are here
    bool is_external = false;
    TextMacros macros;
    std::optional<CallsAtPositions> at_positions;  // while the tool goes from position to position
    std::vector<ReturnedVariable> references;      // noted if somebody looks on
    std::size_t modal_limit = ~std::size_t{0};     // modal calls below this one act here
    // How it ends.
    bool is_returning = false;
    bool leaves_all_passes = false;
    int levels = 1;                         // that are left
    std::optional<ProgramLine> returns_to;  // in the program that goes on
};

}  // namespace kadr::macro
