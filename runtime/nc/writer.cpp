#include "nc/writer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/units.h"
#include "nc/block_writer.h"
#include "nc/comment_text.h"

namespace kadr::nc {

/// The frame of the program around the block writer: header, safety line, end.
struct Writer::State {
    State(const Dialect& dialect, const WriteOptions& options, DiagnosticSink& sink)
        : tables(dialect.tables()), blocks(dialect, options, sink) {}

    const DialectTables& tables;
    BlockWriter blocks;
    std::vector<std::string> start_lines;  // waiting for the first block that does something
    std::vector<std::string> end_lines;
    bool has_started = false;
};

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

}  // namespace

namespace {

/// Whether no line in front of the first block says the units, and the control begins with others.
bool needs_units(const DialectTables& tables, const ProgramInfo& program) {
    const auto says_units = [](const std::string& line) {
        return line.find("{units}") != std::string::npos;
    };
    if (std::ranges::any_of(tables.program.header, says_units) ||
        std::ranges::any_of(tables.program.start, says_units))
        return false;
    const Function first = tables.power_on[static_cast<std::size_t>(Group::Units)];
    return first != (program.is_inch ? Function::Inch : Function::Metric);
}

}  // namespace

Writer::Writer(const Dialect& dialect, WriteOptions options, DiagnosticSink& sink)
    : state_(std::make_unique<State>(dialect, options, sink)) {}
Writer::~Writer() = default;

void Writer::set_statements(std::span<const SourceRange> statements, const Sources* sources) {
    state_->blocks.set_statements(statements, sources);
}

void Writer::begin(const ProgramInfo& program, std::string& out) {
    State& s = *state_;
    s.blocks.begin(program);
    Template filler(s.tables, program);
    for (const std::string& line : s.tables.program.header) {
        const std::string filled = filler.fill(line);
        if (!filled.empty()) s.blocks.write_line(filled, false, out);
    }
    s.start_lines.clear();
    if (needs_units(s.tables, program)) s.start_lines.push_back(filler.fill("{units}"));
    for (const std::string& line : s.tables.program.start)
        s.start_lines.push_back(filler.fill(line));
    s.end_lines.clear();
    for (const std::string& line : s.tables.program.end) s.end_lines.push_back(filler.fill(line));
    s.has_started = false;
}

std::uint32_t Writer::write(const Block& block, std::string& out) {
    State& s = *state_;
    if (!s.has_started && block.kind != Block::Kind::Comment) {
        s.has_started = true;
        for (const std::string& line : s.start_lines) s.blocks.write_start_line(line, out);
    }
    return s.blocks.write(block, out);
}

void Writer::end(std::string& out) {
    State& s = *state_;
    if (!s.has_started) {
        s.has_started = true;
        for (const std::string& line : s.start_lines) s.blocks.write_start_line(line, out);
    }
    if (!s.blocks.has_ended()) {
        for (const std::string& line : s.tables.program.finish)
            s.blocks.write_line(line, true, out);
    }
    for (const std::string& line : s.end_lines) s.blocks.write_line(line, false, out);
}

std::uint32_t Writer::lines() const { return state_->blocks.lines(); }
bool Writer::failed() const { return state_->blocks.failed(); }
const WriterModal& Writer::believed() const { return state_->blocks.modal(); }

}  // namespace kadr::nc
