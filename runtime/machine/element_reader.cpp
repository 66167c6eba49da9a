#include "machine/element_reader.h"

#include <algorithm>
#include <charconv>

#include "base/diagnostics/machine.h"
#include "base/text.h"
#include "machine/number_list.h"

namespace kadr::machine {

namespace {

/// "`x`, `y` or `z`".
std::string words_list(std::span<const std::string_view> words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
        text.append("`").append(words[i]).append("`");
    }
    return text;
}

}  // namespace

std::optional<std::string> proposal(std::string_view wrong,
                                    std::span<const std::string_view> candidates) {
    const auto nearest = nearest_name(wrong, candidates.data(), candidates.size());
    if (!nearest) return std::nullopt;
    return std::string(*nearest);
}

std::string ElementReader::text(std::string_view attribute) const {
    const XmlAttribute* found = element_.find(attribute);
    return found == nullptr ? std::string() : found->value;
}

SourceRange ElementReader::location(std::string_view attribute) const {
    const XmlAttribute* found = element_.find(attribute);
    return found == nullptr ? element_.range : found->value_range;
}

void ElementReader::report_quantity(const XmlAttribute& attribute, const QuantityError& error,
                                    QuantityKind dimension, bool is_range) const {
    const std::string name(dimension_name(dimension));
    switch (error.fault) {
        case QuantityFault::NotANumber:
            sink_.report(diag::MachineNumberBad, attribute.value_range)
                .arg(shown_value(error.text))
                .arg(is_range ? "a range `lower..upper` with a unit" : name + " with its unit");
            return;
        case QuantityFault::DecimalComma: {
            std::string pointed(error.text);
            std::ranges::replace(pointed, ',', '.');
            sink_.report(diag::MachineNumberBad, attribute.value_range)
                .arg(shown_value(error.text))
                .arg(name + " with its unit")
                .fix("write the point of a decimal: `" + pointed + '`');
            return;
        }
        case QuantityFault::UnitMissing:
            sink_.report(diag::MachineUnitMissing, attribute.value_range)
                .arg(shown_value(attribute.value))
                .arg(name)
                .fix("write " + unit_names(dimension) + " after the number");
            return;
        case QuantityFault::UnitUnknown:
            sink_.report(diag::MachineUnitUnknown, attribute.value_range)
                .arg(shown_value(error.text))
                .arg(name)
                .fix("write " + unit_names(dimension));
            return;
    }
}

std::optional<double> ElementReader::quantity(std::string_view attribute,
                                              QuantityKind dimension) const {
    const XmlAttribute* found = element_.find(attribute);
    if (found == nullptr) return std::nullopt;
    const auto value = parse_quantity(found->value, dimension);
    if (value) return *value;
    report_quantity(*found, value.error(), dimension, false);
    return std::nullopt;
}

std::optional<std::array<double, 3>> ElementReader::triple(std::string_view attribute,
                                                           QuantityKind dimension) const {
    const XmlAttribute* found = element_.find(attribute);
    if (found == nullptr) return std::nullopt;
    const std::string_view text = trimmed(found->value);
    // The unit belongs to all three, so the numbers end where the first letter stands.
    const std::size_t unit = std::min(text.find_first_not_of("0123456789.,+- \t"), text.size());
    const auto scale = parse_quantity("1" + std::string(text.substr(unit)), dimension);
    if (!scale) {
        const QuantityError error = {scale.error().fault, text.substr(unit)};
        report_quantity(*found, error, dimension, false);
        return std::nullopt;
    }
    auto values = number_list<3>(text.substr(0, unit), ' ');
    if (!values) {
        sink_.report(diag::KinematicsTriple, found->value_range)
            .arg(shown_value(found->value))
            .arg(" and their unit");
        return std::nullopt;
    }
    for (double& value : *values) value *= *scale;
    return values;
}

std::optional<Range> ElementReader::range(std::string_view attribute,
                                          QuantityKind dimension) const {
    const XmlAttribute* found = element_.find(attribute);
    if (found == nullptr) return std::nullopt;
    const auto value = parse_range(found->value, dimension);
    if (value) return *value;
    report_quantity(*found, value.error(), dimension, true);
    return std::nullopt;
}

std::optional<double> ElementReader::positive(std::string_view attribute,
                                              QuantityKind dimension) const {
    const auto value = quantity(attribute, dimension);
    if (!value || *value > 0) return value;
    sink_.report(diag::MachineNotPositive, location(attribute)).arg(attribute).arg(text(attribute));
    return std::nullopt;
}

std::optional<double> ElementReader::magnitude(std::string_view attribute,
                                               QuantityKind dimension) const {
    const auto value = quantity(attribute, dimension);
    if (!value || *value >= 0) return value;
    sink_.report(diag::MachineNegative, location(attribute)).arg(attribute).arg(text(attribute));
    return std::nullopt;
}

std::optional<double> ElementReader::share(std::string_view attribute) const {
    const auto value = quantity(attribute, QuantityKind::Share);
    if (!value || (*value >= 0 && *value <= 1)) return value;
    sink_.report(diag::MachineShare, location(attribute)).arg(attribute).arg(text(attribute));
    return std::nullopt;
}

std::optional<std::int64_t> ElementReader::whole(std::string_view attribute, std::int64_t least,
                                                 std::int64_t most) const {
    const XmlAttribute* found = element_.find(attribute);
    if (found == nullptr) return std::nullopt;
    std::int64_t number = 0;
    const char* const end = found->value.data() + found->value.size();
    const auto [stop, fault] = std::from_chars(found->value.data(), end, number);
    if (fault == std::errc() && stop == end && number >= least && number <= most) return number;
    sink_.report(diag::MachineWholeNumber, found->value_range)
        .arg(attribute)
        .arg(shown_value(found->value))
        .arg(least)
        .arg(most);
    return std::nullopt;
}

std::optional<std::size_t> ElementReader::choice(std::string_view attribute,
                                                 std::span<const std::string_view> words) const {
    const XmlAttribute* found = element_.find(attribute);
    if (found == nullptr) return std::nullopt;
    const auto word = std::find(words.begin(), words.end(), found->value);
    if (word != words.end()) return static_cast<std::size_t>(word - words.begin());
    auto message = sink_.report(diag::MachineChoice, found->value_range);
    message.arg(attribute).arg(shown_value(found->value)).arg(words_list(words));
    if (const auto better = proposal(found->value, words)) {
        message.fix(found->value_range, *better, "the word is written so");
    }
    return std::nullopt;
}

}  // namespace kadr::machine
