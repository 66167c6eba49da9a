// evaluator_texts.cpp — functions of texts, and how values are written.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/diagnostics/control.h"
#include "base/numbers.h"
#include "base/text.h"
#include "macro/evaluator.h"

namespace kadr::macro {

using nc::Operation;

namespace {

/// `12.5`, `-3`, `1.5EX-3`; the whole text.
std::optional<double> number_in(std::string_view text) {
    const Decimal decimal = parse_decimal(text.data(), text.data() + text.size());
    if (text.empty() || decimal.end == text.data()) return std::nullopt;
    std::string_view rest = text.substr(static_cast<std::size_t>(decimal.end - text.data()));
    if (rest.empty()) return decimal.value;
    if (!upper_ascii(rest).starts_with("EX")) return std::nullopt;
    rest.remove_prefix(2);
    if (rest.starts_with('+')) rest.remove_prefix(1);
    int exponent = 0;
    const auto result = std::from_chars(rest.data(), rest.data() + rest.size(), exponent);
    const bool is_whole = result.ec == std::errc() && result.ptr == rest.data() + rest.size();
    if (!is_whole || std::abs(exponent) > 308) return std::nullopt;
    return decimal.value * std::pow(10.0, exponent);
}

}  // namespace

/// With 10 decimals at most, and no more of them than the number has digits. S 8.4.
std::string Evaluator::written(const ControlValue& value) const {
    if (value.is_text()) return std::string(text(value));
    if (value.kind == ControlValue::Kind::Char) return value.character();
    constexpr int kMostDecimals = 10;
    constexpr int kDigits = std::numeric_limits<double>::digits10;
    int decimals = 0;
    if (value.kind == ControlValue::Kind::Real || value.is_vacant()) {
        const double size = std::clamp(std::fabs(value.number), 1.0, 1e300);
        decimals = std::clamp(kDigits - 1 - static_cast<int>(std::log10(size)), 0, kMostDecimals);
    }
    std::array<char, 400> digits;  // the greatest number has 309 before its point
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value.number,
                                      std::chars_format::fixed, decimals);
    char* end = result.ptr;
    if (decimals > 0) {
        while (end[-1] == '0') --end;
        if (end[-1] == '.') --end;
    }
    std::string out(digits.data(), end);
    return out == "-0" ? "0" : out;
}

namespace {

/// Where the first character stands that is one of `signs`.
std::size_t first_of(std::string_view text, std::string_view signs) {
    std::size_t first = std::string_view::npos;
    for (std::size_t i = 0; i < count_code_points(signs); ++i)
        first = std::min(first, text.find(code_points(signs, i, 1)));
    return first;
}

}  // namespace

Done Evaluator::text_function(Operation operation, ControlValue* a, int count) {
    const bool takes_numbers =
        operation == Operation::Concatenate || operation == Operation::ToText;
    if (!(a->is_text() || (takes_numbers && a->is_number())))
        return fail(diag::TypesDiffer, {"a text function", std::string(kind_name(*a))});
    if (count > 1 && !a[1].is_text() && !a[1].is_number())
        return fail(diag::TypesDiffer, {"a text function", std::string(kind_name(a[1]))});
    const std::string subject = takes_numbers ? written(*a) : std::string(text(*a));
    const auto place = [&](std::size_t found) {
        const bool is_missing = found == std::string::npos;
        const std::string_view before = std::string_view(subject).substr(0, found);
        *a = ControlValue::of(is_missing ? -1.0 : static_cast<double>(count_code_points(before)),
                              nc::ValueType::Int);
        return kDone;
    };
    switch (operation) {
        case Operation::ToText: *a = keep_text(subject); return kDone;
        case Operation::Concatenate: {
            std::string joined = subject + written(a[1]);
            if (const std::size_t length = count_code_points(joined); length > kLongestText)
                return fail(diag::JoinedTooLong,
                            {std::to_string(length), std::to_string(kLongestText)});
            *a = keep_text(std::move(joined));
            return kDone;
        }
        case Operation::TextLength:
            *a = ControlValue::of(static_cast<double>(count_code_points(subject)),
                                  nc::ValueType::Int);
            return kDone;
        case Operation::UpperCase: *a = keep_text(upper_letters(subject)); return kDone;
        case Operation::LowerCase: *a = keep_text(lower_letters(subject)); return kDone;
        case Operation::FindFirst: return place(subject.find(code_points(written(a[1]), 0, 1)));
        case Operation::FindLast: return place(subject.rfind(code_points(written(a[1]), 0, 1)));
        case Operation::FindAny: return place(first_of(subject, written(a[1])));
        case Operation::FindText: return place(subject.find(written(a[1])));
        case Operation::PartOfText: {
            const double from = a[1].number;
            const double length = count > 2 ? std::min(a[2].number, 1e6) : 1e6;
            if (from < 0 || length < 0) return fail(diag::IndexWrong, {"a text"});
            const auto begin = static_cast<std::size_t>(std::min(from, 1e6));
            *a = keep_text(
                std::string(code_points(subject, begin, static_cast<std::size_t>(length))));
            return kDone;
        }
        case Operation::IsNumber:
            *a = ControlValue::truth(number_in(subject).has_value());
            return kDone;
        default: {
            const auto number = number_in(subject);
            if (!number) return fail(diag::NoNumberText, {subject});
            return real(*a, *number);
        }
    }
}

}  // namespace kadr::macro
