#include "nc/program_lines.h"

#include <algorithm>
#include <string_view>

#include "nc/comment_text.h"

namespace kadr::nc {

namespace {

/// `{name}`, `{NAME}`, `{number:04}`, `{title}`, `{TITLE}`, `{units}`; `[…]` stands only if what
/// its placeholders name is not empty.
class Template {
  public:
    Template(const DialectTables& tables, const ProgramInfo& program)
        : tables_(tables), program_(program) {}

    std::string fill(std::string_view text) {
        std::string out;
        for (std::size_t at = 0; at < text.size();) {
            if (text[at] == '[') {
                const std::size_t close = std::min(text.find(']', at), text.size());
                empty_ = false;
                const std::string inner = fill_plain(text.substr(at + 1, close - at - 1));
                if (!empty_) out += inner;
                at = close + 1;
            } else {
                const std::size_t end = std::min(text.find('[', at), text.size());
                out += fill_plain(text.substr(at, end - at));
                at = end;
            }
        }
        return out;
    }

  private:
    std::string fill_plain(std::string_view text) {
        std::string out;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t close = text[at] == '{' ? text.find('}', at) : std::string_view::npos;
            if (close == std::string_view::npos) {
                out += text[at++];
                continue;
            }
            const std::string value = value_of(text.substr(at + 1, close - at - 1));
            empty_ |= value.empty();
            out += value;
            at = close + 1;
        }
        return out;
    }

    std::string value_of(std::string_view name) const {
        if (name == "name") return comment_text(program_.name, tables_.comment);
        if (name == "NAME") return program_name(program_.name, tables_.program);
        if (name == "title") return comment_text(program_.title, tables_.comment);
        if (name == "units") return units();
        if (name.starts_with("number")) {
            std::string digits = std::to_string(program_.number);
            const std::size_t colon = name.find(":0");
            const int width = colon == std::string_view::npos ? 0 : name[colon + 2] - '0';
            while (digits.size() < static_cast<std::size_t>(width))
                digits.insert(digits.begin(), '0');
            return digits;
        }
        return {};
    }

    std::string units() const {
        const Function function = program_.is_inch ? Function::Inch : Function::Metric;
        const auto& forms = tables_.forms_of[static_cast<std::size_t>(function)];
        return forms.empty() ? std::string() : tables_.forms[forms[0]].pattern;
    }

    const DialectTables& tables_;
    const ProgramInfo& program_;
    bool empty_ = false;
};

/// Whether no line in front of the first block programs the units, and the control begins with
/// others.
bool needs_units(const DialectTables& tables, const ProgramInfo& program) {
    const auto has_units = [](const std::string& line) {
        return line.find("{units}") != std::string::npos;
    };
    if (std::ranges::any_of(tables.program.header, has_units) ||
        std::ranges::any_of(tables.program.start, has_units, &StartLine::text))
        return false;
    const Function first = tables.power_on[static_cast<std::size_t>(Group::Units)];
    return first != (program.is_inch ? Function::Inch : Function::Metric);
}

/// A control need not have a function that no program uses: its reset stands only where it is.
bool is_wanted(const StartLine& line, const ProgramInfo& program) {
    if (line.uses.empty() || program.used == nullptr) return true;
    return std::ranges::any_of(line.uses, [&](Function function) {
        return program.used->test(static_cast<std::size_t>(function));
    });
}

}  // namespace

ProgramLines program_lines(const DialectTables& tables, const ProgramInfo& program) {
    const ProgramTemplates& frame = tables.program;
    Template filler(tables, program);
    ProgramLines lines;
    for (const std::string& line : frame.header) {
        std::string filled = filler.fill(line);
        if (!filled.empty()) lines.header.push_back(std::move(filled));
    }
    if (needs_units(tables, program)) lines.start.push_back(filler.fill("{units}"));
    for (const StartLine& line : frame.start)
        if (is_wanted(line, program)) lines.start.push_back(filler.fill(line.text));
    for (const std::string& line : frame.section) lines.section.push_back(filler.fill(line));
    lines.finish = frame.finish;
    for (const std::string& line : frame.end) lines.end.push_back(filler.fill(line));
    return lines;
}

}  // namespace kadr::nc
