// skipped.cpp — blocks that the operator may leave out: what cannot stand in one.
//
// What is left of such a block behind it belongs to one of three kinds. Modal codes, F and S are
// said again by the output (expand/unknown.cpp, nc/block_writer.cpp); the spindle, the coolant and
// M functions are the operator's choice; the rest is refused here.
#include "base/diagnostics/sema.h"
#include "nc/frame_words.h"
#include "sema/checker.h"

namespace kadr::sema {

namespace {

/// Whether the function leaves something behind its block that no modal code says again: frames,
/// offsets, tools, units, limits and tolerances, measured places, words of cycles.
bool stays_unsaid(nc::Function function) {
    using nc::Function;
    if (nc::changes_frame(function)) return true;
    switch (function) {
        case Function::SetPosition:
        case Function::WorkOffset:
        case Function::WorkOffsetData:
        case Function::ToolOffsetData:
        case Function::LatheOffsetData:
        case Function::OffsetToEdge:
        case Function::OffsetToMiddle:
        case Function::Tool:
        case Function::ToolSelect:
        case Function::ToolChange:
        case Function::ToolEdge:
        case Function::LengthCompOn:
        case Function::LengthCompOff:
        case Function::LengthOffset:
        case Function::Inch:
        case Function::Metric:
        case Function::SpeedLimit:
        case Function::CompAllowance:
        case Function::CompDepth:
        case Function::CompCornerPointed:
        case Function::BlendFeedDistance:
        case Function::BlendRapidDistance:
        case Function::PathTolerance:
        case Function::OrientTolerance:
        case Function::HighSpeed:
        case Function::CyclePreset:
        case Function::CycleModal:
        case Function::Cycle: return true;
        default: return false;
    }
}

}  // namespace

/// What stands behind a block that the operator may leave out must mean the same with and without
/// it; a frame or a tool that is there or not changes all of it.
void Checker::check_skipped(const Plan& plan, std::span<const syntax::Word> words) {
    for (const nc::Invocation& invocation : plan.functions) {
        if (!stays_unsaid(invocation.function)) continue;
        report(diag::SkipState, words[0].range).arg(nc::info(invocation.function).name);
        return;
    }
}

}  // namespace kadr::sema
