#include "interp/word_hints.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace kadr::interp {

std::string with_point(double value) {
    constexpr int kDigits = 4;  // what a control shows
    std::string text = format_shortest(round_to(value, kDigits));
    return text.find('.') == std::string::npos ? text + '.' : text;
}

std::string hint_at_comma(const nc::DialectTables& tables, Axis axis, double value) {
    if (axis != Axis::A && axis != Axis::C) return {};
    const std::string name = ',' + std::string(kAxisNames[index(axis)]);
    if (tables.find_address(name) == nc::kNoAddress) return {};
    const std::string what = axis == Axis::C ? "a chamfer" : "the angle of a line";
    // A chamfer has no sign, and a number of thousandths was written without its point: `A5`.
    double shown = axis == Axis::C ? std::abs(value) : value;
    const double thousandths = round_to(shown * 1000, 6);
    const bool has_lost_point = std::abs(shown) < 0.1 && thousandths == std::round(thousandths);
    if (has_lost_point) shown = thousandths;
    return what + " is `" + name + with_point(shown) + "`, with a comma";
}

std::string hint_at_bare_cycle(const nc::DialectTables& tables, const nc::BlockLocations* locations,
                               const nc::Block& caller) {
    const bool has_words = (caller.given & (nc::kTargetSlots | bit(nc::Slot::Radius))) != 0;
    if (has_words || locations == nullptr || caller.find(nc::Function::Cycle) == nullptr) return {};
    const TextLocation location = locations->location(caller, nc::Function::Cycle);
    const std::size_t begin = std::min<std::size_t>(location.column - 1, location.text.size());
    const auto found = tables.foreign.find(location.text.substr(begin, location.length) + "@cycle");
    return found == tables.foreign.end() ? std::string() : found->second;
}

}  // namespace kadr::interp
