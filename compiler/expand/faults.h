// faults.h — errors of a running program: the location, the reason, and who called whom. For the
// room expand only.
#pragma once

#include "expand/running.h"
#include "sema/arithmetic.h"

namespace kadr::expand {

/// Reports at an instruction, with the calls that led there; an error ends the program.
///
/// depth        how many of the calls are named: fewer, where the message stands at a caller
DiagnosticBuilder fault_in(Running& run, const DiagnosticRow& row, std::uint32_t at,
                           std::size_t depth);
/// … with all of them.
DiagnosticBuilder fault(Running& run, const DiagnosticRow& row, std::uint32_t at);
/// A message that is one text.
void fault_note(Running& run, const DiagnosticRow& row, std::uint32_t at, const std::string& text);
/// Adds a note at a statement, if one is known.
void note_statement(const Running& run, DiagnosticBuilder& builder, SourceId statement,
                    std::string text);
/// A calculation that has no result.
void math_fault(Running& run, sema::MathFault why, std::uint32_t at);
/// A value that is not given: by its name; empty: the value of a word.
void not_given(Running& run, std::string_view name, std::uint32_t at);
/// Of two coordinates that belong together only one is given; both by their texts.
void half_given(Running& run, std::int32_t missing, std::int32_t given, std::uint32_t at);
/// A feed or speed is not of the form that is needed; see Op::FeedForm.
void form_fault(Running& run, unsigned needed, std::uint32_t at);
/// An index outside of `whole`, which has `count` elements.
void index_fault(Running& run, std::int64_t index, std::int64_t count, std::uint32_t at,
                 std::string_view whole = "the array");
/// Executes RequireFailed and AssertFailed. A contract is broken by the caller, where the message
/// stands then.
void contract_failed(Running& run, const Instruction& instruction, const Slot* registers,
                     std::uint32_t at);

}  // namespace kadr::expand
