// lexer_letters.cpp — words of letters with numbers behind them, `X10.5`, `N20`, `,R2.`, and words
// that are passed over.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "nc/line_lexer.h"

namespace kadr::nc {

void Lexer::take_letter() {
    const std::size_t begin = at_;
    const char letter = peek();
    ++at_;
    if (take_spindle(begin) == Claimed::Yes || take_computed_index(begin) == Claimed::Yes) return;
    if (is_digit(peek()) && take_extended(begin) == Claimed::Yes) return;
    if (take_code_of_group(begin) == Claimed::Yes) return;
    const AddressId address = tables_.letters[static_cast<unsigned char>(letter) & 127u];
    if (address == kNoAddress) {
        if (take_passed(begin) == Claimed::Yes) return;
        skip_inner_blanks();
        while (at_ < line_.size() && (is_digit(peek()) || peek() == '.' || peek() == '-')) ++at_;
        if (peek() == '=') return fail_at_missing_axis(begin);
        return fail_unknown(begin, at_);
    }
    if (tables_.addresses[address].is_block_number) return take_block_number(begin);
    skip_inner_blanks();
    if (compiler_ != nullptr && compiler_->begins_value(at_)) return take_computed(address, begin);
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

void Lexer::take_comma_word() {
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
    if (compiler_ != nullptr && compiler_->begins_value(at_)) return take_computed(address, begin);
    (void)take_number(address, begin);  // the piece ends here, with a fault or without
}

AddressId Lexer::extended_at(std::size_t begin, std::size_t& end) const {
    end = begin + 1;
    while (end < line_.size() && is_digit(line_[end])) ++end;
    if (end == begin + 1 || end == line_.size() || line_[end] != '=') return kNoAddress;
    std::string name(line_.substr(begin, end - begin));
    if (notation_.ignores_case) name = upper_ascii(name);
    return tables_.find_address(name);
}

bool Lexer::is_declared_name() const {
    std::size_t end = 0;
    return tables_.has_names && compiler_ != nullptr && is_letter(peek()) && is_digit(peek(1)) &&
           extended_at(at_, end) != kNoAddress;
}

Lexer::Claimed Lexer::take_extended(std::size_t begin) {
    std::size_t end = 0;
    const AddressId address = extended_at(begin, end);
    if (address == kNoAddress) return Claimed::No;
    at_ = end;
    take_assigned(address, begin);
    return Claimed::Yes;
}

Lexer::Claimed Lexer::take_code_of_group(std::size_t begin) {
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

void Lexer::take_block_number(std::size_t begin) {
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
    if (number < tables_.block_numbers.least) return fail(diag::IsoBlockNumber, begin, end, {text});
    out_.number = static_cast<std::int32_t>(number);
}

Done Lexer::take_number(AddressId address, std::size_t begin) {
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

Done Lexer::take_spaced_number(AddressId address, std::size_t begin) {
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

Done Lexer::take_exponent(Decimal& decimal) {
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

void Lexer::add_number(AddressId address, std::size_t begin, const Decimal& decimal,
                       bool is_minus) {
    add_word(address, begin);
    out_.words.back().has_value = true;
    out_.words.back().is_known = true;
    out_.words.back().number = decimal.value;
    out_.decimals.back() = decimal;
    out_.minus.back() = is_minus;
}

Lexer::Claimed Lexer::take_passed(std::size_t begin) {
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
    const auto count = std::ranges::count(out_.passed, &found->second, &LexedLine::Passed::word);
    if (found->second.read_max != 0 && count >= found->second.read_max) {
        fail(diag::IsoAddressTwice, begin, at_, {found->first});
        return Claimed::Yes;
    }
    out_.passed.push_back(
        {{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)}, &found->second});
    return Claimed::Yes;
}

Done Lexer::require_passed_value(const PassedWord& word, std::size_t begin) {
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

std::size_t Lexer::end_of_passed(std::size_t begin) const {
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

std::size_t Lexer::end_of_brackets(std::size_t at) const {
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

}  // namespace kadr::nc
