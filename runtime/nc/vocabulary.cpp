#include "nc/vocabulary.h"

#include <algorithm>
#include <array>

namespace kadr::nc {

namespace {

constexpr std::array<std::string_view, kGroups> kGroupNames = {
    "once",       "motion",      "plane",          "units",      "distance",      "feed_mode",
    "speed_mode", "radius_comp", "length_comp",    "path_mode",  "work_offsets",  "spindle",
    "coolant",    "cycle_mode",  "cycle_return",   "comp_start", "comp_corner",   "comp_check",
    "diameter",   "compressor",  "transformation", "turning",    "orient_angles", "orient_system",
    "spinning",   "comp_system", "comp_turning",   "data_input"};

constexpr std::array<std::string_view, 9> kDimensionNames = {
    "number", "count", "length", "angle", "time", "feed", "speed", "factor", "text"};

constexpr std::size_t count_parameters(std::string_view text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), ':'));
}

constexpr Dimension parse_dimension(std::string_view name) {
    for (std::size_t i = 0; i < kDimensionNames.size(); ++i) {
        if (kDimensionNames[i] == name) return static_cast<Dimension>(i);
    }
    throw "unknown dimension in vocabulary.def";  // only ever seen by the compiler
}

/// One parameter of the table: `offset?:count`.
constexpr Parameter parse_parameter(std::string_view text) {
    const std::size_t colon = text.find(':');
    Parameter parameter;
    parameter.name = text.substr(0, colon);
    parameter.dimension = parse_dimension(text.substr(colon + 1));
    if (parameter.name.back() == '?') {
        parameter.is_optional = true;
        parameter.name.remove_suffix(1);
    }
    return parameter;
}

struct FunctionRow {
    Function function;
    std::string_view name;
    Group group;
    std::string_view parameters;
    std::string_view meaning;
};

constexpr std::array<FunctionRow, kFunctions> kRows = {{
#define KADR_FUNCTION(id, name, group, facts, parameters, meaning) \
    {Function::id, name, Group::group, parameters, meaning},
#include "nc/vocabulary.def"
#undef KADR_FUNCTION
}};

constexpr FactInfo kFactInfos[] = {
#define KADR_FACT(name, meaning) {#name, meaning},
#include "nc/facts.def"
#undef KADR_FACT
};

constexpr std::size_t kParameters = [] {
    std::size_t count = 0;
    for (const FunctionRow& row : kRows) count += count_parameters(row.parameters);
    return count;
}();

constexpr std::array<Parameter, kParameters> kParameterTable = [] {
    std::array<Parameter, kParameters> table;
    std::size_t next = 0;
    for (const FunctionRow& row : kRows) {
        std::string_view rest = row.parameters;
        while (!rest.empty()) {
            const std::size_t space = std::min(rest.find(' '), rest.size());
            table[next++] = parse_parameter(rest.substr(0, space));
            rest.remove_prefix(std::min(space + 1, rest.size()));
        }
    }
    return table;
}();

constexpr std::array<FunctionInfo, kFunctions> kTable = [] {
    std::array<FunctionInfo, kFunctions> table;
    std::size_t next = 0;
    for (std::size_t i = 0; i < kFunctions; ++i) {
        const FunctionRow& row = kRows[i];
        const std::size_t count = count_parameters(row.parameters);
        table[i] = {row.function, row.name, row.group,
                    std::span<const Parameter>(kParameterTable.data() + next, count), row.meaning};
        next += count;
    }
    return table;
}();

}  // namespace

const FunctionInfo& info(Function function) { return kTable[static_cast<std::size_t>(function)]; }

std::span<const FunctionInfo> all_functions() { return kTable; }

std::optional<Function> find_function(std::string_view name) {
    if (name.empty()) return std::nullopt;
    for (const FunctionInfo& row : kTable) {
        if (row.name == name) return row.function;
    }
    return std::nullopt;
}

std::string_view group_name(Group group) { return kGroupNames[static_cast<std::size_t>(group)]; }

std::optional<Group> find_group(std::string_view name) {
    const auto found = std::find(kGroupNames.begin(), kGroupNames.end(), name);
    if (found == kGroupNames.end()) return std::nullopt;
    return static_cast<Group>(found - kGroupNames.begin());
}

std::string_view dimension_name(Dimension dimension) {
    return kDimensionNames[static_cast<std::size_t>(dimension)];
}

std::optional<Dimension> find_dimension(std::string_view name) {
    const auto found = std::find(kDimensionNames.begin(), kDimensionNames.end(), name);
    if (found == kDimensionNames.end()) return std::nullopt;
    return static_cast<Dimension>(found - kDimensionNames.begin());
}

std::span<const FactInfo> all_facts() { return kFactInfos; }

}  // namespace kadr::nc
