// contracts.h — what `:help drill_peck` and `drill_peck?` answer.
#pragma once

#include <string>
#include <string_view>

#include "driver/options.h"
#include "driver/shared_inputs.h"
#include "repl/transcript.h"

namespace kadr::repl {

/// The name that a line asks for: `drill_peck?`, `?drill_peck`, `help drill_peck`; empty: it asks
/// for none.
std::string asked_name(std::string_view line);

/// What the name means to who types it: the contract of a declared cycle, function or program, of
/// one of the library (with its import), or what a command or a word is on the control. Empty: it
/// means nothing here.
std::string meaning_of(const driver::Options& options, driver::SharedInputs& inputs,
                       const Transcript& transcript, std::string_view word_for_program,
                       const std::string& name);

}  // namespace kadr::repl
