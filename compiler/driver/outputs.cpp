#include "driver/outputs.h"

#include <algorithm>

#include "base/assert.h"

namespace kadr::driver {

#define KADR_OUTPUT(make, ...) std::unique_ptr<RunOutput> make(const OutputParts& parts);
#define KADR_CHOICE(...)
#define KADR_SETTING(fault, ...) std::string fault(const std::string& text);
#include "driver/outputs.def"
#undef KADR_OUTPUT
#undef KADR_CHOICE
#undef KADR_SETTING

std::span<const OutputRow> output_rows() {
    static constexpr OutputRow kRows[] = {
#define KADR_OUTPUT(make, kind, turn, flag, value, help, manual) \
    {flag, value, help, manual, OutputRow::Kind::kind, turn, make, nullptr},
#define KADR_CHOICE(flag, value, help, manual) \
    {flag, value, help, manual, OutputRow::Kind::Setting, 0, nullptr, nullptr},
#define KADR_SETTING(fault, flag, value, help, manual) \
    {flag, value, help, manual, OutputRow::Kind::Setting, 0, nullptr, fault},
#include "driver/outputs.def"
#undef KADR_OUTPUT
#undef KADR_CHOICE
#undef KADR_SETTING
    };
    return kRows;
}

const OutputRow& output_row(std::string_view flag) {
    const auto row = std::ranges::find(output_rows(), flag, &OutputRow::flag);
    KADR_ASSERT(row != output_rows().end(), "an output of the table");
    return *row;
}

std::string machine_title(const machine::Machine& machine) {
    return machine.title.empty() ? machine.name : machine.title;
}

std::string subtitle_of(const RunFigures& figures, const machine::Machine& machine) {
    return figures.dialect + " · " + machine_title(machine) + " · " +
           duration_text(figures.totals.time);
}

std::string warning_of(const RunFigures& figures) {
    return figures.alarm.empty() ? std::string() : "not complete, ended by " + figures.alarm;
}

}  // namespace kadr::driver
