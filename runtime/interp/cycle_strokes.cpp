#include "interp/cycle_strokes.h"

#include <algorithm>

#include "nc/cycle_codes.h"

namespace kadr::interp {

using nc::CycleId;
using nc::CycleInfo;

std::optional<ModalCycle> call_in_strokes(const nc::Dialect& dialect, const ModalCycle& call) {
    const CycleInfo& from = dialect.cycles()[call.cycle];
    const std::optional<CycleId> cycle = nc::cycle_with_strokes(dialect, call.cycle);
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
