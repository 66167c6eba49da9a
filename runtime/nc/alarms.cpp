#include "nc/alarms.h"

#include <algorithm>

#include "base/text.h"
#include "nc/letters.h"
#include "nc/tables.h"

namespace kadr::nc {

namespace {

/// `PS11` for `ps0011`.
std::string normal_number(std::string_view number) {
    std::string normal = upper_ascii(number);
    const std::size_t digits = static_cast<std::size_t>(
        std::ranges::find_if(normal, [](char c) { return is_digit(c); }) - normal.begin());
    const std::size_t first = std::min(normal.find_first_not_of('0', digits), normal.size());
    return normal.erase(digits, first - digits);
}

}  // namespace

std::vector<KnownAlarm> alarms_numbered(const Dialect& dialect, std::string_view number) {
    const DialectTables& tables = dialect.tables();
    const std::string wanted = normal_number(number);
    std::vector<KnownAlarm> found;
    const auto add = [&](std::string_view row, const AlarmText& alarm) {
        if (normal_number(alarm.number) == wanted) found.push_back({find_diagnostic(row), alarm});
    };
    for (const auto& [row, alarm] : tables.alarms) add(row, alarm);
    for (const AlarmAbout& about : tables.alarms_about) add(about.row, about.alarm);
    std::erase_if(found, [](const KnownAlarm& known) { return known.row == nullptr; });
    const auto code = [](const KnownAlarm& known) { return known.row->code; };
    std::ranges::stable_sort(found, {}, code);
    const auto is_same = [](const KnownAlarm& a, const KnownAlarm& b) { return a.row == b.row; };
    found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
    return found;
}

}  // namespace kadr::nc
