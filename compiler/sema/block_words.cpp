#include "sema/block_words.h"

#include <algorithm>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/sema.h"
#include "base/numbers.h"
#include "nc/lost_words.h"
#include "sema/checking.h"
#include "sema/unknown_names.h"
#include "syntax/parse.h"

namespace kadr::sema {

using syntax::Word;

namespace {

std::optional<nc::BlockPlan> plan_source(Check& check, const nc::Dialect& dialect,
                                         std::span<const nc::SourceWord> source);
std::string hint_of_command(Check& check, std::string_view word);
std::string hint_of_call(Check& check, std::span<const nc::SourceWord> source);

}  // namespace

std::string word_text(const Check& check, const Word& word) {
    std::string all(check.ast().text(word.address));
    if (word.form == Word::Form::Literal) append_shortest(all, word.number);
    else if (word.form == Word::Form::Assigned) all += '=';
    else if (word.form == Word::Form::Increment) all += "+=";
    return all;
}

namespace {

/// Whether no word of the file before it is the same: what is lost is reported once, at its first
/// location.
bool is_first(const syntax::Ast& ast, const nc::LostWord& lost) {
    const auto is_same = [&](const Word& a, const Word& b) {
        return ast.text(a.address) == ast.text(b.address) && a.form == b.form &&
               a.number == b.number;
    };
    const std::vector<Word>& words = ast.words;
    const auto at = std::ranges::find(words, lost.range.begin,
                                      [](const Word& word) { return word.range.begin; });
    // `Q1` of `G05.1 Q1` tells it from `G05.1 Q0`.
    const bool is_pair = lost.text.find(' ') != std::string::npos && std::next(at) != words.end();
    for (auto before = words.begin(); before != at; ++before) {
        const bool is_it =
            is_same(*before, *at) && (!is_pair || is_same(*std::next(before), *std::next(at)));
        if (is_it && before->range.begin < lost.range.begin) return false;
    }
    return true;
}

}  // namespace

std::optional<nc::BlockPlan> plan_words(Check& check, std::span<const Word> words) {
    std::vector<nc::SourceWord> source;
    source.reserve(words.size());
    for (const Word& word : words) {
        nc::SourceWord entry;
        entry.address = check.text(word.address);
        entry.value = word.form == Word::Form::Bare      ? nc::SourceWord::Value::None
                      : word.form == Word::Form::Literal ? nc::SourceWord::Value::Literal
                                                         : nc::SourceWord::Value::Computed;
        entry.number = word.number;
        entry.mode = static_cast<nc::SourceWord::Mode>(word.mode);
        if (word.form == Word::Form::Increment) entry.mode = nc::SourceWord::Mode::Incremental;
        entry.range = word.range;
        source.push_back(entry);
    }
    const nc::Dialect& dialect = check.dialect();
    if (dialect.is_core()) return plan_source(check, dialect, source);
    for (const nc::LostWord& lost : nc::lost_words(dialect, source)) {
        if (is_first(check.ast(), lost))
            check.report(diag::SourceWordLost, lost.range).arg(lost.text).arg(lost.why);
    }
    return plan_source(check, dialect, source);
}

namespace {

/// The plan of a block; what the cycle of another control is here, is reported beside what is
/// wrong.
std::optional<nc::BlockPlan> plan_source(Check& check, const nc::Dialect& dialect,
                                         std::span<const nc::SourceWord> source) {
    DiagnosticList messages;
    std::optional<nc::BlockPlan> plan = nc::plan_block(dialect, source, messages);
    for (Diagnostic diagnostic : messages.all()) {
        std::string hint;
        if (diagnostic.row == &diag::BlockWordCodeUnknown) {
            hint = hint_of_cycle(check, diagnostic.arguments[0]);
            if (hint.empty()) hint = hint_of_command(check, diagnostic.arguments[0]);
        } else if (diagnostic.row == &diag::BlockWordUnused) {
            hint = hint_of_call(check, source);
        }
        if (!hint.empty()) diagnostic.fixes.push_back({{}, {}, hint});
        check.sink.take(std::move(diagnostic));
    }
    return plan;
}

}  // namespace

/// What to write for the cycle of another control, `G83` or `CYCLE81`; empty: it is none.
std::string hint_of_cycle(Check& check, std::string_view word) {
    if (!take_proposal(check)) return "";
    const auto cycle = check.loader.cycle_of_control(word);
    if (!cycle) return "";
    return "this cycle is `" + cycle->function + "(…)` for every control, `import " +
           cycle->module + ";` brings it in; `dialect " + cycle->dialect +
           ";` at the head of the file takes " + quoted(word);
}

namespace {

/// What to write for a word of another control that begins no cycle, `G68` or `G65`; empty: no
/// control has it.
std::string hint_of_command(Check& check, std::string_view word) {
    if (!take_proposal(check)) return "";
    const auto command = check.loader.command_of_control(word);
    if (!command) return "";
    if (command->function.empty()) return syntax::kCallByName;
    return "this is `" + command->function + "(…)` for every control; `dialect " +
           command->dialect + ";` at the head of the file takes " + quoted(word);
}

/// `M98 P100`: to the common core an M function of the machine's builder, with a word too many.
std::string hint_of_call(Check& check, std::span<const nc::SourceWord> source) {
    for (const nc::SourceWord& word : source) {
        if (word.value != nc::SourceWord::Value::Literal || !take_proposal(check)) continue;
        std::string text(word.address);
        append_shortest(text, word.number);
        const auto command = check.loader.command_of_control(text);
        if (command && command->function.empty()) return syntax::kCallByName;
    }
    return "";
}

}  // namespace

}  // namespace kadr::sema
