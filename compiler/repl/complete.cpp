// What can stand at the end of a line of the prompt.
#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/identifier.h"
#include "driver/session.h"
#include "machine/machine.h"
#include "repl/commands.h"
#include "repl/prompt.h"
#include "sema/builtins.h"

namespace kadr::repl {

namespace {

/// Where the last word of the line begins.
std::size_t last_word(std::string_view line) {
    std::size_t begin = line.size();
    while (begin > 0 && is_name_part(line[begin - 1])) --begin;
    return begin;
}

/// The name before the point that stands before `begin`.
std::string_view owner(std::string_view line, std::size_t begin) {
    const std::string_view before = line.substr(0, begin - 1);
    return before.substr(last_word(before));
}

/// The function whose parentheses are open at the end of the line; empty if none are.
std::string open_call(std::string_view line) {
    int depth = 0;
    for (std::size_t i = line.size(); i-- > 0;) {
        if (line[i] == ')') ++depth;
        if (line[i] != '(' || depth-- > 0) continue;
        const std::string_view before = line.substr(0, i);
        return std::string(before.substr(last_word(before)));
    }
    return {};
}

/// Every identifier of a text, for the names of variables.
void add_names(std::string_view text, std::vector<std::string>& out) {
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && is_name_part(text[end])) ++end;
        if (end > i + 1 && (text[i] < '0' || text[i] > '9'))
            out.emplace_back(text.substr(i, end - i));
        i = std::max(end, i + 1);
    }
}

/// The next parts of modules below a folder: `cycles.` behind `import `, `drilling` behind
/// `import cycles.`. `before` is what stands of the name already, to its last point.
void add_modules(const std::string& folder, std::string_view before, const Files& files,
                 std::vector<std::string>& out) {
    namespace fs = std::filesystem;
    std::string below(before);
    std::replace(below.begin(), below.end(), '.', '/');
    for (const FolderEntry& entry : files.list((fs::path(folder) / below).string())) {
        const fs::path path = entry.name;
        if (entry.kind == FileKind::Folder) out.push_back(path.stem().string() + '.');
        else if (path.extension() == ".kadr") out.push_back(path.stem().string());
    }
}

/// What stands of a module's name before its last part, if the line imports one.
std::optional<std::string_view> imported(std::string_view line) {
    constexpr std::string_view kImport = "import ";
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string_view::npos || !line.substr(first).starts_with(kImport))
        return std::nullopt;
    const std::string_view name = line.substr(first + kImport.size());
    if (name.find_first_of(" ;\"") != std::string_view::npos) return std::nullopt;
    const std::size_t point = name.rfind('.');
    return point == std::string_view::npos ? std::string_view() : name.substr(0, point + 1);
}

}  // namespace

std::vector<std::string> Prompt::completions(std::string_view line) const {
    std::vector<std::string> candidates;
    const bool is_command = line.starts_with(':') && pending_.empty();
    const std::size_t begin = last_word(line);
    const std::string_view word = line.substr(begin);
    Sources sources = inputs_.new_sources();
    driver::Messages messages(sources, {}, [](std::string_view) {});
    driver::Session session(options_, inputs_, sources, messages);
    if (is_command && begin == 1) {
        for (const CommandRow& row : command_table()) candidates.emplace_back(row.name);
    } else if (is_command && line.starts_with(":dialect ")) {
        for (const auto& summary : nc::list_dialects(inputs_.share().dialects, inputs_.files())) {
            candidates.push_back(summary.name);
        }
    } else if (is_command && line.starts_with(":machine ")) {
        for (const auto& summary : machine::list(inputs_.share().machines, inputs_.files())) {
            candidates.push_back(summary.name);
        }
    } else if (const auto before = imported(line)) {
        add_modules(inputs_.share().library, *before, inputs_.files(), candidates);
    } else if (begin > 0 && line[begin - 1] == '.' && owner(line, begin) == "state") {
        for (const std::string_view name : sema::state_members()) candidates.emplace_back(name);
    } else if (!is_command) {
        const auto parameters = now_.parameters.find(open_call(line));
        if (parameters != now_.parameters.end()) {
            for (const std::string& name : parameters->second) candidates.push_back(name + ':');
        }
        candidates.insert(candidates.end(), now_.names.begin(), now_.names.end());
        if (const auto* keywords = session.keywords("en", {})) {
            for (const auto& [lexeme, canonical] : keywords->canonical) {
                candidates.push_back(lexeme);
            }
        }
        add_names(program_of(transcript_), candidates);
        add_names(pending_, candidates);
    }
    std::erase_if(candidates, [&](const std::string& name) {
        return !name.starts_with(word) || name.size() == word.size() || !is_name_part(name[0]);
    });
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    return candidates;
}

}  // namespace kadr::repl
