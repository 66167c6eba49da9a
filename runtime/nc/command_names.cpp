#include "nc/command_names.h"

#include <algorithm>
#include <utility>

#include "nc/tables.h"

namespace kadr::nc {

std::vector<std::string> command_names(const Dialect& dialect) {
    const DialectTables& tables = dialect.tables();
    std::vector<std::pair<std::string, std::string>> rows;
    for (std::size_t i = 1; i < tables.forms_of.size(); ++i) {
        const auto function = static_cast<Function>(i);
        if (function == Function::Cycle || tables.forms_of[i].empty()) continue;
        rows.emplace_back(info(function).name, info(function).meaning);
    }
    for (std::size_t i = 0; i < tables.cycles.size(); ++i) {
        if (!tables.forms_of_cycle[i].empty())
            rows.emplace_back(tables.cycles[i].name, "cycle: " + tables.cycles[i].meaning);
    }
    std::size_t width = 0;
    for (const auto& [name, meaning] : rows) width = std::max(width, name.size());
    std::vector<std::string> lines;
    lines.reserve(rows.size());
    for (const auto& [name, meaning] : rows)
        lines.push_back(name + std::string(width + 2 - name.size(), ' ') + meaning);
    return lines;
}

}  // namespace kadr::nc
