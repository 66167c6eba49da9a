// tests.h — tests while they run, and a call as a program of its own. For the room expand only.
#pragma once

#include "expand/running.h"

namespace kadr::expand {

/// See Expander::start_test.
void start_test(Running& run, std::uint32_t index, std::span<const Slot> values, TestBench& asked);
/// See Expander::read_values.
std::optional<std::vector<Slot>> read_values(Running& run, std::uint32_t index,
                                             const std::vector<sema::Define>& defines);
/// Executes TestCall: has the bench execute a call, write it, or wait for its error.
Done test_call(Running& run, const Instruction& instruction, Slot* registers, std::uint32_t at);
/// Executes AssumeFailed: the values of a property are not among those that it assumes.
void reject_values(Running& run);
/// Executes Figure: what the bench measures of a call that was executed.
void ask_figure(Running& run, const Instruction& instruction, Slot* registers);
/// Executes TestDialects: the names of the dialects under test, or of the present one.
void list_dialects(Running& run, const Instruction& instruction, Slot* registers);
/// Reports what does not hold; the test may go on.
void report_expectation(Running& run, const Instruction& instruction, const Slot* registers,
                        std::uint32_t at);
/// See Expander::start_call.
void start_call(Running& run, const CallUnderTest& call);

}  // namespace kadr::expand
