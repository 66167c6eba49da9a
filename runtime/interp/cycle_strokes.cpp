#include "interp/cycle_strokes.h"

#include <algorithm>

#include "nc/tables.h"

namespace kadr::interp {

namespace {

using nc::CycleId;
using nc::CycleInfo;
using nc::Form;
using nc::FormWord;

bool is_read_call(const Form& form) {
    return form.is_read && !form.is_preset && form.function == nc::Function::Cycle &&
           form.words[0].kind == FormWord::Kind::Fixed;
}

bool has_same_code(const Form& a, const Form& b) {
    return a.words[0].address == b.words[0].address && a.words[0].number == b.words[0].number;
}

std::optional<CycleId> cycle_with_strokes(const nc::DialectTables& tables, CycleId cycle) {
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

}  // namespace

std::optional<ModalCycle> call_in_strokes(const nc::Dialect& dialect, const ModalCycle& call) {
    const CycleInfo& from = dialect.cycles()[call.cycle];
    if (from.roles.stroke >= 0) return std::nullopt;
    const std::optional<CycleId> cycle = cycle_with_strokes(dialect.tables(), call.cycle);
    if (!cycle) return std::nullopt;
    const CycleInfo& to = dialect.cycles()[*cycle];
    ModalCycle out;
    out.is_active = call.is_active;
    out.cycle = *cycle;
    for (std::size_t i = 0; i < from.parameters.size(); ++i) {
        const auto place = std::ranges::find(to.parameters, from.parameters[i].name,
                                             [](const auto& parameter) { return parameter.name; });
        if ((call.given >> i & 1u) == 0 || place == to.parameters.end()) continue;
        const auto j = static_cast<std::size_t>(place - to.parameters.begin());
        out.arguments[j] = call.arguments[i];
        out.given |= 1u << j;
        if ((call.by_form >> i & 1u) != 0)
            out.by_form = static_cast<std::uint16_t>(out.by_form | 1u << j);
    }
    return out;
}

}  // namespace kadr::interp
