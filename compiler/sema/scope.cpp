// scope.cpp — names: where they are looked for, what is known about a variable at each point.
#include <algorithm>

#include "base/diagnostics/dialect.h"
#include "base/diagnostics/sema.h"
#include "base/diagnostics/syntax.h"
#include "base/text.h"
#include "sema/builtins.h"
#include "sema/checker.h"
#include "syntax/habits.h"
#include "syntax/parse.h"

namespace kadr::sema {

using syntax::DeclKind;

std::string quoted(std::string_view text) {
    std::string all = "`";
    all += text;
    all += '`';
    return all;
}

const Name* Checker::find_global(std::uint32_t module, std::string_view name) const {
    const ModuleScope& scope = modules_[module];
    if (const auto own = scope.names.find(name); own != scope.names.end()) return &own->second;
    for (const std::uint32_t import : scope.imports) {
        const auto found = modules_[import].names.find(name);
        if (found != modules_[import].names.end()) return &found->second;
    }
    if (prelude_ < modules_.size()) {
        const auto found = modules_[prelude_].names.find(name);
        if (found != modules_[prelude_].names.end()) return &found->second;
    }
    return nullptr;
}

/// Two imports that declare a name: whichever came first would decide.
void Checker::check_unambiguous(std::string_view name, const SourceRange& range) {
    const ModuleScope& scope = modules_[module_];
    if (scope.names.contains(name) || range == ambiguous_) return;
    std::vector<const Name*> all;
    for (const std::uint32_t import : scope.imports) {
        const auto found = modules_[import].names.find(name);
        if (found != modules_[import].names.end()) all.push_back(&found->second);
    }
    if (all.size() < 2) return;
    ambiguous_ = range;
    DiagnosticBuilder builder = report(diag::AmbiguousName, range);
    builder.arg(name);
    for (const Name* declared : all) builder.note(declared->range, "it is declared here");
}

Checker::Found Checker::find(std::string_view name) const {
    const auto local = visible_.find(name);
    if (local != visible_.end() && !local->second.empty()) return {local->second.back(), nullptr};
    return {-1, find_global(module_, name)};
}

void Checker::check_new_name(std::string_view name, const SourceRange& range) {
    if (name.empty()) return;
    const auto local = visible_.find(name);
    if (local != visible_.end() && !local->second.empty()) {
        const auto i = static_cast<std::size_t>(local->second.back());
        const bool same_scope = i >= scope_begin_;
        report(same_scope ? diag::DuplicateName : diag::ShadowedName, range)
            .arg(name)
            .note(symbols_[i].range,
                  same_scope ? "it is declared here" : "the outer one is declared here");
        return;
    }
    const auto own = modules_[module_].names.find(name);
    if (own != modules_[module_].names.end() && own->second.what == Name::What::Variable) {
        report(diag::ShadowedName, range)
            .arg(name)
            .note(own->second.range, "the outer one is declared here");
    }
}

Checker::Found Checker::look_up(syntax::ExprId id) {
    const Found found = find(text(ast()[id].text));
    if (found.symbol >= 0) {
        const Symbol& symbol = symbols_[static_cast<std::size_t>(found.symbol)];
        record_.note_use(module_, id, symbol.checked);
        record_.note_givenness(module_, id, symbol.givenness);
    } else if (found.name != nullptr) {
        record_.note_use(module_, id, found.name->checked);
    }
    return found;
}

Symbol& Checker::add_symbol(Symbol symbol) {
    // `RETURN n;` declares nothing: what its type is, is reported.
    if (kind(symbol.type) != TypeKind::Error) check_new_name(symbol.name, symbol.range);
    visible_[symbol.name].push_back(static_cast<std::int32_t>(symbols_.size()));
    const bool varies =
        symbol.is_parameter || symbol.may_be_unset || type_info(symbol.type).is_optional;
    if (varies) varying_.push_back(static_cast<std::uint32_t>(symbols_.size()));
    if (!symbol.checked.is_valid() && !symbol.name.empty()) {
        using Kind = DeclaredSymbol::Kind;
        DeclaredSymbol declared;
        declared.kind = symbol.is_loop_variable ? Kind::LoopVariable
                        : symbol.decl.is_valid() && ast()[symbol.decl].kind == DeclKind::Contour
                            ? Kind::Contour
                            : Kind::Variable;
        declared.name = symbol.name;
        declared.file = module_;
        declared.decl = symbol.decl;
        declared.range = symbol.range;
        declared.scope = {symbol.range.file, symbol.range.end, scope_end_};
        declared.type = symbol.type;
        if (function_ != nullptr) declared.owner = function_->checked;
        declared.is_const = symbol.is_const;
        symbol.checked = record_.declare(std::move(declared));
    }
    symbols_.push_back(symbol);
    return symbols_.back();
}

Checker::OuterScope Checker::enter_scope(const SourceRange& range) {
    return {symbols_.size(), std::exchange(scope_begin_, symbols_.size()),
            std::exchange(scope_end_, range.end)};
}

void Checker::leave_scope(const OuterScope& outer) {
    forget_symbols(outer.symbols);
    scope_begin_ = outer.begin;
    scope_end_ = outer.end;
}

void Checker::forget_symbols(std::size_t symbols) {
    for (std::size_t i = symbols; i < symbols_.size(); ++i) report_unused(symbols_[i]);
    while (symbols_.size() > symbols) {
        visible_[symbols_.back().name].pop_back();
        symbols_.pop_back();
    }
    while (!varying_.empty() && varying_.back() >= symbols_.size()) varying_.pop_back();
}

/// A local variable that nothing reads; parameters have their own message. It is reported at the
/// end, if there was no error: what a mistake has cost may have read it.
void Checker::report_unused(const Symbol& symbol) {
    const bool is_asked = !symbol.is_parameter && !symbol.is_loop_variable && !symbol.is_read;
    if (!is_asked || symbol.name.empty() || kind(symbol.type) == TypeKind::Error) return;
    if (kind(symbol.type) == TypeKind::Execution) return;  // executing it may be all that is wanted
    // A library's own matter; and in a broken text, what is missing may have read it.
    if (module_ != 0 || function_ == nullptr || ast().has_errors) return;
    unused_.push_back({symbol.range, symbol.name});
}

std::vector<std::string_view> Checker::known_names(bool functions) const {
    std::vector<std::string_view> names;
    const auto add_module = [&](std::uint32_t module) {
        for (const auto& [name, entry] : modules_[module].names) {
            if ((entry.what == Name::What::Function) == functions) names.push_back(name);
        }
    };
    add_module(module_);
    for (const std::uint32_t import : modules_[module_].imports) add_module(import);
    if (prelude_ < modules_.size()) add_module(prelude_);
    if (functions) {
        const auto builtins = builtin_names();
        names.insert(names.end(), builtins.begin(), builtins.end());
        for (const nc::FunctionInfo& info : nc::all_functions()) {
            const bool is_callable = info.function != nc::Function::Cycle &&
                                     !nc::has_fact(info.function, nc::Fact::ReadOnly) &&
                                     !info.name.empty();
            if (is_callable) names.push_back(info.name);
        }
    } else {
        for (const Symbol& symbol : symbols_) names.push_back(symbol.name);
    }
    // Hash tables have no order of their own; messages must be the same everywhere.
    std::sort(names.begin(), names.end());
    return names;
}

Done Checker::require_not_lost(std::string_view name) {
    const std::vector<std::string>& lost = ast().lost_names;
    if (std::find(lost.begin(), lost.end(), name) == lost.end()) return kDone;
    ++sink_.errors;  // the parser has reported why
    return kFailed;
}

/// `mm` in `X=5 mm` and `min` in `100mm / min`, which are no names: the unit stands apart.
Done Checker::require_no_unit(std::string_view name, const SourceRange& range) {
    if (range.file == unit_.file && range.begin >= unit_.begin && range.end <= unit_.end)
        return kFailed;
    const std::string_view source = sources_.text(range.file);
    const std::string_view before = source.substr(0, range.begin);
    const auto behind_blanks = [&](std::size_t end) {
        while (end > 0 && before[end - 1] == ' ') --end;
        return end;
    };
    std::size_t number = behind_blanks(before.size());
    std::string unit(name);
    if (number > 0 && before[number - 1] == '/') {
        const std::size_t end = behind_blanks(number - 1);
        number = before.substr(0, end).find_last_not_of("abcdefghijklmnopqrstuvwxyz") + 1;
        unit = std::string(before.substr(number, end - number)) + '/' + unit;
    }
    const bool is_behind_number =
        number > 0 && std::string_view("0123456789.").find(before[number - 1]) != std::string::npos;
    if (!is_behind_number || !find_unit(unit)) return kDone;
    // `100 mm/min`: all of it.
    std::size_t end = range.end;
    if (end < source.size() && source[end] == '/') {
        const std::size_t past = std::min(
            source.find_first_not_of("abcdefghijklmnopqrstuvwxyz", end + 1), source.size());
        const std::string whole = unit + std::string(source.substr(end, past - end));
        if (find_unit(whole)) {
            unit = whole;
            end = past;
        }
    }
    unit_ = {range.file, range.begin, static_cast<std::uint32_t>(end)};
    report(diag::UnitApart, unit_)
        .arg(unit)
        .fix({range.file, static_cast<std::uint32_t>(number), unit_.end}, unit,
             "write it right behind the number");
    return kFailed;
}

/// Whether this is a word with a number: `X10`.
bool Checker::is_numbered_word(std::string_view word) const {
    const std::size_t letters = word.find_first_of("0123456789");
    return letters != std::string_view::npos && letters > 0 &&
           word.find_first_not_of("0123456789", letters) == std::string_view::npos &&
           nc::word_kind(*modules_[module_].dialect, word.substr(0, letters)) ==
               nc::WordKind::Address;
}

/// A keyword of English in a file of another keyword language: `program`, `warn(…)`.
Done Checker::require_no_foreign_keyword(std::string_view name, const SourceRange& range) {
    const auto found = ast().keyword_words.find(name);
    if (found == ast().keyword_words.end()) return kDone;
    report(diag::ForeignKeyword, range)
        .arg(name)
        .arg(found->second)
        .arg(ast().language)
        .fix(range, found->second, "use the word of the keyword language");
    return kFailed;
}

/// The word of another control where the target of a block may stand: `G1 X10 Q5`.
Done Checker::require_no_foreign_word(std::string_view name, const SourceRange& range) {
    const std::size_t digit = name.find_first_of("0123456789");
    const bool is_like_word =
        digit != 0 && digit != std::string_view::npos && upper_ascii(name) == name;
    const syntax::Habit* habit = syntax::habit_of(name);
    const bool is_statement = habit != nullptr && habit->is_statement;  // `N20 END1`
    if (!is_like_word || is_statement || !(range == target_)) return kDone;
    report(diag::BlockWordUnknown, range)
        .arg(name)
        .arg(modules_[module_].dialect->name())
        .fix(syntax::kForeignWord);
    return kFailed;
}

/// Whether a statement begins with the name at `range`.
bool Checker::is_statement_at(const SourceRange& range) const {
    const std::string_view before = sources_.text(range.file).substr(0, range.begin);
    const std::size_t last = before.find_last_not_of(" \t\r\n");
    return last == std::string_view::npos ||
           std::string_view(";{}):").find(before[last]) != std::string_view::npos;
}

namespace {

/// R1: a variable of a control, and no word of a block.
bool is_control_parameter(std::string_view word) {
    return word.size() > 1 && word[0] == 'R' &&
           word.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

}  // namespace

/// `GO` and `XO` where words stand: a letter for a digit. Not `NO = 5;`, nor the loop `DO1;`.
Done Checker::require_no_letter_for_digit(std::string_view name, const SourceRange& range) {
    const std::string_view behind = sources_.text(range.file).substr(range.end);
    const std::size_t at = behind.find_first_not_of(" \t");
    const char next = at == std::string_view::npos ? ';' : behind[at];
    const bool is_lone = is_statement_at(range) && (next == ';' || (next >= 'A' && next <= 'Z'));
    if ((!(range == target_) && !is_lone) || name.starts_with("DO")) return kDone;
    const std::string word = syntax::word_with_digits(*modules_[module_].dialect, name);
    if (word.empty()) return kDone;
    report(diag::LetterForDigit, range).arg(name).arg(word).fix(range, word, "write digits");
    return kFailed;
}

/// `G1 X=dY5`: a variable with the next word right behind it.
bool Checker::fix_next_word(std::string_view name, const SourceRange& range,
                            DiagnosticBuilder& builder) {
    constexpr std::size_t kMostLetters = 8;  // of an address
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    const std::size_t first = digits > kMostLetters ? digits - kMostLetters : 1;
    for (std::size_t i = first; i < digits; ++i) {
        if (!is_numbered_word(name.substr(i))) continue;
        const Found value = find(name.substr(0, i));
        if (value.symbol < 0) continue;
        const std::uint32_t at = range.begin + static_cast<std::uint32_t>(i);
        builder.fix({range.file, at, at}, " ", "a blank ends the name in front of the next word");
        return true;
    }
    return false;
}

/// `for (k = 0; k < 5; k++)`: a loop declares its variable.
bool Checker::fix_loop_variable(const SourceRange& range, DiagnosticBuilder& builder) {
    const std::string_view source = sources_.text(range.file);
    std::string_view before = source.substr(0, range.begin);
    before = before.substr(0, before.find_last_not_of(" \t") + 1);
    if (!before.ends_with('(')) return false;
    before.remove_suffix(1);
    before = before.substr(0, before.find_last_not_of(" \t") + 1);
    const std::size_t behind = source.find_first_not_of(" \t", range.end);
    const bool is_assigned = behind != std::string_view::npos && source[behind] == '=';
    if (!before.ends_with("for") || !is_assigned) return false;
    builder.fix({range.file, range.begin, range.begin}, "int ", "a loop declares its variable");
    return true;
}

/// A name that is a statement by itself, as only words of a language are: `BREAK;`, `E5;`, `L100;`.
bool Checker::fix_statement(std::string_view name, const SourceRange& range,
                            DiagnosticBuilder& builder) {
    const std::string_view behind = sources_.text(range.file).substr(range.end);
    const std::size_t next = behind.find_first_not_of(" \t");
    const bool is_alone = next != std::string_view::npos && behind[next] == ';';
    const std::string lower = syntax::lower_ascii(name);
    if (!is_statement_at(range)) return false;
    if (lower != name && syntax::is_keyword(lower)) {  // `RETURN -a;`: a difference to the parser
        builder.fix(range, lower, "keywords are written in lower case");
        return true;
    }
    const std::size_t letters = name.find_first_of("0123456789");
    const bool is_word = letters != std::string_view::npos && letters > 0 &&
                         name.find_first_not_of("0123456789", letters) == std::string_view::npos &&
                         upper_ascii(name) == name;
    if (!is_alone || !is_word) return false;
    const std::string_view address = name.substr(0, letters);
    if (address == "O")
        builder.fix("a program that is called so has this number: `program " + std::string(name) +
                    "() { … }`");
    else if (address == "DO") builder.fix("a loop is `while (…) { … }`, its body stands in braces");
    else if (address == "L" || address == "P") builder.fix(syntax::kCallByName);
    else builder.fix(syntax::kForeignWord);
    return true;
}

/// Letters of the address of a word that has its value without `=`, where words stand: 1 of
/// `G0 Xd/2;` and of `Xd;`. 0: it is none.
std::size_t Checker::glued_letters(std::string_view name, const SourceRange& range) {
    const std::size_t letters = syntax::glued_address(*modules_[module_].dialect, name);
    if (letters == 0) return 0;
    const bool is_small = name[letters] >= 'a' && name[letters] <= 'z';
    const bool is_target = range.file == target_.file && range.begin == target_.begin;
    if (is_target && is_small) return letters;
    const std::string_view before = sources_.text(range.file).substr(0, range.begin);
    const std::size_t last = before.find_last_not_of(" \t\r\n");
    const bool begins = last == std::string_view::npos ||
                        std::string_view(";{}").find(before[last]) != std::string_view::npos;
    const Found value = find(name.substr(letters));
    const bool is_known = value.symbol >= 0 || value.name != nullptr;
    return is_known && (begins || is_target) ? letters : 0;
}

/// `=` between an address and its value.
void Checker::fix_glued(std::size_t letters, const SourceRange& range, DiagnosticBuilder& builder) {
    const auto value = range.begin + static_cast<std::uint32_t>(letters);
    builder.fix({range.file, value, value}, "=", syntax::kValueBehindSign);
}

/// `SIN[30]` and `sin[30]`: a function of a control, its argument in square brackets.
Done Checker::require_no_control_index(std::string_view name, const SourceRange& range) {
    const std::string_view source = sources_.text(range.file);
    const std::string function = syntax::lower_ascii(name);
    const std::vector<std::string_view> functions = known_names(true);
    if (range.end >= source.size() || source[range.end] != '[' ||
        !std::binary_search(functions.begin(), functions.end(), function))
        return kDone;
    std::size_t close = range.end;
    for (int depth = 0; close < source.size() && source[close] != '\n'; ++close) {
        if (source[close] == '[') ++depth;
        if (source[close] == ']' && --depth == 0) break;
    }
    if (close >= source.size() || source[close] != ']') return kDone;
    std::string argument(source.substr(range.end + 1, close - range.end - 1));
    const bool is_number = argument.find_first_not_of("0123456789.-") == std::string::npos;
    const bool takes_angle = function == "sin" || function == "cos" || function == "tan";
    if (is_number && takes_angle) argument += "deg";
    report(diag::UnknownName, range)
        .arg(name)
        .fix({range.file, range.begin, static_cast<std::uint32_t>(close + 1)},
             function + '(' + argument + ')',
             "functions are in small letters, their arguments in round brackets");
    return kFailed;
}

/// A Latin `c` where a Cyrillic one is declared, and the other way round.
bool Checker::fix_lookalike(std::string_view name, const SourceRange& range,
                            DiagnosticBuilder& builder) {
    const std::string skeleton = latin_skeleton(name);
    for (const std::string_view known : known_names(false)) {
        if (known == name || latin_skeleton(known) != skeleton) continue;
        const bool is_cyrillic = latin_skeleton(known) != known;
        builder.fix(range, std::string(known),
                    std::string("a name that looks alike is declared, in ") +
                        (is_cyrillic ? "Cyrillic" : "Latin") + " letters");
        return true;
    }
    return false;
}

/// Another look for a name that was meant, among all names. False: there were enough. Behind so
/// many mistakes of this kind nobody reads what it would report, and each takes as long as there
/// are names.
bool Checker::take_proposal() {
    constexpr std::uint32_t kMost = 100;
    return ++proposals_ <= kMost;
}

void Checker::report_unknown(std::string_view name, const SourceRange& range) {
    if (!require_not_lost(name)) return;
    for (std::size_t i = defaults_from_; function_ != nullptr && i < function_->parameters.size();
         ++i) {
        if (function_->parameters[i].name != name) continue;
        symbols_[i].is_read = true;
        report(diag::DefaultOrder, range)
            .arg(function_->parameters[defaults_from_].name)
            .arg(name)
            .note(function_->parameters[i].range, "it is declared here");
        return;
    }
    if (!require_no_unit(name, range) || !require_no_foreign_keyword(name, range)) return;
    if (!require_no_letter_for_digit(name, range) || !require_no_foreign_word(name, range) ||
        !require_no_control_index(name, range))
        return;
    auto builder = report(diag::UnknownName, range);
    builder.arg(name);
    if (name == declared_) {
        builder.note(range, "it is used in its own value, before it has one");
        return;
    }
    if (fix_as_word(name, range, builder)) return;
    if (const syntax::Habit* habit = syntax::habit_of(name)) {
        syntax::advise(builder, *habit, range);
        return;
    }
    if (!take_proposal() || fix_lookalike(name, range, builder)) return;
    const std::vector<std::string_view> functions = known_names(true);
    const std::string lower = syntax::lower_ascii(name);
    for (const std::string_view function : {name, std::string_view(lower)}) {
        const bool is_it = std::binary_search(functions.begin(), functions.end(), function);
        if (!is_it || (function != name && !is_statement_at(range))) continue;
        builder.fix(range, std::string(function) + "()", "it is a function: call it");
        return;
    }
    if (fix_statement(name, range, builder) || fix_next_word(name, range, builder) ||
        fix_loop_variable(range, builder))
        return;
    // Every letter is near to every other.
    if (count_code_points(name) == 1 || is_control_parameter(upper_ascii(name))) {
        builder.fix("declare it first, with its type");
        return;
    }
    const std::vector<std::string_view> names = known_names(false);
    if (const auto near = nearest_name(name, names.data(), names.size())) {
        builder.fix(range, std::string(*near), "did you mean " + quoted(*near) + "?");
    }
}

/// `G1 x10 y-5 Zd`: words in lower case, and one that has its value without `=`.
bool Checker::fix_as_word(std::string_view name, const SourceRange& range,
                          DiagnosticBuilder& builder) {
    const std::string word = upper_ascii(name);
    const bool is_target = range.file == target_.file && range.begin == target_.begin;
    const bool is_address =
        name.size() == 1 && name != word &&
        nc::word_kind(*modules_[module_].dialect, word) == nc::WordKind::Address;
    const bool is_number = is_numbered_word(word) && !is_control_parameter(word);
    if (is_number || (is_target && is_address)) {
        builder.fix(range, word, "words of blocks are written in upper case");
        return true;
    }
    const std::size_t letters = glued_letters(name, range);
    if (letters > 0) fix_glued(letters, range, builder);
    return letters > 0;
}

// Only of what can be without a value: at each branch, all variables would be looked at.

std::vector<Givenness> Checker::remember_givenness() const {
    std::vector<Givenness> states;
    states.reserve(varying_.size());
    for (const std::uint32_t i : varying_) states.push_back(symbols_[i].givenness);
    return states;
}

void Checker::set_givenness(const std::vector<Givenness>& other) {
    for (std::size_t i = 0; i < varying_.size() && i < other.size(); ++i) {
        symbols_[varying_[i]].givenness = other[i];
    }
}

void Checker::merge_givenness(const std::vector<Givenness>& other) {
    for (std::size_t i = 0; i < varying_.size() && i < other.size(); ++i) {
        Givenness& now = symbols_[varying_[i]].givenness;
        if (now != other[i]) now = Givenness::Perhaps;
    }
}

void Checker::forget_givenness() {
    // A loop's body may run again after what stands below has been assigned.
    for (const std::uint32_t i : varying_) {
        Symbol& symbol = symbols_[i];
        const bool varies = symbol.may_be_unset || type_info(symbol.type).is_optional;
        if (varies) symbol.givenness = Givenness::Perhaps;
    }
}

}  // namespace kadr::sema
