#include "nc/lexer.h"

#include <algorithm>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/text.h"
#include "nc/line_lexer.h"
#include "nc/refused_words.h"

namespace kadr::nc {

Lexer::Lexer(const DialectTables& tables, std::string_view line, LexedLine& out,
             ValueCompiler* compiler)
    : tables_(tables), notation_(tables.notation), line_(line), out_(out), compiler_(compiler) {
    open_ = tables.comment.open;
    while (open_.ends_with(' ')) open_.remove_suffix(1);
}

std::optional<LineFault> Lexer::run() {
    out_.clear();
    take_skip();
    while (!fault_ && skip_blanks()) {
        if (take_front() == Claimed::Yes) continue;
        if (is_declared_name()) {
            take_piece();
        } else if (take_axis_word() == Claimed::Yes || take_language() == Claimed::Yes) {
            is_behind_statement_ = true;
        } else {
            take_piece();
        }
    }
    return std::move(fault_);
}

// ---------------------------------------------------------------- the front of a block, pieces

void Lexer::take_skip() {
    skip_blanks();
    while (!fault_ && peek() == '/') take_skip_sign();
}

std::optional<int> Lexer::take_skip_level() {
    const std::size_t begin = at_++;
    skip_inner_blanks();
    int level = notation_.default_skip;
    if (is_digit(peek())) {
        level = 0;
        while (is_digit(peek()) && level < 100) level = level * 10 + (line_[at_++] - '0');
    }
    if (level >= notation_.default_skip && level < notation_.skip_levels && level <= 9)
        return level;
    fail(diag::IsoSkipLevel, begin, at_, {std::to_string(level)});
    return std::nullopt;
}

void Lexer::take_skip_of_rest() {
    if (compiler_ == nullptr || is_behind_computed_) {
        return fail(diag::IsoNotSupported, at_, line_.size(),
                    {"a part of a block that the operator may leave out"});
    }
    const std::optional<int> level = take_skip_level();
    if (level && compiler_->leaves_out(*level)) at_ = line_.size();
}

void Lexer::take_skip_sign() {
    const std::optional<int> given = take_skip_level();
    if (!given) return;
    const int level = *given;
    if (out_.skip_level < 0) {
        out_.skip_level = static_cast<std::int8_t>(level);
    } else {
        out_.further_skip_levels |= static_cast<std::uint16_t>(1u << level);
    }
    skip_blanks();
    if (peek() == '/' && !notation_.has_several_skips) fail_here(diag::IsoSyntax);
}

/// Signs in front of the words that mean nothing here, and a label between its signs: `"LAB"`.
Lexer::Claimed Lexer::take_front() {
    const std::string& quote = tables_.language.label_quote;
    if ((notation_.front_signs.empty() && quote.empty()) || !out_.words.empty()) return Claimed::No;
    if (notation_.front_signs.find(peek()) != std::string::npos) {
        ++at_;
        return Claimed::Yes;
    }
    const bool is_label = !quote.empty() && line_.substr(at_).starts_with(quote);
    if (!is_label || is_behind_statement_) return Claimed::No;
    const std::size_t begin = at_;
    const std::size_t first = begin + quote.size();
    const std::size_t end = std::min(line_.find(quote, first), line_.size());
    at_ = std::min(end + quote.size(), line_.size());
    if (end == line_.size() || end == first || !out_.label.empty())
        fail(diag::IsoSyntax, begin, at_, {std::string(line_.substr(begin, at_ - begin))});
    else take_label(line_.substr(first, end - first), first);
    return Claimed::Yes;
}

void Lexer::take_label(std::string_view written, std::size_t begin) {
    const auto longest = static_cast<std::size_t>(tables_.language.label_length);
    if (written.size() > longest) {
        return fail(diag::LabelTooLong, begin, begin + written.size(),
                    {std::string(written), std::to_string(longest)});
    }
    out_.label = notation_.ignores_case ? upper_ascii(written) : std::string(written);
}

Lexer::Claimed Lexer::take_language() {
    bool was_taken = false;
    if (compiler_ != nullptr) fault_ = compiler_->take_piece(at_, was_taken);
    return was_taken || fault_ ? Claimed::Yes : Claimed::No;
}

Lexer::Claimed Lexer::take_axis_word() {
    const char first = upper(line_[at_]);
    const auto begins = [&](const std::string& name) { return !name.empty() && name[0] == first; };
    const Language& language = tables_.language;
    if (compiler_ == nullptr ||
        !(begins(language.axis_word) || std::ranges::any_of(language.lone_axis_words, begins)))
        return Claimed::No;
    const std::size_t begin = at_;
    bool was_taken = false;
    fault_ = compiler_->take_axis(at_, static_cast<std::uint16_t>(out_.words.size()), was_taken);
    if (!was_taken || fault_) return fault_ ? Claimed::Yes : Claimed::No;
    skip_blanks();
    if (peek() == '=') {
        take_assigned(tables_.find_address(kAxisNames[0]), begin);
    } else {
        fail(diag::IsoNoValue, begin, at_, {std::string(line_.substr(begin, at_ - begin))});
    }
    return Claimed::Yes;
}

void Lexer::take_computed(AddressId address, std::size_t begin) {
    const auto word = static_cast<std::uint16_t>(out_.words.size());
    fault_ = compiler_->take_value(at_, word, -1);
    if (fault_) return;
    add_word(address, begin);
    out_.words.back().has_value = true;
    is_behind_computed_ = true;
}

bool Lexer::is_computed(std::size_t at) const {
    if (compiler_ == nullptr) return false;
    const Decimal decimal = parse_decimal(line_.data() + at, line_.data() + line_.size());
    auto end = static_cast<std::size_t>(decimal.end - line_.data());
    if (end == at) return true;
    if (line_.substr(end).starts_with("EX") || line_.substr(end).starts_with("ex")) {
        end = line_.find_first_not_of("0123456789+-", end + 2);
        end = std::min(end, line_.size());
    }
    return compiler_->continues(end);
}

void Lexer::take_piece() {
    if (line_.compare(at_, open_.size(), open_) == 0) return take_comment();
    if (const CommentMarks* const other = other_comment(at_)) return take_other_comment(*other);
    const char c = peek();
    if (c == '(' && tables_.has_bracket_calls) return take_call_in_brackets();
    if (c == notation_.end_sign && c != '\0') return take_end();
    if (c == '/' && notation_.has_several_skips) return take_skip_of_rest();
    is_behind_computed_ = false;
    if (c == ',' && tables_.has_comma_words) return take_comma_word();
    if (c == '[' && compiler_ != nullptr) return fail_here(diag::IsoSyntax);
    if ((c == '#' || c == '[' || c == '$') && compiler_ == nullptr) {
        return fail(diag::IsoNotSupported, at_, at_ + 1, {"the control's own parametric language"});
    }
    if (!is_letter(c) && c != '_') return fail_here(diag::IsoSyntax);
    const char next = peek(1);
    const bool is_name = tables_.has_names && (is_letter(next) || next == '_' || c == '_');
    is_name ? take_name() : take_letter();
}

void Lexer::take_end() {
    const std::size_t sign = at_++;
    if (!skip_blanks()) return;
    // Comments alone are a block that does nothing.
    while (at_ < line_.size() && is_comment(at_)) {
        const CommentMarks* const other = other_comment(at_);
        if (other != nullptr) take_other_comment(*other);
        else take_comment();
        if (fault_ || !skip_blanks()) return;
    }
    // A word, or the comment of another control?
    const char next = peek(1);
    const bool is_word =
        is_letter(peek()) && (is_digit(next) || next == '-' || next == '+' || next == '.');
    if (is_word)
        return fail(diag::IsoNotSupported, at_, line_.size(), {"a second block in one line"});
    at_ = sign;
    fail_here(diag::IsoSyntax);
}

void Lexer::take_comment() {
    const std::size_t begin = at_ + open_.size();
    const std::string& close = tables_.comment.close;
    std::size_t end = line_.size();
    if (!close.empty()) {
        end = line_.find(close, begin);
        if (end == std::string_view::npos) return fail(diag::IsoCommentOpen, at_, line_.size(), {});
    }
    const std::string_view text = line_.substr(begin, end - begin);
    const std::size_t start = at_;
    at_ = std::min(end + close.size(), line_.size());
    for (const FormId id : tables_.comment_forms) {
        const Form& form = tables_.forms[id];
        if (!text.starts_with(form.words[0].text)) continue;
        out_.comment_form = id;
        out_.text = text.substr(form.words[0].text.size());
        out_.comment_form_span = {static_cast<std::uint32_t>(start),
                                  static_cast<std::uint32_t>(at_)};
        return;
    }
    note_comment(text);
}

void Lexer::note_comment(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    if (out_.has_comment) out_.comment += ' ';
    out_.comment += text;
    out_.has_comment = true;
}

const CommentMarks* Lexer::other_comment(std::size_t at) const {
    const auto& others = tables_.comment.also_read;
    if (others.empty()) return nullptr;
    const auto found = std::ranges::find_if(others, [&](const CommentMarks& marks) {
        return line_.substr(at).starts_with(marks.open);
    });
    return found == others.end() ? nullptr : &*found;
}

void Lexer::take_other_comment(const CommentMarks& marks) {
    const std::size_t begin = at_ + marks.open.size();
    std::size_t end = line_.size();
    if (!marks.close.empty()) {
        end = line_.find(marks.close, begin);
        if (end == std::string_view::npos) return fail(diag::IsoCommentOpen, at_, line_.size(), {});
    }
    note_comment(line_.substr(begin, end - begin));
    at_ = std::min(end + marks.close.size(), line_.size());
}

bool Lexer::is_comment(std::size_t at) const {
    if (other_comment(at) != nullptr) return true;
    return !open_.empty() && line_.compare(at, open_.size(), open_) == 0;
}

void Lexer::add_word(AddressId address, std::size_t begin) {
    GivenWord word;
    word.address = address;
    out_.words.push_back(word);
    out_.decimals.emplace_back();
    out_.minus.push_back(false);
    out_.spans.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)});
}

// ---------------------------------------------------------------- faults

void Lexer::fail(const DiagnosticRow& row, std::size_t begin, std::size_t end,
                 std::vector<std::string> arguments) {
    if (fault_) return;
    fault_ = LineFault{&row,
                       {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)},
                       std::move(arguments)};
}

void Lexer::fail_unknown(std::size_t begin, std::size_t end) {
    const std::string written(line_.substr(begin, end - begin));
    const std::string known =
        tables_.unsupported_words(notation_.ignores_case ? upper_ascii(written) : written);
    if (!known.empty()) return fail(diag::IsoNotSupported, begin, end, {known});
    // `L1:` would be the label that it looks like, had it another name.
    const std::string& colon = tables_.language.label_sign;
    if (!colon.empty() && line_.substr(end).starts_with(colon))
        return fail(diag::IsoSyntax, end, end + colon.size(), {colon});
    if (is_program_call(tables_, written)) return fail(diag::CallNotAlone, begin, end, {written});
    if (require_supported_words()) fail(diag::IsoUnknownWord, begin, end, {written});
}

Done Lexer::require_number_behind(std::size_t begin) {
    const AddressId address = tables_.letters[static_cast<unsigned char>(peek_at(begin)) & 127u];
    if (!notation_.blanks_inside_words || address == kNoAddress) return kDone;
    const std::size_t next = begin + 1;
    const bool is_next_word =
        next + 1 < line_.size() && !is_letter(line_[next + 1]) &&
        tables_.letters[static_cast<unsigned char>(peek_at(next)) & 127u] != kNoAddress;
    if (!is_next_word) return kDone;
    fail(diag::IsoNoValue, begin, next, {std::string(line_.substr(begin, 1))});
    return kFailed;
}

void Lexer::fail_assigned(std::size_t begin, const char* otherwise) {
    const std::string known =
        tables_.unsupported_words(upper_ascii(line_.substr(begin, at_ - begin)) + '=');
    if (known.empty() && !notation_.has_assignment) return fail_here(diag::IsoSyntax);
    fail(diag::IsoNotSupported, begin, at_, {known.empty() ? otherwise : known});
}

void Lexer::fail_at_missing_axis(std::size_t begin) {
    const std::string name = upper_ascii(line_.substr(begin, at_ - begin));
    const bool may_be_variable = compiler_ == nullptr;  // `R1=5`, in text without a language
    if (may_be_variable || !tables_.unsupported_words(name + '=').empty() ||
        !notation_.has_assignment)
        return fail_assigned(begin, "the control's own parametric language");
    fail(diag::AxisMissing, begin, at_, {name});
}

void Lexer::fail_numbered(AddressId address, std::size_t begin) {
    const int slot = tables_.addresses[address].slot;
    const bool is_axis =
        slot >= 0 && (kTargetSlots & bit(static_cast<Slot>(slot))) != 0 && compiler_ != nullptr;
    if (is_axis && notation_.has_assignment) return fail_at_missing_axis(begin);
    fail_assigned(begin, "an address with a number of its own");
}

Done Lexer::require_supported_words() {
    for (const Span& span : out_.spans) {
        const std::string written(line_.substr(span.begin, span.end - span.begin));
        const std::string known =
            tables_.unsupported_words(notation_.ignores_case ? upper_ascii(written) : written);
        if (known.empty()) continue;
        fail(diag::IsoNotSupported, span.begin, span.end, {known});
        return kFailed;
    }
    return kDone;
}

void Lexer::fail_here(const DiagnosticRow& row) {
    if (&row == &diag::IsoSyntax && !require_supported_words()) return;
    std::size_t end = at_ + 1;
    // A character of several bytes is shown whole.
    while (end < line_.size() && (static_cast<unsigned char>(line_[end]) & 0xc0u) == 0x80u) ++end;
    end = std::min(end, line_.size());
    if (at_ >= line_.size()) return fail(row, at_, end, {"the end of the line"});
    const auto code = static_cast<unsigned char>(line_[at_]);
    // What no screen shows is named by its code.
    if (code < ' ') return fail(row, at_, end, {"character " + std::to_string(code)});
    fail(row, at_, end, {std::string(line_.substr(at_, end - at_))});
}

void LexedLine::clear() {
    passed.clear();
    words.clear();
    decimals.clear();
    minus.clear();
    spans.clear();
    arguments.clear();
    text.clear();
    comment.clear();
    label.clear();
    skip_level = -1;
    further_skip_levels = 0;
    number = -1;
    has_comment = false;
    comment_form = kNoForm;
}

std::optional<LineFault> lex_line(const DialectTables& tables, std::string_view line,
                                  LexedLine& out, ValueCompiler* compiler) {
    return Lexer(tables, line, out, compiler).run();
}

}  // namespace kadr::nc
