#include "syntax/habits.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/text.h"

namespace kadr::syntax {

namespace {

constexpr std::string_view kReal =
    "numbers with a fraction are `real`, measures `length`, `angle`, `time`, `feed`, `speed`";
constexpr std::string_view kInt = "whole numbers are `int`, of 64 bits and with a sign";
constexpr std::string_view kText = "texts are `string`, in double quotes";
constexpr std::string_view kAuto = "`auto` takes the type of the value";
constexpr std::string_view kLasting =
    "a variable lives in its block; one for all functions stands outside of them, with `const` if "
    "it "
    "never changes";
constexpr std::string_view kOutput =
    "`note \"n = {n}\";` is a comment in the output, `message(\"…\")` shows at the control, "
    "`warn(\"…\")` is a warning of Kadr";
constexpr std::string_view kFormat = "values stand in braces: `\"n = {n}, x = {x:.3}\"`";
constexpr std::string_view kNothing =
    "a variable may be not given: `length? a`, asked with `given a`; `a ?? 3mm` supplies a value";
constexpr std::string_view kJump =
    "there are no jumps: `while` and `for` repeat, `break`, `continue` and `return` leave";
constexpr std::string_view kFunction =
    "a function begins with the type of its result, `length f(length a) { … }`, or with `void`";
constexpr std::string_view kDeclaration =
    "a variable is declared by its type and its name, `real a = 5.5;`, a function so as well, "
    "`length f(length a) { … }`";
constexpr std::string_view kCall = "a function is called by its name: `f(5mm);`";
constexpr std::string_view kReturn = "`return;` leaves a function, its `}` ends it";
constexpr std::string_view kElse = "another condition begins with two words: `else if (…)`";
constexpr std::string_view kBraces = "a body stands in braces: `{ … }`";
constexpr std::string_view kUntil = "a loop with its condition at the end: `do { … } while (…);`";
constexpr std::string_view kEach = "a loop over a list: `for (length x : list) { … }`";
constexpr std::string_view kFault =
    "`error(\"…\")` ends the program with a message, `require(…, \"…\")` asks for a condition";
constexpr std::string_view kMemory = "arrays grow by themselves: `list.append(x)`";
constexpr std::string_view kWait = "to wait: `dwell(0.5s)`";
constexpr std::string_view kPlainNames = "functions have no name in front: `sin(a)`, `sqrt(x)`";
constexpr std::string_view kOneType = "a type has one name; several values together are a `struct`";

/// Words in lower case, in the order of the alphabet.
constexpr Habit kHabits[] = {
    {"acosf", "acos", ""},
    {"begin", "", kBraces, true},
    {"boolean", "bool", "truth values are `bool`"},
    {"byte", "int", kInt},
    {"call", "", kCall, true},
    {"calloc", "", kMemory},
    {"catch", "", kFault, true},
    {"ceilf", "ceil", ""},
    {"char", "string", kText},
    {"console", "", kOutput},
    {"cosf", "cos", ""},
    {"cout", "", kOutput},
    {"def", "", kDeclaration, true},
    {"delay", "", kWait},
    {"double", "real", kReal},
    {"echo", "", kOutput, true},
    {"elif", "", kElse, true},
    {"elseif", "", kElse, true},
    {"elsif", "", kElse, true},
    {"end", "", kBraces, true},
    {"end_for", "", kBraces, true},
    {"end_if", "", kBraces, true},
    {"end_while", "", kBraces, true},
    {"endfor", "", kBraces, true},
    {"endif", "", kBraces, true},
    {"endloop", "", kBraces, true},
    {"endproc", "", kBraces, true},
    {"endwhile", "", kBraces, true},
    {"exit", "", "`return;` leaves a function, `error(\"…\")` ends the program with a message"},
    {"extern", "", kLasting, true},
    {"fabs", "abs", "the amount of every quantity"},
    {"false", "false", ""},
    {"fi", "", kBraces, true},
    {"float", "real", kReal},
    {"floorf", "floor", ""},
    {"fmod", "mod", "the rest of a division, as `a % b`"},
    {"foreach", "", kEach, true},
    {"fprintf", "", kOutput},
    {"free", "", kMemory},
    {"function", "", kFunction, true},
    {"gosub", "", kFunction, true},
    {"goto", "", kJump, true},
    {"gotob", "", kJump, true},
    {"gotoc", "", kJump, true},
    {"gotof", "", kJump, true},
    {"gotos", "", kJump, true},
    {"include", "", "`import cycles.drilling;` brings names in", true},
    {"inline", "", kFunction, true},
    {"int16_t", "int", kInt},
    {"int32_t", "int", kInt},
    {"int64_t", "int", kInt},
    {"int8_t", "int", kInt},
    {"integer", "int", kInt},
    {"jump", "", kJump, true},
    {"lambda", "", kFunction, true},
    {"len", "", "a list has as many elements as `list.count`, a text as many letters"},
    {"let", "auto", kAuto, true},
    {"long", "int", kInt, true},
    {"loop", "", "loops are `while (…) { … }` and `for (int i = 0; i < n; i++) { … }`", true},
    {"m_pi", "pi", ""},
    {"malloc", "", kMemory},
    {"math", "", kPlainNames},
    {"new", "", kMemory, true},
    {"nil", "", kNothing},
    {"none", "", kNothing},
    {"null", "", kNothing},
    {"nullptr", "", kNothing},
    {"number", "real", kReal},
    {"pi", "pi", ""},
    {"print", "", kOutput},
    {"printf", "", kOutput},
    {"println", "", kOutput},
    {"proc", "", kFunction, true},
    {"puts", "", kOutput},
    {"realloc", "", kMemory},
    {"register", "", kLasting, true},
    {"repeat", "", kUntil, true},
    {"ret", "", kReturn, true},
    {"short", "int", kInt, true},
    {"signed", "int", kInt, true},
    {"sinf", "sin", ""},
    {"size_t", "int", kInt},
    {"sizeof", "", "a list has as many elements as `list.count`"},
    {"sleep", "", kWait},
    {"snprintf", "", kFormat},
    {"sprintf", "", kFormat},
    {"sqr", "", "a square is `x*x`, a root `sqrt(x)`"},
    {"sqrtf", "sqrt", ""},
    {"static", "", kLasting, true},
    {"std", "", kPlainNames, true},
    {"str", "text", "a value as a text"},
    {"strcat", "", "texts are joined with `+`"},
    {"strcmp", "", "texts are compared with `==`"},
    {"strlen", "", "a text has as many letters as `s.count`"},
    {"sub", "", kFunction, true},
    {"tanf", "tan", ""},
    {"then", "", kBraces, true},
    {"throw", "", kFault, true},
    {"tostring", "text", "a value as a text"},
    {"true", "true", ""},
    {"try", "", kFault, true},
    {"typedef", "", kOneType, true},
    {"uint16_t", "int", kInt},
    {"uint32_t", "int", kInt},
    {"uint64_t", "int", kInt},
    {"uint8_t", "int", kInt},
    {"undefined", "", kNothing},
    {"unsigned", "int", kInt, true},
    {"until", "", kUntil, true},
    {"using", "", "`import cycles.drilling;` brings names in", true},
    {"var", "auto", kAuto, true},
    {"volatile", "", kLasting, true},
    {"wait", "", kWait},
    {"wend", "", kBraces, true},
};

}  // namespace

std::string lower_ascii(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
    }
    return lower;
}

std::string form_of_statement(std::string_view keyword, bool jumps) {
    constexpr std::pair<std::string_view, std::string_view> kForms[] = {
        {"if", "`if (a < 3) { … } else { … }`"},
        {"while", "`while (a < 3) { … }`"},
        {"for", "`for (int i = 0; i < n; i++) { … }`"},
        {"case", "`switch (n) { case 1: … break; default: … }`"},
    };
    const auto* const form =
        std::ranges::find(kForms, keyword, [](const auto& f) { return f.first; });
    if (form == std::end(kForms)) return "";
    return "it is written " + std::string(form->second) +
           (jumps ? "; there are no jumps, what is left out or repeated stands in its braces" : "");
}

const Habit* habit_of(std::string_view word) {
    const std::size_t last = word.find_last_not_of("0123456789");
    const bool is_numbered =
        last != std::string_view::npos && last + 1 < word.size() && upper_ascii(word) == word;
    const std::string lower = lower_ascii(is_numbered ? word.substr(0, last + 1) : word);
    const auto* const found = std::ranges::lower_bound(kHabits, lower, {}, &Habit::word);
    if (found == std::end(kHabits) || found->word != lower || found->instead == word)
        return nullptr;
    return is_numbered && !found->is_statement ? nullptr : found;
}

void advise(DiagnosticBuilder& message, const Habit& habit, const SourceRange& range) {
    const std::string hint(habit.hint.empty() ? "it has another name here" : habit.hint);
    if (habit.instead.empty()) message.fix(hint);
    else message.fix(range, std::string(habit.instead), hint);
}

}  // namespace kadr::syntax
