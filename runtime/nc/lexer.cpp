#include "nc/lexer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "base/done.h"
#include "base/text.h"
#include "nc/letters.h"
#include "nc/mode_words.h"
#include "nc/refused_words.h"

namespace kadr::nc {

namespace {

char upper(char c) { return is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c; }

/// Whether what begins here is of the kind that was asked for; then it is in the line, or the fault
/// says what is wrong with it.
enum class Claimed : std::uint8_t { No, Yes };

class Lexer {
  public:
    Lexer(const DialectTables& tables, std::string_view line, LexedLine& out,
          ValueCompiler* compiler)
        : tables_(tables), notation_(tables.notation), line_(line), out_(out), compiler_(compiler) {
        open_ = tables.comment.open;
        while (open_.ends_with(' ')) open_.remove_suffix(1);
    }

    std::optional<LineFault> run() {
        out_.clear();
        take_skip();
        while (!fault_ && skip_blanks()) {
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

  private:
    // ------------------------------------------------------------ characters

    char peek(std::size_t ahead = 0) const { return peek_at(at_ + ahead); }
    char peek_at(std::size_t i) const {
        if (i >= line_.size()) return '\0';
        return notation_.ignores_case ? upper(line_[i]) : line_[i];
    }
    bool skip_blanks() {
        while (at_ < line_.size() && is_blank(line_[at_])) ++at_;
        return at_ < line_.size();
    }
    void skip_inner_blanks() {
        if (notation_.blanks_inside_words) skip_blanks();
    }
    bool is_letter(char c) const { return is_upper(c) || (notation_.ignores_case && is_lower(c)); }

    void fail(const DiagnosticRow& row, std::size_t begin, std::size_t end,
              std::vector<std::string> arguments) {
        if (fault_) return;
        fault_ = LineFault{&row,
                           {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)},
                           std::move(arguments)};
    }
    /// A word that the dialect does not declare; the control may have it all the same.
    void fail_unknown(std::size_t begin, std::size_t end) {
        const std::string written(line_.substr(begin, end - begin));
        const std::string known =
            tables_.unsupported_words(notation_.ignores_case ? upper_ascii(written) : written);
        if (!known.empty()) return fail(diag::IsoNotSupported, begin, end, {known});
        // `L1:` would be the label that it looks like, had it another name.
        const std::string& colon = tables_.language.label_sign;
        if (!colon.empty() && line_.substr(end).starts_with(colon))
            return fail(diag::IsoSyntax, end, end + colon.size(), {colon});
        if (is_program_call(tables_, written))
            return fail(diag::CallNotAlone, begin, end, {written});
        if (require_supported_words()) fail(diag::IsoUnknownWord, begin, end, {written});
    }
    /// `XY1.` on a control whose words are letters with numbers: X has none.
    Done require_number_behind(std::size_t begin) {
        const AddressId address =
            tables_.letters[static_cast<unsigned char>(peek_at(begin)) & 127u];
        if (!notation_.blanks_inside_words || address == kNoAddress) return kDone;
        const std::size_t next = begin + 1;
        const bool is_next_word =
            next + 1 < line_.size() && !is_letter(line_[next + 1]) &&
            tables_.letters[static_cast<unsigned char>(peek_at(next)) & 127u] != kNoAddress;
        if (!is_next_word) return kDone;
        fail(diag::IsoNoValue, begin, next, {std::string(line_.substr(begin, 1))});
        return kFailed;
    }
    /// `A3=`: a letter with a number of its own, behind which `=` stands.
    void fail_assigned(std::size_t begin, const char* otherwise) {
        const std::string known =
            tables_.unsupported_words(upper_ascii(line_.substr(begin, at_ - begin)) + '=');
        if (known.empty() && !notation_.has_assignment) return fail_here(diag::IsoSyntax);
        fail(diag::IsoNotSupported, begin, at_, {known.empty() ? otherwise : known});
    }
    /// `E=0`, `Q1=5`: the control has axes of any letter, and this machine none such.
    void fail_at_missing_axis(std::size_t begin) {
        const std::string name = upper_ascii(line_.substr(begin, at_ - begin));
        const bool may_be_variable = compiler_ == nullptr;  // `R1=5`, in text without a language
        if (may_be_variable || !tables_.unsupported_words(name + '=').empty() ||
            !notation_.has_assignment)
            return fail_assigned(begin, "the control's own parametric language");
        fail(diag::AxisMissing, begin, at_, {name});
    }
    /// `C1=5`: an axis of that name is not there; `F1=5`: words of others are.
    void fail_numbered(AddressId address, std::size_t begin) {
        const int slot = tables_.addresses[address].slot;
        const bool is_axis =
            slot >= 0 && (kTargetSlots & bit(static_cast<Slot>(slot))) != 0 && compiler_ != nullptr;
        if (is_axis && notation_.has_assignment) return fail_at_missing_axis(begin);
        fail_assigned(begin, "an address with a number of its own");
    }
    /// What stands behind a word that Kadr does not know may have a form that it does not know: the
    /// fault is that word then.
    Done require_supported_words() {
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
    void fail_here(const DiagnosticRow& row) {
        if (&row == &diag::IsoSyntax && !require_supported_words()) return;
        std::size_t end = at_ + 1;
        // A character of several bytes is shown whole.
        while (end < line_.size() && (static_cast<unsigned char>(line_[end]) & 0xc0u) == 0x80u)
            ++end;
        end = std::min(end, line_.size());
        if (at_ >= line_.size()) return fail(row, at_, end, {"the end of the line"});
        const auto code = static_cast<unsigned char>(line_[at_]);
        // What no screen shows is named by its code.
        if (code < ' ') return fail(row, at_, end, {"character " + std::to_string(code)});
        fail(row, at_, end, {std::string(line_.substr(at_, end - at_))});
    }

    // ------------------------------------------------------------ the front of a block

    void take_skip() {
        skip_blanks();
        while (!fault_ && peek() == '/') take_skip_sign();
    }

    /// `/`, `/2`: the level, or nothing if it was reported.
    std::optional<int> take_skip_level() {
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

    /// The rest of the block is left out if the operator wants it. Behind a value of the control's
    /// own language the sign could be a division.
    void take_skip_of_rest() {
        if (compiler_ == nullptr || is_behind_computed_) {
            return fail(diag::IsoNotSupported, at_, line_.size(),
                        {"a part of a block that the operator may leave out"});
        }
        const std::optional<int> level = take_skip_level();
        if (level && compiler_->leaves_out(*level)) at_ = line_.size();
    }

    void take_skip_sign() {
        const std::optional<int> given = take_skip_level();
        if (!given) return;
        const int level = *given;
        if (out_.skip < 0) {
            out_.skip = static_cast<std::int8_t>(level);
        } else {
            out_.further_skip_levels |= static_cast<std::uint16_t>(1u << level);
        }
        skip_blanks();
        if (peek() == '/' && !notation_.has_several_skips) fail_here(diag::IsoSyntax);
    }

    // ------------------------------------------------------------ the control's language

    Claimed take_language() {
        bool was_taken = false;
        if (compiler_ != nullptr) fault_ = compiler_->take_piece(at_, was_taken);
        return was_taken || fault_ ? Claimed::Yes : Claimed::No;
    }

    /// `AX[AXA]=10`: the address of X stands for the axis that is known when the line runs.
    Claimed take_axis_word() {
        const char first = upper(line_[at_]);
        const auto begins = [&](const std::string& name) {
            return !name.empty() && name[0] == first;
        };
        const Language& language = tables_.language;
        if (compiler_ == nullptr ||
            !(begins(language.axis_word) || std::ranges::any_of(language.lone_axis_words, begins)))
            return Claimed::No;
        const std::size_t begin = at_;
        bool was_taken = false;
        fault_ =
            compiler_->take_axis(at_, static_cast<std::uint16_t>(out_.words.size()), was_taken);
        if (!was_taken || fault_) return fault_ ? Claimed::Yes : Claimed::No;
        skip_blanks();
        if (peek() == '=') {
            take_assigned(tables_.find_address(kAxisNames[0]), begin);
        } else {
            fail(diag::IsoNoValue, begin, at_, {std::string(line_.substr(begin, at_ - begin))});
        }
        return Claimed::Yes;
    }

    /// A value that is computed when the line runs.
    void take_computed(AddressId address, std::size_t begin) {
        const auto word = static_cast<std::uint16_t>(out_.words.size());
        fault_ = compiler_->take_value(at_, word, -1);
        if (fault_) return;
        add_word(address, begin);
        out_.words.back().has_value = true;
        is_behind_computed_ = true;
    }

    /// Whether what stands here is more than one number.
    bool is_computed(std::size_t at) const {
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

    // ------------------------------------------------------------ pieces

    void take_piece() {
        if (line_.compare(at_, open_.size(), open_) == 0) return take_comment();
        const char c = peek();
        if (c == notation_.end_sign && c != '\0') return take_end();
        if (c == '/' && notation_.has_several_skips) return take_skip_of_rest();
        is_behind_computed_ = false;
        if (c == ',' && tables_.has_comma_words) return take_comma_word();
        if (c == '[' && compiler_ != nullptr) return fail_here(diag::IsoSyntax);
        if ((c == '#' || c == '[' || c == '$') && compiler_ == nullptr) {
            return fail(diag::IsoNotSupported, at_, at_ + 1,
                        {"the control's own parametric language"});
        }
        if (!is_letter(c) && c != '_') return fail_here(diag::IsoSyntax);
        const char next = peek(1);
        const bool is_name = tables_.has_names && (is_letter(next) || next == '_' || c == '_');
        is_name ? take_name() : take_letter();
    }

    /// The sign that ends a block; nothing stands behind it in the line.
    void take_end() {
        const std::size_t sign = at_++;
        if (!skip_blanks()) return;
        // Comments alone are a block that does nothing.
        while (at_ < line_.size() && is_comment(at_)) {
            take_comment();
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

    void take_comment() {
        const std::size_t begin = at_ + open_.size();
        const std::string& close = tables_.comment.close;
        std::size_t end = line_.size();
        if (!close.empty()) {
            end = line_.find(close, begin);
            if (end == std::string_view::npos)
                return fail(diag::IsoCommentOpen, at_, line_.size(), {});
        }
        std::string_view text = line_.substr(begin, end - begin);
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
        while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
        while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
        if (out_.has_comment) out_.comment += ' ';
        out_.comment += text;
        out_.has_comment = true;
    }

    void add_word(AddressId address, std::size_t begin) {
        GivenWord word;
        word.address = address;
        out_.words.push_back(word);
        out_.decimals.emplace_back();
        out_.minus.push_back(false);
        out_.spans.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)});
    }

    void take_letter() {
        const std::size_t begin = at_;
        const char letter = peek();
        ++at_;
        if (take_spindle(begin) == Claimed::Yes || take_computed_index(begin) == Claimed::Yes)
            return;
        if (is_digit(peek()) && take_extended(begin) == Claimed::Yes) return;
        if (take_code_of_group(begin) == Claimed::Yes) return;
        const AddressId address = tables_.letters[static_cast<unsigned char>(letter) & 127u];
        if (address == kNoAddress) {
            if (take_passed(begin) == Claimed::Yes) return;
            skip_inner_blanks();
            while (at_ < line_.size() && (is_digit(peek()) || peek() == '.' || peek() == '-'))
                ++at_;
            if (peek() == '=') return fail_at_missing_axis(begin);
            return fail_unknown(begin, at_);
        }
        if (tables_.addresses[address].is_block_number) return take_block_number(begin);
        skip_inner_blanks();
        if (compiler_ != nullptr && compiler_->begins_value(at_))
            return take_computed(address, begin);
        if (peek() == '#' || peek() == '[' || peek() == '$') return take_piece();
        if (notation_.has_assignment) {
            const std::size_t next = line_.find_first_not_of(" \t", at_);
            if (next != std::string_view::npos && line_[next] == '=') {
                at_ = next;
                return take_assigned(address, begin);
            }
        }
        if (!take_number(address, begin)) return;
        if (peek() == '=') fail_numbered(address, begin);
    }

    /// `S1=500`, `M1=3`, `SPOS[1]=90`, `S[SPI(1)]=500`: a word of the first spindle, which is the
    /// master unless the program says otherwise; `at_` is behind the letters that begin at `begin`.
    /// What the dialect declares for other spindles are addresses of their own.
    Claimed take_spindle(std::size_t begin) {
        const bool has_index = peek() == '[';
        if ((!has_index && !is_digit(peek())) || notation_.spindle_words.empty())
            return Claimed::No;
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
        if (has_index && number != "1" && is_declared(name, number, false)) {
            at_ = sign;
            take_assigned(tables_.find_address(name + std::string(number)), begin);
            return Claimed::Yes;
        }
        if (number != "1") {
            if (!is_named && is_declared(name, number, has_index)) return Claimed::No;
            if (is_declared(name, "2", has_index)) {
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

    /// `S[R1]=500`, `SPOS[R1]=90`, `ACC[AXV]=50`: words of a spindle or of an axis that is known
    /// when the line runs; `at_` is behind the letters that begin at `begin`.
    Claimed take_computed_index(std::size_t begin) {
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

    bool is_declared(const std::string& name, std::string_view number, bool has_index) const {
        std::string whole = name;
        if (has_index) whole += '[';
        whole += number;
        if (has_index) whole += ']';
        return tables_.find_address(whole) != kNoAddress;
    }

    /// `G[6]=2`: a code by its place in the list of its group; `at_` is behind the letter.
    Claimed take_code_of_group(std::size_t begin) {
        if (compiler_ == nullptr || peek() != '[' || tables_.language.code_lists.empty())
            return Claimed::No;
        const AddressId address =
            tables_.letters[static_cast<unsigned char>(upper(line_[begin])) & 127u];
        if (address == kNoAddress ||
            std::ranges::find(notation_.code_words, tables_.addresses[address].name) ==
                notation_.code_words.end())
            return Claimed::No;
        fault_ = compiler_->take_code(at_, static_cast<std::uint16_t>(out_.words.size()));
        if (fault_) return Claimed::Yes;
        add_word(address, begin);
        return Claimed::Yes;
    }

    /// A word on which nothing here depends, with its brackets and its value; `at_` is behind the
    /// letters that begin at `begin`.
    Claimed take_passed(std::size_t begin) {
        if (tables_.passed.empty()) return Claimed::No;
        const auto named = [&](std::size_t end) {
            std::string text;
            for (const char c : line_.substr(begin, end - begin))
                if (!is_blank(c)) text += notation_.ignores_case ? upper(c) : c;
            return tables_.passed.find(text);
        };
        const std::size_t end = end_of_passed(begin);
        auto found = named(end);
        // Where the control has more of the word than that, it counts as it stands alone.
        const std::string word = upper_ascii(line_.substr(begin, at_ - begin));
        if (found == tables_.passed.end() && tables_.unsupported_words(word).empty())
            found = named(at_);
        if (found == tables_.passed.end()) return Claimed::No;
        at_ = found->second.takes_rest ? line_.size() : end;
        if (!require_passed_value(found->second, begin)) return Claimed::Yes;
        const auto count =
            std::ranges::count(out_.passed, &found->second, &LexedLine::Passed::word);
        if (found->second.read_max != 0 && count >= found->second.read_max) {
            fail(diag::IsoAddressTwice, begin, at_, {found->first});
            return Claimed::Yes;
        }
        out_.passed.push_back(
            {{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)}, &found->second});
        return Claimed::Yes;
    }

    /// The number behind `=`, if one stands there, is one that the word takes; `at_` is behind it.
    Done require_passed_value(const PassedWord& word, std::size_t begin) {
        const std::string_view text = line_.substr(begin, at_ - begin);
        const std::size_t sign = text.rfind('=');
        if (sign == std::string_view::npos) return kDone;
        const std::size_t first = std::min(text.find_first_not_of(" \t", sign + 1), text.size());
        const Decimal decimal = parse_decimal(text.data() + first, text.data() + text.size());
        if (first == text.size() || decimal.end != text.data() + text.size()) return kDone;
        if (decimal.value >= word.least && decimal.value <= word.most) return kDone;
        std::array<std::string, 2> bounds;
        append_shortest(bounds[0], word.least);
        append_shortest(bounds[1], word.most);
        fail(diag::PassedValue, begin, at_, {std::string(text), bounds[0], bounds[1]});
        return kFailed;
    }

    /// Where a word ends whose letters end at `at_`: behind its number or brackets, and its value.
    std::size_t end_of_passed(std::size_t begin) const {
        std::size_t end = at_;
        if (end == begin + 1 && (peek() == '-' || peek() == '+')) ++end;
        const auto behind_blanks = [&] {
            return std::min(line_.find_first_not_of(" \t", end), line_.size());
        };
        while (end < line_.size() && (is_digit(line_[end]) || line_[end] == '.')) ++end;
        while (behind_blanks() < line_.size() && !is_comment(behind_blanks()) &&
               (line_[behind_blanks()] == '[' || line_[behind_blanks()] == '('))
            end = end_of_brackets(behind_blanks());
        if (behind_blanks() == line_.size() || line_[behind_blanks()] != '=') return end;
        end = behind_blanks() + 1;
        end = behind_blanks();
        // Words that signs join: `=2*R1`, `=AC(5) + 1`.
        const auto joins = [&](std::size_t i) {
            return i < line_.size() && std::string_view("+-*/<>").find(line_[i]) < 6;
        };
        while (end < line_.size()) {
            while (joins(end)) ++end;
            end = behind_blanks();
            while (end < line_.size() && !is_blank(line_[end]) && !joins(end) && !is_comment(end)) {
                const bool opens = line_[end] == '(' || line_[end] == '[' || line_[end] == '"';
                end = opens ? end_of_brackets(end) : end + 1;
            }
            if (!joins(behind_blanks())) break;
            end = behind_blanks();
        }
        return end;
    }

    bool is_comment(std::size_t at) const {
        return !open_.empty() && line_.compare(at, open_.size(), open_) == 0;
    }

    /// Behind the bracket or the text that opens at `at`.
    std::size_t end_of_brackets(std::size_t at) const {
        int depth = 0;
        for (; at < line_.size(); ++at) {
            const char c = line_[at];
            if (c == '"') at = std::min(line_.find('"', at + 1), line_.size() - 1);
            if (c == '(' || c == '[') ++depth;
            if (c == ')' || c == ']') --depth;
            if (depth == 0) return at + 1;
        }
        return at;
    }

    /// `,C5.`: an address of two characters.
    void take_comma_word() {
        const std::size_t begin = at_++;
        skip_inner_blanks();
        const std::string name{',', peek()};
        const AddressId address = tables_.find_address(name);
        if (address == kNoAddress) {
            at_ = std::min(at_ + 1, line_.size());
            return fail_unknown(begin, at_);
        }
        ++at_;
        skip_inner_blanks();
        if (compiler_ != nullptr && compiler_->begins_value(at_))
            return take_computed(address, begin);
        (void)take_number(address, begin);  // the piece ends here, with a fault or without
    }

    /// The address of a letter with a number of its own that stands at `begin`, if the dialect
    /// declares it; `end` is behind its name.
    AddressId extended_at(std::size_t begin, std::size_t& end) const {
        end = begin + 1;
        while (end < line_.size() && is_digit(line_[end])) ++end;
        if (end == begin + 1 || end == line_.size() || line_[end] != '=') return kNoAddress;
        std::string name(line_.substr(begin, end - begin));
        if (notation_.ignores_case) name = upper_ascii(name);
        return tables_.find_address(name);
    }

    /// Whether such a word stands here: it is a word of the control even where its language has
    /// variables with such names.
    bool is_declared_name() const {
        std::size_t end = 0;
        return tables_.has_names && compiler_ != nullptr && is_letter(peek()) &&
               is_digit(peek(1)) && extended_at(at_, end) != kNoAddress;
    }

    /// `X1=0`
    Claimed take_extended(std::size_t begin) {
        std::size_t end = 0;
        const AddressId address = extended_at(begin, end);
        if (address == kNoAddress) return Claimed::No;
        at_ = end;
        take_assigned(address, begin);
        return Claimed::Yes;
    }

    void take_block_number(std::size_t begin) {
        const bool is_first = out_.words.empty() && out_.number < 0;
        skip_inner_blanks();
        std::int64_t number = 0;
        const std::size_t first = at_;
        while (is_digit(peek()) && number < 1'000'000'000) {
            number = number * 10 + (line_[at_++] - '0');
            skip_inner_blanks();
        }
        std::size_t end = at_;
        while (end > begin + 1 && is_blank(line_[end - 1])) --end;
        const std::string text(line_.substr(begin, end - begin));
        if (at_ == first) return fail(diag::IsoNoValue, begin, begin + 1, {text.substr(0, 1)});
        if (!is_first && notation_.number_first) return fail(diag::IsoSyntax, begin, at_, {text});
        if (peek() == '.') return fail(diag::IsoPointNotAllowed, begin, at_ + 1, {text + '.'});
        if (number > tables_.block_numbers.most)
            return fail(diag::IsoTooManyDigits, begin, at_, {text});
        if (number < tables_.block_numbers.least)
            return fail(diag::IsoBlockNumber, begin, end, {text});
        out_.number = static_cast<std::int32_t>(number);
    }

    /// `10`, `-5.25`, and on some controls `1 0 . 5`.
    Done take_number(AddressId address, std::size_t begin) {
        Decimal decimal = parse_decimal(line_.data() + at_, line_.data() + line_.size());
        auto end = static_cast<std::size_t>(decimal.end - line_.data());
        const bool is_minus = peek() == '-';
        if (notation_.blanks_inside_words) {
            const std::size_t beyond = line_.find_first_not_of(" \t", end);
            const bool is_more = beyond != std::string_view::npos && end > at_ &&
                                 (is_digit(line_[beyond]) || line_[beyond] == '.');
            const bool has_blank_behind_sign =
                end == at_ && (is_minus || peek() == '+' || peek() == '.') && is_blank(peek(1));
            if (is_more || has_blank_behind_sign) {
                return take_spaced_number(address, begin);
            }
        }
        if (end == at_) {
            const bool has_sign = is_minus || peek() == '+' || peek() == '.';
            end = has_sign ? at_ + 1 : at_;
            while (end > begin + 1 && is_blank(line_[end - 1])) --end;
            fail(diag::IsoNoValue, begin, end, {std::string(line_.substr(begin, end - begin))});
            return kFailed;
        }
        at_ = end;
        if (!take_exponent(decimal)) return kFailed;
        add_number(address, begin, decimal, is_minus);
        return kDone;
    }

    Done take_spaced_number(AddressId address, std::size_t begin) {
        compact_.clear();
        std::size_t i = at_;
        for (; i < line_.size(); ++i) {
            const char c = line_[i];
            if (is_blank(c)) continue;
            if (!is_digit(c) && c != '.' && c != '-' && c != '+') break;
            compact_ += c;
        }
        const Decimal decimal = parse_decimal(compact_.data(), compact_.data() + compact_.size());
        if (compact_.size() == 1 || decimal.end != compact_.data() + compact_.size()) {
            // The sign that does not fit, a second point: `X1.2.3`.
            for (std::ptrdiff_t fits = decimal.end - compact_.data(); fits > 0; ++at_) {
                if (!is_blank(line_[at_])) --fits;
            }
            skip_blanks();
            fail_here(diag::IsoSyntax);
            return kFailed;
        }
        at_ = i;
        while (at_ > begin && is_blank(line_[at_ - 1])) --at_;
        add_number(address, begin, decimal, compact_[0] == '-');
        return kDone;
    }

    /// `1.5EX-3`, on controls whose words are told apart by blanks.
    Done take_exponent(Decimal& decimal) {
        if (!tables_.has_names || notation_.blanks_inside_words || peek() != 'E' || peek(1) != 'X')
            return kDone;
        const std::size_t begin = at_;
        at_ += 2;
        const bool is_minus = peek() == '-';
        if (is_minus || peek() == '+') ++at_;
        int exponent = 0;
        const std::size_t first = at_;
        while (is_digit(peek()) && exponent < 1000) exponent = exponent * 10 + (line_[at_++] - '0');
        if (at_ == first || exponent > 308) {
            fail(diag::IsoSyntax, begin, at_, {std::string(line_.substr(begin, at_ - begin))});
            return kFailed;
        }
        decimal.value *= std::pow(10.0, is_minus ? -exponent : exponent);
        decimal.has_point = true;
        return kDone;
    }

    void add_number(AddressId address, std::size_t begin, const Decimal& decimal, bool is_minus) {
        add_word(address, begin);
        out_.words.back().has_value = true;
        out_.words.back().is_known = true;
        out_.words.back().number = decimal.value;
        out_.decimals.back() = decimal;
        out_.minus.back() = is_minus;
    }

    // ------------------------------------------------------------ names

    void take_name() {
        const std::size_t begin = at_;
        std::size_t end = at_;
        while (end < line_.size() &&
               (is_letter(line_[end]) || is_digit(line_[end]) || line_[end] == '_'))
            ++end;
        const std::string_view written = line_.substr(begin, end - begin);
        const std::string name =
            notation_.ignores_case ? upper_ascii(written) : std::string(written);
        const AddressId address = tables_.find_address(name);
        at_ = end;
        skip_blanks();
        if (address == kNoAddress) {
            if (peek() == '[' && take_bracketed_name(name, begin) == Claimed::Yes) return;
            if (peek() == ':' && tables_.language.label_sign == ":") {
                ++at_;
                const bool is_front =
                    out_.words.empty() && out_.label.empty() && !is_behind_statement_;
                if (!is_front)
                    return fail(diag::IsoSyntax, begin, at_, {std::string(written) + ':'});
                constexpr std::size_t kLongest = 32;  // S 1.5
                if (name.size() > kLongest)
                    return fail(diag::LabelTooLong, begin, end, {std::string(written)});
                out_.label = name;
                return;
            }
            at_ = end;
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
        if (head.kind == Address::Kind::Value && peek() == '=')
            return take_assigned(address, begin);
        skip_blanks();
        if (peek() == '"') return fail_here(diag::IsoSyntax);  // `MSG "…"`: no bracket, no `=`
        fail(diag::IsoNoValue, begin, end, {std::string(written)});
    }

    /// `PO[X]=(10,2)`, which a dialect declares as a call of the name `PO[X]=`, and `ACC[X]=50`, an
    /// address `ACC[X]`; `at_` is behind the letters that begin at `begin`.
    Claimed take_indexed(std::size_t begin) {
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

    /// A word that names an axis between brackets (`ACC[X]=50`) names one that is there. That of a
    /// spindle may be passed over. `at_` is behind its letters.
    Done require_axis_index(std::size_t begin) {
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

    /// `DIAMONA[X]`: a word of its own by the name with its brackets; `at_` stands at the bracket.
    Claimed take_bracketed_name(const std::string& name, std::size_t begin) {
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

    /// `F=FPO(100,5)`, which a dialect declares as a call of the name `F=FPO`; `at_` is behind the
    /// sign.
    Claimed take_call_behind(const Address& head, std::size_t begin) {
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

    /// `=10`, `=AC(10)`, `=IC(-5)`, `=DC(90)`, `="text"`; behind the address.
    void take_assigned(AddressId address, std::size_t begin) {
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

    /// `AC(`, `DIC(`, … stands here.
    const ModeWord* mode_here() const {
        for (const ModeWord& mode : kModeWords) {
            std::size_t i = 0;
            while (i < mode.name.size() && peek(i) == mode.name[i]) ++i;
            if (i == mode.name.size() && peek(i) == '(') return &mode;
        }
        return nullptr;
    }

    /// `AC(` or `IC(` in front of the end of an axis in a polynomial, `PO[X]=(AC(10),2)`.
    const ModeWord* end_mode_here(AddressId address) const {
        const bool is_end =
            std::ranges::any_of(tables_.addresses[address].forms, [&](const FormId id) {
                return tables_.forms[id].function == Function::PolynomialAxis;
            });
        const ModeWord* const mode = is_end && notation_.has_modes ? mode_here() : nullptr;
        const bool is_way = mode != nullptr && (mode->mode == GivenWord::Mode::Absolute ||
                                                mode->mode == GivenWord::Mode::Incremental);
        return is_way ? mode : nullptr;
    }

    /// Whether more than one text stands here: `"X="<<R1`.
    bool is_computed_text() const {
        if (compiler_ == nullptr) return false;
        const std::size_t close = line_.find('"', at_ + 1);
        return close != std::string_view::npos && compiler_->continues(close + 1);
    }

    Done take_text(std::size_t begin) {
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

    void take_quoted(AddressId address, std::size_t begin) {
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

    void take_call(AddressId address, std::size_t begin) {
        ++at_;
        const auto first = static_cast<std::uint16_t>(out_.arguments.size());
        auto mode = GivenWord::Mode::Modal;
        bool has_text = false;
        while (skip_blanks() && peek() != ')') {
            if (out_.arguments.size() - first >= kMaxCallArguments) {
                return fail(diag::IsoTooManyWords, begin, at_, {});
            }
            GivenArgument argument;
            const ModeWord* const own_mode =
                out_.arguments.size() == first ? end_mode_here(address) : nullptr;
            if (own_mode != nullptr) {
                mode = own_mode->mode;
                at_ += own_mode->name.size() + 1;
                skip_blanks();
            }
            if (peek() == '"' ? is_computed_text() : peek() != ',' && is_computed(at_)) {
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
            } else if (peek() != ',') {
                const Decimal decimal =
                    parse_decimal(line_.data() + at_, line_.data() + line_.size());
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

    const DialectTables& tables_;
    const Notation& notation_;
    std::string_view line_;
    LexedLine& out_;
    ValueCompiler* compiler_;
    std::string_view open_;
    std::string compact_;
    bool is_behind_statement_ = false;
    bool is_behind_computed_ = false;  // the piece before is a word that is worked out
    std::size_t at_ = 0;
    std::optional<LineFault> fault_;
};

}  // namespace

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
    skip = -1;
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
