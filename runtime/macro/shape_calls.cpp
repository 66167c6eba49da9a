// shape_calls.cpp — cycles that work along a shape: its blocks come next, wherever they
// stand in the program or in another one.
#include "macro/shape_calls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "macro/named_shape.h"
#include "macro/program_run.h"
#include "nc/parameters.h"
#include "nc/quoted.h"

namespace kadr::macro {

using nc::Block;
using nc::Function;
using nc::LineFault;
using nc::quoted;

/// A cycle that works along a shape is followed by the blocks of the shape, wherever they stand;
/// then the program goes on with the block behind the cycle. Where that is the shape itself, and
/// the cycle works something out of it, it goes on behind the shape.
void ShapeCalls::follow(const Block& block, std::string_view text, const ProgramLine& line) {
    if (run_.phase.is_only_checking || run_.phase.has_ended) return;
    if (block.find(Function::CycleModal) != nullptr && !run_.is_left_out(block))
        return keep_modal_shape(block, text, line);
    const nc::Invocation* const call = block.find(Function::Cycle);
    if (call == nullptr || run_.is_left_out(block)) return;
    const nc::CycleInfo& cycle = run_.dialect.cycles()[block.cycle];
    const auto argument_of = [&](int parameter) -> std::int64_t {
        return std::llround(block.argument(*call, static_cast<std::size_t>(parameter), -1));
    };
    // It stays until another is named, for the cycles behind that name none themselves.
    if (names_contour(cycle)) {
        named_ = contour_named_by(block, cycle);
        return;
    }
    if (names_shape(cycle)) return follow_named_shape(block, text, line);
    if (!cycle.takes_shape()) return;
    const std::int64_t first = argument_of(cycle.roles.first_block);
    const std::int64_t last = argument_of(cycle.roles.last_block);
    if (first < 0 || last < 0) return;  // the interpreter reports it
    ProgramLine begin;
    ProgramLine end;
    ProgramMap::Fault fault = run_.map().find({"", first}, Direction::Both, line, begin);
    std::int64_t missing = first;
    if (fault == ProgramMap::Fault::None) {
        end = begin;
        missing = last;
        if (last != first) fault = run_.map().find({"", last}, Direction::Forward, begin, end);
    }
    if (fault != ProgramMap::Fault::None) {
        run_.lines.report_event(
            text, LineFault{&diag::ShapeBlockMissing, {0, 1}, {std::to_string(missing)}});
        run_.end();
        return;
    }
    const bool is_followed = cycle.parameters.size() == 2;
    const bool is_next = begin.line.offset >= run_.frame->here.offset &&
                         run_.map().finds_nothing_between(run_.frame->here, begin.line) &&
                         !is_followed;
    run_.show_way(WayTaken::Kind::Repeat, line.line, *run_.frame->unit, begin.line);
    run_.show_way(WayTaken::Kind::Repeat, line.line, *run_.frame->unit, end.line);
    run_.frame->repeats.push_back(
        {begin.line, end.next, is_next ? end.next : run_.frame->here, 1, true});
    run_.frame->here = begin.line;
    run_.frame->next_line = nullptr;
}

/// MCALL in front of such a cycle, or alone, which ends it.
void ShapeCalls::keep_modal_shape(const Block& block, std::string_view text_of_line,
                                  const ProgramLine& line) {
    modal_.reset();
    const bool has_shape =
        block.find(Function::Cycle) != nullptr && names_shape(run_.dialect.cycles()[block.cycle]);
    if (has_shape) modal_.emplace(ModalShape{block, std::string(text_of_line), line});
}

/// The interpreter calls the cycle behind every block that moves an axis.
void ShapeCalls::follow_modal(const Block& block) {
    constexpr nc::SlotMask kPlaces = nc::kTargetSlots | nc::kPolarSlots;
    const bool is_in_shape = std::ranges::any_of(
        run_.frames,
        [](const std::unique_ptr<RunningProgram>& each) { return each->call.is_shape; });
    if (run_.phase.is_only_checking || run_.phase.has_ended || is_in_shape ||
        run_.modal_calls.has_due())
        return;
    const bool is_alone = block.find(Function::RapidOnce) != nullptr;
    if ((block.given & kPlaces) == 0 || is_alone || run_.is_left_out(block)) return;
    const ModalShape shape = *modal_;
    follow_named_shape(shape.block, shape.text, shape.program_line);
}

/// The contour along which a cycle works: the one that it names, or the one that was named before.
NamedContour ShapeCalls::contour_of(const Block& block) const {
    if (block.text.empty() && named_) return with_labels(*named_);
    return contour_named_by(block, run_.dialect.cycles()[block.cycle]);
}

/// The blocks of a shape that a cycle names: those of a program, or those between two labels of the
/// program that runs (`"BEGIN:END"`) or of another. They come next; behind them the cycle is
/// called.
void ShapeCalls::follow_named_shape(const Block& block, std::string_view text_of_line,
                                    const ProgramLine& line) {
    const nc::Span whole{0, static_cast<std::uint32_t>(text_of_line.size())};
    const auto missing = [&](const DiagnosticRow& row, std::string what) {
        run_.lines.report_fault(text_of_line, nc::LineFault{&row, whole, {std::move(what)}});
        run_.end();
    };
    NamedContour contour = contour_of(block);
    const ContourSource kind = contour.kind;
    PreparedCall call;
    call.is_shape = true;
    call.site = std::make_shared<nc::CallSite>(
        nc::CallSite{run_.lines.location(text_of_line, line.line.line, whole), run_.frame->site});
    call.unit = run_.frame->unit;
    if (kind == ContourSource::Program || kind == ContourSource::ProgramLabels) {
        const std::string text = contour.parts.empty() ? std::string() : contour.parts[0];
        const std::string name =
            nc::program_of_path(run_.language.calls, text, run_.tables.notation.ignores_case);
        const std::string its_kind =
            nc::kind_of_path(run_.language.calls, text, run_.tables.notation.ignores_case);
        call.unit = name.empty() ? nullptr : run_.units.find(name, run_.text(), its_kind);
        if (call.unit == nullptr)
            return missing(
                diag::ProgramMissing,
                quoted(name.empty() ? text : nc::shown_program(run_.language.calls, name)));
        if (!contour.parts.empty()) contour.parts.erase(contour.parts.begin());
        if (!block.text.empty() && !modal_)
            run_.show_way(WayTaken::Kind::Call, line.line, *call.unit, call.unit->begin);
    }
    if (kind == ContourSource::Program) {
        run_.modal_calls.make_due(std::move(call));
        return;
    }
    contour.parts.resize(2);  // a label that nobody gave is missing
    ProgramLine begin{call.unit->begin, call.unit->begin};
    ProgramLine end;
    for (const std::string& label : contour.parts) {
        const ProgramLine from = begin;
        ProgramLine& found = &label == &contour.parts[0] ? begin : end;
        if (call.unit->map.find({label, -1}, Direction::Forward, from, found) !=
            ProgramMap::Fault::None)
            return missing(diag::JumpTargetMissing, quoted(label));
    }
    call.from = begin;
    call.to = end.next;
    if (!block.text.empty() && !modal_) {
        run_.show_way(WayTaken::Kind::Repeat, line.line, *call.unit, begin.line);
        run_.show_way(WayTaken::Kind::Repeat, line.line, *call.unit, end.line);
    }
    run_.modal_calls.make_due(std::move(call));
}

}  // namespace kadr::macro
