#include "nc/match_faults.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/numbers.h"

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
    const Address& address = tables.addresses[wanted.address];
    return std::ranges::any_of(lexed.words, [&](const GivenWord& word) {
        if (word.address == wanted.address) return true;
        const Address& other = tables.addresses[word.address];
        return address.slot >= 0 && other.is_incremental && other.slot == address.slot;
    });
}

/// The plane in which a form acts alone; None: it acts in all of them.
Function plane_of(const Form& form) {
    const auto plane = std::ranges::find_if(
        form.during, [](Function needed) { return info(needed).group == Group::Plane; });
    return plane == form.during.end() ? Function::None : *plane;
}

/// The plane that a line programs itself, else the one that acts.
Function plane_of(const DialectTables& tables, const LexedLine& lexed, Function modal) {
    for (const GivenWord& word : lexed.words) {
        const CodeStart* const code =
            word.is_known ? tables.find_code(word.address, word.number) : nullptr;
        if (code == nullptr || code->simple == kNoForm) continue;
        const Function function = tables.forms[code->simple].function;
        if (info(function).group == Group::Plane) return function;
    }
    return modal;
}

/// The word of a block for an axis of the program, where the code at `head` goes by those of the
/// machine: Z of `G75 Z0`, for which `Z1=0` stands.
std::optional<std::size_t> axis_of_program(const DialectTables& tables, const LexedLine& lexed,
                                           std::size_t head) {
    const CodeStart* const code =
        tables.find_code(lexed.words[head].address, lexed.words[head].number);
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
    std::size_t index = 0;
    for (std::string word; words >> word;) {
        if (index == form.words.size()) return shown_pattern(whole);
        const FormWord& wanted = form.words[index++];
        const bool may_lack = wanted.is_kept || wanted.is_optional || wanted.has_default;
        if (may_lack || has_word(tables, lexed, wanted)) continue;
        missing.append(missing.empty() ? "" : " ").append(shown_pattern(word));
    }
    return missing.empty() || index != form.words.size() ? shown_pattern(whole) : missing;
}

/// "`CYCLE83` with -5 as its 17th argument", "`CYCLE97` without its 3rd argument"
std::string argument_words(const LexedLine& lexed, const MatchFault& fault,
                           const std::string& name) {
    const GivenWord& word = lexed.words[fault.word];
    const auto index = static_cast<std::size_t>(fault.argument);
    const std::size_t number = index + 1;
    const bool is_teen = number / 10 % 10 == 1;
    const std::string_view ending = is_teen            ? "th"
                                    : number % 10 == 1 ? "st"
                                    : number % 10 == 2 ? "nd"
                                    : number % 10 == 3 ? "rd"
                                                       : "th";
    std::string words = '`' + name + "` ";
    const bool is_given = index < word.argument_count;
    const GivenArgument given =
        is_given ? lexed.arguments[word.first_argument + index] : GivenArgument{};
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

/// One mistake, and where it is.
class FaultWords {
  public:
    FaultWords(const DialectTables& tables, const MatchFault& fault, const LexedLine& words,
               std::string_view line, const ModalFunctions& modal)
        : tables_(tables), fault_(fault), words_(words), line_(line), modal_(modal) {}

    LineFault line_fault() const;

  private:
    const GivenWord& word() const { return words_.words[fault_.word]; }
    const Form* form() const {
        return fault_.form == kNoForm ? nullptr : &tables_.forms[fault_.form];
    }
    bool is_of(Function function) const {
        return form() != nullptr && form()->function == function;
    }
    bool has_form_fact(Fact fact) const {
        return form() != nullptr && has_fact(form()->function, fact);
    }
    bool is_polynomial() const {
        return is_of(Function::PolynomialAxis) || is_of(Function::PolynomialWeight);
    }
    std::string pattern() const {
        return form() == nullptr ? "" : shown_pattern(first_line(*form()));
    }
    void take_argument(LineFault& out) const;
    void take_other_plane(LineFault& out) const;
    void take_unknown_code(LineFault& out) const;
    void take_missing(LineFault& out) const;
    void take_value(LineFault& out) const;
    void take_alone(LineFault& out) const;

    const DialectTables& tables_;
    const MatchFault& fault_;
    const LexedLine& words_;
    std::string_view line_;
    const ModalFunctions& modal_;
};

/// An argument of a call that its form does not take.
void FaultWords::take_argument(LineFault& out) const {
    constexpr int kPowers = 5;
    const auto index = static_cast<std::size_t>(fault_.argument);
    if (is_polynomial() && fault_.argument >= kPowers) {
        out.row = &diag::PolynomialDegree;
        out.arguments = {std::to_string(word().argument_count)};
        return;
    }
    const bool is_text =
        index < word().argument_count &&
        words_.arguments[word().first_argument + index].kind == GivenArgument::Kind::Text;
    const bool is_text_missing = !is_text && is_of(Function::Message);
    const bool is_of_type = is_text_missing || (is_text && is_of(Function::Cycle));
    out.row = is_of_type ? &diag::IsoArgumentType : &diag::IsoNotSupported;
    out.arguments = {argument_words(words_, fault_, tables_.addresses[word().address].name)};
    if (is_of_type) out.arguments.emplace_back(is_text ? "a number" : "a text");
}

/// A word beside a function that takes it in another plane: Y of `G68 X0 Y0 R30` under G18.
void FaultWords::take_other_plane(LineFault& out) const {
    const GivenWord& head = word();
    const GivenWord& other = words_.words[fault_.other];
    const CodeStart* const code = tables_.find_code(head.address, head.number);
    if (code == nullptr) return;
    const Function active =
        plane_of(tables_, words_, modal_[static_cast<std::size_t>(Group::Plane)]);
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

void FaultWords::take_unknown_code(LineFault& out) const {
    const std::string text = words_.text_of(line_, fault_.word);
    const std::string known = tables_.unsupported_words(text);
    out.row = known.empty() ? &diag::IsoUnknownCode : &diag::IsoNotSupported;
    out.arguments = {known.empty() ? text : known};
    if (known.empty() && word().address == tables_.builder_address) {
        out.row = &diag::IsoNotSupported;
        out.arguments = {'`' + text + "` (a function of the machine's builder)"};
    }
}

void FaultWords::take_missing(LineFault& out) const {
    const std::string text = words_.text_of(line_, fault_.word);
    out.row = &diag::IsoWordsMissing;
    // A word that is inherited, and of which the control has no form.
    if (form() == nullptr) out.row = &diag::IsoUnknownWord, out.arguments = {text};
    else out.arguments = {text, missing_words(tables_, *form(), words_)};
    if (is_polynomial() && modal_[static_cast<std::size_t>(Group::Motion)] != Function::Polynomial)
        out.row = &diag::PolynomialAlone, out.arguments = {text};
    if (has_form_fact(Fact::WritesOffset)) out.row = &diag::OffsetDataFormat;
}

void FaultWords::take_value(LineFault& out) const {
    const std::string text = words_.text_of(line_, fault_.word);
    const std::string with_other = words_.text_of(line_, fault_.other) + ' ' + text;
    out.row = &diag::IsoValueWrong, out.arguments = {text, pattern()};
    if (fault_.argument >= 0) take_argument(out);
    if (is_of(Function::WorkOffset))
        out.row = &diag::WorkOffsetUnknown, out.arguments = {with_other};
    if (has_form_fact(Fact::WritesOffset))
        out.row = &diag::OffsetDataNumber, out.arguments = {with_other};
    if (has_form_fact(Fact::CallsOffset)) out.row = &diag::IsoToolOffset, out.arguments = {text};
}

void FaultWords::take_alone(LineFault& out) const {
    const std::string text = words_.text_of(line_, fault_.word);
    out.row = &diag::IsoAlone, out.arguments = {text};
    if (fault_.other > fault_.word) {
        out.span = words_.spans[fault_.other];
        take_other_plane(out);
    }
    if (const auto wrong = axis_of_program(tables_, words_, fault_.word)) {
        out.row = &diag::MachineAxisWanted;
        out.span = words_.spans[*wrong];
        out.arguments = {text, words_.text_of(line_, *wrong)};
    }
}

LineFault FaultWords::line_fault() const {
    using Kind = MatchFault::Kind;
    if (fault_.kind == Kind::Full && words_.words.size() > kMaxWords)
        return {&diag::IsoTooManyWords, {0, static_cast<std::uint32_t>(line_.size())}, {}};
    LineFault out;
    const std::string text = words_.text_of(line_, fault_.word);
    const std::string other = words_.text_of(line_, fault_.other);
    out.span = words_.spans[fault_.word];
    switch (fault_.kind) {
        case Kind::UnknownCode:
        case Kind::CodeComputed: take_unknown_code(out); break;
        case Kind::NoValue:
        case Kind::NoNumber: out.row = &diag::IsoNoValue, out.arguments = {text}; break;
        case Kind::AddressTwice:
            out.row = &diag::IsoAddressTwice;
            out.arguments = {tables_.addresses[word().address].name};
            break;
        case Kind::GroupTwice: out.row = &diag::IsoGroupTwice, out.arguments = {text, other}; break;
        case Kind::Missing: take_missing(out); break;
        case Kind::Value: take_value(out); break;
        case Kind::Conflict:
            out.row = &diag::IsoWordsConflict, out.arguments = {text, other};
            break;
        case Kind::Unused: out.row = &diag::IsoWordUnused, out.arguments = {text}; break;
        case Kind::Alone: take_alone(out); break;
        case Kind::Company: out.row = &diag::IsoCompany, out.arguments = {text, other}; break;
        case Kind::NotSupported:
            out.row = &diag::IsoNotSupported;
            out.arguments = {'`' + text + "` (" + form()->unsupported + ')'};
            break;
        case Kind::Mode: {
            const bool is_indexed = word().mode == GivenWord::Mode::Indexed;
            out.row = is_indexed ? &diag::AxisNotIndexed : &diag::IsoModeMisplaced;
            out.arguments = {text};
            break;
        }
        case Kind::Full: out.row = &diag::IsoTooManyWords; break;
    }
    return out;
}

}  // namespace

LineFault fault_of_line(const DialectTables& tables, const MatchFault& fault,
                        const LexedLine& words, std::string_view line,
                        const ModalFunctions& modal) {
    return FaultWords(tables, fault, words, line, modal).line_fault();
}

}  // namespace kadr::nc
