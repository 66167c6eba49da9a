#include "macro/evaluator.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/text.h"
#include "base/units.h"

namespace kadr::macro {

using nc::ControlInstruction;
using nc::Operation;

namespace {

/// The nearest whole number; what is too large for any index stays too large.
std::int64_t index_of(double value) {
    return static_cast<std::int64_t>(std::round(std::clamp(value, -1e15, 1e15)));
}

/// Sine of degrees, exact where the circle crosses its axes.
double sine(double degrees) {
    const double turned = std::fmod(degrees, 360.0);
    if (turned == 0 || std::fabs(turned) == 180) return 0;
    if (turned == 90 || turned == -270) return 1;
    if (turned == 270 || turned == -90) return -1;
    return std::sin(rad_from_deg(turned));
}

double cosine(double degrees) { return sine(std::fmod(degrees, 360.0) + 90); }

/// Whole but for the last bits: 6101.9999999999991 is 6102.
double truncated_near(double value) {
    const double nearest = std::round(value);
    const double tolerance = 1e-12 * std::max(1.0, std::fabs(value));
    return std::fabs(value - nearest) <= tolerance ? nearest : std::trunc(value);
}

/// A whole number of 32 bits; false: it is too large.
bool whole(double value, std::int32_t& out) {
    const double rounded = std::round(value);
    // Bit patterns with the first bit set may be written as large numbers.
    if (!(rounded >= -2147483648.0 && rounded <= 4294967295.0)) return false;
    out = static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(rounded)));
    return true;
}

}  // namespace

Evaluator::Outcome Evaluator::run(const nc::ControlLine& line, const nc::Expression& expression,
                                  ControlValue& out, int decimals) {
    const Outcome outcome = execute(line, expression, decimals);
    if (outcome == Outcome::Done) out = stack_[0];
    return outcome;
}

Evaluator::Outcome Evaluator::execute(const nc::ControlLine& line, const nc::Expression& expression,
                                      int decimals) {
    size_ = 0;
    is_later_ = false;
    if (stack_.size() < expression.count + 1) stack_.resize(expression.count + 8);
    const std::size_t end = expression.first + expression.count;
    for (std::size_t at = expression.first; at < end; ++at) {
        const ControlInstruction& instruction = line.code[at];
        Done is_fine = kDone;
        if (instruction.kind == ControlInstruction::Kind::Number) {
            push(ControlValue::of(instruction.number, instruction.type));
        } else if (instruction.kind == ControlInstruction::Kind::Operate) {
            const bool is_sign = expression.keeps_vacant && at + 1 == end;
            if (is_sign && stack_[size_ - 1].is_vacant()) continue;
            place_ = line.spans[at];
            is_fine = operate(instruction, decimals);
        } else {
            place_ = line.spans[at];
            is_fine = load(line, at);
        }
        if (!is_fine) return is_later_ ? Outcome::Later : Outcome::Fault;
    }
    return Outcome::Done;
}

Evaluator::Outcome Evaluator::indices(const nc::ControlLine& line, const nc::Reference& reference,
                                      std::span<std::int64_t> out) {
    const Outcome outcome = execute(line, reference.indices, -1);
    if (outcome != Outcome::Done) return outcome;
    for (std::size_t i = 0; i < size_ && i < out.size(); ++i) {
        if (!stack_[i].is_number() && stack_[i].kind != ControlValue::Kind::Axis) {
            note_fault(diag::IndexType, {std::string(kind_name(stack_[i]))});
            return Outcome::Fault;
        }
        out[i] = stack_[i].spindle().value_or(index_of(stack_[i].number));
    }
    return Outcome::Done;
}

void Evaluator::note_fault(const DiagnosticRow& row, std::vector<std::string> arguments) {
    fault_ = nc::LineFault{&row, place_, std::move(arguments)};
}

Done Evaluator::fail(const DiagnosticRow& row, std::vector<std::string> arguments) {
    note_fault(row, std::move(arguments));
    return kFailed;
}

Done Evaluator::load(const nc::ControlLine& line, std::size_t at) {
    const ControlInstruction& instruction = line.code[at];
    const auto from = [&](const Store& store) {
        ControlValue value = store.values[instruction.index];
        if (value.is_vacant() && !rules_.has_vacant) value = ControlValue::of(0, instruction.type);
        push(keep(value, store.content(value)));
        return kDone;
    };
    switch (instruction.kind) {
        case ControlInstruction::Kind::Global: return from(globals_);
        case ControlInstruction::Kind::Local: return from(level_->locals);
        case ControlInstruction::Kind::Text:
            push(keep_text(line.texts[instruction.index]));
            return kDone;
        case ControlInstruction::Kind::Vacant: push({}); return kDone;
        case ControlInstruction::Kind::Family: return load_family(instruction);
        case ControlInstruction::Kind::System: return load_system(instruction);
        case ControlInstruction::Kind::Input: return load_input(instruction);
        case ControlInstruction::Kind::Element: return load_element(instruction);
        case ControlInstruction::Kind::SystemPart:
        case ControlInstruction::Kind::ElementPart: return load_frame_part(instruction);
        case ControlInstruction::Kind::Number:
        case ControlInstruction::Kind::Operate: break;
    }
    return kFailed;
}

Done Evaluator::answer(Variables::Answer answer) {
    switch (answer) {
        case Variables::Answer::Value: return kDone;
        case Variables::Answer::Later: is_later_ = true; return kFailed;
        case Variables::Answer::Missing: return fail(diag::VariableNumber, {"with this index"});
        case Variables::Answer::NotReadable:
            return fail(diag::VariableWriteOnly, {"this variable"});
        case Variables::Answer::Compensated:
            return fail(diag::IsoNotSupported,
                        {"the position of the tool under cutter radius compensation"});
        case Variables::Answer::Unsupported:
            return fail(diag::IsoNotSupported, {"this system variable"});
    }
    return kFailed;
}

Done Evaluator::load_family(const ControlInstruction& instruction) {
    const double number = stack_[size_ - 1].number;
    if (!stack_[size_ - 1].is_number())
        return fail(diag::TypesDiffer, {"an index", std::string(kind_name(stack_[size_ - 1]))});
    if (!(std::fabs(number) < 1e9)) return fail(diag::VariableNumber, {format_shortest(number)});
    ControlValue value;
    const auto answered =
        variables_.family(instruction.index, static_cast<std::int64_t>(std::round(number)), value);
    const auto named = [&] {
        return variables_.named(instruction.index, static_cast<std::int64_t>(std::round(number)));
    };
    if (answered == Variables::Answer::Missing) return fail(diag::VariableNumber, {named()});
    if (answered == Variables::Answer::Unsupported) return fail(diag::IsoNotSupported, {named()});
    if (answered == Variables::Answer::NotReadable) return fail(diag::VariableWriteOnly, {named()});
    stack_[size_ - 1] = value;
    return answer(answered);
}

Done Evaluator::load_input(const ControlInstruction& instruction) {
    size_ -= instruction.count;
    std::array<std::int64_t, 4> indices{};
    for (std::size_t i = 0; i < instruction.count; ++i) {
        const ControlValue& index = stack_[size_ + i];
        if (!index.is_number() && index.kind != ControlValue::Kind::Axis)
            return fail(diag::IndexType, {std::string(kind_name(index))});
        indices[i] = index_of(index.number);
    }
    ControlValue value;
    std::string text;
    const auto answered = variables_.input(
        instruction.index, std::span(indices).first(instruction.count), value, text);
    push(value.is_text() ? keep_text(std::move(text)) : value);
    return answer(answered);
}

Done Evaluator::load_system(const ControlInstruction& instruction) {
    size_ -= instruction.count;
    const auto index = [&](std::size_t i) {
        if (i >= instruction.count) return std::int64_t{0};
        const ControlValue& value = stack_[size_ + i];
        return value.spindle().value_or(index_of(value.number));
    };
    const auto quantity = static_cast<nc::SystemQuantity>(instruction.index);
    if (instruction.type == nc::ValueType::Frame) {
        control::ControlFrame frame;
        const auto answered = variables_.frame(quantity, index(0), frame);
        push(keep_frame(frame));
        return answer(answered);
    }
    if (instruction.type == nc::ValueType::Text) {
        std::string text;
        const auto answered = variables_.text(quantity, index(0), text);
        push(keep_text(std::move(text)));
        return answer(answered);
    }
    double number = 0;
    const auto answered = variables_.system(quantity, index(0), index(1), number);
    push(ControlValue::of(number, instruction.type));
    return answer(answered);
}

/// The frame, then its component: the axis is the last index.
Done Evaluator::load_frame_part(const ControlInstruction& instruction) {
    const ControlValue axis = stack_[--size_];
    ControlInstruction whole = instruction;
    whole.kind = instruction.kind == ControlInstruction::Kind::SystemPart
                     ? ControlInstruction::Kind::System
                     : ControlInstruction::Kind::Element;
    whole.type = nc::ValueType::Frame;
    --whole.count;
    const Done is_fine =
        whole.kind == ControlInstruction::Kind::System ? load_system(whole) : load_element(whole);
    if (!is_fine) return kFailed;
    const control::ControlFrame& from = *frame(stack_[--size_]);
    const nc::FramePart part = instruction.part();
    const auto value = part_of(from, part, *axis.axis());
    if (!value) return fail(diag::IsoNotSupported, {"a component of a frame that shears"});
    const bool is_distance = part == nc::FramePart::Shift || part == nc::FramePart::Fine;
    push(ControlValue::real(is_distance ? *value / variables_.axis_unit(*axis.axis()) : *value));
    return kDone;
}

std::optional<std::uint32_t> Evaluator::element(const nc::ControlSymbol& symbol,
                                                std::span<const std::int64_t> indices) {
    std::uint32_t index = 0;
    for (std::size_t i = 0; i < symbol.dimensions; ++i) {
        if (indices[i] < 0 || indices[i] >= symbol.sizes[i]) return std::nullopt;
        index = index * symbol.sizes[i] + static_cast<std::uint32_t>(indices[i]);
    }
    return symbol.slot + index;
}

std::string Evaluator::wrong_index(const nc::ControlSymbol& symbol,
                                   std::span<const std::int64_t> indices) {
    std::size_t index = 0;
    while (index + 1 < symbol.dimensions && indices[index] >= 0 &&
           indices[index] < symbol.sizes[index])
        ++index;
    const std::string name = '`' + symbol.name + '`';
    return index == 0 ? name : name + " in place " + std::to_string(index + 1);
}

Done Evaluator::load_element(const ControlInstruction& instruction) {
    const nc::ControlSymbol& symbol = level_->symbols.at(instruction.index);
    std::array<std::int64_t, 4> indices{};
    size_ -= instruction.count;
    for (std::size_t i = 0; i < instruction.count; ++i) {
        if (!stack_[size_ + i].is_number())
            return fail(diag::IndexType, {std::string(kind_name(stack_[size_ + i]))});
        indices[i] = index_of(stack_[size_ + i].number);
    }
    const auto slot = element(symbol, indices);
    if (!slot) return fail(diag::IndexWrong, {wrong_index(symbol, indices)});
    const Store& store = *level_->stores[instruction.index];
    ControlValue value = store.values[*slot];
    if (symbol.type == nc::ValueType::Frame) {
        push(keep_frame(value.is_frame() ? store.frames[value.text] : control::ControlFrame()));
        return kDone;
    }
    if (symbol.type != nc::ValueType::Text) {
        push(value.is_vacant() ? ControlValue::of(0, symbol.type) : value);
        return kDone;
    }
    const std::string text = value.is_text() ? store.texts[value.text] : std::string();
    if (instruction.count == symbol.dimensions) {
        push(keep_text(text));
        return kDone;
    }
    const std::int64_t index = indices[symbol.dimensions];
    if (index < 0 || index >= symbol.text_size)
        return fail(diag::IndexWrong, {'`' + symbol.name + '`'});
    const auto i = static_cast<std::size_t>(index);
    const std::string_view character = code_points(text, i, 1);
    const char32_t code = character.empty() ? 0 : first_code_point(character);
    push(ControlValue::of(code, nc::ValueType::Char));
    return kDone;
}

Done Evaluator::real(ControlValue& out, double number) {
    if (!std::isfinite(number)) return fail(diag::NumberTooLarge);
    out = ControlValue::real(number);
    return kDone;
}

Done Evaluator::operate(const ControlInstruction& instruction, int decimals) {
    const Operation operation = instruction.operation;
    operation_ = operation;
    size_ -= instruction.count;
    ControlValue* const a = &stack_[size_];
    const ControlValue& b = a[1];
    Done is_fine = kFailed;
    switch (operation) {
        case Operation::Add:
        case Operation::Subtract:
        case Operation::Multiply:
        case Operation::Divide:
        case Operation::Quotient:
        case Operation::Remainder:
        case Operation::RoundedRemainder: is_fine = arithmetic(operation, *a, b); break;
        case Operation::Equal:
        case Operation::NotEqual:
        case Operation::Greater:
        case Operation::GreaterEqual:
        case Operation::Less:
        case Operation::LessEqual: is_fine = compare(operation, *a, b); break;
        case Operation::BitAnd:
        case Operation::BitOr:
        case Operation::BitXor:
        case Operation::BitNot:
        case Operation::And:
        case Operation::Or:
        case Operation::Xor:
        case Operation::Not: is_fine = bits(operation, *a, b); break;
        case Operation::Concatenate:
        case Operation::ToText:
        case Operation::TextLength:
        case Operation::UpperCase:
        case Operation::LowerCase:
        case Operation::FindFirst:
        case Operation::FindLast:
        case Operation::FindAny:
        case Operation::FindText:
        case Operation::PartOfText:
        case Operation::IsNumber:
        case Operation::ToNumber: is_fine = text_function(operation, a, instruction.count); break;
        case Operation::Chain:
        case Operation::FrameShift:
        case Operation::FrameFine:
        case Operation::FrameRotation:
        case Operation::FrameSolid:
        case Operation::FrameInPlane:
        case Operation::FrameScale:
        case Operation::FrameMirror:
        case Operation::FrameInverse:
            is_fine = frame_function(operation, a, instruction.count);
            break;
        case Operation::ToAxis:
        case Operation::AxisOfText:
        case Operation::TextOfAxis:
        case Operation::AxisNumber:
        case Operation::ModuloValue:
        case Operation::SpindleAxis:
        case Operation::SpindleNumber:
        case Operation::IsAxis: is_fine = axis_function(operation, a); break;
        case Operation::HasName:
        case Operation::HasProgram:
        case Operation::VariableType: is_fine = question(operation, a); break;
        case Operation::FormatText: is_fine = format_text(a, instruction.count); break;
        case Operation::CircleThrough: is_fine = circle_through(a); break;
        case Operation::MeasuredFrame: is_fine = measured_frame(a); break;
        case Operation::CommonPoint: is_fine = common_point(a); break;
        case Operation::EdgeNumber:
        case Operation::GiveEdgeNumber:
        case Operation::ToolOfEdge:
        case Operation::EdgesUnique:
            is_fine = edge_question(operation, a, instruction.count);
            break;
        default: is_fine = function(operation, a, decimals);
    }
    ++size_;
    return is_fine;
}

Done Evaluator::arithmetic(Operation operation, ControlValue& a, const ControlValue& b) {
    for (const ControlValue& value : {a, b}) {
        if (!value.is_number())
            return fail(diag::TypesDiffer, {"a calculation", std::string(kind_name(value))});
    }
    const bool is_whole = a.is_whole() && b.is_whole();
    double x = a.number;
    double y = b.number;
    if (operation == Operation::RoundedRemainder) x = std::round(x), y = std::round(y);
    const bool divides = operation >= Operation::Divide && operation <= Operation::RoundedRemainder;
    if (divides && y == 0) return fail(diag::ZeroDivide);
    double result = 0;
    switch (operation) {
        case Operation::Add: result = x + y; break;
        case Operation::Subtract: result = x - y; break;
        case Operation::Multiply: result = x * y; break;
        case Operation::Divide: return real(a, x / y);
        case Operation::Quotient: result = truncated_near(x / y); break;
        default: result = std::fmod(x, y);
    }
    if (!is_whole) {
        const bool is_cut = operation == Operation::Quotient && rules_.has_types;
        if (is_cut && std::fabs(result) <= 2147483647.0) {
            a = ControlValue::of(result, nc::ValueType::Int);
            return kDone;
        }
        return real(a, result);
    }
    if (std::fabs(result) > 2147483648.0) return fail(diag::NumberTooLarge);
    a = ControlValue::of(result, nc::ValueType::Int);
    return kDone;
}

/// A character beside a text of one character, `TXT[0]=="A"`: that is a constant of its kind.
/// S 1.4.
void Evaluator::make_character(ControlValue& value, const ControlValue& other) const {
    if (!value.is_text() || other.kind != ControlValue::Kind::Char) return;
    const std::string_view words = text(value);
    if (count_code_points(words) != 1) return;
    value = ControlValue::of(static_cast<double>(first_code_point(words)), nc::ValueType::Char);
}

std::optional<bool> Evaluator::is_same(ControlValue a, const ControlValue& b) {
    if (!compare(Operation::Equal, a, b)) return std::nullopt;
    return a.number != 0;
}

Done Evaluator::compare(Operation operation, ControlValue& a, ControlValue b) {
    make_character(a, b);
    make_character(b, a);
    const bool is_alike = a.is_number() ? b.is_number() : a.kind == b.kind;
    if (!is_alike || a.is_frame()) {
        const ControlValue& first = a.is_number() ? b : a;
        const ControlValue& other = a.is_number() ? a : b;
        return fail(diag::TypesDiffer, {"a comparison with " + std::string(kind_name(first)),
                                        std::string(kind_name(other))});
    }
    bool is_equal = false;
    bool is_less = false;
    if (a.is_text()) {
        is_equal = text(a) == text(b);
        is_less = text(a) < text(b);
    } else {
        const double scale = std::max(std::fabs(a.number), std::fabs(b.number));
        is_equal = std::fabs(a.number - b.number) <= rules_.comparison_tolerance * scale;
        is_less = a.number < b.number && !is_equal;
    }
    const bool is_told_apart = a.is_vacant() != b.is_vacant();
    switch (operation) {
        case Operation::Equal: a = ControlValue::truth(is_equal && !is_told_apart); break;
        case Operation::NotEqual: a = ControlValue::truth(!is_equal || is_told_apart); break;
        case Operation::Greater: a = ControlValue::truth(!is_equal && !is_less); break;
        case Operation::GreaterEqual: a = ControlValue::truth(!is_less); break;
        case Operation::Less: a = ControlValue::truth(is_less); break;
        default: a = ControlValue::truth(is_less || is_equal);
    }
    return kDone;
}

Done Evaluator::bits(Operation operation, ControlValue& a, const ControlValue& b) {
    const bool is_single = operation == Operation::Not || operation == Operation::BitNot;
    if (!a.is_number() || (!is_single && !b.is_number())) {
        return fail(diag::TypesDiffer,
                    {"a logical operation", std::string(kind_name(a.is_number() ? b : a))});
    }
    const bool p = a.number != 0;
    const bool q = !is_single && b.number != 0;
    switch (operation) {
        case Operation::And: a = ControlValue::truth(p && q); return kDone;
        case Operation::Or: a = ControlValue::truth(p || q); return kDone;
        case Operation::Xor: a = ControlValue::truth(p != q); return kDone;
        case Operation::Not: a = ControlValue::truth(!p); return kDone;
        default: break;
    }
    std::int32_t x = 0;
    std::int32_t y = 0;
    if (!whole(a.number, x) || (!is_single && !whole(b.number, y)))
        return fail(diag::NumberTooLarge);
    const std::int32_t result = operation == Operation::BitAnd   ? x & y
                                : operation == Operation::BitOr  ? x | y
                                : operation == Operation::BitXor ? x ^ y
                                                                 : ~x;
    a = ControlValue::of(result, nc::ValueType::Int);
    return kDone;
}

Done Evaluator::function(Operation operation, ControlValue* a, int decimals) {
    if (!a->is_number())
        return fail(diag::TypesDiffer, {"a function of numbers", std::string(kind_name(*a))});
    const double x = a->number;
    const bool was_whole = a->is_whole();
    const auto out_of_range = [&] {
        return fail(diag::ArgumentRange, {variables_.word_of(operation_), format_shortest(x)});
    };
    const auto whole_result = [&](double number) {
        if (!rules_.has_types || std::fabs(number) > 2147483647.0) return real(*a, number);
        *a = ControlValue::of(number, nc::ValueType::Int);
        return kDone;
    };
    switch (operation) {
        case Operation::Negate:
            *a = was_whole ? ControlValue::of(-x, nc::ValueType::Int) : ControlValue::real(-x);
            return kDone;
        case Operation::Sine: look_for_radians(operation, x); return real(*a, sine(x));
        case Operation::Cosine: look_for_radians(operation, x); return real(*a, cosine(x));
        case Operation::Tangent:
            look_for_radians(operation, x);
            if (cosine(x) == 0) return out_of_range();
            return real(*a, sine(x) / cosine(x));
        case Operation::Arcsine:
        case Operation::Arccosine:
        case Operation::Arctangent:
        case Operation::ArctangentOfTwo: return arc_function(operation, a);
        case Operation::SquareRoot: return x < 0 ? out_of_range() : real(*a, std::sqrt(x));
        case Operation::LengthOfTwo: return real(*a, std::hypot(x, a[1].number));
        case Operation::Square: return real(*a, x * x);
        case Operation::Absolute:
            *a = was_whole ? ControlValue::of(std::fabs(x), nc::ValueType::Int)
                           : ControlValue::real(std::fabs(x));
            return kDone;
        case Operation::Round: {
            if (decimals < 0) return whole_result(std::round(x));
            const double power = std::pow(10.0, decimals);
            return real(*a, std::round(x * power) / power);
        }
        case Operation::Truncate: return whole_result(std::trunc(x));
        case Operation::TruncateNear: return whole_result(truncated_near(x));
        case Operation::RoundAway: return whole_result(x < 0 ? std::floor(x) : std::ceil(x));
        case Operation::RoundUp: return whole_result(std::ceil(x));
        case Operation::Logarithm: return x <= 0 ? out_of_range() : real(*a, std::log(x));
        case Operation::Exponential: return real(*a, std::exp(x));
        case Operation::Power: {
            const double result = std::pow(x, a[1].number);
            return std::isnan(result) ? out_of_range() : real(*a, result);
        }
        case Operation::Minimum:
            if (a[1].number < x) *a = a[1];
            return kDone;
        case Operation::Maximum:
            if (a[1].number > x) *a = a[1];
            return kDone;
        case Operation::Bound:
            // least, most, value
            *a = a[2].number < x ? *a : a[2].number > a[1].number ? a[1] : a[2];
            return kDone;
        case Operation::FromBcd:
        case Operation::ToBcd: {
            if (!(x >= 0 && x <= 99999999.0 * 4096)) return out_of_range();
            const bool is_to = operation == Operation::ToBcd;
            const std::uint64_t from = is_to ? 10 : 16;
            const std::uint64_t to = is_to ? 16 : 10;
            std::uint64_t result = 0;
            std::uint64_t index = 1;
            for (auto rest = static_cast<std::uint64_t>(std::round(x)); rest != 0;
                 rest /= from, index *= to) {
                if (rest % from > 9) return out_of_range();
                result += rest % from * index;
            }
            return real(*a, static_cast<double>(result));
        }
        default: return fail(diag::ExpressionSyntax, {variables_.word_of(operation_)});
    }
}

Done Evaluator::arc_function(Operation operation, ControlValue* a) {
    const double x = a->number;
    const bool is_outside = operation != Operation::Arctangent &&
                            operation != Operation::ArctangentOfTwo && std::fabs(x) > 1;
    if (is_outside)
        return fail(diag::ArgumentRange, {variables_.word_of(operation_), format_shortest(x)});
    double angle = 0;
    int range = 0;
    switch (operation) {
        case Operation::Arcsine:
            angle = deg_from_rad(std::asin(x));
            range = rules_.arcsine_range;
            break;
        case Operation::Arccosine: angle = deg_from_rad(std::acos(x)); break;
        case Operation::Arctangent: angle = deg_from_rad(std::atan(x)); break;
        default: angle = deg_from_rad(std::atan2(x, a[1].number)); range = rules_.arctangent_range;
    }
    if (range == 360 && angle < 0) angle += 360;
    return real(*a, angle);
}

}  // namespace kadr::macro
