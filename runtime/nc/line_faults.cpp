// What is wrong with a line of ISO-7bit text, in the control's words where it has some.
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <sstream>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/text.h"
#include "nc/control_words.h"
#include "nc/foreign_words.h"
#include "nc/letters.h"
#include "nc/line_reader.h"

namespace kadr::nc {

namespace {

/// The pattern as a manual writes it: `G10 L2 P_ X_`; arguments of a call keep their names.
std::string shown_pattern(std::string_view pattern) {
    std::string out;
    while (!pattern.empty()) {
        const std::size_t open = std::min(pattern.find('{'), pattern.size());
        out += pattern.substr(0, open);
        const std::size_t close = pattern.find('}', open);
        if (close == std::string_view::npos) break;
        const std::string_view hole = pattern.substr(open + 1, close - open - 1);
        const bool is_argument = out.ends_with('(') || out.ends_with(',');
        if (is_argument) out += hole.substr(0, hole.find_first_of("?:="));
        if (!is_argument) out += '_';
        pattern.remove_prefix(close + 1);
    }
    return out;
}

/// Whether the block has the word of a form, or the distance that may stand for it.
bool has_word(const DialectTables& tables, const LexedLine& lexed, const FormWord& wanted) {
    if (wanted.address == kNoAddress) return true;
    const Address& place = tables.addresses[wanted.address];
    return std::ranges::any_of(lexed.words, [&](const GivenWord& word) {
        if (word.address == wanted.address) return true;
        const Address& other = tables.addresses[word.address];
        return place.slot >= 0 && other.is_incremental && other.slot == place.slot;
    });
}

/// The plane in which a form acts alone; None: it acts in all of them.
Function plane_of(const Form& form) {
    const auto plane = std::ranges::find_if(
        form.during, [](Function needed) { return info(needed).group == Group::Plane; });
    return plane == form.during.end() ? Function::None : *plane;
}

/// The plane that a line says itself, else the one that acts.
Function plane_of(const DialectTables& tables, const LexedLine& lexed, Function modal) {
    for (const GivenWord& word : lexed.words) {
        const Code* const code =
            word.is_known ? tables.find_code(word.address, word.number) : nullptr;
        if (code == nullptr || code->simple == kNoForm) continue;
        const Function said = tables.forms[code->simple].function;
        if (info(said).group == Group::Plane) return said;
    }
    return modal;
}

/// The word of a block for an axis of the program, where the code at `head` goes by those of the
/// machine: Z of `G75 Z0`, for which `Z1=0` stands.
std::optional<std::size_t> axis_of_program(const DialectTables& tables, const LexedLine& lexed,
                                           std::size_t head) {
    const Code* const code = tables.find_code(lexed.words[head].address, lexed.words[head].number);
    if (code == nullptr) return std::nullopt;
    for (std::size_t i = 0; i < lexed.words.size(); ++i) {
        const AddressId of_machine =
            tables.find_address(tables.addresses[lexed.words[i].address].name + '1');
        if (i == head || of_machine == kNoAddress) continue;
        const bool is_wanted = std::ranges::any_of(code->forms, [&](const FormId id) {
            return std::ranges::any_of(tables.forms[id].words, [&](const FormWord& word) {
                return word.address == of_machine;
            });
        });
        if (is_wanted) return i;
    }
    return std::nullopt;
}

/// What the block lacks of a form: `P_ Q_`; the whole form where no word of it can be told apart.
std::string missing_words(const DialectTables& tables, const Form& form, const LexedLine& lexed) {
    const std::string whole = first_line(form);
    std::istringstream words(whole);
    std::string missing;
    std::size_t place = 0;
    for (std::string word; words >> word;) {
        if (place == form.words.size()) return shown_pattern(whole);
        const FormWord& wanted = form.words[place++];
        const bool may_lack = wanted.is_kept || wanted.is_optional || wanted.has_default;
        if (may_lack || has_word(tables, lexed, wanted)) continue;
        missing.append(missing.empty() ? "" : " ").append(shown_pattern(word));
    }
    return missing.empty() || place != form.words.size() ? shown_pattern(whole) : missing;
}

/// "`CYCLE83` with -5 as its 17th argument", "`CYCLE97` without its 3rd argument"
std::string argument_words(const LexedLine& lexed, const MatchFault& fault,
                           const std::string& name) {
    const GivenWord& word = lexed.words[fault.word];
    const auto place = static_cast<std::size_t>(fault.argument);
    const std::size_t number = place + 1;
    const bool is_teen = number / 10 % 10 == 1;
    const std::string_view ending = is_teen            ? "th"
                                    : number % 10 == 1 ? "st"
                                    : number % 10 == 2 ? "nd"
                                    : number % 10 == 3 ? "rd"
                                                       : "th";
    std::string words = '`' + name + "` ";
    const bool is_given = place < word.argument_count;
    const GivenArgument given =
        is_given ? lexed.arguments[word.first_argument + place] : GivenArgument{};
    if (given.kind == GivenArgument::Kind::Empty) {
        words += "without its ";
    } else if (given.kind == GivenArgument::Kind::Text) {
        words += "with a text as its ";
    } else {
        words += "with ";
        append_shortest(words, given.number);
        words += " as its ";
    }
    append_shortest(words, static_cast<double>(number));
    return words.append(ending).append(" argument");
}

/// `ENDWIHLE`: the word of a statement that is written nearly so.
std::optional<std::string_view> nearest_statement(const DialectTables& tables,
                                                  std::string_view word) {
    constexpr std::size_t kShortest = 4;  // below it nearly everything is near
    if (word.size() < kShortest) return std::nullopt;
    std::vector<std::string_view> names;
    for (const StatementForm& form : tables.language.statements) {
        const std::string& first = form.tokens[0].text;
        if (form.tokens[0].kind == StatementToken::Kind::Word && first.size() >= kShortest)
            names.push_back(first);
    }
    return nearest_name(word, names.data(), names.size());
}

}  // namespace

TextLocation LineReader::place(const std::string& file, std::string_view line, std::uint64_t number,
                               const Span& span) {
    constexpr std::size_t kShown = 400;  // bytes of a line that a message keeps
    TextLocation place;
    place.file = file;
    place.line = static_cast<std::uint32_t>(number);
    const std::size_t begin = std::min<std::size_t>(span.begin, line.size());
    const std::size_t end = std::clamp<std::size_t>(span.end, begin, line.size());
    place.column = static_cast<std::uint32_t>(count_code_points(line.substr(0, begin)) + 1);
    place.length = static_cast<std::uint32_t>(
        std::max<std::size_t>(1, count_code_points(line.substr(begin, end - begin))));
    place.text = line.substr(0, std::max(kShown, std::min(end, line.size())));
    return place;
}

std::string LineReader::word_text(std::string_view line, std::size_t word) const {
    const Span& span = lexed_->spans[word];
    return std::string(line.substr(span.begin, span.end - span.begin));
}

/// Whether a cycle acts, or the line that is read calls one.
bool LineReader::is_in_cycle() const {
    if (modal_[static_cast<std::size_t>(Group::CycleMode)] == Function::Cycle) return true;
    return lexed_ != nullptr && std::ranges::any_of(lexed_->words, [&](const GivenWord& word) {
               const Code* code =
                   word.is_known ? tables_.find_code(word.address, word.number) : nullptr;
               return code != nullptr && std::ranges::any_of(code->forms, [&](FormId id) {
                          return tables_.forms[id].function == Function::Cycle;
                      });
           });
}

namespace {

/// Whether a message says that a word or a sign is not understood; others, of a number out of its
/// range or a bracket that is not closed, have nothing to do with the words of other controls.
bool is_about_words(const DiagnosticRow& row) {
    static constexpr std::array kRows = {
        &diag::IsoUnknownWord,       &diag::IsoUnknownCode,  &diag::IsoNoValue,
        &diag::IsoWordsMissing,      &diag::IsoWordUnused,   &diag::IsoSyntax,
        &diag::ExpressionSyntax,     &diag::StatementSyntax, &diag::AssignmentMissing,
        &diag::StatementWordMissing, &diag::LoopNumber,      &diag::CallNotAlone,
        &diag::NameUnknown};
    return std::ranges::find(kRows, &row) != kRows.end();
}

/// A word of small letters as `x5` is one in capital letters; three in a row are a remark.
std::string fix_of_small_letters(const DialectTables& tables, std::string_view line,
                                 std::size_t at) {
    constexpr std::size_t kRemark = 3;
    const auto begin = line.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = std::find_if_not(begin, line.end(), is_letter);
    if (tables.comment.open != "(" || static_cast<std::size_t>(end - begin) < kRemark)
        return "write capital letters";
    return "a comment stands in brackets: `(…)`";
}

/// What a number is written as whose exponent begins at `at`, as `1e3`: with the exponent of the
/// control's language, or without one. Empty: there is none.
std::string fix_of_exponent(const DialectTables& tables, std::string_view line, std::size_t at) {
    if (at >= line.size() || (line[at] != 'e' && line[at] != 'E')) return "";
    std::size_t begin = at;
    while (begin > 0 && (is_digit(line[begin - 1]) || line[begin - 1] == '.')) --begin;
    if (begin == at) return "";
    if (begin > 0 && line[begin - 1] == '-') --begin;
    double value = 0;
    const char* const end = line.data() + line.size();
    const auto read = std::from_chars(line.data() + begin, end, value);
    if (read.ec != std::errc() || read.ptr <= line.data() + at) return "";
    if (tables.language.is_present && ControlWords(tables, line).has_exponents()) {
        const auto behind = static_cast<std::size_t>(read.ptr - line.data());
        return "an exponent begins with `EX`: `" + std::string(line.substr(begin, at - begin)) +
               "EX" + std::string(line.substr(at + 1, behind - at - 1)) + '`';
    }
    std::array<char, 400> text;
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    if (written.ec != std::errc() || written.ptr - text.data() > 12) return "";
    std::string number(text.data(), written.ptr);
    if (number.find('.') == number.npos) number += '.';
    return "numbers have no exponent: `" + number + '`';
}

}  // namespace

DiagnosticBuilder LineReader::report(std::string_view line, const LineFault& fault, FaultOf of) {
    note_fault();
    DiagnosticBuilder builder = sink_.report(*fault.row, place(line, line_number_, fault.span));
    std::string detail;
    for (const std::string& argument : fault.arguments) {
        builder.arg(argument);
        detail += argument + ' ';
    }
    if (const auto alarm = dialect_.alarm(*fault.row, detail))
        builder.alarm(alarm->number, alarm->text);
    const bool is_executed = of == FaultOf::Execution;
    const std::string_view instead =
        is_executed || is_about_words(*fault.row)
            ? instead_of_foreign(tables_, line, fault.span, {is_in_cycle(), is_executed})
            : std::string_view();
    const std::size_t at = fault.span.begin;
    const bool is_small = !tables_.notation.ignores_case && at < line.size() && is_lower(line[at]);
    const std::string number =
        is_about_words(*fault.row) ? fix_of_exponent(tables_, line, at) : std::string();
    if (!fault.fix.empty()) builder.fix(fault.fix);
    else if (!number.empty()) builder.fix(number);
    else if (!instead.empty()) builder.fix(std::string(instead));
    else if (fault.row == &diag::MachineAxisWanted)
        builder.fix("name the axis of the machine: `" + fault.arguments[1].substr(0, 1) + "1=0`");
    else if (is_small && fault.row == &diag::IsoSyntax)
        builder.fix(fix_of_small_letters(tables_, line, at));
    else if (fault.row == &diag::IsoUnknownWord)
        if (const auto meant = nearest_statement(tables_, fault.arguments[0]))
            builder.fix("is `" + std::string(*meant) + "` meant?");
    write_notes(builder);
    return builder;
}

bool LineReader::is_polynomial(FormId form) const {
    if (form == kNoForm) return false;
    const Function function = tables_.forms[form].function;
    return function == Function::PolynomialAxis || function == Function::PolynomialWeight;
}

/// An argument of a call that its form does not take.
void LineReader::take_argument_fault(const MatchFault& fault, LineFault& out) const {
    constexpr int kPowers = 5;
    const GivenWord& word = lexed_->words[fault.word];
    const auto place = static_cast<std::size_t>(fault.argument);
    if (is_polynomial(fault.form) && fault.argument >= kPowers) {
        out.row = &diag::PolynomialDegree;
        out.arguments = {std::to_string(word.argument_count)};
        return;
    }
    const bool is_text =
        place < word.argument_count &&
        lexed_->arguments[word.first_argument + place].kind == GivenArgument::Kind::Text;
    const bool is_cycle =
        fault.form != kNoForm && tables_.forms[fault.form].function == Function::Cycle;
    const bool is_text_missing = !is_text && fault.form != kNoForm &&
                                 tables_.forms[fault.form].function == Function::Message;
    const bool is_of_type = is_text_missing || (is_text && is_cycle);
    out.row = is_of_type ? &diag::IsoArgumentType : &diag::IsoNotSupported;
    out.arguments = {argument_words(*lexed_, fault, tables_.addresses[word.address].name)};
    if (is_of_type) out.arguments.emplace_back(is_text ? "a number" : "a text");
}

/// A word beside a function that takes it in another plane: Y of `G68 X0 Y0 R30` under G18.
void LineReader::take_other_plane(const MatchFault& fault, LineFault& out) const {
    const GivenWord& head = lexed_->words[fault.word];
    const GivenWord& other = lexed_->words[fault.other];
    const Code* const code = tables_.find_code(head.address, head.number);
    if (code == nullptr) return;
    const Function active =
        plane_of(tables_, *lexed_, modal_[static_cast<std::size_t>(Group::Plane)]);
    const Form* acting = nullptr;
    bool is_of_another = false;
    for (const FormId id : code->forms) {
        const Form& form = tables_.forms[id];
        const Function plane = plane_of(form);
        if (plane == Function::None) continue;
        const bool acts = plane == active;
        if (acts && acting == nullptr) acting = &form;
        is_of_another |= !acts && std::ranges::any_of(form.words, [&](const FormWord& word) {
            return word.address == other.address;
        });
    }
    if (acting == nullptr || !is_of_another) return;
    out.row = &diag::IsoWordUnused;
    out.arguments = {tables_.addresses[other.address].name};
    out.fix = "in the plane that acts it is `" + shown_pattern(first_line(*acting)) + '`';
}

void LineReader::report(std::string_view line, const MatchFault& fault) {
    using Kind = MatchFault::Kind;
    LineFault out;
    if (fault.kind == Kind::Full && lexed_->words.size() > kMaxWords) {
        out = {&diag::IsoTooManyWords, {0, static_cast<std::uint32_t>(line.size())}, {}};
        report(line, out);
        return;
    }
    const std::string word = word_text(line, fault.word);
    const std::string other = word_text(line, fault.other);
    const std::string form =
        fault.form == kNoForm ? "" : shown_pattern(first_line(tables_.forms[fault.form]));
    out.span = lexed_->spans[fault.word];
    switch (fault.kind) {
        case Kind::UnknownCode:
        case Kind::CodeComputed: {
            const std::string known = tables_.unsupported_words(word);
            out.row = known.empty() ? &diag::IsoUnknownCode : &diag::IsoNotSupported;
            out.arguments = {known.empty() ? word : known};
            if (known.empty() && lexed_->words[fault.word].address == tables_.builder_address) {
                out.row = &diag::IsoNotSupported;
                out.arguments = {'`' + word + "` (a function of the machine's builder)"};
            }
            break;
        }
        case Kind::NoValue:
        case Kind::NoNumber: out.row = &diag::IsoNoValue, out.arguments = {word}; break;
        case Kind::AddressTwice:
            out.row = &diag::IsoAddressTwice;
            out.arguments = {tables_.addresses[lexed_->words[fault.word].address].name};
            break;
        case Kind::GroupTwice: out.row = &diag::IsoGroupTwice, out.arguments = {word, other}; break;
        case Kind::Missing:
            out.row = &diag::IsoWordsMissing;
            // A word that is inherited, and of which the control has no form.
            if (fault.form == kNoForm) out.row = &diag::IsoUnknownWord, out.arguments = {word};
            else out.arguments = {word, missing_words(tables_, tables_.forms[fault.form], *lexed_)};
            if (is_polynomial(fault.form) &&
                modal_[static_cast<std::size_t>(Group::Motion)] != Function::Polynomial)
                out.row = &diag::PolynomialAlone, out.arguments = {word};
            if (fault.form != kNoForm &&
                has_fact(tables_.forms[fault.form].function, Fact::WritesOffset))
                out.row = &diag::OffsetDataFormat;
            break;
        case Kind::Value:
            out.row = &diag::IsoValueWrong, out.arguments = {word, form};
            if (fault.argument >= 0) take_argument_fault(fault, out);
            if (fault.form != kNoForm && tables_.forms[fault.form].function == Function::WorkOffset)
                out.row = &diag::WorkOffsetUnknown, out.arguments = {other + ' ' + word};
            if (fault.form != kNoForm &&
                has_fact(tables_.forms[fault.form].function, Fact::WritesOffset))
                out.row = &diag::OffsetDataNumber, out.arguments = {other + ' ' + word};
            if (fault.form != kNoForm &&
                has_fact(tables_.forms[fault.form].function, Fact::CallsOffset))
                out.row = &diag::IsoToolOffset, out.arguments = {word};
            break;
        case Kind::Conflict:
            out.row = &diag::IsoWordsConflict, out.arguments = {word, other};
            break;
        case Kind::Unused: out.row = &diag::IsoWordUnused, out.arguments = {word}; break;
        case Kind::Alone:
            out.row = &diag::IsoAlone, out.arguments = {word};
            if (fault.other > fault.word) {
                out.span = lexed_->spans[fault.other];
                take_other_plane(fault, out);
            }
            if (const auto wrong = axis_of_program(tables_, *lexed_, fault.word)) {
                out.row = &diag::MachineAxisWanted;
                out.span = lexed_->spans[*wrong];
                out.arguments = {word, word_text(line, *wrong)};
            }
            break;
        case Kind::Company: out.row = &diag::IsoCompany, out.arguments = {word, other}; break;
        case Kind::NotSupported:
            out.row = &diag::IsoNotSupported;
            out.arguments = {'`' + word + "` (" + tables_.forms[fault.form].unsupported + ')'};
            break;
        case Kind::Mode: {
            const bool is_indexed = lexed_->words[fault.word].mode == GivenWord::Mode::Indexed;
            out.row = is_indexed ? &diag::AxisNotIndexed : &diag::IsoModeMisplaced;
            out.arguments = {word};
            break;
        }
        case Kind::Full: out.row = &diag::IsoTooManyWords; break;
    }
    report(line, out);
}

}  // namespace kadr::nc
