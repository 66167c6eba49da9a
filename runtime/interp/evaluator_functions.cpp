// Functions of the language that ask about names, put values into texts, or work on arrays of the
// program.
#include <algorithm>
#include <array>
#include <vector>

#include "base/diagnostics/control.h"
#include "interp/control_functions.h"
#include "interp/evaluator.h"

namespace kadr::interp {

using nc::Operation;

bool Evaluator::question(Operation operation, Value* a) {
    if (!a->is_text())
        return fail(diag::TypesDiffer, {"a text function", std::string(kind_name(*a))});
    const std::string asked(text(*a));
    if (operation == Operation::VariableType) {
        // In the order of S 8.1; which of 6 and 7 is an axis is not told there (unsure).
        const auto type = variables_.type_of(asked);
        const auto number = [](nc::ValueType of) {
            switch (of) {
                case nc::ValueType::Bool: return 1;
                case nc::ValueType::Char: return 2;
                case nc::ValueType::Int: return 3;
                case nc::ValueType::Real: return 4;
                case nc::ValueType::Text: return 5;
                case nc::ValueType::Axis: return 6;
                case nc::ValueType::Frame: return 7;
            }
            return 0;
        };
        *a = Value::of(type ? number(*type) : 0, nc::ValueType::Int);
        return true;
    }
    *a = Value::truth(operation == Operation::HasName ? variables_.has_name(asked)
                                                      : variables_.has_program(asked));
    return true;
}

bool Evaluator::format_text(Value* a, int count) {
    if (!a->is_text())
        return fail(diag::TypesDiffer, {"a text function", std::string(kind_name(*a))});
    std::vector<FormatValue> values;
    for (int i = 1; i < count; ++i) {
        if (!a[i].is_text() && !a[i].is_number())
            return fail(diag::TypesDiffer, {"a text function", std::string(kind_name(a[i]))});
        values.push_back({a[i].number, a[i].is_text(), a[i].kind == Value::Kind::Char, text(a[i])});
    }
    Formatted formatted = interp::format_text(text(*a), values);
    if (!formatted.wrong.empty()) return fail(diag::FormatMismatch, {formatted.wrong});
    if (const std::size_t length = count_code_points(formatted.text); length > kLongestText)
        return fail(diag::JoinedTooLong, {std::to_string(length), std::to_string(kLongestText)});
    *a = keep_text(std::move(formatted.text));
    return true;
}

/// The variable of the program that an argument names, with as many elements at least; nullptr: it
/// has fewer, or none of them is a number.
const nc::Symbol* Evaluator::variable_itself(const Value& place, std::uint32_t least,
                                             const std::string& what) {
    const nc::Symbol& symbol = level_->symbols.at(static_cast<std::uint32_t>(place.number));
    const bool is_number = symbol.type == nc::ValueType::Real || symbol.type == nc::ValueType::Int;
    if (is_number && symbol.count() >= least) return &symbol;
    if (is_number) {
        fail(diag::ArrayTooSmall, {symbol.name, what});
    } else {
        fail(diag::ArgumentDiffers, {what, "an array of numbers"});
    }
    return nullptr;
}

double Evaluator::element_of(const nc::Symbol& symbol, std::uint32_t element) const {
    const Store& store = *level_->stores[level_->symbols.index_of(symbol)];
    return store.values[symbol.slot + element].number;
}

bool Evaluator::set_element(const nc::Symbol& symbol, std::uint32_t element, double value) {
    if (variables_.set_element(symbol, element, value)) return true;
    return fail(diag::ValueForType, {std::to_string(value), "a whole number"});
}

/// An array of points, their number, an array that takes the centre and the radius.
bool Evaluator::circle_through(Value* a) {
    const double count = a[1].number;
    if (!a[1].is_number() || (count != 3 && count != 4))
        return fail(diag::ArgumentRange, {variables_.word_of(operation_), written(a[1])});
    const auto points = static_cast<std::uint32_t>(count);
    const nc::Symbol* from = variable_itself(a[0], 2 * points, "the points");
    const nc::Symbol* to =
        from == nullptr ? nullptr : variable_itself(a[2], 3, "a centre and a radius");
    if (to == nullptr) return false;
    std::array<double, 8> values{};
    for (std::uint32_t i = 0; i < 2 * points; ++i) values[i] = element_of(*from, i);
    const auto circle = interp::circle_through(std::span(values).first(2 * points));
    if (circle) {
        const std::array<double, 3> found{circle->x, circle->y, circle->radius};
        for (std::uint32_t i = 0; i < 3; ++i)
            if (!set_element(*to, i, found[i])) return false;
    }
    *a = Value::truth(circle.has_value());
    return true;
}

/// Two arrays of three points, and a variable that takes the error.
bool Evaluator::measured_frame(Value* a) {
    std::array<std::array<double, 9>, 2> points{};
    for (std::size_t k = 0; k < 2; ++k) {
        const nc::Symbol* of = variable_itself(a[k], 9, "three points");
        if (of == nullptr) return false;
        for (std::uint32_t i = 0; i < 9; ++i)
            points[k][i] = element_of(*of, i) * variables_.axis_unit(static_cast<Axis>(i % 3));
    }
    const nc::Symbol* error = variable_itself(a[2], 1, "the error");
    if (error == nullptr) return false;
    const MeasuredFrame found = interp::measured_frame(points[0], points[1]);
    const double shown =
        found.error < 0 ? found.error : found.error / variables_.axis_unit(Axis::X);
    if (!set_element(*error, 0, shown)) return false;
    *a = keep_frame(found.frame);
    return true;
}

}  // namespace kadr::interp
