#include "write/check.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "base/diagnostics/dialect.h"
#include "base/numbers.h"
#include "nc/program_head.h"
#include "nc/reader.h"
#include "nc/tables.h"
#include "write/spelling.h"
#include "write/writer.h"

namespace kadr::write {

namespace {

/// `(0=-10, 1=2)` at the front of the text, which is taken off: `(to=-10, retract=2)`.
std::string named_arguments(const nc::CycleInfo& cycle, std::string_view& text) {
    std::string out;
    const std::size_t close = std::min(text.find(')'), text.size() - 1);
    std::string_view rest = text.substr(0, close + 1);
    text.remove_prefix(rest.size());
    while (!rest.empty()) {
        out += rest.front();
        rest.remove_prefix(1);
        const bool begins = out.back() == '(' || out.back() == ' ';
        std::size_t index = 0;
        const auto number = std::from_chars(rest.data(), rest.data() + rest.size(), index);
        const bool is_index = begins && number.ec == std::errc() &&
                              number.ptr != rest.data() + rest.size() && *number.ptr == '=' &&
                              index < cycle.parameters.size();
        if (!is_index) continue;
        out += cycle.parameters[index].name;
        rest.remove_prefix(static_cast<std::size_t>(number.ptr - rest.data()));
    }
    return out;
}

/// Cycles and their parameters by name: `cycle#0(0=-10, 1=2)` is `drill(to=-10, retract=2)`.
std::string with_names(const Dialect& dialect, std::string_view text) {
    std::string out;
    while (true) {
        const std::size_t sign = text.find('#');
        out += text.substr(0, sign);
        if (sign == std::string_view::npos) return out;
        const char* const end = text.data() + text.size();
        std::size_t id = 0;
        const auto number = std::from_chars(text.data() + sign + 1, end, id);
        const bool is_cycle = number.ec == std::errc() && id < dialect.cycles().size();
        if (!is_cycle) {
            out += '#';
            text.remove_prefix(sign + 1);
            continue;
        }
        constexpr std::string_view kPlain = "cycle";
        const bool is_preset = !out.ends_with(kPlain);
        if (is_preset) out += ' ';
        else out.resize(out.size() - kPlain.size());
        const nc::CycleInfo& cycle = dialect.cycles()[id];
        out += cycle.name;
        text.remove_prefix(static_cast<std::size_t>(number.ptr - text.data()));
        if (text.starts_with('(')) out += named_arguments(cycle, text);
    }
}

/// What a text means, a line for every block that means something; or why it cannot be read.
struct Reading {
    std::string blocks;
    std::string fault;
};

/// The message about a text, and of several lines the one that it is about.
std::string fault_of(const Diagnostic& message, std::string_view text) {
    const bool has_lines = text.find('\n') != std::string_view::npos;
    if (!has_lines || !message.line) return message.message();
    return message.message() + ", in line " + std::to_string(message.line->line);
}

Reading read(const Dialect& dialect, std::string_view text) {
    Reading reading;
    DiagnosticList messages;
    nc::WholeText source(text);
    nc::Reader reader(dialect, source, "example", messages);
    std::array<Block, 8> batch;
    while (const std::size_t count = reader.pull(batch)) {
        for (const Block& block : std::span(batch).first(count)) {
            if (!reading.blocks.empty()) reading.blocks += '\n';
            reading.blocks += with_names(dialect, describe(block));
        }
    }
    if (!messages.all().empty()) reading.fault = fault_of(messages.all()[0], text);
    return reading;
}

/// Whether two descriptions mean the same. A value that went through the units of the language and
/// one that was read need not be the same to the last bit: 2000 and 2000.0000000000002.
bool is_same_meaning(std::string_view a, std::string_view b) {
    constexpr double kRounding = 1e-12;  // of the value; sixteen digits, and a few operations
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    while (!a.empty() && !b.empty()) {
        if (is_digit(a.front()) && is_digit(b.front())) {
            const Decimal one = parse_decimal(a.data(), a.data() + a.size());
            const Decimal other = parse_decimal(b.data(), b.data() + b.size());
            const double most = std::max(one.value, other.value);
            if (std::abs(one.value - other.value) > kRounding * most) return false;
            a.remove_prefix(static_cast<std::size_t>(one.end - a.data()));
            b.remove_prefix(static_cast<std::size_t>(other.end - b.data()));
        } else {
            if (a.front() != b.front()) return false;
            a.remove_prefix(1);
            b.remove_prefix(1);
        }
    }
    return a.empty() && b.empty();
}

/// Words of a meaning or of an outcome: `drill(to=-10, retract=2)` are three.
std::vector<std::string_view> words_of_meaning(std::string_view line) {
    constexpr std::string_view kBetween = " (,)|";
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t first = line.find_first_not_of(kBetween);
        if (first == std::string_view::npos) return words;
        const std::size_t end = std::min(line.find_first_of(kBetween, first), line.size());
        words.push_back(line.substr(first, end - first));
        line.remove_prefix(end);
    }
}

/// The line with this number, from 0, and how many there are.
std::string_view line_of(std::string_view text, std::size_t number) {
    for (; number > 0; --number) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    return text.substr(0, text.find('\n'));
}

/// A text of several lines in one.
std::string one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        if (c == '\n') line += " ⏎ ";
        else if (c != '\r') line += c;
    }
    return line;
}

/// The text with line ends as the file may have them.
std::string without_returns(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c != '\r') out += c;
    }
    return out;
}

/// Why the text has not the form that its author may have expected; each is reported once.
void note_refusals(const std::vector<Refusal>& refusals, DiagnosticBuilder& message) {
    constexpr std::size_t kMost = 4;
    std::vector<std::string> noted;
    for (const Refusal& refusal : refusals) {
        std::string note = "`" + refusal.pattern + "` is not taken: " + refusal.why;
        if (std::ranges::find(noted, note) != noted.end() || noted.size() == kMost) continue;
        message.note(refusal.range, note);
        noted.push_back(std::move(note));
    }
}

}  // namespace

std::string first_difference(std::string_view found, std::string_view example) {
    const auto lines = static_cast<std::size_t>(
        std::max(std::ranges::count(found, '\n'), std::ranges::count(example, '\n')));
    for (std::size_t i = 0; i <= lines; ++i) {
        const std::string_view line = line_of(found, i);
        const std::string_view other = line_of(example, i);
        if (is_same_meaning(line, other)) continue;
        const std::vector<std::string_view> words = words_of_meaning(line);
        const std::vector<std::string_view> others = words_of_meaning(other);
        std::size_t k = 0;
        while (k < words.size() && k < others.size() && is_same_meaning(words[k], others[k])) ++k;
        const auto shown = [&](const std::vector<std::string_view>& all) {
            return k < all.size() ? '`' + std::string(all[k]) + '`' : std::string("nothing more");
        };
        std::string text = lines > 0 ? "in block " + std::to_string(i + 1) + ": " : "";
        return text + "it is " + shown(words) + " where the example says " + shown(others);
    }
    return {};
}

void check_frame(const Dialect& dialect, DiagnosticSink& sink) {
    for (const bool is_inch : {false, true}) {
        if (is_inch && !dialect.can_write(Function::Inch)) continue;
        DiagnosticList messages;
        Writer writer(dialect, {}, messages);
        std::string text;
        writer.begin({"example", 1, "title", is_inch}, text);
        writer.write(Block{}, text);
        writer.end(text);
        while (text.ends_with('\n') || text.ends_with('\r')) text.pop_back();
        const std::string fault =
            messages.all().empty() ? read(dialect, text).fault : messages.all()[0].message();
        if (fault.empty()) continue;
        const nc::ProgramTemplates& frame = dialect.tables().program;
        auto message = sink.report(diag::DialectTextUnread,
                                   frame.is_inherited ? dialect.tables().root : frame.range);
        message.arg(one_line(text)).arg(fault);
        if (frame.is_inherited) {
            message.note(frame.range, "these lines are inherited")
                .fix("give the dialect a `<program>` of its own");
        }
        return;
    }
}

void check_example(const Dialect& dialect, const Example& example, std::span<const Block> blocks,
                   DiagnosticSink& sink, std::vector<Refusal> refusals) {
    std::string meant = with_names(dialect, example.block);
    if (!blocks.empty()) {
        const Spelling writing = spelling_of(dialect, blocks, &refusals);
        const std::string text = without_returns(writing.text);
        if (!writing.fault.empty()) {
            sink.report(diag::DialectExampleSource, example.source_range).arg(writing.fault);
            return;
        }
        if (text != without_returns(example.text)) {
            DiagnosticBuilder message =
                sink.report(diag::DialectExampleWritten, example.text_range);
            message.arg(one_line(text)).arg(one_line(example.text));
            if (text.find('\n') != std::string::npos)  // both stand in the message
                message.note(
                    first_difference(without_returns(text), without_returns(example.text)));
            note_refusals(refusals, message);
            return;
        }
        if (meant.empty()) {
            for (const Block& block : blocks) {
                if (!meant.empty()) meant += '\n';
                meant += with_names(dialect, describe(block));
            }
        }
    }
    const Reading reading = read(dialect, example.text);
    if (!reading.fault.empty()) {
        sink.report(diag::DialectTextUnread, example.text_range)
            .arg(one_line(example.text))
            .arg(reading.fault);
    } else if (!meant.empty() && !is_same_meaning(reading.blocks, meant)) {
        sink.report(diag::DialectExampleMeans,
                    example.block.empty() ? example.text_range : example.block_range)
            .arg(one_line(example.text))
            .arg(one_line(reading.blocks))
            .arg(one_line(meant))
            .note(first_difference(reading.blocks, meant));
    }
}

}  // namespace kadr::write
