#include "tests/nc/nc_testing.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

#include "base/numbers.h"
#include "nc/reader.h"

namespace kadr::nc::testing {

const Dialect& shipped(const std::string& name) {
    static std::map<std::string, Dialect> loaded;
    const auto found = loaded.find(name);
    if (found != loaded.end()) return found->second;
    Sources sources;
    DiagnosticList sink;
    auto dialect = load_dialect(name, dialect_folders(), sources, sink);
    if (!dialect) {
        std::fputs(rendered(sink, sources).c_str(), stderr);
        std::abort();
    }
    return loaded.emplace(name, std::move(*dialect)).first->second;
}

std::string rendered(const DiagnosticList& list, const Sources& sources) {
    std::string all;
    for (const Diagnostic& one : list.all()) all += render_text(one, sources);
    return all;
}

std::string codes(const DiagnosticList& list) {
    std::string all;
    for (const Diagnostic& one : list.all()) {
        if (!all.empty()) all += ' ';
        all += one.row->code;
    }
    return all;
}

SourceWord source_word(std::string_view text) {
    SourceWord word;
    std::size_t letters = 0;
    while (letters < text.size() && (text[letters] >= 'A' && text[letters] <= 'Z')) ++letters;
    word.address = text.substr(0, letters);
    std::string_view value = text.substr(letters);
    if (value.empty()) return word;
    if (value.starts_with("=")) value.remove_prefix(1);
    if (value.starts_with("AC(")) word.mode = SourceWord::Mode::Absolute;
    if (value.starts_with("IC(")) word.mode = SourceWord::Mode::Incremental;
    if (word.mode != SourceWord::Mode::Modal) value = value.substr(3, value.size() - 4);
    word.value = SourceWord::Value::Literal;
    word.number = parse_decimal(value.data(), value.data() + value.size()).value;
    return word;
}

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        std::string_view part = text.substr(0, end);
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        if (!part.empty()) parts.push_back(part);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

Block words_block(const Dialect& dialect, std::string_view text) {
    std::vector<SourceWord> words;
    for (const std::string_view part : split(text, ' ')) words.push_back(source_word(part));
    DiagnosticList sink;
    auto plan = plan_block(dialect, words, sink);
    if (!plan) {
        std::fprintf(stderr, "%.*s: %s\n", static_cast<int>(text.size()), text.data(),
                     sink.all()[0].message().c_str());
        std::abort();
    }
    Block block = plan->block;
    for (const Hole& hole : plan->holes) {
        const double value = words[hole.word].number * hole.factor + hole.offset;
        if (hole.is_argument) {
            block.set_argument(block.functions[hole.invocation], hole.parameter, value);
        } else {
            block.set(static_cast<Slot>(hole.index), value);
        }
    }
    return block;
}

Block command_block(const Dialect& dialect, std::string_view name, std::string_view arguments) {
    Block block;
    std::span<const Parameter> parameters;
    Invocation* invocation = nullptr;
    if (const auto cycle = dialect.find_cycle(name)) {
        parameters = dialect.cycles()[*cycle].parameters;
        invocation = block.add(Function::Cycle, parameters.size());
        block.cycle = *cycle;
    } else if (const auto function = find_function(name)) {
        parameters = info(*function).parameters;
        invocation = block.add(*function, parameters.size());
    } else {
        std::fprintf(stderr, "no command %.*s\n", static_cast<int>(name.size()), name.data());
        std::abort();
    }
    std::size_t next = 0;
    for (std::string_view part : split(arguments, ',')) {
        const std::size_t colon = part.find(':');
        if (colon != std::string_view::npos) {
            for (next = 0;
                 next < parameters.size() && parameters[next].name != part.substr(0, colon);)
                ++next;
            part = split(part.substr(colon + 1), ' ')[0];
        }
        if (parameters[next].dimension == Dimension::Text) {
            block.text = std::string(arguments.substr(1, arguments.size() - 2));
            break;
        }
        const double number =
            part == "true" ? 1 : parse_decimal(part.data(), part.data() + part.size()).value;
        block.set_argument(*invocation, next, number);
        ++next;
    }
    return block;
}

}  // namespace

Block source_block(const Dialect& dialect, std::string_view statement) {
    if (statement.ends_with(';')) statement.remove_suffix(1);
    const bool is_command = !statement.empty() && statement[0] >= 'a' && statement[0] <= 'z';
    if (!is_command) return words_block(dialect, statement);
    const std::size_t open = statement.find('(');
    return command_block(dialect, statement.substr(0, open),
                         statement.substr(open + 1, statement.size() - open - 2));
}

ReadText read_blocks(const Dialect& dialect, std::string_view text) {
    ReadText result;
    OneText source(text);
    Reader reader(dialect, source, "test", result.messages);
    std::vector<Block> batch(7);
    while (const std::size_t count = reader.pull(batch)) {
        result.blocks.insert(result.blocks.end(), batch.begin(),
                             batch.begin() + static_cast<std::ptrdiff_t>(count));
    }
    result.failed = reader.failed();
    return result;
}

}  // namespace kadr::nc::testing
