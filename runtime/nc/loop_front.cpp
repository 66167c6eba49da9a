#include "nc/loop_front.h"

#include "nc/letters.h"

namespace kadr::nc {

namespace {

constexpr int kMostNumber = 100000;  // what no control takes any more

}  // namespace

bool begins_with_loop(const StatementForm& form) {
    using Kind = StatementToken::Kind;
    return form.tokens.size() > 2 && form.tokens[0].text.size() == 1 &&
           form.tokens[1].kind == Kind::Hole && form.tokens[1].hole == StatementToken::Hole::Loop &&
           form.tokens[2].kind == Kind::Word;
}

std::optional<int> loop_in_front(const ControlWords& words, std::string_view line,
                                 const StatementForm& form, std::size_t at) {
    if (!words.starts_with(at, form.tokens[0].text)) return std::nullopt;
    at = words.skip_blanks(at + 1);
    const std::size_t first = at;
    int number = 0;
    for (; at < line.size() && is_digit(line[at]) && number < kMostNumber; ++at)
        number = number * 10 + (line[at] - '0');
    if (at == first) return std::nullopt;
    const LetterRun keyword = words.word_at(words.skip_blanks(at));
    return words.matches(keyword, form.tokens[2].text) ? std::optional(number) : std::nullopt;
}

std::optional<std::size_t> behind_front(const ControlWords& words, std::string_view line,
                                        const StatementForm& form, std::size_t at) {
    for (const char sign : form.front) {
        if (at >= line.size() || line[at] != sign) return std::nullopt;
        at = words.skip_blanks(at + 1);
    }
    return at;
}

}  // namespace kadr::nc
