// lexer_names.cpp — words of several letters, with indices, values behind `=`, and arguments:
// `CR=5`, `S2=500`, `ACC[X]=50`, `X=AC(10)`, `CYCLE83(…)`.
#include <algorithm>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "nc/line_lexer.h"
#include "nc/refused_words.h"

namespace kadr::nc {

namespace {

/// Whether the dialect has the word of a spindle with this number, `S2` or `SPOS[2]`.
bool is_declared(const DialectTables& tables, const std::string& name, std::string_view number,
                 bool has_index) {
    std::string whole = name;
    if (has_index) whole += '[';
    whole += number;
    if (has_index) whole += ']';
    return tables.find_address(whole) != kNoAddress;
}

}  // namespace

void Lexer::take_name() {
    const std::size_t begin = at_;
    std::size_t end = at_;
    while (end < line_.size() &&
           (is_letter(line_[end]) || is_digit(line_[end]) || line_[end] == '_'))
        ++end;
    const std::string_view written = line_.substr(begin, end - begin);
    const std::string name = notation_.ignores_case ? upper_ascii(written) : std::string(written);
    const AddressId address = tables_.find_address(name);
    at_ = end;
    skip_blanks();
    if (address == kNoAddress) {
        if (peek() == '[' && take_bracketed_name(name, begin) == Claimed::Yes) return;
        if (peek() == ':' && tables_.language.label_sign == ":") {
            ++at_;
            const bool is_front = out_.words.empty() && out_.label.empty() && !is_behind_statement_;
            if (!is_front) return fail(diag::IsoSyntax, begin, at_, {std::string(written) + ':'});
            return take_label(written, begin);
        }
        at_ = end;
        if (take_letter_with_variable(begin) == Claimed::Yes) return;
        if (take_indexed(begin) == Claimed::Yes || take_computed_index(begin) == Claimed::Yes ||
            !require_axis_index(begin) || take_passed(begin) == Claimed::Yes)
            return;
        if (require_number_behind(begin)) fail_unknown(begin, end);
        return;
    }
    const std::size_t next = at_;
    at_ = end;
    if (take_spindle(begin) == Claimed::Yes ||
        (peek() == '[' && take_indexed(begin) == Claimed::Yes) ||
        take_computed_index(begin) == Claimed::Yes)
        return;
    at_ = next;
    const Address& head = tables_.addresses[address];
    if (head.kind == Address::Kind::Call && peek() == '(') return take_call(address, begin);
    if (head.kind == Address::Kind::Word || head.is_word_too) {
        at_ = end;
        return add_word(address, begin);
    }
    if (head.kind == Address::Kind::Value && peek() == '=') return take_assigned(address, begin);
    skip_blanks();
    if (peek() == '"') return fail_here(diag::IsoSyntax);  // `MSG "…"`: no bracket, no `=`
    fail(diag::IsoNoValue, begin, end, {std::string(written)});
}

Lexer::Claimed Lexer::take_bracketed_name(const std::string& name, std::size_t begin) {
    const std::size_t close = line_.find(']', at_);
    if (close == std::string_view::npos) return Claimed::No;
    std::string whole = name;
    for (const char c : line_.substr(at_, close + 1 - at_))
        if (!is_blank(c)) whole += notation_.ignores_case ? upper(c) : c;
    const AddressId address = tables_.find_address(whole);
    if (address == kNoAddress || tables_.addresses[address].kind != Address::Kind::Word)
        return Claimed::No;
    at_ = close + 1;
    add_word(address, begin);
    return Claimed::Yes;
}

Done Lexer::require_axis_index(std::size_t begin) {
    const std::size_t end = at_;
    const std::string name = upper_ascii(line_.substr(begin, end - begin));
    if (!takes_axis(tables_, name)) return kDone;
    const std::size_t next = std::min(line_.find_first_not_of(" \t", end), line_.size());
    const std::size_t close =
        next < line_.size() && line_[next] == '[' ? end_of_brackets(next) : next;
    if (close == next) {
        fail(diag::AxisIndexMissing, begin, end, {name});
        return kFailed;
    }
    std::size_t first = next + 1;
    std::size_t last = close - 1;
    while (first < last && is_blank(line_[first])) ++first;
    while (last > first && is_blank(line_[last - 1])) --last;
    const std::string index = upper_ascii(line_.substr(first, last - first));
    const bool is_spindle = is_spindle_name(index);
    if (is_spindle && tables_.passed.contains(name)) return kDone;
    fail(diag::AxisIndexWrong, first, std::max(last, first + 1),
         {index, name, is_spindle ? "it is a spindle" : why_no_axis(tables_, index)});
    return kFailed;
}

Lexer::Claimed Lexer::take_indexed(std::size_t begin) {
    if (peek() != '[') return Claimed::No;
    const std::size_t close = line_.find(']', at_);
    if (close == std::string_view::npos) return Claimed::No;
    std::string name;
    for (const char c : line_.substr(begin, close + 1 - begin))
        if (!is_blank(c)) name += notation_.ignores_case ? upper(c) : c;
    const std::size_t sign = line_.find_first_not_of(" \t", close + 1);
    if (sign == std::string_view::npos || line_[sign] != '=') return Claimed::No;
    const AddressId value = tables_.find_address(name);
    if (value != kNoAddress && tables_.addresses[value].kind == Address::Kind::Value) {
        at_ = sign;
        take_assigned(value, begin);
        return Claimed::Yes;
    }
    const AddressId address = tables_.find_address(name + '=');
    if (address == kNoAddress || tables_.addresses[address].kind != Address::Kind::Call)
        return Claimed::No;
    at_ = sign + 1;
    skip_blanks();
    if (peek() == '(') {
        take_call(address, begin);
    } else {
        fail_here(diag::IsoSyntax);
    }
    return Claimed::Yes;
}

Lexer::Claimed Lexer::take_spindle(std::size_t begin) {
    const bool has_index = peek() == '[';
    if ((!has_index && !is_digit(peek())) || notation_.spindle_words.empty()) return Claimed::No;
    std::string name(line_.substr(begin, at_ - begin));
    if (notation_.ignores_case) name = upper_ascii(name);
    if (std::ranges::find(notation_.spindle_words, name) == notation_.spindle_words.end())
        return Claimed::No;
    std::size_t end = at_ + (has_index ? 1 : 0);
    // `S[SPI(2)]`: as `S[2]`.
    const bool is_named = has_index && upper_ascii(line_.substr(end, 4)) == "SPI(";
    if (is_named) end += 4;
    const std::size_t first = end;
    while (end < line_.size() && is_digit(line_[end])) ++end;
    const std::string_view number = line_.substr(first, end - first);
    if (is_named && (end == line_.size() || line_[end++] != ')')) return Claimed::No;
    if (has_index) {
        if (end == line_.size() || line_[end] != ']') return Claimed::No;
        ++end;
    }
    const std::size_t sign = std::min(line_.find_first_not_of(" \t", end), line_.size());
    if (number.empty() || sign == line_.size() || line_[sign] != '=') return Claimed::No;
    if (has_index && number != "1" && is_declared(tables_, name, number, false)) {
        at_ = sign;
        take_assigned(tables_.find_address(name + std::string(number)), begin);
        return Claimed::Yes;
    }
    if (number != "1") {
        if (!is_named && is_declared(tables_, name, number, has_index)) return Claimed::No;
        if (is_declared(tables_, name, "2", has_index)) {
            fail(diag::SpindleMissing, begin, end, {std::string(number)});
            return Claimed::Yes;
        }
        fail(diag::IsoNotSupported, begin, end,
             {"`" + std::string(line_.substr(begin, end - begin)) + "` (another spindle)"});
        return Claimed::Yes;
    }
    at_ = sign;
    const std::size_t word = out_.words.size();
    take_assigned(tables_.find_address(name), begin);
    if (word < out_.words.size()) out_.words[word].names_first = true;
    return Claimed::Yes;
}

Lexer::Claimed Lexer::take_computed_index(std::size_t begin) {
    if (compiler_ == nullptr || peek() != '[') return Claimed::No;
    const std::string name = upper_ascii(line_.substr(begin, at_ - begin));
    AddressId address = tables_.find_address(name);
    const bool is_of_spindle =
        std::ranges::find(notation_.spindle_words, name) != notation_.spindle_words.end();
    if (!is_of_spindle) {
        if (!takes_axis(tables_, name)) return Claimed::No;
        address = tables_.find_address(name + '[' + std::string(kAxisNames[0]) + ']');
    }
    if (address == kNoAddress) return Claimed::No;
    std::size_t at = begin;
    bool was_taken = false;
    fault_ = compiler_->take_axis(at, static_cast<std::uint16_t>(out_.words.size()), was_taken);
    if (!was_taken || fault_) return fault_ ? Claimed::Yes : Claimed::No;
    at_ = at;
    skip_blanks();
    if (peek() == '=') {
        take_assigned(address, begin);
    } else {
        fail(diag::IsoNoValue, begin, at_, {std::string(line_.substr(begin, at_ - begin))});
    }
    return Claimed::Yes;
}

void Lexer::take_assigned(AddressId address, std::size_t begin) {
    const Address& head = tables_.addresses[address];
    if (head.kind == Address::Kind::Code &&
        std::ranges::find(notation_.code_words, head.name) != notation_.code_words.end())
        return fail_here(diag::IsoSyntax);
    ++at_;
    skip_blanks();
    if (peek() == '"' && !is_computed_text()) return take_quoted(address, begin);
    if (peek() == '"') return take_computed(address, begin);
    if (const ModeWord* mode = notation_.has_modes ? mode_here() : nullptr) {
        at_ += mode->name.size() + 1;
        skip_blanks();
        if (is_computed(at_)) {
            take_computed(address, begin);
        } else if (!take_number(address, begin)) {
            return;
        }
        if (fault_) return;
        skip_blanks();
        out_.words.back().mode = mode->mode;
        skip_blanks();
        if (peek() != ')') return fail_here(diag::IsoSyntax);
        ++at_;
        out_.spans.back().end = static_cast<std::uint32_t>(at_);
        return;
    }
    if (is_letter(peek()) && take_call_behind(head, begin) == Claimed::Yes) return;
    if (is_computed(at_)) return take_computed(address, begin);
    if (is_letter(peek()) || peek() == '(' || peek() == '$') {
        std::size_t end = line_.find_first_of(" \t;", at_);
        end = std::min(end, line_.size());
        return fail(diag::IsoNotSupported, begin, end, {"a computed value"});
    }
    if (!take_number(address, begin)) return;
    skip_blanks();
    const bool is_end = peek() == notation_.end_sign && notation_.end_sign != '\0';
    if (!is_end && (peek() == '+' || peek() == '-' || peek() == '*' || peek() == '/')) {
        fail(diag::IsoNotSupported, begin, at_, {"a computed value"});
    }
}

Lexer::Claimed Lexer::take_call_behind(const Address& head, std::size_t begin) {
    std::size_t end = at_;
    std::string name = head.name + '=';
    for (; end < line_.size() && is_letter(line_[end]); ++end)
        name += notation_.ignores_case ? upper(line_[end]) : line_[end];
    const std::size_t open = std::min(line_.find_first_not_of(" \t", end), line_.size());
    if (open == line_.size() || line_[open] != '(') return Claimed::No;
    const AddressId address = tables_.find_address(name);
    if (address == kNoAddress || tables_.addresses[address].kind != Address::Kind::Call)
        return Claimed::No;
    at_ = open;
    take_call(address, begin);
    return Claimed::Yes;
}

const ModeWord* Lexer::mode_here() const {
    for (const ModeWord& mode : kModeWords) {
        std::size_t i = 0;
        while (i < mode.name.size() && peek(i) == mode.name[i]) ++i;
        if (i == mode.name.size() && peek(i) == '(') return &mode;
    }
    return nullptr;
}

const ModeWord* Lexer::end_mode_here(AddressId address) const {
    const bool is_end = std::ranges::any_of(tables_.addresses[address].forms, [&](const FormId id) {
        return tables_.forms[id].function == Function::PolynomialAxis;
    });
    const ModeWord* const mode = is_end && notation_.has_modes ? mode_here() : nullptr;
    const bool is_distance = mode != nullptr && (mode->mode == GivenWord::Mode::Absolute ||
                                                 mode->mode == GivenWord::Mode::Incremental);
    return is_distance ? mode : nullptr;
}

bool Lexer::is_computed_text() const {
    if (compiler_ == nullptr) return false;
    const std::size_t close = line_.find('"', at_ + 1);
    return close != std::string_view::npos && compiler_->continues(close + 1);
}

Done Lexer::take_text(std::size_t begin) {
    const std::size_t first = at_ + 1;
    const std::size_t close = line_.find('"', first);
    if (close == std::string_view::npos) {
        fail(diag::IsoSyntax, begin, line_.size(), {std::string(line_.substr(begin))});
        return kFailed;
    }
    out_.text = line_.substr(first, close - first);
    at_ = close + 1;
    return kDone;
}

void Lexer::take_quoted(AddressId address, std::size_t begin) {
    if (!take_text(begin)) return;
    add_word(address, begin);
    GivenWord& word = out_.words.back();
    word.has_value = true;
    word.is_text = true;
    // A name that is a number names the tool with this number.
    const char* const first = out_.text.data();
    const Decimal decimal = parse_decimal(first, first + out_.text.size());
    if (!out_.text.empty() && decimal.end == first + out_.text.size() && !decimal.has_point) {
        word.number = decimal.value;
        word.is_known = true;
        out_.decimals.back() = decimal;
    }
}

void Lexer::take_call(AddressId address, std::size_t begin) {
    ++at_;
    take_arguments(address, begin);
}

Lexer::Claimed Lexer::take_letter_with_variable(std::size_t begin) {
    const AddressId address = tables_.letters[static_cast<unsigned char>(peek_at(begin)) & 127u];
    if (address == kNoAddress || compiler_ == nullptr || !compiler_->begins_value(begin + 1))
        return Claimed::No;
    at_ = begin + 1;
    take_computed(address, begin);
    return Claimed::Yes;
}

void Lexer::take_call_in_brackets() {
    const std::size_t begin = at_++;
    skip_blanks();
    const std::size_t first = at_;
    while (is_letter(peek()) || is_digit(peek())) ++at_;
    std::string name(line_.substr(first, at_ - first));
    if (notation_.ignores_case) name = upper_ascii(name);
    name.insert(0, 1, '(');
    const std::size_t end = at_;
    skip_blanks();
    const AddressId address = tables_.find_address(name);
    if (address == kNoAddress) {
        if (take_passed_in_brackets(name, begin) == Claimed::Yes) return;
        const std::string known = tables_.unsupported_words(name);
        if (!known.empty()) return fail(diag::IsoNotSupported, begin, end, {known});
        return fail(diag::IsoUnknownWord, begin, end,
                    {std::string(line_.substr(begin, end - begin))});
    }
    if (peek() == ',') ++at_;
    else if (peek() != ')') return fail_here(diag::IsoSyntax);
    take_arguments(address, begin);
}

Lexer::Claimed Lexer::take_passed_in_brackets(const std::string& name, std::size_t begin) {
    const auto found = tables_.passed.find(name);
    if (found == tables_.passed.end()) return Claimed::No;
    at_ = end_of_brackets(begin);
    out_.passed.push_back(
        {{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)}, &found->second});
    return Claimed::Yes;
}

AddressId Lexer::argument_letter() const {
    if (!is_letter(peek())) return kNoAddress;
    const AddressId address = tables_.letters[static_cast<unsigned char>(peek()) & 127u];
    const bool is_variable = compiler_ != nullptr && compiler_->begins_value(at_);
    return is_variable ? kNoAddress : address;
}

void Lexer::take_arguments(AddressId address, std::size_t begin) {
    const bool is_in_brackets = tables_.addresses[address].name[0] == '(';
    const auto first = static_cast<std::uint16_t>(out_.arguments.size());
    auto mode = GivenWord::Mode::Modal;
    bool has_text = false;
    while (skip_blanks() && peek() != ')') {
        if (out_.arguments.size() - first >= kMaxCallArguments) {
            return fail(diag::IsoTooManyWords, begin, at_, {});
        }
        GivenArgument argument;
        if (is_in_brackets) {
            argument.letter = argument_letter();
            if (argument.letter != kNoAddress) ++at_;
            skip_blanks();
        }
        const bool is_letter_alone =
            argument.letter != kNoAddress && (peek() == ',' || peek() == ')');
        if (is_letter_alone) argument.kind = GivenArgument::Kind::Letter;
        const ModeWord* const own_mode =
            out_.arguments.size() == first ? end_mode_here(address) : nullptr;
        if (own_mode != nullptr) {
            mode = own_mode->mode;
            at_ += own_mode->name.size() + 1;
            skip_blanks();
        }
        if (peek() == '"'     ? is_computed_text()
            : is_letter_alone ? false
                              : peek() != ',' && is_computed(at_)) {
            fault_ = compiler_->take_value(at_, static_cast<std::uint16_t>(out_.words.size()),
                                           static_cast<std::int32_t>(out_.arguments.size()));
            if (fault_) return;
            argument.kind = GivenArgument::Kind::Number;
        } else if (peek() == '"') {
            // A block has one text: several of a call stand in it with colons between them.
            const std::string before = has_text ? out_.text + ':' : std::string();
            if (!take_text(begin)) return;
            out_.text.insert(0, before);
            has_text = true;
            argument.kind = GivenArgument::Kind::Text;
        } else if (peek() != ',' && !is_letter_alone) {
            const Decimal decimal = parse_decimal(line_.data() + at_, line_.data() + line_.size());
            const auto end = static_cast<std::size_t>(decimal.end - line_.data());
            if (end == at_) {
                if (is_letter(peek()) || peek() == '$') {
                    return fail(diag::IsoNotSupported, at_, at_ + 1, {"a computed value"});
                }
                return fail_here(diag::IsoSyntax);
            }
            argument.kind = GivenArgument::Kind::Number;
            argument.number = decimal.value;
            at_ = end;
        }
        out_.arguments.push_back(argument);
        skip_blanks();
        if (own_mode != nullptr) {
            if (peek() != ')') return fail_here(diag::IsoSyntax);
            ++at_;
            skip_blanks();
        }
        if (peek() == ',') {
            ++at_;
        } else if (peek() != ')') {
            return fail_here(at_ < line_.size() ? diag::IsoSyntax : diag::CloseBracketMissing);
        }
    }
    if (at_ >= line_.size()) return fail_here(diag::CloseBracketMissing);
    ++at_;
    add_word(address, begin);
    GivenWord& word = out_.words.back();
    word.is_call = true;
    word.mode = mode;
    word.first_argument = first;
    word.argument_count = static_cast<std::uint16_t>(out_.arguments.size() - first);
}

}  // namespace kadr::nc
