// alarms.h — what Kadr reports under a number of the control.
#pragma once

#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "nc/dialect.h"

namespace kadr::nc {

/// A message, and the alarm that the control raises in its place.
struct KnownAlarm {
    const DiagnosticRow* row = nullptr;
    AlarmText alarm;
};

/// What raises the alarm with this number, in the order of the codes. Letters in either case and
/// zeros in front of the digits do not count: `ps11` is PS0011.
std::vector<KnownAlarm> alarms_numbered(const Dialect& dialect, std::string_view number);

}  // namespace kadr::nc
