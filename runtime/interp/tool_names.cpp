#include "interp/tool_names.h"

#include <algorithm>

namespace kadr::interp {

ToolNames::ToolNames(const machine::Machine& machine) {
    for (const machine::ToolData& tool : machine.tools) {
        if (!tool.name.empty()) names_[tool.number] = tool.name;
        last_ = std::max(last_, tool.number);
    }
}

std::vector<std::int64_t> ToolNames::numbers(std::string_view name) const {
    std::vector<std::int64_t> found;
    for (const auto* names : {&names_, &invented_}) {
        for (const auto& [number, of] : *names)
            if (of == name) found.push_back(number);
    }
    return found;
}

std::string ToolNames::of(std::int64_t number) const {
    for (const auto* names : {&names_, &invented_}) {
        if (const auto found = names->find(number); found != names->end()) return found->second;
    }
    return std::to_string(number);
}

void ToolNames::set(std::int64_t number, std::string_view name) {
    std::erase_if(invented_,
                  [&](const auto& tool) { return tool.first == number || tool.second == name; });
    names_.insert_or_assign(number, std::string(name));
    last_ = std::max(last_, number);
}

std::int64_t ToolNames::invent(std::string_view name, std::int64_t last) {
    last_ = std::max(last_, last) + 1;
    invented_.emplace(last_, name);
    return last_;
}

}  // namespace kadr::interp
