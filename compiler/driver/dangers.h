// dangers.h — a text that is only made is run as well, for what it would do to a machine.
//
// `kadr run` reports what is legal and dangerous (diagnostics/danger.def) while it executes. `kadr
// check`, and `kadr expand` for a machine, report the same of a Kadr program, at the statement that
// wrote the line.
#pragma once

#include <memory>

#include "driver/generated_text.h"
#include "driver/session.h"

namespace kadr::driver {

/// Makes a text to its end, and runs it so far as no alarm stops it: alarms are `kadr run`'s
/// matter. Warnings of danger go to the messages of the session.
///
/// text  that has been started, of `program` for `target`; it keeps its calls
void make_with_dangers(Session& session, const KadrProgram& program, const nc::Dialect& target,
                       std::unique_ptr<GeneratedText> text);

}  // namespace kadr::driver
