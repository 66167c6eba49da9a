#include "nc/refusals.h"

#include <algorithm>
#include <optional>

#include "base/numbers.h"
#include "nc/quoted.h"
#include "nc/tables.h"

namespace kadr::nc {

namespace {

/// What the form has by itself, with all that were made of the same element: `G{number+53}` is a
/// form for each number.
std::optional<Constraint> said_by_itself(const DialectTables& tables, const Form& form,
                                         int parameter) {
    std::optional<Constraint> range;
    for (const Form& other : tables.forms) {
        if (!(other.range == form.range) || other.pattern != form.pattern) continue;
        for (const auto& [fixed, value] : other.fixed) {
            if (fixed != parameter) continue;
            if (!range) range = Constraint{parameter, value, value};
            range->least = std::min(range->least, value);
            range->most = std::max(range->most, value);
        }
    }
    return range;
}

/// What the form takes of the parameter: "0", "1 to 6"; empty if it takes any value.
std::string taken(const DialectTables& tables, const Form& form, int parameter) {
    std::optional<Constraint> range = said_by_itself(tables, form, parameter);
    const auto said = std::ranges::find(form.when, parameter, &Constraint::parameter);
    if (!range && said != form.when.end()) range = *said;
    if (!range) return {};
    const std::string least = format_shortest(range->least);
    return range->least == range->most ? least : least + " to " + format_shortest(range->most);
}

bool has_word(const std::vector<FormWord>& words, int parameter) {
    return std::ranges::any_of(words, [&](const FormWord& word) {
        return word.parameter == parameter || has_word(word.arguments, parameter);
    });
}

bool has_place(const Form& form, int parameter) {
    return has_word(form.words, parameter) || has_word(form.lead, parameter) ||
           std::ranges::any_of(form.extra,
                               [&](const auto& line) { return has_word(line, parameter); });
}

}  // namespace

Refusal refusal_of(const DialectTables& tables, const Form& form, std::uint32_t wrong,
                   std::uint32_t given, std::span<const double> values) {
    Refusal refusal{first_line(form), form.range, {}};
    const std::span<const Parameter> parameters = tables.parameters(form);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if ((wrong >> i & 1u) == 0) continue;
        const int parameter = static_cast<int>(i);
        const std::string wanted = taken(tables, form, parameter);
        const std::string value = i < values.size() ? format_shortest(values[i]) : "another value";
        if (!refusal.why.empty()) refusal.why += ", ";
        refusal.why += quoted(parameters[i].name);
        if ((given >> i & 1u) == 0) refusal.why += " is not given";
        else if (!wanted.empty()) refusal.why += " is " + value + ", not " + wanted;
        else if (has_place(form, parameter)) refusal.why += " is " + value + ", its word says 0";
        else refusal.why += " has no place in it";
    }
    return refusal;
}

std::uint32_t excluded_values(const Form& form, std::uint32_t given,
                              std::span<const double> values) {
    std::uint32_t excluded = 0;
    const auto hold = [&](int parameter, double least, double most) {
        const double value = values[static_cast<std::size_t>(parameter)];
        const bool is_given = (given >> parameter & 1u) != 0;
        if (is_given && !(value >= least && value <= most)) excluded |= 1u << parameter;
    };
    for (const auto& [parameter, value] : form.fixed) hold(parameter, value, value);
    for (const Constraint& c : form.when) hold(c.parameter, c.least, c.most);
    return excluded;
}

}  // namespace kadr::nc
