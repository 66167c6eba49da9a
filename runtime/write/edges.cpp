// Where the length of a tool does not act, and where it acts again.
#include <algorithm>
#include <span>

#include "write/block_writer.h"

namespace kadr::write {

/// The edge that a block in machine coordinates put aside acts again where the tool moves next.
void BlockWriter::write_waiting_edge(const Block& block, std::string& out) {
    const bool is_machine = block.find(Fact::AtMachinePosition) != nullptr;
    const bool moves = (block.given & kTargetSlots) != 0 || block.find(Function::Cycle) != nullptr;
    if (is_machine || !moves || block.find(Function::ToolEdge) != nullptr) return;
    put_waiting_edge(block, out);
}

/// In a line that nobody leaves out, whatever the block beside it is.
void BlockWriter::put_waiting_edge(const Block& block, std::string& out) {
    Block edge;
    edge.source = block.source;
    Invocation* invocation = edge.add(Function::ToolEdge, 1);
    edge.set_argument(*invocation, parameter_of<Function::ToolEdge>("edge"),
                      state_.call_waiting_edge());
    const WrittenPosition position = modal_.position;
    write_block(edge, out);
    state_.edge_is_given(position);
}

/// The length comes with the first motion along it: a motion there would be travelled less the
/// length.
void BlockWriter::check_length_due(const Block& block) {
    const std::size_t along = text_.plane_axes()[2];
    const bool is_other = block.find(Fact::AtMachinePosition) != nullptr;
    if (is_other || !block.has(static_cast<Slot>(along))) return;
    state_.length_acts();
    if (!text_.is_distance(block, along)) return;
    messages_.cannot_express(block, "a distance along " + std::string(kAxisNames[along]) +
                                        " behind a move without the tool's length");
}

/// Where the tool length would act in machine coordinates, edge 0 stands beside them.
void BlockWriter::add_edge(const Block& block, Items& items) {
    if (block.function_count == 0 || block.find(Function::ToolEdge) != nullptr) return;
    for (std::size_t i = 0; i < items.count; ++i) {
        const Item& item = items.list[i];
        if (item.form == kNoForm || !tables_.forms[item.form].keeps_length) continue;
        const NumberInForce old = state_.drop_edge();
        if (old.is_known && old.value == 0) return;
        const auto& edges = tables_.forms_of[static_cast<std::size_t>(Function::ToolEdge)];
        if (edges.empty()) return;
        if (old.is_known) state_.let_wait(old.value);
        if (!old.is_known && modal_.edge.is_lost && modal_.edge.waiting == 0)
            messages_.cannot_express(
                block,
                "a move without tool length, while nobody knows which cutting edge "
                "acts (say `D1` before it),");
        items.add(Item::of_edge(tables_.forms[edges[0]].order, 0));
        return;
    }
}

/// `G43 H1`, `G49`, `H2` of the block; null: it has none.
static const Invocation* length_in(const Rules& rules, const Block& block) {
    const Invocation* length = nullptr;
    for (const Effect& effect : effects_of(rules, block, nc::Changer::Magazine)) {
        const bool is_length =
            effect.kind == EffectKind::ChangesLength || effect.kind == EffectKind::SelectsLength;
        if (is_length) length = &effect.invocation_in(block);
    }
    return length;
}

/// Whether the block changes a length that its program travels with the next move of the axis, and
/// the control at once.
bool BlockWriter::holds_length(const Block& block) const {
    const bool is_move = block.has(Slot::Z) || block.find(Function::Cycle) != nullptr;
    if (block.function_count == 0 || is_move) return false;
    const bool has_length =
        modal_.text_of(Group::LengthComp) != Function::LengthCompOff || modal_.edge.is_end_due ||
        std::ranges::any_of(state_.pending(),
                            [](const Pending& pending) { return pending.deferred->axis >= 0; });
    const Invocation* length = length_in(rules_, block);
    if (length == nullptr) return false;
    // `G43` without a number is the control's own matter.
    return length->function == Function::LengthCompOn
               ? length->has(parameter_of<Function::LengthCompOn>("offset"))
               : has_length;
}

/// The words of the length wait for the block that moves the axis.
void BlockWriter::write_without_length(const Block& block, std::string& out) {
    const auto of_axis = std::ranges::find_if(
        tables_.deferred, [](const Deferred& deferred) { return deferred.axis >= 0; });
    if (block.skip_level >= 0 || of_axis == tables_.deferred.end()) {
        messages_.cannot_express(
            block, "a change of the tool length in a block that moves no axis along it");
        return;
    }
    Block rest = block;
    rest.length_waits = false;
    rest.function_count = 0;
    const Invocation* length = length_in(rules_, block);
    for (const Invocation& invocation : std::span(block.functions).first(block.function_count))
        if (&invocation != length) rest.functions[rest.function_count++] = invocation;
    write_long(rest, out);
    const bool is_end = length->function == Function::LengthCompOff ||
                        (length->function == Function::LengthOffset && modal_.edge.is_end_due);
    constexpr std::size_t kNumber = parameter_of<Function::LengthCompOn>("offset");
    static_assert(kNumber == parameter_of<Function::LengthOffset>("offset"));
    state_.hold_length(block, is_end ? nullptr : &*of_axis,
                       is_end ? 0 : block.argument(*length, kNumber));
}

}  // namespace kadr::write
