// running.h — one program that runs: what it is given, what it makes, and who owns which state of
// it.
//
// The functions that run it take a Running first and stand by subject: start.h (programs and their
// parameters), vm.h (the instructions), values.h (texts, arrays, tables), text_format.h; blocks.h
// and block_values.h; cuts.h and unknown.h (what a block needs of the state that acts); scopes.h
// (`with`, what a cycle needs and preserves), frame_blocks.h, tilted_planes.h and orienting.h
// (planes and directions of five axes), native_cycles.h; input.h, input_frames.h, input_tools.h,
// input_positions.h, input_references.h and cycles.h (blocks in the manner of another control);
// contour_values.h, contour_recording.h, contours.h, follow.h, curves.h; drawn_words.h and
// corners.h (angles, polar coordinates, chamfers and roundings in blocks); faults.h (errors with
// the call stack); tests.h. For the room expand only.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/done.h"
#include "expand/active_cycle.h"
#include "expand/batch.h"
#include "expand/budget.h"
#include "expand/call_stack.h"
#include "expand/corner_state.h"
#include "expand/expander.h"
#include "expand/heap.h"
#include "expand/modal.h"
#include "expand/open_scopes.h"
#include "expand/recording.h"
#include "expand/reported_in_program.h"
#include "expand/written_shapes.h"
#include "sema/code.h"

namespace kadr::expand {

using sema::Instruction;
using sema::OpCode;

/// What the instructions work on.
struct VirtualMachine {
    VirtualMachine(const sema::Code& code, const RunLimits& limits);

    Heap heap;                // texts and arrays
    std::vector<Slot> stack;  // registers of all calls
    CallStack calls;
    std::uint32_t pc = 0;        // instruction that is next
    std::vector<double> slopes;  // beside `stack`, while a point of a curve is calculated
    std::vector<std::uint64_t> loop_counts;      // only with a trace
    const std::vector<std::uint32_t> all_given;  // by function: a call with every argument

    /// Where a function begins that gets these arguments: defaults are for those that it does not.
    std::uint32_t beginning_of(const sema::FunctionCode& function, std::size_t number,
                               std::uint32_t given) const {
        return given == all_given[number] ? function.body : function.entry;
    }

    /// Room for so many registers; it may move them.
    void reserve_stack(std::size_t slots) {
        if (stack.size() < slots) stack.resize(std::max(slots, 2 * stack.size()));
    }
};

/// Whether the program runs, and whether it has failed.
class RunStatus {
  public:
    bool is_running() const { return is_running_; }
    bool has_failed() const { return has_failed_; }

    void begin() {
        is_running_ = true;
        has_failed_ = false;
    }
    void finish() { is_running_ = false; }
    /// It counts as failed, but may go on.
    void note_failure() { has_failed_ = true; }
    void fail() {
        note_failure();
        finish();
    }

  private:
    bool is_running_ = false;
    bool has_failed_ = false;
};

/// A test that runs; only tests.cpp writes it.
struct TestAtWork {
    TestBench* bench = nullptr;            // null: it is none
    bool is_rejected = false;              // an assumption of a property does not hold
    std::vector<std::uint32_t> failed_at;  // expectations that have been reported
    std::string reason;                    // of the figure asked last
    SourceId reason_at;
};

struct Running {
    Running(const sema::Code& program, const nc::Dialect& dialect, const ExpandOptions& wanted,
            DiagnosticSink& messages);

    VirtualMachine vm;  // first: its members are what the instructions ask all the time
    Batch batch;
    ModalState modal;  // behind the block that was made last
    OpenScopes scopes;
    Recordings recordings;
    CurveAtWork curve;
    CornersInWork corners;
    ActiveCycle cycle;
    Budget budget;
    RunStatus status;
    TestAtWork test;
    ReportedInProgram reported;  // of the whole program; see also ModalState::reported
    ReportedAt reported_at;
    WrittenShapes shapes;

    const sema::Code& code;
    const nc::Dialect& target;
    ExpandOptions options;
    DiagnosticSink& sink;
};

/// The statement behind an instruction that makes blocks.
inline SourceId statement_of(const Instruction& instruction) {
    return {static_cast<std::uint32_t>(instruction.immediate.pair.second)};
}

}  // namespace kadr::expand
