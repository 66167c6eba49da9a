#include "tests/docs/table_pages.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "base/danger_limits.h"
#include "base/diagnostic.h"
#include "base/numbers.h"
#include "nc/language.h"
#include "nc/load.h"
#include "nc/rules.h"
#include "nc/statement_holes.h"
#include "nc/tables.h"
#include "nc/vocabulary.h"
#include "tests/docs/cells.h"

namespace docs {
namespace {

namespace nc = kadr::nc;

std::string head(std::initializer_list<const char*> names) {
    std::string first;
    std::string second;
    for (const char* name : names) {
        first.append("| ").append(name).append(" ");
        second += "| --- ";
    }
    return first + "|\n" + second + "|\n";
}

std::string row(std::initializer_list<std::string> cells) {
    std::string out;
    for (const std::string& each : cells) out += "| " + each + ' ';
    return out + "|\n";
}

std::string code(std::string_view name) { return '`' + std::string(name) + '`'; }

/// `ArcError::ShiftCenter` as a dialect writes it, shift_center; `true` is yes.
std::string written_default(std::string_view standard) {
    if (standard == "true") return "yes";
    if (standard == "false") return "no";
    const std::size_t colons = standard.rfind("::");
    if (colons == std::string_view::npos) {
        const bool is_whole = standard.ends_with(".0");
        return std::string(is_whole ? standard.substr(0, standard.size() - 2) : standard);
    }
    std::string out;
    for (const char c : standard.substr(colons + 2)) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isupper(byte) != 0 && !out.empty()) out += '_';
        out += static_cast<char>(std::tolower(byte));
    }
    return out;
}

struct RuleRow {
    const char* name;
    const char* standard;
    const char* values;
    const char* meaning;
    const char* source;
};

constexpr RuleRow kRules[] = {
#define KADR_RULE(type, field, standard, values, meaning, source) \
    {#field, #standard, values, meaning, source},
#include "nc/rules.def"
#undef KADR_RULE
};

constexpr RuleRow kLanguageRules[] = {
#define KADR_LANGUAGE_RULE(type, field, standard, values, meaning, source) \
    {#field, #standard, values, meaning, source},
#include "nc/language.def"
#undef KADR_LANGUAGE_RULE
};

struct FigureRow {
    std::string_view name;
    std::string_view result;
    std::string_view parameters;
    std::string_view meaning;
};

constexpr FigureRow kFigures[] = {
#define KADR_FIGURE(name, word, result, parameters, meaning) {word, #result, parameters, meaning},
#include "compiler/sema/figures.def"
#undef KADR_FIGURE
};

/// The type in a program of what a figure gives.
std::string type_of(std::string_view result) {
    static const std::map<std::string_view, std::string> kTypes = {
        {"Count", "int"},   {"Length", "length"}, {"Time", "time"},    {"Truth", "bool"},
        {"Text", "string"}, {"Point", "point"},   {"Counts", "int[]"}, {"Lengths", "length[]"}};
    return code(kTypes.at(result));
}

/// "from. to. [margin]" as a call, `inside(from, to, margin: …)`.
std::string call_of(const FigureRow& figure) {
    std::string out(figure.name);
    if (figure.parameters.empty()) return code(out);
    std::istringstream words{std::string(figure.parameters)};
    std::string inside;
    for (std::string word; words >> word;) {
        if (word.ends_with('.')) word.pop_back();
        if (word.starts_with('[')) word = word.substr(1, word.size() - 2) + ": …";
        inside += (inside.empty() ? "" : ", ") + word;
    }
    return code(out + '(' + inside + ')');
}

std::string table_of(std::span<const RuleRow> rules) {
    std::string out = head({"rule", "value", "default", "meaning", "from"});
    for (const RuleRow& rule : rules) {
        out += row({code(rule.name), cell(rule.values), written_default(rule.standard),
                    cell(rule.meaning), cell(rule.source)});
    }
    return out;
}

const nc::Dialect& shipped(const std::string& name) {
    static std::map<std::string, std::optional<nc::Dialect>> loaded;
    std::optional<nc::Dialect>& dialect = loaded[name];
    if (!dialect) {
        kadr::Sources sources;
        kadr::DiagnosticList messages;
        dialect = nc::load_dialect(name, {KADR_ROOT "/dialects"}, sources, messages);
        EXPECT_TRUE(dialect.has_value()) << name;
    }
    return *dialect;
}

/// The words of the forms of a function, or of one of its cycles, in the order of the file, each
/// once: `G83 Z{to} …`. Of many the first ones.
std::string spelled(const nc::Dialect& dialect, nc::Function function, nc::CycleId cycle = 0) {
    constexpr std::size_t kMost = 3;
    std::vector<std::string> words;
    for (const nc::Form& form : dialect.tables().forms) {
        if (form.function != function || form.cycle != cycle) continue;
        const std::string first = cell(code(form.pattern.substr(0, form.pattern.find('\n'))));
        if (std::ranges::find(words, first) == words.end()) words.push_back(first);
    }
    std::string out;
    for (const std::string& each : std::span(words).first(std::min(words.size(), kMost)))
        out += (out.empty() ? "" : ", ") + each;
    return words.size() > kMost ? out + " …" : out;
}

std::string parameters(std::span<const nc::Parameter> all) {
    std::string out;
    for (const nc::Parameter& each : all) {
        out += (out.empty() ? "`" : " `") + std::string(each.name) + (each.is_optional ? "?" : "") +
               ':' + std::string(nc::dimension_name(each.dimension)) + '`';
    }
    return out.empty() ? "—" : out;
}

std::string arguments(const nc::OperationInfo& operation) {
    const std::string least = std::to_string(operation.least_arguments);
    const std::string most = std::to_string(operation.most_arguments);
    if (least == most) return least;
    const bool is_next = operation.most_arguments == operation.least_arguments + 1;
    return least + (is_next ? " or " : " to ") + most;
}

const char* access_name(nc::QuantityInfo::Access access) {
    switch (access) {
        case nc::QuantityInfo::Access::Read: return "read";
        case nc::QuantityInfo::Access::Write: return "written";
        case nc::QuantityInfo::Access::Both: return "read and written";
    }
    return "";
}

const char* severity_name(kadr::Severity severity) {
    switch (severity) {
        case kadr::Severity::Warning: return "warning";
        case kadr::Severity::Error: return "error";
        case kadr::Severity::Alarm: return "alarm";
    }
    return "";
}

}  // namespace

std::string rules_table() { return table_of(kRules); }
std::string language_rules_table() { return table_of(kLanguageRules); }

std::string operations_table() {
    std::string out = head({"name", "arguments", "meaning"});
    for (const nc::OperationInfo& each : nc::all_operations())
        out += row({code(each.name), arguments(each), cell(each.meaning)});
    return out;
}

std::string frame_parts_table() {
    std::string out = head({"name", "meaning"});
    for (const nc::FramePartInfo& each : nc::all_frame_parts())
        out += row({code(each.name), cell(each.meaning)});
    return out;
}

std::string statements_table() {
    std::string out = head({"name", "holes", "meaning"});
    const auto all = nc::all_statements();
    for (std::size_t i = 1; i < all.size(); ++i) {  // behind `None`
        const std::string holes = nc::shown_holes(static_cast<nc::Statement>(i));
        out += row({code(all[i].name), holes.empty() ? "—" : holes, cell(all[i].meaning)});
    }
    return out;
}

std::string quantities_table() {
    std::string out = head({"name", "indices", "access", "meaning"});
    const auto all = nc::all_quantities();
    for (const nc::QuantityInfo& each : all.subspan(1)) {  // behind `None`
        out += row({code(each.name), std::to_string(each.indices), access_name(each.access),
                    cell(each.meaning)});
    }
    return out;
}

std::string commands_table() {
    std::string out = head({"command", "group", "parameters", "meaning", "SINUMERIK", "FANUC"});
    for (const nc::FunctionInfo& each : nc::all_functions()) {
        if (each.name.empty()) continue;
        const bool has_group = each.group != nc::Group::NonModal;
        out += row({code(each.name), has_group ? std::string(nc::group_name(each.group)) : "—",
                    parameters(each.parameters), cell(each.meaning),
                    spelled(shipped("sinumerik"), each.function),
                    spelled(shipped("fanuc"), each.function)});
    }
    return out;
}

std::string cycles_table() {
    std::string out = head({"cycle", "parameters", "meaning", "SINUMERIK", "FANUC"});
    for (const nc::CycleInfo& each : shipped("iso").cycles()) {
        const auto words_of = [&](const nc::Dialect& dialect) {
            const auto id = dialect.find_cycle(each.name);
            return id ? spelled(dialect, nc::Function::Cycle, *id) : "";
        };
        out += row({code(each.name), parameters(each.parameters), cell(each.meaning),
                    words_of(shipped("sinumerik")), words_of(shipped("fanuc"))});
    }
    return out;
}

std::string figures_table() {
    std::string out = head({"member", "type", "meaning"});
    for (const FigureRow& each : kFigures)
        out += row({call_of(each), type_of(each.result), cell(each.meaning)});
    return out;
}

std::string danger_limits_table() {
    std::string out = head({"name", "beyond it"});
    for (const kadr::DangerLimit& each : kadr::kDangerLimits) {
        out += row({code(each.name), kadr::format_shortest(each.value) + ' ' +
                                         std::string(each.unit) + ": " + cell(each.meaning)});
    }
    return out;
}

std::string diagnostics_table(std::string_view begin) {
    std::string out = head({"code", "name", "severity", "message", "what is behind it"});
    for (const kadr::DiagnosticRow* each : kadr::all_diagnostics()) {
        if (!each->code.starts_with(begin)) continue;
        out += row({std::string(each->code), code(each->name), severity_name(each->severity),
                    cell(each->message), cell(each->explanation)});
    }
    return out;
}

}  // namespace docs
