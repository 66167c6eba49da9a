#include "nc/command_names.h"

#include <algorithm>
#include <charconv>
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

std::optional<CommandMeaning> command_of_word(const Dialect& dialect, std::string_view word) {
    const DialectTables& tables = dialect.tables();
    for (const CallForm& call : tables.language.calls.calls) {
        if (call.code == word) return CommandMeaning{true, Function::None};
    }
    const std::size_t digits = std::min(word.find_first_of("0123456789"), word.size());
    const AddressId address = tables.find_address(word.substr(0, digits));
    double number = 0;
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data() + digits, end, number);
    if (address == kNoAddress || read.ec != std::errc() || read.ptr != end) return std::nullopt;
    const CodeStart* code = tables.find_code(address, number);
    if (code == nullptr) return std::nullopt;
    for (const FormId id : code->forms) {
        const Form& form = tables.forms[id];
        if (form.function == Function::Cycle) return std::nullopt;
        const bool is_builders = form.function == Function::MachineFunction;  // of any number
        if (form.is_written && !is_builders) return CommandMeaning{false, form.function};
    }
    return std::nullopt;
}

}  // namespace kadr::nc
