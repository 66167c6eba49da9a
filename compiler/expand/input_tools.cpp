#include "expand/input_tools.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/diagnostics/dialect.h"
#include "expand/faults.h"
#include "expand/input_words.h"
#include "nc/parameters.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;

namespace {

constexpr std::size_t kTool = parameter_of_all<"tool", Function::ToolSelect, Function::Tool>();
constexpr std::size_t kLengthOffset = parameter_of<Function::LengthCompOn>("offset");

/// Whether the control has words such as `T0102`.
bool says_offset_with_tool(const nc::DialectTables& tables) {
    const auto& forms = tables.forms_of[static_cast<std::size_t>(Function::ToolSelect)];
    return std::ranges::any_of(forms, [&](const nc::FormId id) {
        return std::ranges::any_of(tables.forms[id].words, [](const nc::FormWord& word) {
            return word.tail_parameter >= 0;
        });
    });
}

/// The number of the length that acts behind the block; 0: none. Nothing: nobody knows.
std::optional<double> length_behind(const ModalState& modal, const Block& block) {
    bool is_on = modal[Group::LengthComp] == Function::LengthCompOn;
    std::optional<double> number = modal.length.offset();
    if (modal[Group::LengthComp] == Function::None) number.reset();
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Invocation& invocation = block.functions[i];
        static_assert(kLengthOffset == parameter_of<Function::LengthOffset>("offset"));
        const bool is_length = invocation.function == Function::LengthCompOn;
        if (is_length) is_on = true;
        if (invocation.function == Function::LengthCompOff) return 0;
        if ((is_length || invocation.function == Function::LengthOffset) &&
            invocation.has(kLengthOffset))
            number = block.argument(invocation, kLengthOffset);
    }
    if (!is_on && modal[Group::LengthComp] != Function::None) return 0;
    return number;
}

}  // namespace

Function name_length_axis(ModalState& modal, Block& block) {
    const std::optional<double> before = length_behind(modal, Block{});
    const std::optional<double> behind = length_behind(modal, block);
    if (before && behind && *before == *behind) return Function::None;
    // Where its axis is no length acts, and none is left to be taken off.
    if (modal.length.is_away() && behind == 0) return Function::None;
    const Function motion = block.motion != Function::None ? block.motion : modal[Group::Motion];
    const bool is_straight = motion == Function::Rapid || motion == Function::Line;
    const bool is_changed = block.find(Function::ToolChange) != nullptr;
    if (!is_straight || is_changed || (modal.position.known() & bit(Axis::Z)) == 0)
        return behind == 0 ? Function::LengthCompOff : Function::LengthCompOn;
    block.set(nc::Slot::Z, modal.position[index(Axis::Z)]);
    if (modal[Group::Distance] == Function::Incremental) block.absolute |= bit(nc::Slot::Z);
    return Function::None;
}

Done take_station(Running& run, Block& block, Invocation& select, std::uint32_t at) {
    constexpr std::size_t kOffset = parameter_of<Function::ToolSelect>("offset");
    if (!select.has(kOffset) || says_offset_with_tool(run.target.tables())) return kDone;
    const double tool = block.argument(select, kTool);
    const double offset = block.argument(select, kOffset);
    if (offset == tool) {
        become(block, select, Function::Tool, kTool, tool);
        return kDone;
    }
    const bool is_off = offset == 0 && run.modal.tool.in() == tool;
    if (is_off && run.target.can_write(Function::ToolEdge)) {
        become(block, select, Function::ToolEdge, kEdge, 0);
        return kDone;
    }
    if (is_off && run.target.can_write(Function::LengthCompOff)) {
        select.function = Function::LengthCompOff;
        select.given = 0;
        return kDone;
    }
    fault(run, diag::SourceOffset, at)
        .arg(run.target.name())
        .arg("tool " + std::to_string(std::llround(tool)) + " with the offset")
        .arg(std::to_string(std::llround(offset)))
        .fix("give the offset the number of its tool, or say `tool(n)`");
    return kFailed;
}

Done take_offsets_as_edges(Running& run, Block& block, std::uint32_t at) {
    // The tool that is in, not one that waits for its change; before the first change the one that
    // was called.
    const Invocation* select = block.find(Function::ToolSelect);
    const bool changes = block.find(Function::ToolChange) != nullptr;
    const bool is_called = select != nullptr && (changes || !run.modal.tool.in());
    const bool is_in = !is_called && !changes && run.modal.tool.in();
    const bool has_tool = is_called || is_in || run.modal.tool.called();
    const double tool = is_called ? block.argument(*select, kTool)
                        : is_in   ? run.modal.tool.in().value_or(0)
                                  : run.modal.tool.called().value_or(0);
    bool is_given = false;
    for (std::size_t i = 0; i < block.function_count;) {
        Invocation& invocation = block.functions[i];
        // `H2` alone is another offset of a length that acts already.
        const bool is_other_length = invocation.function == Function::LengthOffset;
        const bool is_length = invocation.function == Function::LengthCompOn || is_other_length;
        const bool is_off = invocation.function == Function::LengthCompOff;
        const bool is_radius = invocation.function == Function::RadiusOffset;
        if (!is_length && !is_off && !is_radius) {
            ++i;
            continue;
        }
        const bool acts =
            !is_other_length || (run.modal[Group::LengthComp] == Function::LengthCompOn &&
                                 block.find(nc::Fact::CallsEdge) == nullptr);
        // An edge that is switched off takes its radius along.
        const bool is_plain = run.modal[Group::RadiusComp] == Function::RadiusCompOff ||
                              block.find(Function::RadiusCompOff) != nullptr;
        static_assert(kLengthOffset == parameter_of<Function::RadiusOffset>("offset"));
        const double number = is_off ? 0 : block.argument(invocation, kLengthOffset, -1);
        static_assert(kLengthOffset == parameter_of<Function::LengthOffset>("offset"));
        const bool fits = acts && (number == 0 ? is_plain : has_tool && number == tool);
        if (!fits) {
            std::string shown = number < 0 ? "without H" : std::to_string(std::llround(number));
            if (is_off) shown.clear();
            auto builder = fault(run, diag::SourceOffset, at);
            builder.arg(run.target.name())
                .arg(is_length ? "the length offset"
                     : is_off  ? "the end of the length offset"
                               : "the radius offset")
                .arg(shown);
            builder.fix(is_off ? "switch the radius compensation off before it"
                               : "give the offset the number of its tool, or say `tool(n)`");
            return kFailed;
        }
        if (is_given) {
            erase(block, i);
            continue;
        }
        is_given = true;
        if (!is_radius) {  // what a `with` around it sets back
            run.modal.assume(Group::LengthComp,
                             number == 0 ? Function::LengthCompOff : Function::LengthCompOn);
            run.modal.length.take_offset(number != 0 ? std::optional(number) : std::nullopt);
        }
        become(block, invocation, Function::ToolEdge, kEdge, number == 0 ? 0 : 1);
        ++i;
    }
    return kDone;
}

namespace {

/// `D1` is the length of the tool that is in, `D0` none.
Done take_edge_as_length(Running& run, Block& block, Invocation& edge, std::uint32_t at) {
    const double number = block.argument(edge, kEdge);
    const Invocation* select = block.find(Function::ToolSelect);
    const bool changes = block.find(Function::ToolChange) != nullptr;
    // Of a tool that waits for its change the length must not act yet.
    const bool has_tool = changes ? select != nullptr || run.modal.tool.called()
                                  : select == nullptr && run.modal.tool.in();
    const double tool = !changes            ? run.modal.tool.in().value_or(0)
                        : select != nullptr ? block.argument(*select, kTool)
                                            : run.modal.tool.called().value_or(0);
    if (number == 0) {
        edge.function = Function::LengthCompOff;
        edge.given = 0;
        return kDone;
    }
    if (number != 1 || !has_tool) {
        fault(run, diag::SourceOffset, at)
            .arg(run.target.name())
            .arg("the edge")
            .arg(std::to_string(std::llround(number)))
            .fix("say `tool(n)`, which makes the length act on every control");
        return kFailed;
    }
    become(block, edge, Function::LengthCompOn, kLengthOffset, tool);
    return kDone;
}

}  // namespace

Done take_core_offsets(Running& run, Block& block, std::uint32_t at) {
    const bool by_tool = run.target.counts_offsets_by_tool();
    for (std::size_t i = 0; i < block.function_count; ++i) {
        Invocation& invocation = block.functions[i];
        if (run.target.can_write(invocation.function)) continue;
        switch (invocation.function) {
            case Function::LengthCompOn:
            case Function::LengthCompOff:
                if (!by_tool) return take_offsets_as_edges(run, block, at);
                break;
            case Function::ToolEdge:
                if (by_tool && !take_edge_as_length(run, block, invocation, at)) return kFailed;
                break;
            default: break;
        }
    }
    return kDone;
}

Done take_edges_as_offsets(Running& run, Block& block, std::uint32_t at) {
    for (std::size_t i = block.function_count; i-- > 0;) {
        if (block.functions[i].function != Function::ToolEdge) continue;
        const double edge = block.argument(block.functions[i], kEdge);
        const bool is_off = edge == 0 && block.find(Function::MachineCoordinates) != nullptr;
        // An edge that is switched off takes its radius along.
        const bool is_plain = run.modal[Group::RadiusComp] == Function::RadiusCompOff ||
                              block.find(Function::RadiusCompOff) != nullptr;
        if (edge == 0 && !is_off && is_plain && run.target.can_write(Function::LengthCompOff)) {
            block.functions[i].function = Function::LengthCompOff;
            block.functions[i].given = 0;
            run.modal.length.end();
            continue;
        }
        if (edge == 1 && run.modal.length.has_ended() && run.modal.tool.in() &&
            block.find(Function::ToolChange) == nullptr) {
            become(block, block.functions[i], Function::LengthCompOn, kLengthOffset,
                   run.modal.tool.in().value_or(0));
            run.modal.length.begin_again();
            continue;
        }
        if (edge != 1 && !is_off) {
            fault(run, diag::SourceOffset, at)
                .arg(run.target.name())
                .arg("the edge")
                .arg(std::to_string(std::llround(edge)))
                .fix(
                    "say what the target is to do where it is the target: `G49`, "
                    "`G43 H…`");
            return kFailed;
        }
        erase(block, i);
    }
    if (run.target.rules().tool_change_activates_length) return kDone;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (block.functions[i].function != Function::ToolChange) continue;
        const Invocation* select = block.find(Function::ToolSelect);
        if (select == nullptr && !run.modal.tool.called()) return kDone;
        const double tool = select != nullptr ? block.argument(*select, kTool)
                                              : run.modal.tool.called().value_or(0);
        become(block, block.functions[i], Function::Tool, kTool, tool);
        if (select != nullptr)
            erase(block, static_cast<std::size_t>(select - block.functions.data()));
        return kDone;
    }
    return kDone;
}

}  // namespace kadr::expand
