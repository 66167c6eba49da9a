// Functions of the language that ask about names, put values into texts, or work on arrays of the
// program.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/danger_limits.h"
#include "base/diagnostics/control.h"
#include "macro/control_functions.h"
#include "macro/evaluator.h"

namespace kadr::macro {

using nc::Operation;

/// An angle of which the control thinks in degrees, and that is a part of pi.
void Evaluator::look_for_radians(Operation operation, double angle) {
    constexpr double kPi = std::numbers::pi;
    constexpr std::array kParts = {kPi / 6,     kPi / 4, kPi / 3,     kPi / 2, 2 * kPi / 3,
                                   3 * kPi / 4, kPi,     3 * kPi / 2, 2 * kPi};
    const double amount = std::fabs(angle);
    if (amount < kParts.front() - 1 || amount > kParts.back() + 1) return;
    for (const double part : kParts) {
        if (std::fabs(amount - part) < danger::kRadianMatch) radians_ = {place_, operation, angle};
    }
}

Done Evaluator::question(Operation operation, ControlValue* a) {
    if (!a->is_text())
        return fail(diag::TypesDiffer, {"a text function", std::string(kind_name(*a))});
    const std::string asked(text(*a));
    if (operation == Operation::VariableType) {
        // In the order of S 8.1; which of 6 and 7 is an axis is not given there (unsure).
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
        *a = ControlValue::of(type ? number(*type) : 0, nc::ValueType::Int);
        return kDone;
    }
    *a = ControlValue::truth(operation == Operation::HasName ? variables_.has_name(asked)
                                                             : variables_.find_program(asked));
    return kDone;
}

Done Evaluator::format_text(ControlValue* a, int count) {
    if (!a->is_text())
        return fail(diag::TypesDiffer, {"a text function", std::string(kind_name(*a))});
    std::vector<FormatValue> values;
    for (int i = 1; i < count; ++i) {
        if (!a[i].is_text() && !a[i].is_number())
            return fail(diag::TypesDiffer, {"a text function", std::string(kind_name(a[i]))});
        values.push_back(
            {a[i].number, a[i].is_text(), a[i].kind == ControlValue::Kind::Char, text(a[i])});
    }
    Formatted formatted = macro::format_text(text(*a), values);
    if (!formatted.wrong.empty()) return fail(diag::FormatMismatch, {formatted.wrong});
    if (const std::size_t length = count_code_points(formatted.text); length > kLongestText)
        return fail(diag::JoinedTooLong, {std::to_string(length), std::to_string(kLongestText)});
    *a = keep_text(std::move(formatted.text));
    return kDone;
}

/// The variable of the program that an argument names, with as many elements at least; nullptr: it
/// has fewer, or none of them is a number.
const nc::ControlSymbol* Evaluator::variable_itself(const ControlValue& place, std::uint32_t least,
                                                    const std::string& what) {
    const nc::ControlSymbol& symbol = level_->symbols.at(static_cast<std::uint32_t>(place.number));
    const bool is_number = symbol.type == nc::ValueType::Real || symbol.type == nc::ValueType::Int;
    if (is_number && symbol.count() >= least) return &symbol;
    if (is_number) {
        note_fault(diag::ArrayTooSmall, {symbol.name, what});
    } else {
        note_fault(diag::ArgumentDiffers, {what, "an array of numbers"});
    }
    return nullptr;
}

double Evaluator::element_of(const nc::ControlSymbol& symbol, std::uint32_t element) const {
    const Store& store = *level_->stores[level_->symbols.index_of(symbol)];
    return store.values[symbol.slot + element].number;
}

Done Evaluator::set_element(const nc::ControlSymbol& symbol, std::uint32_t element, double value) {
    if (variables_.set_element(symbol, element, value)) return kDone;
    return fail(diag::ValueForType, {std::to_string(value), "a whole number"});
}

/// An array of points, their number, an array that takes the centre and the radius.
Done Evaluator::circle_through(ControlValue* a) {
    const double count = a[1].number;
    if (!a[1].is_number() || (count != 3 && count != 4))
        return fail(diag::ArgumentRange, {variables_.word_of(operation_), written(a[1])});
    const auto points = static_cast<std::uint32_t>(count);
    const nc::ControlSymbol* from = variable_itself(a[0], 2 * points, "the points");
    const nc::ControlSymbol* to =
        from == nullptr ? nullptr : variable_itself(a[2], 3, "a centre and a radius");
    if (to == nullptr) return kFailed;
    std::array<double, 8> values{};
    for (std::uint32_t i = 0; i < 2 * points; ++i) values[i] = element_of(*from, i);
    const auto circle = macro::circle_through(std::span(values).first(2 * points));
    if (circle) {
        const std::array<double, 3> found{circle->x, circle->y, circle->radius};
        for (std::uint32_t i = 0; i < 3; ++i)
            if (!set_element(*to, i, found[i])) return kFailed;
    }
    *a = ControlValue::truth(circle.has_value());
    return kDone;
}

/// Two arrays of three points, and a variable that takes the error.
Done Evaluator::measured_frame(ControlValue* a) {
    std::array<std::array<double, 9>, 2> points{};
    for (std::size_t k = 0; k < 2; ++k) {
        const nc::ControlSymbol* of = variable_itself(a[k], 9, "three points");
        if (of == nullptr) return kFailed;
        for (std::uint32_t i = 0; i < 9; ++i)
            points[k][i] = element_of(*of, i) * variables_.axis_unit(static_cast<Axis>(i % 3));
    }
    const nc::ControlSymbol* error = variable_itself(a[2], 1, "the error");
    if (error == nullptr) return kFailed;
    const MeasuredFrame found = macro::measured_frame(points[0], points[1]);
    const double shown =
        found.error < 0 ? found.error : found.error / variables_.axis_unit(Axis::X);
    if (!set_element(*error, 0, shown)) return kFailed;
    *a = keep_frame(found.frame);
    return kDone;
}

ContourRow Evaluator::contour_row(const nc::ControlSymbol& table, std::int64_t row) const {
    ContourRow out{};
    for (std::uint32_t i = 0; i < kContourColumns; ++i)
        out[i] =
            element_of(table, static_cast<std::uint32_t>(row) * std::uint32_t{kContourColumns} + i);
    return out;
}

/// Two tables of contours with a row each, and an array that takes the point.
Done Evaluator::common_point(ControlValue* a) {
    std::array<ContourElement, 2> elements;
    for (std::size_t k = 0; k < 2; ++k) {
        const ControlValue& row = a[2 * k + 1];
        const nc::ControlSymbol& table =
            level_->symbols.at(static_cast<std::uint32_t>(a[2 * k].number));
        const bool is_table = table.type == nc::ValueType::Real && table.dimensions == 2 &&
                              table.sizes[1] == kContourColumns;
        if (!is_table)
            return fail(diag::ArgumentDiffers, {"the table", "an array of reals with 11 columns"});
        if (!row.is_number() || row.number < 0 || row.number >= table.sizes[0])
            return fail(diag::IndexWrong, {'`' + table.name + '`'});
        const auto element = macro::element_of(contour_row(table, std::llround(row.number)));
        if (!element) return fail(diag::ContourRowWrong, {written(row)});
        elements[k] = *element;
    }
    const nc::ControlSymbol* to = variable_itself(a[4], 2, "a point");
    if (to == nullptr) return kFailed;
    const auto point = macro::common_point(elements[0], elements[1]);
    for (std::uint32_t i = 0; point && i < 2; ++i)
        if (!set_element(*to, i, (*point)[static_cast<Eigen::Index>(i)])) return kFailed;
    *a = ControlValue::truth(point.has_value());
    return kDone;
}

/// A whole number of the control, where it is known and there is one.
Done Evaluator::ask(nc::SystemQuantity quantity, double first, double second, double& out) {
    return answer(variables_.system(quantity, std::llround(first), std::llround(second), out));
}

/// Numbers of tools and edges.
Done Evaluator::edge_question(Operation operation, ControlValue* a, int count) {
    if (operation == Operation::ToolOfEdge) return tool_of_edge(a);
    if (operation == Operation::EdgesUnique) return edges_unique(a, count);
    for (int i = 0; i < count; ++i) {
        const bool is_number = a[i].is_number() && std::fabs(a[i].number) < 1e9;
        if (!is_number)
            return fail(diag::ArgumentRange, {variables_.word_of(operation), written(a[i])});
    }
    double edge = 0;
    if (!ask(nc::SystemQuantity::EdgeNumberOf, a[0].number, a[1].number, edge)) return kFailed;
    if (operation == Operation::EdgeNumber) {
        *a = ControlValue::of(edge, nc::ValueType::Int);
        return kDone;
    }
    const bool is_given =
        edge != 0 &&
        variables_.set_system(nc::SystemQuantity::EdgeNumberOf, std::llround(a[0].number),
                              std::llround(a[1].number), a[2].number);
    *a = ControlValue::truth(is_given);
    return kDone;
}

/// A variable that takes the tool, and the number D.
Done Evaluator::tool_of_edge(ControlValue* a) {
    const nc::ControlSymbol* to = variable_itself(a[0], 1, "a tool");
    if (to == nullptr) return kFailed;
    if (!a[1].is_number())
        return fail(diag::ArgumentRange, {variables_.word_of(operation_), written(a[1])});
    double tool = 0;
    double other = 0;
    if (!ask(nc::SystemQuantity::ToolWithEdge, a[1].number, 0, tool) ||
        !ask(nc::SystemQuantity::ToolWithEdge, a[1].number, 1, other) || !set_element(*to, 0, tool))
        return kFailed;
    *a = ControlValue::of(tool == 0 ? -1 : other == 0 ? 0 : -2, nc::ValueType::Int);
    return kDone;
}

/// Variables that name a tool, another one, and a number D; those that are not there mean all.
Done Evaluator::edges_unique(ControlValue* a, int count) {
    std::array<const nc::ControlSymbol*, 3> of{};
    std::array<double, 3> wanted{};
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        of[k] = variable_itself(a[i], 1, "a tool, or a number D");
        if (of[k] == nullptr) return kFailed;
        wanted[k] = element_of(*of[k], 0);
    }
    constexpr int kMostEdges = 12;  // that a tool can have
    for (int edge = 1; edge <= kMostEdges; ++edge) {
        if (count == 3 && edge != wanted[2]) continue;
        std::vector<double> tools;
        double tool = 0;
        do {
            if (!ask(nc::SystemQuantity::ToolWithEdge, edge, static_cast<double>(tools.size()),
                     tool))
                return kFailed;
            if (tool != 0) tools.push_back(tool);
        } while (tool != 0);
        for (std::size_t i = 0; i < tools.size(); ++i) {
            for (std::size_t j = i + 1; j < tools.size(); ++j) {
                const auto is_among = [&](double which) {
                    return tools[i] == which || tools[j] == which;
                };
                if ((count >= 1 && !is_among(wanted[0])) || (count >= 2 && !is_among(wanted[1])))
                    continue;
                const std::array<double, 3> found{tools[i], tools[j], static_cast<double>(edge)};
                for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
                    if (!set_element(*of[k], 0, found[k])) return kFailed;
                *a = ControlValue::truth(false);
                return kDone;
            }
        }
    }
    *a = ControlValue::truth(true);
    return kDone;
}

}  // namespace kadr::macro
