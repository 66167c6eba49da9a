#include "nc/form.h"

#include <algorithm>

#include "base/diagnostics/dialect.h"
#include "base/done.h"
#include "base/numbers.h"
#include "base/text.h"
#include "nc/letters.h"
#include "nc/quoted.h"

namespace kadr::nc {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

constexpr double kMostCodes = 1000;     // that one pattern may stand for
constexpr double kGreatestCode = 9999;  // codes are looked up in tables of this size

struct FormUnit {
    std::string_view name;
    double factor;  // text = canonical · factor
};
constexpr std::array<FormUnit, 7> kUnits = {{{"s", 1},
                                             {"cs", 100},
                                             {"ms", 1000},
                                             {"min", 1.0 / 60},
                                             {"deg", 1},
                                             {"mm", 1},
                                             {"permille", 1000}}};

/// Reads one line of a pattern.
class LineParser {
  public:
    LineParser(std::string_view line, std::span<const Parameter> parameters, DialectTables& tables,
               const SourceRange& range, DiagnosticSink& sink)
        : line_(line), parameters_(parameters), tables_(tables), range_(range), sink_(sink) {}

    /// Where a cycle is read, what its block leaves out may have been given before.
    LineParser& completed_by_others(bool is_completed) {
        completed_by_others_ = is_completed;
        return *this;
    }

    /// A form that is never written may hold numbers on which nothing depends.
    LineParser& read_only(bool is_read_only) {
        is_read_only_ = is_read_only;
        return *this;
    }

    Done parse(std::vector<FormWord>& words) {
        while (skip_blanks()) {
            FormWord word;
            if (!parse_word(word)) return kFailed;
            if (!is_first(word, words))
                return fail(quoted(tables_.addresses[word.address].name) + " stands twice in it");
            words.push_back(std::move(word));
        }
        return kDone;
    }

    /// Letters and placeholders: each word is a placeholder and what stands before it, the last one
    /// what stands at the end.
    Done parse_verbatim(std::vector<FormWord>& words) {
        while (at_ < line_.size()) {
            FormWord word;
            const std::size_t brace = std::min(line_.find('{', at_), line_.size());
            word.text = line_.substr(at_, brace - at_);
            word.kind = FormWord::Kind::Name;
            at_ = brace;
            if (at_ < line_.size()) {
                word.kind = FormWord::Kind::Value;
                if (!parse_placeholder(word)) return kFailed;
                if (is_text(word)) return fail("a verbatim form holds numbers, and this is a text");
            }
            words.push_back(std::move(word));
        }
        if (words[0].text.empty()) return fail("it begins with a placeholder");
        return kDone;
    }

    Done parse_text(FormWord& word) {
        word.kind = FormWord::Kind::Text;
        const std::size_t brace = line_.find('{');
        if (brace == std::string_view::npos) return fail("there is no `{…}` in the comment");
        word.text = line_.substr(0, brace);
        at_ = brace;
        if (!parse_placeholder(word)) return kFailed;
        if (at_ != line_.size()) return fail("nothing may follow the text");
        return is_text(word) ? kDone
                             : fail("a comment keeps a text, and no number: it would be lost");
    }

  private:
    bool is_text(const FormWord& word) const {
        return word.parameter >= 0 && word.dimension == Dimension::Text;
    }

    Done fail(const std::string& why) {
        sink_.report(diag::DialectBadForm, range_).arg(line_).arg(why);
        return kFailed;
    }

    /// Codes may stand beside each other, other words once in a line.
    bool is_first(const FormWord& word, const std::vector<FormWord>& before) const {
        if (word.address == kNoAddress) return true;
        if (tables_.addresses[word.address].kind == Address::Kind::Code) return true;
        return std::ranges::none_of(
            before, [&](const FormWord& other) { return other.address == word.address; });
    }

    bool skip_blanks() {
        while (at_ < line_.size() && (line_[at_] == ' ' || line_[at_] == '\t')) ++at_;
        return at_ < line_.size();
    }
    bool take(char c) {
        if (at_ == line_.size() || line_[at_] != c) return false;
        ++at_;
        return true;
    }
    bool at_blank() const { return at_ == line_.size() || line_[at_] == ' ' || line_[at_] == '\t'; }

    Done parse_word(FormWord& word) {
        const std::size_t begin = at_;
        if (take('(')) return parse_call_in_brackets(word, begin);
        if (take(',') && at_ < line_.size() && is_letter(line_[at_])) {  // `,C{width}`
            ++at_;
            if (at_ == line_.size() || line_[at_] != '{')
                return fail("behind an address with a comma stands a `{…}`");
            return parse_value(word, line_.substr(begin, 2), begin);
        }
        while (at_ < line_.size() && is_letter(line_[at_])) ++at_;
        // Names of several letters may hold digits: `CUT2D`, `CYCLE83(…)`.
        std::size_t behind = at_;
        if (at_ - begin >= 2) {
            while (behind < line_.size() && (is_letter(line_[behind]) || is_digit(line_[behind])))
                ++behind;
        }
        // So may a letter with a number of its own: `X1={x}`.
        if (at_ - begin == 1) {
            std::size_t digits = at_;
            while (digits < line_.size() && is_digit(line_[digits])) ++digits;
            if (digits > at_ && digits < line_.size() && line_[digits] == '=') behind = digits;
        }
        if (at_ - begin >= 2 && behind < line_.size() && line_[behind] == '[')
            return parse_bracketed(word, begin, behind);
        const char next = behind < line_.size() ? line_[behind] : ' ';
        const bool extends = next == '(' || next == ' ' || next == '\t' || next == '=';
        if (extends) at_ = behind;
        const std::string_view name = line_.substr(begin, at_ - begin);
        if (name.empty()) return fail("a word begins with a letter");
        if (take('(')) return parse_call(word, name);
        const bool has_equals = take('=');
        if (has_equals && begins_call()) return parse_call_behind(word, begin);
        if (take('"')) return parse_quoted(word, name);
        if (at_ < line_.size() && line_[at_] == '{') return parse_value(word, name, begin);
        if (at_blank() && !has_equals) return parse_name(word, name);
        return parse_fixed(word, name, begin);
    }

    /// `(UAO,{number})`: the brackets stand around the name.
    Done parse_call_in_brackets(FormWord& word, std::size_t begin) {
        while (at_ < line_.size() && (is_letter(line_[at_]) || is_digit(line_[at_]))) ++at_;
        const std::string_view name = line_.substr(begin, at_ - begin);
        if (name.size() < 2) return fail("a name is expected behind the bracket: `(NAME,{…})`");
        tables_.has_bracket_calls = true;
        if (take(',') || (at_ < line_.size() && line_[at_] == ')')) return parse_call(word, name);
        return fail("a comma or the closing bracket is expected behind " + quoted(name));
    }

    /// `DIAMONA[X]`, `PO[X]=(…)`, `ACC[X]={percent}`: the bracket belongs to the name.
    Done parse_bracketed(FormWord& word, std::size_t begin, std::size_t bracket) {
        const std::size_t close = line_.find(']', bracket);
        if (close == std::string_view::npos) return fail("a `]` is missing");
        if (line_.substr(close).starts_with("]=(")) return parse_indexed_call(word, begin, close);
        at_ = close + 1;
        if (line_.substr(at_).starts_with("={")) {
            const std::string_view name = line_.substr(begin, at_ - begin);
            ++at_;
            return parse_value(word, name, begin);
        }
        if (!at_blank()) return fail("words stand between blanks");
        return parse_name(word, line_.substr(begin, at_ - begin));
    }

    /// `PO[X]=({end},{a2?})`: a call whose name ends with the sign.
    Done parse_indexed_call(FormWord& word, std::size_t begin, std::size_t close) {
        constexpr std::size_t kSign = 2;  // `]=`
        at_ = close + kSign + 1;
        return parse_call(word, line_.substr(begin, close + kSign - begin));
    }

    /// `F=FPO({end},{square?})`: a call whose name begins with the address and the sign.
    bool begins_call() const {
        std::size_t end = at_;
        while (end < line_.size() && is_letter(line_[end])) ++end;
        return end > at_ && end < line_.size() && line_[end] == '(';
    }
    Done parse_call_behind(FormWord& word, std::size_t begin) {
        at_ = line_.find('(', at_) + 1;
        return parse_call(word, line_.substr(begin, at_ - 1 - begin));
    }

    Done parse_name(FormWord& word, std::string_view name) {
        word.kind = FormWord::Kind::Name;
        word.text = name;
        return take_head(word, name, Address::Kind::Word);
    }

    Done parse_fixed(FormWord& word, std::string_view name, std::size_t begin) {
        const Decimal number = parse_decimal(line_.data() + at_, line_.data() + line_.size());
        if (number.end == line_.data() + at_)
            return fail("there is no number behind " + quoted(name));
        at_ = static_cast<std::size_t>(number.end - line_.data());
        if (!at_blank()) return fail("words stand between blanks");
        word.kind = FormWord::Kind::Fixed;
        word.number = number.value;
        word.text = line_.substr(begin, at_ - begin);
        return require_declared(word, name);
    }

    Done parse_value(FormWord& word, std::string_view name, std::size_t begin) {
        word.kind = FormWord::Kind::Value;
        word.text = line_.substr(begin, at_ - begin);
        if (!require_declared(word, name) || !parse_placeholder(word) || !parse_tail(word))
            return kFailed;
        return at_blank() ? kDone : fail("words stand between blanks");
    }

    /// `{offset:2}` or `0060` behind a value: the last digits of its number.
    Done parse_tail(FormWord& word) {
        if (at_blank()) return kDone;
        word.has_point_tail = take('.');
        if (!take('{')) {
            if (word.has_point_tail) return fail("behind the point stands a `{…}`");
            parse_fixed_tail(word);
            return kDone;
        }
        const std::size_t close = std::min(line_.find('}', at_), line_.size());
        const std::string_view inner = line_.substr(at_, close - at_);
        at_ = std::min(close + 1, line_.size());
        const std::string_view name = inner.substr(0, inner.find(':'));
        word.tail_parameter = parameter_named(name);
        if (word.tail_parameter < 0) return fail_unknown(name);
        if (word.has_point_tail) {
            // Two numbers in one: both are counted, and digits are no decimals.
            if (name.size() == inner.size()) return kDone;
            return fail("behind a point all digits are the second number: `{offset}`");
        }
        const std::string_view digits = inner.substr(std::min(name.size() + 1, inner.size()));
        if (digits.size() != 1 || digits[0] < '1' || digits[0] > '9') {
            return fail("a second `{…}` says how many digits it has: `{offset:2}`");
        }
        word.tail_digits = digits[0] - '0';
        return kDone;
    }

    void parse_fixed_tail(FormWord& word) {
        constexpr int kMost = 9;
        while (at_ < line_.size() && is_digit(line_[at_]) && word.tail_digits < kMost) {
            word.tail_value = word.tail_value * 10 + (line_[at_++] - '0');
            ++word.tail_digits;
        }
    }

    int parameter_named(std::string_view name) const {
        const auto found = std::ranges::find(parameters_, name, &Parameter::name);
        return found == parameters_.end() ? -1 : static_cast<int>(found - parameters_.begin());
    }

    Done parse_quoted(FormWord& word, std::string_view name) {
        word.kind = FormWord::Kind::Quoted;
        word.text = std::string(name) + '=';
        if (!require_declared(word, name) || !parse_placeholder(word)) return kFailed;
        return take('"') ? kDone : fail("the quotation mark is not closed");
    }

    Done parse_call(FormWord& word, std::string_view name) {
        word.kind = FormWord::Kind::Call;
        word.text = name;
        if (!take_head(word, name, Address::Kind::Call)) return kFailed;
        if (take(')')) return kDone;
        do {
            FormWord argument;
            const bool is_last =
                !word.arguments.empty() && word.arguments.back().kind == FormWord::Kind::Rest;
            if (is_last) return fail("nothing may follow `{...}`");
            if (!parse_argument(argument, name.starts_with('('))) return kFailed;
            word.arguments.push_back(std::move(argument));
        } while (take(','));
        return take(')') ? kDone : fail("the parenthesis is not closed");
    }

    /// `X{x}`, `X{x?:letter}`: an argument that is found by its letter.
    Done parse_lettered(FormWord& word) {
        const std::string_view letter = line_.substr(at_++, 1);
        word.kind = FormWord::Kind::Value;
        word.text = letter;
        if (!require_declared(word, letter)) return kFailed;
        is_argument_ = true;
        const Done parsed = parse_placeholder(word);
        is_argument_ = false;
        return parsed;
    }

    /// `{...}`
    Done parse_rest(FormWord& word) {
        constexpr std::string_view kRest = "{...}";
        if (!is_read_only_) return fail("`{...}` stands in a form that is only read");
        at_ += kRest.size();
        word.kind = FormWord::Kind::Rest;
        word.is_optional = true;
        return kDone;
    }

    Done parse_argument(FormWord& word, bool is_in_brackets) {
        word.kind = FormWord::Kind::Empty;
        skip_blanks();
        if (at_ == line_.size() || line_[at_] == ',' || line_[at_] == ')') return kDone;
        if (line_.substr(at_).starts_with("{...}")) return parse_rest(word);
        if (is_in_brackets && is_letter(line_[at_]) && line_.substr(at_ + 1).starts_with('{'))
            return parse_lettered(word);
        if (line_[at_] == '{') {
            word.kind = FormWord::Kind::Value;
            return parse_placeholder(word);
        }
        if (take('"')) {
            word.kind = FormWord::Kind::Text;
            if (!parse_placeholder(word)) return kFailed;
            return take('"') ? kDone : fail("the quotation mark is not closed");
        }
        const Decimal number = parse_decimal(line_.data() + at_, line_.data() + line_.size());
        if (number.end == line_.data() + at_)
            return fail("an argument is a number, a `{…}` or empty");
        const auto end = static_cast<std::size_t>(number.end - line_.data());
        word.kind = FormWord::Kind::Fixed;
        word.number = number.value;
        word.text = line_.substr(at_, end - at_);
        at_ = end;
        return kDone;
    }

    /// `{time:ms}`, `{number-6}`, `{x=0}`, `{x?}`, `{+retract}`, `{-pitch}`, `{x?:named}`
    Done parse_placeholder(FormWord& word) {
        if (!take('{')) return fail("`{` expected");
        const std::size_t close = line_.find('}', at_);
        if (close == std::string_view::npos) return fail("`{` is not closed");
        std::string_view inner = line_.substr(at_, close - at_);
        at_ = close + 1;
        if (inner.starts_with('=')) return parse_quantity(word, inner.substr(1));
        if (!inner.empty() && inner.front() == '+') {
            word.adds = true;
            inner.remove_prefix(1);
        }
        const bool is_negated = !inner.empty() && inner.front() == '-';
        if (is_negated) inner.remove_prefix(1);
        const std::size_t colon = inner.find(':');
        const std::string_view unit =
            colon == std::string_view::npos ? std::string_view() : inner.substr(colon + 1);
        inner = inner.substr(0, std::min(colon, inner.size()));
        if (inner.ends_with('?')) {
            word.is_optional = true;
            inner.remove_suffix(1);
        }
        if (inner.empty()) return parse_any(word);
        const std::size_t sign = inner.find_first_of("*/+-=");
        const std::string_view name = inner.substr(0, std::min(sign, inner.size()));
        word.parameter = parameter_named(name);
        if (word.parameter < 0) return fail_unknown(name);
        const Parameter& parameter = parameters_[static_cast<std::size_t>(word.parameter)];
        word.dimension = parameter.dimension;
        if (word.is_optional && !parameter.is_optional && !completed_by_others_)
            return fail("the parameter " + quoted(name) + " is not optional");
        word.is_kept = word.is_optional && completed_by_others_;
        word.is_optional |= word.adds;
        if (!parse_operator(word, inner, sign) || !parse_unit(word, unit)) return kFailed;
        if (is_negated) word.factor = -word.factor;
        return kDone;
    }

    /// `{}`, `{?}`: a number on which nothing depends.
    Done parse_any(FormWord& word) {
        if (word.kind != FormWord::Kind::Value || !is_read_only_)
            return fail("`{}` is the number of a letter, in a form that is only read");
        word.is_any = true;
        return kDone;
    }

    /// `{=0.5:length}`: always the same, in the units of the text; `{=work_offset}`: the number of
    /// the work offset that acts.
    Done parse_quantity(FormWord& word, std::string_view inner) {
        if (inner == "work_offset") {
            if (word.kind != FormWord::Kind::Value || word.address != kNoAddress)
                return fail("`{=work_offset}` is an argument of a call");
            word.kind = FormWord::Kind::Fixed;
            word.is_work_offset = true;
            return kDone;
        }
        const Decimal number = parse_decimal(inner.data(), inner.data() + inner.size());
        const auto digits = static_cast<std::size_t>(number.end - inner.data());
        const bool is_length = digits > 0 && inner.substr(digits) == ":length";
        if (!is_length ||
            (word.kind != FormWord::Kind::Value && word.kind != FormWord::Kind::Fixed))
            return fail("a number of its own is a length, in mm: `{=0.5:length}`");
        word.kind = FormWord::Kind::Fixed;
        word.number = number.value;
        word.dimension = Dimension::Length;
        word.is_quantity = true;
        return kDone;
    }

    Done fail_unknown(std::string_view name) {
        std::vector<std::string_view> names;
        for (const Parameter& parameter : parameters_) names.push_back(parameter.name);
        const auto near = nearest_name(name, names.data(), names.size());
        std::string why = "there is no parameter " + quoted(name);
        if (near) why += ", is " + quoted(*near) + " meant?";
        return fail(why);
    }

    Done parse_operator(FormWord& word, std::string_view inner, std::size_t sign) {
        if (sign == std::string_view::npos) return kDone;
        if (inner[sign] == '*' || inner[sign] == '/') return parse_factor(word, inner, sign);
        const std::string_view rest = inner.substr(inner[sign] == '=' ? sign + 1 : sign);
        const Decimal number = parse_decimal(rest.data(), rest.data() + rest.size());
        if (number.end != rest.data() + rest.size() || rest.empty()) {
            return fail(quoted(rest) + " is not a number");
        }
        if (inner[sign] == '=') {
            word.has_default = true;
            word.fallback = number.value;
        } else {
            word.offset = number.value;
        }
        return kDone;
    }

    /// `{allowance*0.5}`, `{x/2+1}`: what is written is the parameter times the factor.
    Done parse_factor(FormWord& word, std::string_view inner, std::size_t sign) {
        const std::string_view rest = inner.substr(sign + 1);
        const Decimal number = parse_decimal(rest.data(), rest.data() + rest.size());
        const auto digits = static_cast<std::size_t>(number.end - rest.data());
        if (digits == 0 || number.value == 0)
            return fail(quoted(rest) + " is no factor, which is a number other than 0");
        word.factor = inner[sign] == '*' ? number.value : 1 / number.value;
        if (digits == rest.size()) return kDone;
        const bool is_offset = rest[digits] == '+' || rest[digits] == '-';
        if (!is_offset) return fail(quoted(rest.substr(digits)) + " is no offset: `{x*2+1}`");
        return parse_operator(word, rest, digits);
    }

    Done parse_unit(FormWord& word, std::string_view unit) {
        if (unit.empty()) return kDone;
        if (unit == "named" || unit == "lead") {
            word.is_named_only = unit == "named";
            word.is_pitch = unit == "lead";
            return kDone;
        }
        if (unit == "letter") {
            if (word.address == kNoAddress || word.text.size() != 1 || !is_argument_)
                return fail(
                    "a letter alone is an argument of a command in brackets: "
                    "`(MIR,X{x?:letter})`");
            word.is_letter_alone = word.is_named_only = true;
            return kDone;
        }
        if (unit == "placeholder") {
            word.is_named_only = word.is_placeholder = true;
            return kDone;
        }
        if (unit == "absolute") {
            word.is_absolute = true;
            return kDone;
        }
        if (unit == "incremental") {
            word.is_incremental = true;
            return kDone;
        }
        if (unit == "turned") {
            word.takes_rotary_approaches = true;
            return kDone;
        }
        if (unit == "increments") {
            word.in_increments = true;
            return kDone;
        }
        if (unit == "s|ms") {
            word.plain_factor = 1000;
            return kDone;
        }
        if (unit == "digits") {
            word.plain_factor = -1;  // below 0: no increment makes another number of them
            return kDone;
        }
        for (const FormUnit& known : kUnits) {
            if (known.name != unit) continue;
            word.factor *= known.factor;
            return kDone;
        }
        return fail(
            "there is no unit " + quoted(unit) +
            "; known are s, cs, ms, s|ms, min, deg, mm, permille, increments, digits, lead, named, "
            "letter, absolute and incremental");
    }

    Done require_declared(FormWord& word, std::string_view name) {
        word.address = tables_.find_address(name);
        if (word.address != kNoAddress) return kDone;
        sink_.report(diag::DialectUnknownAddress, range_).arg(name).arg(line_);
        return kFailed;
    }

    /// Words by themselves and calls need no declaration of their own.
    Done take_head(FormWord& word, std::string_view name, Address::Kind kind) {
        word.address = tables_.find_address(name);
        if (word.address == kNoAddress) {
            Address address;
            address.name = name;
            address.kind = kind;
            address.order = 10;
            word.address = static_cast<AddressId>(tables_.addresses.size());
            tables_.names.emplace(address.name, word.address);
            if (name.size() == 1)
                tables_.letters[static_cast<unsigned char>(name[0])] = word.address;
            tables_.addresses.push_back(std::move(address));
            return kDone;
        }
        Address& known = tables_.addresses[word.address];
        const bool takes_both =
            (known.kind == Address::Kind::Word && kind == Address::Kind::Call) ||
            (known.kind == Address::Kind::Call && kind == Address::Kind::Word);
        if (takes_both) {
            known.kind = Address::Kind::Call;
            known.is_word_too = true;
        }
        if (takes_both || known.kind == kind) return kDone;
        return fail(quoted(name) + " needs a value");
    }

    std::string_view line_;
    std::span<const Parameter> parameters_;
    DialectTables& tables_;
    SourceRange range_;
    DiagnosticSink& sink_;
    bool completed_by_others_ = false;
    bool is_read_only_ = false;
    bool is_argument_ = false;  // of a command in brackets, behind its letter
    std::size_t at_ = 0;
};

std::vector<std::string_view> split_lines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        if (!line.empty()) lines.push_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// A code with a parameter, `G{number+53}`, as one form for every number of its constraint.
std::vector<Form> expand_codes(Form form, DialectTables& tables, DiagnosticSink& sink) {
    const auto is_open = [&](const FormWord& word) {
        return word.kind == FormWord::Kind::Value &&
               tables.addresses[word.address].kind == Address::Kind::Code;
    };
    const auto open = std::find_if(form.words.begin(), form.words.end(), is_open);
    if (open == form.words.end()) return {std::move(form)};
    const auto range = std::find_if(form.when.begin(), form.when.end(), [&](const Constraint& c) {
        return c.parameter == open->parameter;
    });
    if (range == form.when.end()) {
        sink.report(diag::DialectBadForm, form.range)
            .arg(form.pattern)
            .arg("a code with a parameter needs its range in `when`");
        return {};
    }
    std::vector<Form> forms;
    const Constraint limits = *range;
    if (limits.most - limits.least >= kMostCodes) {
        sink.report(diag::DialectBadForm, form.range)
            .arg(form.pattern)
            .arg("a code has at most 1000 numbers");
        return {};
    }
    const auto index = static_cast<std::size_t>(open - form.words.begin());
    form.when.erase(range);
    const auto count = static_cast<int>(limits.most - limits.least) + 1;
    for (int i = 0; i < count; ++i) {
        const double n = limits.least + i;
        Form one = form;
        FormWord& word = one.words[index];
        word.kind = FormWord::Kind::Fixed;
        word.number = n * word.factor + word.offset;
        append_shortest(word.text, word.number);
        one.fixed.emplace_back(word.parameter, n);
        word.parameter = -1;
        forms.push_back(std::move(one));
    }
    return forms;
}

/// Codes that a form may begin with are looked up in tables.
Done require_usual_codes(const std::vector<Form>& forms, DiagnosticSink& sink) {
    for (const Form& form : forms) {
        const FormWord& first = form.words[0];
        if (first.kind != FormWord::Kind::Fixed) continue;
        if (first.number >= 0 && first.number <= kGreatestCode) continue;
        sink.report(diag::DialectBadForm, form.range)
            .arg(form.pattern)
            .arg("its first number is not from 0 to 9999");
        return kFailed;
    }
    return kDone;
}

bool says(const std::vector<FormWord>& words, int parameter) {
    return std::ranges::any_of(words, [&](const FormWord& word) {
        return word.parameter == parameter || word.tail_parameter == parameter ||
               says(word.arguments, parameter);
    });
}

/// `when="number 0"` on a pattern without {number}: the pattern itself fixes the value.
void fix_single_values(Form& form) {
    std::erase_if(form.when, [&](const Constraint& c) {
        if (c.least != c.most || says(form.words, c.parameter)) return false;
        form.fixed.emplace_back(c.parameter, c.least);
        return true;
    });
}

}  // namespace

Done parse_form_line(std::string_view line, std::span<const Parameter> parameters,
                     DialectTables& tables, const SourceRange& range, std::vector<FormWord>& words,
                     DiagnosticSink& sink) {
    return LineParser(trimmed(line), parameters, tables, range, sink).parse(words);
}

std::vector<Form> parse_form(const Form& prototype, std::string_view text, DialectTables& tables,
                             DiagnosticSink& sink) {
    Form form = prototype;
    form.pattern = trimmed(text);
    const std::vector<std::string_view> lines = split_lines(text);
    if (lines.empty()) {
        sink.report(diag::DialectBadForm, form.range).arg("").arg("it is empty");
        return {};
    }
    // A copy: parsing may add cycles' addresses while the span is in use.
    const std::span<const Parameter> parameters = tables.parameters(form);
    const CommentStyle& comment = tables.comment;
    if (lines[0].starts_with(comment.open) && lines[0].ends_with(comment.close)) {
        std::string_view inner = lines[0].substr(comment.open.size());
        inner.remove_suffix(comment.close.size());
        form.is_comment = true;
        form.order = 100;
        form.words.resize(1);
        if (!LineParser(inner, parameters, tables, form.range, sink).parse_text(form.words[0]))
            return {};
        return {std::move(form)};
    }
    if (form.is_verbatim) {
        if (!LineParser(form.pattern, parameters, tables, form.range, sink)
                 .parse_verbatim(form.words))
            return {};
        form.owns_block = true;
        fix_single_values(form);
        return {std::move(form)};
    }
    const bool is_read_cycle = form.function == Function::Cycle && !form.is_written;
    if (!LineParser(lines[0], parameters, tables, form.range, sink)
             .completed_by_others(is_read_cycle)
             .read_only(!form.is_written || form.function == Function::None)
             .parse(form.words))
        return {};
    for (std::size_t i = 1; i < lines.size(); ++i) {
        std::vector<FormWord> words;
        if (!LineParser(lines[i], parameters, tables, form.range, sink).parse(words)) return {};
        form.extra.push_back(std::move(words));
    }
    form.order = tables.addresses[form.words[0].address].order;
    fix_single_values(form);
    std::vector<Form> forms = expand_codes(std::move(form), tables, sink);
    if (!require_usual_codes(forms, sink)) forms.clear();
    return forms;
}

}  // namespace kadr::nc
