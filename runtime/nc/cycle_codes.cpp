#include "nc/cycle_codes.h"

#include <algorithm>

#include "nc/tables.h"

namespace kadr::nc {

namespace {

bool is_read_call(const Form& form) {
    return form.is_read && !form.is_preset && form.function == Function::Cycle &&
           form.words[0].kind == FormWord::Kind::Fixed;
}

bool has_same_code(const Form& a, const Form& b) {
    return a.words[0].address == b.words[0].address && a.words[0].number == b.words[0].number;
}

}  // namespace

std::optional<CycleId> cycle_with_strokes(const Dialect& dialect, CycleId cycle) {
    const DialectTables& tables = dialect.tables();
    if (tables.cycles[cycle].roles.stroke >= 0) return std::nullopt;
    for (const Form& form : tables.forms) {
        if (!is_read_call(form) || form.cycle != cycle) continue;
        const auto other = std::ranges::find_if(tables.forms, [&](const Form& candidate) {
            return is_read_call(candidate) && has_same_code(candidate, form) &&
                   tables.cycles[candidate.cycle].roles.stroke >= 0;
        });
        if (other != tables.forms.end()) return other->cycle;
    }
    return std::nullopt;
}

}  // namespace kadr::nc
