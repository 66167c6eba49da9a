// messages.h — what a command says with `--diagnostics json`.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace kadr::testing {

struct Message {
    std::string code;
    bool is_warning = false;
    std::string words;
};

inline std::vector<Message> messages_of(const std::string& lines) {
    std::vector<Message> all;
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
        const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
        if (!json.is_object()) continue;
        all.push_back({json.value("code", ""), json.value("severity", "") == "warning",
                       json.value("message", "")});
    }
    return all;
}

}  // namespace kadr::testing
