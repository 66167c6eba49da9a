// control_texts.cpp — texts that a program writes: into its own variables, and what of the control
// is one, the names of tools.
#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "macro/control_variables.h"

namespace kadr::macro {

using nc::Quantity;

/// What a variable of texts gets: a character or a truth value is written out. S 8.2.
std::string ControlVariables::written_text(const Value& value, std::string_view text) {
    if (value.kind == Value::Kind::Char) return value.character();
    if (value.kind == Value::Kind::Bool) return value.number != 0 ? "1" : "0";
    return std::string(text);
}

ControlVariables::Fault ControlVariables::store_text(Quantity quantity, std::int64_t index,
                                                     const Value& value, std::string_view text) {
    const std::string name(info(quantity).name);
    if (info(quantity).access == nc::QuantityInfo::Access::Read)
        return {&diag::VariableReadOnly, {name}};
    if (state_ == nullptr) return {&diag::IsoNotSupported, {name}};
    Value converted = value;
    if (Fault fault = convert(nc::ValueType::Text, converted, text); fault.row != nullptr)
        return fault;
    const std::string written = written_text(value, text);
    const auto most = static_cast<std::size_t>(language_.rules.most_tool_name);
    if (const std::size_t length = count_code_points(written); length > most)
        return {&diag::TextTooLong, {std::to_string(length), std::to_string(most)}};
    if (written.empty() && quantity == Quantity::ToolNameOf) return {&diag::ToolNameEmpty, {}};
    switch (state_->set_text(quantity, index, written)) {
        case ControlAccess::Write::Done: return {};
        case ControlAccess::Write::NoSuchEntry: return {&diag::VariableNumber, {"of this tool"}};
        case ControlAccess::Write::TooLarge:
        case ControlAccess::Write::Refused: break;
    }
    return {&diag::IsoNotSupported, {name}};
}

}  // namespace kadr::macro
