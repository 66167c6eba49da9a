#include "nc/passed_over.h"

#include <algorithm>
#include <string>

#include "base/diagnostics/iso.h"

namespace kadr::nc {

namespace {

/// Where the first word of the form stands.
Span span_of_form(const Form& form, const LexedLine& words, std::string_view line) {
    for (std::size_t i = 0; i < words.words.size(); ++i) {
        const GivenWord& word = words.words[i];
        if (word.address == form.words[0].address && word.number == form.words[0].number)
            return words.spans[i];
    }
    return {0, static_cast<std::uint32_t>(line.size())};
}

}  // namespace

void PassedOver::announce(const LexedLine& words, std::string_view line) {
    for (const LexedLine::Passed& passed : words.passed) {
        if (!passed.word->is_given || !reported_words_.insert(passed.word).second) continue;
        const Span& span = passed.span;
        DiagnosticBuilder builder = faults_.message(diag::WordPassed, line, span);
        builder.arg(line.substr(span.begin, span.end - span.begin)).arg(passed.word->meaning);
        faults_.write_notes(builder);
    }
}

void PassedOver::announce(FormId id, const LexedLine& words, std::string_view line) {
    const Form& form = tables_.forms[id];
    const bool is_reported =
        form.passed.empty() || std::ranges::find(reported_forms_, id) != reported_forms_.end();
    if (is_reported) return;
    reported_forms_.push_back(id);
    const Span span = span_of_form(form, words, line);
    DiagnosticBuilder message = faults_.message(diag::IsoPassedOver, line, span);
    message.arg(std::string(line.substr(span.begin, span.end - span.begin))).arg(form.passed);
    faults_.write_notes(message);
}

bool PassedOver::leave_out(const MatchFault& fault, LexedLine& words, std::string_view line) {
    const PassedWord* const found = beside(fault, words);
    if (found == nullptr) return false;
    words.words[fault.word].is_left_out = true;
    const auto is_known = [&](const LexedLine::Passed& passed) { return passed.word == found; };
    if (std::ranges::none_of(words.passed, is_known))
        words.passed.push_back({words.spans[fault.word], found});
    announce(words, line);
    return true;
}

/// What a word that no form takes is to another one of the block, as P to the function of the
/// machine in `M59 P10`; null: it belongs to none.
const PassedWord* PassedOver::beside(const MatchFault& fault, const LexedLine& words) const {
    if (fault.kind != MatchFault::Kind::Unused && fault.kind != MatchFault::Kind::Value)
        return nullptr;
    const GivenWord& word = words.words[fault.word];
    const std::string front = tables_.addresses[word.address].name + '@';
    const auto first = tables_.passed.lower_bound(front);
    if (first == tables_.passed.end() || !first->first.starts_with(front)) return nullptr;
    const PassedWord* found = nullptr;
    for (const GivenWord& other : words.words) {
        const Address& address = tables_.addresses[other.address];
        std::string name = address.name;
        if (address.kind == Address::Kind::Code) {
            const CodeStart* const code =
                other.is_known ? tables_.find_code(other.address, other.number) : nullptr;
            const Function function = code == nullptr ? Function::MachineFunction
                                                      : tables_.forms[code->forms[0]].function;
            name = info(function).name;
        }
        const auto rule = tables_.passed.find(front + name);
        if (&other != &word && rule != tables_.passed.end() && found == nullptr)
            found = &rule->second;
    }
    // What is reported of several words is reported once.
    for (auto same = first; found != nullptr && same->first.starts_with(front); ++same) {
        if (same->second.meaning != found->meaning) continue;
        found = &same->second;
        break;
    }
    return found;
}

}  // namespace kadr::nc
