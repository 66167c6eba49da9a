// noted_writes.cpp — what the program writes into the control, for who looks on: tool data,
// offsets, frames, timers, before and behind the write.
#include "macro/noted_writes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kadr::macro {

using nc::ControlInstruction;
using nc::FramePart;
using nc::SystemQuantity;
using nc::VariableRange;

namespace {

constexpr char kIndexSeparator = ',';

/// The indices as they were worked out, in place of what the program has: `$TC_DP6[R1,2]` is
/// `$TC_DP6[7,2]`. Axes and names of parts stay.
std::string with_indices(std::string_view written, std::span<const std::int64_t> indices, char open,
                         char close) {
    const std::size_t begin = written.find(open);
    if (begin == std::string_view::npos || written.back() != close) return std::string(written);
    std::string out(written.substr(0, begin + 1));
    const std::string_view inner = written.substr(begin + 1, written.size() - begin - 2);
    std::size_t index = 0;
    int depth = 0;
    std::size_t from = 0;
    const auto put = [&](std::string_view part) {
        if (index > 0) out += kIndexSeparator;
        const bool is_number = index < indices.size() && indices[index] >= 0;
        const bool is_name = !part.empty() && part.find_first_of("0123456789") == part.npos &&
                             part.find(open) == part.npos;
        if (is_number && !is_name) {
            // Of a datum of tools the last index is that of the edge as well.
            out += std::to_string(index == 0 ? indices[index] : indices[index] % nc::kDatum);
        } else {
            out += part;
        }
        ++index;
    };
    for (std::size_t i = 0; i < inner.size(); ++i) {
        if (inner[i] == open || inner[i] == '(') ++depth;
        if (inner[i] == close || inner[i] == ')') --depth;
        if (inner[i] != kIndexSeparator || depth != 0) continue;
        put(inner.substr(from, i - from));
        from = i + 1;
    }
    put(inner.substr(from));
    return out + close;
}

bool is_of_tool_offset(SystemQuantity quantity) {
    switch (quantity) {
        case SystemQuantity::LengthGeometry:
        case SystemQuantity::LengthWear:
        case SystemQuantity::RadiusGeometry:
        case SystemQuantity::RadiusWear:
        case SystemQuantity::CrossGeometry:
        case SystemQuantity::CrossWear:
        case SystemQuantity::ToolTip: return true;
        default: return false;
    }
}

}  // namespace

/// A system variable of the control as a variable of this name; vacant if it cannot be read.
ControlVariable ControlVariables::shown_state(const ControlInstruction& target,
                                              std::span<const std::int64_t> indices,
                                              std::string name) {
    ControlVariable out;
    out.name = std::move(name);
    out.kind = ControlVariable::Kind::Vacant;
    const auto take_number = [&](double number, nc::ValueType type) {
        out.number = number;
        out.kind = type == nc::ValueType::Int    ? ControlVariable::Kind::Int
                   : type == nc::ValueType::Bool ? ControlVariable::Kind::Bool
                                                 : ControlVariable::Kind::Real;
    };
    if (target.kind == ControlInstruction::Kind::Family) {
        ControlValue value;
        if (family(target.index, indices[0], value) == Answer::Value && value.is_number())
            take_number(value.number, nc::ValueType::Real);
        return out;
    }
    const auto quantity = static_cast<SystemQuantity>(target.index);
    control::ControlFrame whole;
    if (target.kind == ControlInstruction::Kind::SystemPart) {
        const auto axis = static_cast<Axis>(-indices[target.count - 1u] - 1);
        const FramePart part = target.part();
        const bool is_distance = part == FramePart::Shift || part == FramePart::Fine;
        if (frame(quantity, target.count > 1 ? indices[0] : 0, whole) != Answer::Value) return out;
        if (const auto value = part_of(whole, part, axis))
            take_number(*value / (is_distance ? axis_unit(axis) : 1), nc::ValueType::Real);
        return out;
    }
    if (target.type == nc::ValueType::Frame) {
        if (frame(quantity, indices[0], whole) != Answer::Value) return out;
        out.kind = ControlVariable::Kind::Text;
        out.text = names_.written(whole);
        return out;
    }
    if (target.type == nc::ValueType::Text) {
        if (text(quantity, indices[0], out.text) == Answer::Value)
            out.kind = ControlVariable::Kind::Text;
        return out;
    }
    double number = 0;
    if (system(quantity, indices[0], indices[1], number) == Answer::Value)
        take_number(number, target.type);
    return out;
}

std::vector<ControlVariable> ControlVariables::shown_data(bool is_of_tool, std::int64_t number) {
    std::vector<ControlVariable> out;
    std::vector<std::pair<SystemQuantity, std::int64_t>> known;
    for (std::size_t form = 0; form < language_.variables.size(); ++form) {
        const nc::VariableForm& family = language_.variables[form];
        if (!family.is_family) continue;
        for (const VariableRange& range : family.ranges) {
            const bool is_wanted = is_of_tool ? is_of_tool_offset(range.quantity)
                                              : range.quantity == SystemQuantity::WorkOffset;
            if (range.kind != VariableRange::Kind::System || !is_wanted) continue;
            for (std::int64_t at = range.first; at <= range.last; ++at) {
                const QuantityIndices indices = indices_of(range, at);
                const std::pair place(range.quantity, indices.second);
                if (indices.first != number || std::ranges::find(known, place) != known.end())
                    continue;
                known.push_back(place);
                ControlInstruction load;
                load.kind = ControlInstruction::Kind::Family;
                load.index = static_cast<std::uint32_t>(form);
                const std::array one = {at};
                out.push_back(shown_state(load, one, names_.in_family(family, at)));
            }
        }
    }
    return out;
}

bool ControlVariables::is_state(const ControlInstruction& target,
                                std::span<const std::int64_t> indices) const {
    if (target.kind == ControlInstruction::Kind::Family)
        return quantity_of(target.index, indices[0]) != SystemQuantity::None;
    return target.kind == ControlInstruction::Kind::System ||
           target.kind == ControlInstruction::Kind::SystemPart;
}

/// Data that a block writes (G10) are shown by the variables that have them; `step` notes what
/// became of them when the block is executed.
void NotedWrites::note_data(const nc::Block& block) {
    using nc::Function;
    struct Data {
        Function function;
        std::size_t number;  // parameter that chooses which offset
        bool is_of_tool;
    };
    static constexpr std::array kData = {
        Data{Function::WorkOffsetData, nc::parameter_of<Function::WorkOffsetData>("number"), false},
        Data{Function::ToolOffsetData, nc::parameter_of<Function::ToolOffsetData>("number"), true},
        Data{Function::LatheOffsetData, nc::parameter_of<Function::LatheOffsetData>("number"),
             true}};
    data_.clear();
    for (const Data& data : kData) {
        const nc::Invocation* const call = block.find(data.function);
        if (call == nullptr) continue;
        const std::int64_t number = std::llround(block.argument(*call, data.number));
        data_ = variables_.shown_data(data.is_of_tool, number);
        owner_ = {data.is_of_tool, number};
    }
}

void NotedWrites::report_data() {
    const std::vector<ControlVariable> before = std::move(data_);
    data_.clear();
    std::vector<ControlVariable> now = variables_.shown_data(owner_.is_of_tool, owner_.number);
    for (std::size_t i = 0; i < now.size() && i < before.size(); ++i) {
        if (now[i].number != before[i].number) variables_.note_change(before[i], std::move(now[i]));
    }
}

/// Writes a variable; what it is of the control's own state is noted if somebody looks on.
VariableFault NotedWrites::store(const CompiledLine& line, const nc::Reference& reference,
                                 std::span<const std::int64_t> indices, const ControlValue& value) {
    const Content content = evaluator_.content(value);
    if (!variables_.notes_changes() || !variables_.is_state(reference.load, indices))
        return variables_.store(reference.load, indices, value, content);
    const std::string_view written = std::string_view(line.text).substr(
        reference.span.begin, reference.span.end - reference.span.begin);
    std::string name = with_indices(written, indices, language_.index_open, language_.index_close);
    ControlVariable before = variables_.shown_state(reference.load, indices, name);
    VariableFault fault = variables_.store(reference.load, indices, value, content);
    if (fault.row == nullptr) {
        variables_.note_change(std::move(before),
                               variables_.shown_state(reference.load, indices, std::move(name)));
    }
    return fault;
}

}  // namespace kadr::macro
