// shape_calls.cpp — cycles that work along a shape: its blocks come next, wherever they
// stand in the program or in another one.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "macro/named_shape.h"
#include "macro/program_state.h"
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
void Program::State::follow_shape(const Block& block, std::string_view text, const Place& place) {
    if (is_only_checking || has_ended) return;
    if (block.find(Function::CycleModal) != nullptr && !is_left_out(block))
        return keep_modal_shape(block, text, place);
    const nc::Invocation* const call = block.find(Function::Cycle);
    if (call == nullptr || is_left_out(block)) return;
    const nc::CycleInfo& cycle = dialect.cycles()[block.cycle];
    const auto argument_of = [&](int parameter) -> std::int64_t {
        return std::llround(block.argument(*call, static_cast<std::size_t>(parameter), -1));
    };
    if (names_contour(cycle)) {
        const std::optional<std::size_t> kind = nc::find_parameter(cycle.parameters, "kind");
        return keep_contour(block, kind ? argument_of(static_cast<int>(*kind)) : -1);
    }
    if (names_shape(cycle)) return follow_named_shape(block, text, place);
    if (!cycle.takes_shape()) return;
    const std::int64_t first = argument_of(cycle.roles.first_block);
    const std::int64_t last = argument_of(cycle.roles.last_block);
    if (first < 0 || last < 0) return;  // the interpreter says so
    Place begin;
    Place end;
    ProgramMap::Fault fault = map().find({"", first}, Direction::Both, place, begin);
    std::int64_t missing = first;
    if (fault == ProgramMap::Fault::None) {
        end = begin;
        missing = last;
        if (last != first) fault = map().find({"", last}, Direction::Forward, begin, end);
    }
    if (fault != ProgramMap::Fault::None) {
        lines.report_event(text,
                           LineFault{&diag::ShapeBlockMissing, {0, 1}, {std::to_string(missing)}});
        has_ended = true;
        return;
    }
    const bool is_followed = cycle.parameters.size() == 2;
    const bool is_next = begin.line.offset >= frame->here.offset &&
                         map().finds_nothing_between(frame->here, begin.line) && !is_followed;
    frame->repeats.push_back({begin.line, end.next, is_next ? end.next : frame->here, 1, true});
    frame->here = begin.line;
    frame->next_line = nullptr;
}

/// MCALL in front of such a cycle, or alone, which ends it.
void Program::State::keep_modal_shape(const Block& block, std::string_view text_of_line,
                                      const Place& place) {
    modal_shape.reset();
    const bool has_shape =
        block.find(Function::Cycle) != nullptr && names_shape(dialect.cycles()[block.cycle]);
    if (has_shape) modal_shape.emplace(ModalShape{block, std::string(text_of_line), place});
}

/// The interpreter calls the cycle behind every block that moves an axis.
void Program::State::follow_modal_shape(const Block& block) {
    constexpr nc::SlotMask kPlaces = nc::kTargetSlots | nc::kPolarSlots;
    const bool is_in_shape = std::ranges::any_of(
        frames, [](const std::unique_ptr<Frame>& each) { return each->call.is_shape; });
    if (is_only_checking || has_ended || is_in_shape || due) return;
    const bool is_alone = block.find(Function::RapidOnce) != nullptr;
    if ((block.given & kPlaces) == 0 || is_alone || is_left_out(block)) return;
    const ModalShape shape = *modal_shape;
    follow_named_shape(shape.block, shape.text, shape.place);
}

namespace {

std::vector<std::string> parts_of(std::string_view text) {
    std::vector<std::string> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(':'), text.size());
        if (end > 0) parts.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

}  // namespace

/// Of the cycles behind that name no contour themselves; it stays until another is named.
void Program::State::keep_contour(const Block& block, std::int64_t kind) {
    named_contour = NamedContour{parts_of(block.text), std::max<std::int64_t>(kind, 0)};
}

/// The contour along which a cycle works: the one that it names, or the one that was named before.
Program::State::NamedContour Program::State::contour_of(const Block& block) const {
    NamedContour contour;
    if (block.text.empty() && named_contour) {
        contour = *named_contour;
    } else {
        contour.parts = parts_of(block.text);
        contour.kind = static_cast<std::int64_t>(contour.parts.size() == 2 ? ContourPlace::Labels
                                                                           : ContourPlace::Program);
    }
    if (contour.kind == static_cast<std::int64_t>(ContourPlace::Named) && !contour.parts.empty()) {
        const std::string name = contour.parts[0];
        contour.parts = {std::string(kContourBegin) + name, std::string(kContourEnd) + name};
    }
    return contour;
}

/// The blocks of a shape that a cycle names: those of a program, or those between two labels of the
/// program that runs (`"BEGIN:END"`) or of another. They come next; behind them the cycle is
/// called.
void Program::State::follow_named_shape(const Block& block, std::string_view text_of_line,
                                        const Place& place) {
    const nc::Span whole{0, static_cast<std::uint32_t>(text_of_line.size())};
    const auto missing = [&](const DiagnosticRow& row, std::string what) {
        lines.report_fault(text_of_line, nc::LineFault{&row, whole, {std::move(what)}});
        has_ended = true;
    };
    NamedContour contour = contour_of(block);
    const auto kind = static_cast<ContourPlace>(contour.kind);
    PreparedCall call;
    call.is_shape = true;
    call.site = std::make_shared<nc::CallSite>(
        nc::CallSite{lines.place(text_of_line, place.line.line, whole), frame->site});
    call.unit = frame->unit;
    if (kind == ContourPlace::Program || kind == ContourPlace::ProgramLabels) {
        const std::string said = contour.parts.empty() ? std::string() : contour.parts[0];
        const std::string name =
            nc::program_of_path(language.calls, said, tables.notation.ignores_case);
        const std::string its_kind =
            nc::kind_of_path(language.calls, said, tables.notation.ignores_case);
        call.unit = name.empty() ? nullptr : units.find(name, text(), its_kind);
        if (call.unit == nullptr)
            return missing(diag::ProgramMissing,
                           quoted(name.empty() ? said : nc::shown_program(language.calls, name)));
        if (!contour.parts.empty()) contour.parts.erase(contour.parts.begin());
    }
    if (kind == ContourPlace::Program) {
        due = std::move(call);
        return;
    }
    contour.parts.resize(2);  // a label that nobody said is missing
    Place begin{call.unit->begin, call.unit->begin};
    Place end;
    for (const std::string& label : contour.parts) {
        const Place from = begin;
        Place& found = &label == &contour.parts[0] ? begin : end;
        if (call.unit->map.find({label, -1}, Direction::Forward, from, found) !=
            ProgramMap::Fault::None)
            return missing(diag::JumpTargetMissing, quoted(label));
    }
    call.from = begin;
    call.to = end.next;
    due = std::move(call);
}

}  // namespace kadr::macro
