#include "macro/fixed_targets.h"

#include <cmath>

namespace kadr::macro {

using nc::ControlInstruction;
using nc::Statement;

namespace {

/// 10 to the power of so many digits.
std::int64_t power_of_ten(int digits) {
    std::int64_t out = 1;
    for (int i = 0; i < digits; ++i) out *= 10;
    return out;
}

/// The one instruction that an expression is; nullptr: it has more, or none.
const ControlInstruction* only_step(const nc::ControlLine& line, const nc::Expression& value) {
    return value.count == 1 ? &line.code[value.first] : nullptr;
}

}  // namespace

Direction direction_of(Statement jump) {
    return jump == Statement::JumpForward    ? Direction::Forward
           : jump == Statement::JumpBackward ? Direction::Backward
                                             : Direction::Both;
}

LineTarget target_named(const nc::ControlWords& words, std::string_view text) {
    LineTarget out;
    out.label = words.normal(text);
    out.number = words.block_number(out.label);
    if (out.number >= 0) out.label.clear();
    return out;
}

std::optional<LineTarget> block_numbered(const nc::DialectTables& tables, double number) {
    if (number != std::floor(number) || number < 1 ||
        number > static_cast<double>(tables.block_numbers.most))
        return std::nullopt;
    return LineTarget{{}, static_cast<std::int64_t>(number)};
}

std::optional<LineTarget> fixed_target(const nc::DialectTables& tables, const nc::ControlLine& line,
                                       const nc::JumpTarget& target) {
    using Kind = nc::JumpTarget::Kind;
    switch (target.kind) {
        case Kind::None: return std::nullopt;
        case Kind::Number: return LineTarget{{}, target.number};
        case Kind::Label: return LineTarget{target.label, target.number};
        case Kind::Computed: break;
    }
    if (const auto text = fixed_text(line, target.value))
        return target_named(nc::ControlWords(tables, *text), *text);
    const ControlInstruction* const step = only_step(line, target.value);
    const bool is_number = step != nullptr && step->kind == ControlInstruction::Kind::Number;
    return is_number ? block_numbered(tables, step->number) : std::nullopt;
}

std::optional<NumberedProgram> program_numbered(double number, int split) {
    if (number != std::floor(number) || !(number >= 1 && number < 1e12)) return std::nullopt;
    NumberedProgram out;
    auto whole = static_cast<std::int64_t>(number);
    if (split > 0 && whole >= power_of_ten(split)) {
        out.passes = whole / power_of_ten(split);
        whole %= power_of_ten(split);
    }
    out.name = std::to_string(whole);
    return out;
}

int split_of(const nc::CallForm* form, const nc::Call& call) {
    return form == nullptr || call.repeats.is_given ? 0 : form->split;
}

std::optional<double> fixed_number(const nc::ControlLine& line, const nc::CallValue& value) {
    if (!value.is_given) return std::nullopt;
    if (value.is_plain) return value.decimal.value;
    const ControlInstruction* const step = only_step(line, value.value);
    const bool is_number = step != nullptr && step->kind == ControlInstruction::Kind::Number;
    return is_number ? std::optional(std::round(step->number)) : std::nullopt;
}

std::optional<std::string> fixed_text(const nc::ControlLine& line, const nc::Expression& value) {
    const ControlInstruction* const step = only_step(line, value);
    const bool is_text = step != nullptr && step->kind == ControlInstruction::Kind::Text;
    return is_text ? std::optional(line.texts[step->index]) : std::nullopt;
}

}  // namespace kadr::macro
