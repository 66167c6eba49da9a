#include "nc/block.h"

#include "base/numbers.h"

namespace kadr::nc {

namespace {

constexpr std::array<std::string_view, kSlots> kSlotNames = {
    "X", "Y", "Z",    "A", "B", "C",  "U",  "V",  "W",  "I",  "J",
    "K", "R", "TURN", "F", "S", "AP", "RP", "AR", "I1", "J1", "K1"};

}  // namespace

std::string_view slot_name(Slot slot) { return kSlotNames[static_cast<std::size_t>(slot)]; }

namespace {

bool same_invocation(const Block& a, const Invocation& fa, const Block& b, const Invocation& fb) {
    if (fa.function != fb.function || fa.given != fb.given) return false;
    for (std::size_t i = 0; fa.given >> i != 0; ++i) {
        if ((fa.given >> i & 1u) == 0) continue;
        if (a.arguments[fa.first + i] != b.arguments[fb.first + i]) return false;
    }
    return true;
}

/// Both hold the same functions, in any order: the words of a block act together.
bool same_functions(const Block& a, const Block& b) {
    if (a.function_count != b.function_count) return false;
    std::uint32_t taken = 0;
    for (std::size_t i = 0; i < a.function_count; ++i) {
        bool found = false;
        for (std::size_t j = 0; j < b.function_count && !found; ++j) {
            if ((taken >> j & 1u) != 0) continue;
            if (!same_invocation(a, a.functions[i], b, b.functions[j])) continue;
            taken |= 1u << j;
            found = true;
        }
        if (!found) return false;
    }
    return true;
}

/// "IC", "DAC", "ACP"; empty: as the modal state has it.
std::string_view mode_of(const Block& block, Slot slot) {
    const bool is_incremental = (block.incremental & bit(slot)) != 0;
    if (slot == Slot::X && block.x_measure == XMeasure::Diameter)
        return is_incremental ? "DIC" : "DAC";
    if (slot == Slot::X && block.x_measure == XMeasure::Radius)
        return is_incremental ? "RIC" : "RAC";
    if (slot >= Slot::A && slot <= Slot::C) {
        switch (block.rotary_approach(static_cast<Axis>(slot))) {
            case RotaryApproach::AsProgrammed: break;
            case RotaryApproach::Shortest: return "DC";
            case RotaryApproach::Positive: return "ACP";
            case RotaryApproach::Negative: return "ACN";
        }
    }
    if (is_incremental) return "IC";
    return (block.absolute & bit(slot)) != 0 ? "AC" : "";
}

void describe_slot(const Block& block, Slot slot, std::string& out) {
    out += ' ';
    out += slot_name(slot);
    const std::string_view mode = mode_of(block, slot);
    if (!mode.empty()) out.append("=").append(mode).append("(");
    if (mode.empty() && slot_name(slot).size() > 1) out += '=';
    append_shortest(out, block.at(slot));
    if (!mode.empty()) out += ')';
}

void describe_invocation(const Block& block, const Invocation& invocation, std::string& out) {
    const FunctionInfo& function = info(invocation.function);
    out += function.name;
    const bool is_cycle =
        invocation.function == Function::Cycle || invocation.function == Function::CyclePreset;
    if (is_cycle) {
        out += '#';
        append_shortest(out, block.cycle);
    }
    if (invocation.given == 0 && block.text.empty()) return;
    std::string arguments;
    for (std::size_t i = 0; i < 32; ++i) {
        const bool is_text =
            i < function.parameters.size() && function.parameters[i].dimension == Dimension::Text;
        if ((invocation.given >> i & 1u) == 0 && !(is_text && !block.text.empty())) continue;
        if (!arguments.empty()) arguments += ", ";
        if (i < function.parameters.size()) {
            arguments += function.parameters[i].name;
        } else {
            append_shortest(arguments, static_cast<double>(i));
        }
        arguments += '=';
        if (is_text) {
            arguments += '"';
            arguments += block.text;
            arguments += '"';
        } else {
            append_shortest(arguments, block.arguments[invocation.first + i]);
        }
    }
    if (arguments.empty()) return;
    out += '(';
    out += arguments;
    out += ')';
}

}  // namespace

bool Block::add(Function function) {
    return add(function, info(function).parameters.size()) != nullptr;
}

Invocation* Block::add(Function function, std::size_t parameter_count) {
    if (function_count == kMaxInvocations) return nullptr;
    if (argument_count + parameter_count > kMaxArguments) return nullptr;
    Invocation& invocation = functions[function_count++];
    invocation = {function, argument_count, 0};
    argument_count = static_cast<std::uint8_t>(argument_count + parameter_count);
    return &invocation;
}

const Invocation* Block::find(Function function) const {
    for (std::size_t i = 0; i < function_count; ++i) {
        if (functions[i].function == function) return &functions[i];
    }
    return nullptr;
}

Function programmed_in(const Block& block, Group group) {
    if (group == Group::Motion && block.motion != Function::None) return block.motion;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (info(block.functions[i].function).group == group) return block.functions[i].function;
    }
    return Function::None;
}

const Invocation* Block::find(Fact fact) const {
    for (std::size_t i = 0; i < function_count; ++i) {
        if (has_fact(functions[i].function, fact)) return &functions[i];
    }
    return nullptr;
}

bool operator==(const Block& a, const Block& b) {
    if (a.kind != b.kind || a.motion != b.motion || a.given != b.given) return false;
    if (((a.incremental ^ b.incremental) & a.given) != 0) return false;
    if (((a.absolute ^ b.absolute) & a.given) != 0) return false;
    for (std::size_t i = 0; i < kSlots; ++i) {
        if ((a.given >> i & 1u) != 0 && a.values[i] != b.values[i]) return false;
    }
    if (!same_functions(a, b)) return false;
    const bool has_cycle =
        a.find(Function::Cycle) != nullptr || a.find(Function::CyclePreset) != nullptr;
    if (has_cycle && a.cycle != b.cycle) return false;
    if (a.x_measure != b.x_measure || a.rotary_approaches != b.rotary_approaches) return false;
    if (a.feed_along_arc != b.feed_along_arc || a.feed_of_all_axes != b.feed_of_all_axes)
        return false;
    return a.skip_level == b.skip_level && a.further_skip_levels == b.further_skip_levels &&
           a.number == b.number && a.text == b.text && a.comment == b.comment;
}

std::string describe(const Block& block) {
    std::string out;
    switch (block.kind) {
        case Block::Kind::Nc: break;
        case Block::Kind::Comment:
            return out.append("comment \"").append(block.comment).append("\"");
        case Block::Kind::Raw: return out.append("raw \"").append(block.text).append("\"");
        case Block::Kind::Label: return out.append("label ").append(block.text);
        case Block::Kind::Modal: return "modal";
        case Block::Kind::Position: out = "position"; break;
    }
    if (block.skip_level >= 0) {
        out += '/';
        append_shortest(out, block.skip_level);
    }
    if (block.number >= 0) {
        out += out.empty() ? "N" : " N";
        append_shortest(out, block.number);
    }
    if (block.motion != Function::None) {
        if (!out.empty()) out += ' ';
        out += info(block.motion).name;
    }
    for (std::size_t i = 0; i < kSlots; ++i) {
        if ((block.given >> i & 1u) != 0) describe_slot(block, static_cast<Slot>(i), out);
    }
    bool has_message = false;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (!out.empty()) out += " | ";
        describe_invocation(block, block.functions[i], out);
        has_message |= block.functions[i].function == Function::Message;
    }
    if (!block.text.empty() && !has_message) out.append(" \"").append(block.text).append("\"");
    if (!block.comment.empty()) {
        out += out.empty() ? "; " : " ; ";
        out += block.comment;
    }
    if (!out.empty() && out.front() == ' ') out.erase(0, 1);
    return out;
}

}  // namespace kadr::nc
