// tables.h — `kadr explain`, `kadr dialect …`, `kadr machine …`: what Kadr's tables hold.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "driver/options.h"
#include "driver/session.h"

namespace kadr::driver {

/// What was asked for, as text for standard output; empty if it was reported instead.
struct Reply {
    Status status = Status::Done;
    std::string text;
};

/// The row of a message with its explanation and examples; all codes if `code` is empty.
Reply explain_message(Session& session, std::string_view code);

Reply list_dialects(Session& session);
/// Everything that can be wrong in a dialect file: what loading finds, rules of the interpreter
/// that do not exist or have a wrong value, a frame that does not read back, examples that are not
/// true.
Reply check_dialect(Session& session, const std::string& name_or_file);
/// What a word of the control, a function of the vocabulary or a cycle means there.
Reply explain_word(Session& session, const std::string& name_or_file, const std::string& word);

Reply list_machines(Session& session);
/// A machine by name or file; nothing, reported, if there is none or it has mistakes.
std::optional<machine::Machine> machine_of(Session& session, const std::string& name_or_file);
Reply check_machine(Session& session, const std::string& name_or_file);

}  // namespace kadr::driver
