#include "nc/line_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/powers.h"
#include "base/short_number.h"
#include "base/text.h"

namespace kadr::nc {

namespace {

bool is_digit(char c) { return static_cast<unsigned char>(c - '0') <= 9; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// What a byte behind the digits of a number says about it.
enum NumberEnd : std::uint8_t { kEnds = 0, kGoesOn = 1, kIsExpression = 2, kBlank = 4 };
constexpr std::array<std::uint8_t, 256> number_ends() {
    std::array<std::uint8_t, 256> ends{};
    for (const char c : std::string_view(".0123456789"))
        ends[static_cast<unsigned char>(c)] = kGoesOn;
    for (const char c : std::string_view("=Ee#["))
        ends[static_cast<unsigned char>(c)] = kIsExpression;
    for (const char c : std::string_view(" \t")) ends[static_cast<unsigned char>(c)] = kBlank;
    return ends;
}
constexpr std::array<std::uint8_t, 256> kNumberEnds = number_ends();

/// Whether no number of the format needs a second look.
bool is_literal(const NumberFormat& format) {
    return format.increment == 0 && format.inch_increment == 0 &&
           format.revolution_increment == 0 && !format.truncates && format.max_digits == 0 &&
           format.point == PointRule::Needed && format.allows_minus;
}

/// Whether a line is the last one of a program: it begins as the template does before what is
/// filled in.
bool is_end_line(std::string_view line, std::string_view end) {
    const std::size_t fixed = end.find_first_of("{[");
    if (fixed == 0 || fixed == std::string_view::npos) return line == end;
    return line.starts_with(end.substr(0, fixed));
}

}  // namespace

LineReader::LineReader(const Dialect& dialect, std::string name, DiagnosticSink& sink)
    : dialect_(dialect), tables_(dialect.tables()), own_text_{std::move(name)}, sink_(sink) {
    for (std::size_t letter = 0; letter < letters_.size(); ++letter) prepare(letter);
    modal_ = tables_.power_on;
    modal_[static_cast<std::size_t>(Group::Motion)] = Function::None;
    last_forms_.assign(tables_.groups.size(), kNoForm);
    const auto& threads = tables_.forms_of[static_cast<std::size_t>(Function::Thread)];
    feed_is_pitch_ = !threads.empty() && tables_.forms[threads[0]].feed_is_pitch;
    if (feed_is_pitch_) closely_read_.set(static_cast<std::size_t>(Function::Thread));
    follow_units();
}

/// Whether a word of the address means its slot but under certain motions, which are noted.
bool LineReader::are_of_motions(const Address& address) {
    for (const FormId id : address.forms) {
        const std::vector<Function>& during = tables_.forms[id].during;
        const bool is_of_motion = during.size() == 1 && info(during[0]).group == Group::Motion;
        if (!is_of_motion) return false;
        closely_read_.set(static_cast<std::size_t>(during[0]));
    }
    return true;
}
void LineReader::prepare(std::size_t letter) {
    const AddressId id = tables_.letters[letter];
    FastLetter& fast = letters_[letter];
    if (id != kNoAddress) {
        const Address& address = tables_.addresses[id];
        fast.address = id;
        fast.format = &address.format;
        fast.dimension = address.dimension;
        fast.is_literal = is_literal(address.format);
        if (address.is_block_number) {
            fast.kind = FastLetter::Kind::Number;
        } else if (address.kind == Address::Kind::Code) {
            fast.kind = FastLetter::Kind::Code;
        } else if (address.slot >= 0 && !address.is_incremental && !address.is_coordinate &&
                   are_of_motions(address) && tables_.code_index[id].empty()) {
            fast.kind = FastLetter::Kind::Slot;
            fast.slot = static_cast<Slot>(address.slot);
        }
    }
    if (letter >= 'A' && letter <= 'Z' && tables_.rules.ignores_case) letters_[letter + 32] = fast;
}

// ---------------------------------------------------------------- lines

LineReader::LineKind LineReader::kind_of(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    if (line.empty()) return LineKind::Nothing;
    const std::vector<std::string>& ends = tables_.program.end;
    const auto is_end = [&](const std::string& end) { return is_end_line(line, end); };
    if (text_->has_content && std::ranges::any_of(ends, is_end)) text_->has_ended = true;
    if (text_->has_ended) return LineKind::Nothing;
    const bool is_header = std::ranges::any_of(
        tables_.program.skipped, [&](const std::string& front) { return line.starts_with(front); });
    if (!is_header) return LineKind::Words;
    if (text_->has_content &&
        program_of_header(tables_.language.calls, line, tables_.rules.ignores_case)) {
        text_->has_ended = true;
        return LineKind::Nothing;
    }
    if (has_wrong_number(line)) return LineKind::WrongNumber;
    if (!text_->has_content) return LineKind::Nothing;
    // Where a mark ends the text, another program may begin before it.
    text_->has_ended = !ends.empty();
    return text_->has_ended ? LineKind::Nothing : LineKind::Misplaced;
}

/// Whether the line names the program by a number that the control does not have.
bool LineReader::has_wrong_number(std::string_view line) const {
    const ProgramFrame& frame = tables_.program;
    if (frame.most_read_number == 0) return false;
    for (const std::string& header : frame.header) {
        const std::size_t front = header.find("{number");
        if (front == 0 || front == std::string::npos) continue;
        if (!line.starts_with(std::string_view(header).substr(0, front))) continue;
        const char* const digits = line.data() + front;
        const Decimal number = parse_decimal(digits, line.data() + line.size());
        return number.end != digits && (number.value < static_cast<double>(frame.least_number) ||
                                        number.value > static_cast<double>(frame.most_read_number));
    }
    return false;
}

bool LineReader::read_plain(std::string_view line, Block& block) {
    if (!read_fast(line, block)) {
        block.reset();
        return false;
    }
    text_->has_content = true;
    // Later forms depend on modal functions: G68 on its plane, G53 on absolute dimensions.
    if (block.function_count != 0 || block.motion != Function::None) follow_modal(block, modal_);
    return true;
}

bool LineReader::has_words(std::string_view line) {
    const LineKind kind = kind_of(line);
    if (kind == LineKind::Misplaced) {
        const std::size_t begin = line.find_first_not_of(" \t");
        const auto at = static_cast<std::uint32_t>(begin);
        report(line, LineFault{&diag::IsoSyntax, {at, at + 1}, {std::string(1, line[begin])}});
    }
    if (kind == LineKind::WrongNumber) {
        const std::size_t begin = line.find_first_not_of(" \t");
        const std::size_t end = std::min(line.find_first_of(" \t(;", begin), line.size());
        report(line, LineFault{&diag::IsoProgramNumber,
                               {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)},
                               {std::string(line.substr(begin, end - begin))}});
    }
    return kind == LineKind::Words;
}

bool LineReader::read_known(std::string_view line, Block& block) {
    if (!read_verbatim(line, block)) return false;
    text_->has_content = true;
    follow_modal(block, modal_);
    return true;
}

bool LineReader::read(std::string_view line, std::uint64_t number, Block& block) {
    begin(number);
    if (read_plain(line, block)) return true;
    if (!has_words(line)) return false;
    if (read_slow(line, block)) {
        text_->has_content |= block.kind != Block::Kind::Comment;
        follow(block);
        return true;
    }
    note_fault();
    return false;
}

bool LineReader::read_words(std::string_view line, ControlLine& compiled,
                            std::span<const WordValue> values, Block& block, MatchedLine* known) {
    lexed_ = &compiled.words;
    set_values(compiled, values);
    text_->has_content = true;
    const bool is_whole = std::ranges::none_of(
        values, [](const WordValue& value) { return value.kind == WordValue::Kind::Vacant; });
    const bool is_known =
        known != nullptr && known->is_valid && is_whole && known->before == modal_;
    if (is_known) recall(*known, block);
    const bool is_fine =
        is_known ? apply(block, line) : fill(line, block, is_whole ? known : nullptr, &compiled);
    if (!is_fine) {
        note_fault();
        return false;
    }
    follow_modal(block, modal_);
    return true;
}

/// The block as the words were understood before; the values are to be put in.
void LineReader::recall(const MatchedLine& known, Block& block) {
    const Block& shape = known.shape;
    block.skip = shape.skip;
    block.skip_also = shape.skip_also;
    block.number = shape.number;
    block.motion = shape.motion;
    block.incremental = shape.incremental;
    block.absolute = shape.absolute;
    block.x_measure = shape.x_measure;
    block.rotary_ways = shape.rotary_ways;
    block.cycle = shape.cycle;
    block.function_count = shape.function_count;
    block.argument_count = shape.argument_count;
    std::copy_n(shape.functions.begin(), shape.function_count, block.functions.begin());
    std::copy_n(shape.arguments.begin(), shape.argument_count, block.arguments.begin());
    if (!lexed_->comment.empty()) block.comment = lexed_->comment;
    if (!lexed_->text.empty()) block.text = lexed_->text;
    std::ranges::copy(known.claims, match_.claims.begin());
    std::ranges::copy(known.forms, match_.forms.begin());
    match_.claim_count = known.claims.size();
    match_.form_count = known.forms.size();
}

/// Only lines of which no computed value decides what they say.
void LineReader::remember(const ControlLine& compiled, const Block& block,
                          MatchedLine& known) const {
    known.is_valid = !compiled.words.words.empty() &&
                     std::ranges::all_of(compiled.computed, [&](const ComputedValue& computed) {
                         if (computed.argument >= 0) return false;
                         const AddressId id = compiled.words.words[computed.word].address;
                         const Address& address = tables_.addresses[id];
                         return address.kind == Address::Kind::Value && address.slot >= 0 &&
                                address.forms.empty() && tables_.code_index[id].empty();
                     });
    if (!known.is_valid) return;
    known.before = modal_;
    known.shape = block;
    known.claims.assign(match_.claims.begin(),
                        match_.claims.begin() + static_cast<std::ptrdiff_t>(match_.claim_count));
    known.forms.assign(match_.forms.begin(),
                       match_.forms.begin() + static_cast<std::ptrdiff_t>(match_.form_count));
}

/// Puts computed values into the words; a word that is vacant is none.
void LineReader::set_values(ControlLine& compiled, std::span<const WordValue> values) {
    LexedLine& lexed = compiled.words;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const ComputedValue& computed = compiled.computed[i];
        const WordValue& value = values[i];
        if (value.kind == WordValue::Kind::Text) lexed.text = value.text;
        if (computed.argument >= 0) {
            GivenArgument& argument = lexed.arguments[static_cast<std::size_t>(computed.argument)];
            argument.kind = value.kind == WordValue::Kind::Text     ? GivenArgument::Kind::Text
                            : value.kind == WordValue::Kind::Vacant ? GivenArgument::Kind::Empty
                                                                    : GivenArgument::Kind::Number;
            argument.number = value.number;
            continue;
        }
        GivenWord& word = lexed.words[computed.word];
        word.is_computed = true;
        word.is_left_out = value.kind == WordValue::Kind::Vacant;
        word.is_text = value.kind == WordValue::Kind::Text;
        word.is_known = value.kind == WordValue::Kind::Number;
        word.number = whole_if_needed(word.address, value.number);
        Decimal& decimal = lexed.decimals[computed.word];
        decimal = {};
        decimal.value = word.number;
        decimal.has_point = true;
        lexed.minus[computed.word] = word.number < 0;
    }
}

/// Codes and addresses that take whole numbers get one: `M[3.5]` is M4.
double LineReader::whole_if_needed(AddressId id, double value) const {
    const Address& address = tables_.addresses[id];
    const bool is_whole = address.kind == Address::Kind::Code
                              ? !has_decimal_codes(id)
                              : address.format.point == PointRule::Never;
    return is_whole ? std::round(value) : value;
}

bool LineReader::has_decimal_codes(AddressId id) const {
    const std::vector<std::uint16_t>& index = tables_.code_index[id];
    for (std::size_t i = 0; i < index.size(); ++i) {
        if (index[i] != 0 && i % 10 != 0) return true;
    }
    return false;
}

int LineReader::value_decimals(const ControlLine& line, std::size_t computed) const {
    const ComputedValue& value = line.computed[computed];
    if (value.argument >= 0) return 0;
    const Address& address = tables_.addresses[line.words.words[value.word].address];
    return text_decimals(address.format, address.dimension, units_);
}

/// A computed value as the control takes it: rounded to the increment of its address, halves away
/// from zero.
double LineReader::rounded(double value, const NumberFormat& format, Dimension dimension) const {
    if (!tables_.language.rules.rounds_values) return value;
    const double power = power_of_ten(text_decimals(format, dimension, units_));
    return std::round(value * power) / power;
}

void LineReader::report_too_long(std::string_view line, std::uint64_t number) {
    begin(number);
    const auto shown = static_cast<std::uint32_t>(std::min<std::size_t>(line.size(), 1));
    report(line.substr(0, 80),
           LineFault{&diag::IsoLineTooLong, {0, shown}, {std::to_string(tables_.rules.max_line)}});
}

/// Gives up on anything that needs a second look; the slow way reads the line again from its start.
bool LineReader::read_fast(std::string_view line, Block& block) const {
    const char* p = line.data();
    const char* const end = p + line.size();
    std::uint32_t groups = 0;
    bool has_word = false;
    const Function motion = modal_[static_cast<std::size_t>(Group::Motion)];
    if (closely_read_[static_cast<std::size_t>(motion)] || tables_.used != nullptr) return false;
    while (p != end && is_blank(*p)) ++p;
    while (p != end) {
        const auto letter = static_cast<unsigned char>(*p);
        if (letter >= 128) return false;
        const FastLetter& fast = letters_[letter];
        ++p;
        std::uint8_t wrong_ends = kGoesOn;
        if (fast.kind == FastLetter::Kind::Slot) {
            if (block.has(fast.slot)) return false;
            const ShortNumber number = fast.is_literal ? read_short_number(p, line) : ShortNumber{};
            double meaning = number.value;
            if (number.end != nullptr) {
                p = number.end;
            } else {
                const Decimal decimal = parse_decimal(p, end);
                if (decimal.end == p) return false;
                const bool is_minus = *p == '-';
                p = decimal.end;
                meaning = read_meaning(decimal, *fast.format, fast.dimension, units_);
                if (check_read(decimal, is_minus, meaning, *fast.format, fast.dimension, units_) !=
                    NumberFault::None)
                    return false;
            }
            const double scale = slot_scales_[static_cast<std::size_t>(fast.dimension)];
            block.set(fast.slot, scale == 1 ? meaning : meaning / scale);
            wrong_ends = kGoesOn | kIsExpression;
        } else if (fast.kind == FastLetter::Kind::Code) {
            const ShortWhole whole = read_short_whole(p, line);
            p = whole.end;
            if (p == nullptr || (p != end && *p == '=')) return false;
            const std::size_t code = whole.value;
            const std::vector<std::uint16_t>& index = tables_.code_index[fast.address];
            if (code * 10 >= index.size() || index[code * 10] == 0) return false;
            const Code& known = tables_.codes[index[code * 10] - 1u];
            if (!known.is_plain) return false;
            const Group group = info(known.function).group;
            const std::uint32_t mask = 1u << static_cast<unsigned>(group);
            // What changes the meaning of numbers, and groups said twice, are looked at closely.
            if (group == Group::Units || group == Group::FeedMode || group == Group::SpeedMode)
                return false;
            if ((groups & mask) != 0) return false;
            groups |= mask;
            if (group == Group::Motion) {
                if (closely_read_[static_cast<std::size_t>(known.function)]) return false;
                block.motion = known.function;
            } else if (!block.add(known.function)) {
                return false;
            }
        } else if (fast.kind == FastLetter::Kind::Number && block.number < 0 && !has_word) {
            const ShortWhole whole = read_short_whole(p, line);
            p = whole.end;
            if (p == nullptr) return false;
            block.number = static_cast<std::int32_t>(whole.value);
            if (block.number > tables_.block_numbers.most ||
                block.number < tables_.block_numbers.least)
                return false;
        } else {
            return false;
        }
        has_word = true;
        if (p == end) return true;
        // A blank may stand inside a number: a digit behind it is no letter that is known.
        std::uint8_t behind = kNumberEnds[static_cast<unsigned char>(*p)];
        if ((behind & wrong_ends) != 0) return false;
        while (behind == kBlank) {
            if (++p == end) return true;
            behind = kNumberEnds[static_cast<unsigned char>(*p)];
        }
    }
    return has_word;
}

/// A line of the control's own language that the dialect knows by its letters.
bool LineReader::read_verbatim(std::string_view line, Block& block) const {
    if (tables_.verbatim_forms.empty()) return false;
    const char* begin = line.data();
    const char* const end = begin + line.size();
    const auto skip_blanks = [&] {
        while (begin != end && is_blank(*begin)) ++begin;
    };
    skip_blanks();
    std::int8_t skip = -1;
    if (begin != end && *begin == '/') {
        ++begin;
        skip = static_cast<std::int8_t>(tables_.rules.default_skip);
        if (begin != end && is_digit(*begin)) skip = static_cast<std::int8_t>(*begin++ - '0');
        skip_blanks();
    }
    std::int32_t number = -1;
    if (begin != end && *begin == 'N') {
        const Decimal decimal = parse_decimal(begin + 1, end);
        if (decimal.end == begin + 1 || decimal.has_point || decimal.value > 99999999) return false;
        number = static_cast<std::int32_t>(decimal.value);
        begin = decimal.end;
    }
    for (const FormId id : tables_.verbatim_forms) {
        const Form& form = tables_.forms[id];
        if (!match_verbatim(form, {begin, end}, block)) continue;
        tables_.note(&form);
        block.number = number;
        block.skip = skip;
        return true;
    }
    return false;
}

/// Fills the block if the text has the letters of the form and numbers between them; blanks do not
/// count.
bool LineReader::match_verbatim(const Form& form, std::string_view text, Block& block) const {
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto skip = [](const char*& p, const char* last) {
        while (p != last && is_blank(*p)) ++p;
    };
    std::array<double, 32> values{};
    std::uint32_t given = 0;
    for (const FormWord& word : form.words) {
        const char* letter = word.text.data();
        const char* const last = letter + word.text.size();
        for (skip(letter, last); letter != last; skip(letter, last)) {
            skip(at, end);
            if (at == end || *at != *letter) return false;
            ++at;
            ++letter;
        }
        if (word.parameter < 0 && !word.is_quantity) continue;
        skip(at, end);
        const Decimal decimal = parse_decimal(at, end);
        if (decimal.end == at) return false;
        at = decimal.end;
        if (word.is_quantity) {
            if (!is_quantity(word, decimal.value, argument_format(tables_), units_)) return false;
            continue;
        }
        const auto parameter = static_cast<std::size_t>(word.parameter);
        const double scale = text_scale(word.dimension, units_, false);
        const double value = (decimal.value / scale - word.offset) / word.factor;
        const bool is_given = (given >> parameter & 1u) != 0;
        if (is_given && value != values[parameter]) return false;
        values[parameter] = value;
        given |= 1u << parameter;
    }
    skip(at, end);
    if (at != end) return false;
    for (const Constraint& c : form.when) {
        const double value = values[static_cast<std::size_t>(c.parameter)];
        if (value < c.least || value > c.most) return false;
    }
    const std::size_t count = tables_.parameters(form).size();
    Invocation* invocation = block.add(form.function, count);
    if (invocation == nullptr) return false;
    for (std::size_t i = 0; i < count; ++i) {
        if ((given >> i & 1u) != 0) block.set_argument(*invocation, i, values[i]);
    }
    for (const auto& [parameter, value] : form.fixed) {
        block.set_argument(*invocation, static_cast<std::size_t>(parameter), value);
    }
    return true;
}

bool LineReader::read_slow(std::string_view line, Block& block) {
    if (read_verbatim(line, block)) return true;
    lexed_ = &own_lexed_;
    if (auto fault = lex_line(tables_, line, own_lexed_)) {
        report(line, *fault);
        return false;
    }
    if (!lexed_->label.empty()) {
        if (lexed_->words.empty()) {
            block.skip = lexed_->skip;
            block.number = lexed_->number;
            block.comment = lexed_->comment;
            block.kind = Block::Kind::Label;
            block.text = lexed_->label;
            return true;
        }
        report(line,
               LineFault{&diag::IsoNotSupported, lexed_->spans[0], {"a label in front of words"}});
        return false;
    }
    return fill(line, block);
}

/// The words of `lexed_` as a block.
bool LineReader::fill(std::string_view line, Block& block, MatchedLine* known,
                      const ControlLine* compiled) {
    block.skip = lexed_->skip;
    block.skip_also = lexed_->skip_also;
    block.number = lexed_->number;
    block.comment = lexed_->comment;
    block.text = lexed_->text;
    if (lexed_->comment_form != kNoForm) {
        tables_.note(&tables_.forms[lexed_->comment_form]);
        block.add(tables_.forms[lexed_->comment_form].function);
    }
    if (lexed_->words.empty()) {
        if (lexed_->has_comment && block.number < 0 && block.skip < 0 &&
            block.function_count == 0) {
            block.kind = Block::Kind::Comment;
        }
        return true;
    }
    if (const auto fault =
            match_words(tables_, lexed_->words, lexed_->arguments, modal_, block, match_)) {
        report(line, *fault);
        return false;
    }
    if (known != nullptr) remember(*compiled, block, *known);
    return apply(block, line);
}

/// Puts the numbers where they belong. The block's own changes of units act in it already.
bool LineReader::apply(Block& block, std::string_view line) {
    for (std::size_t i = 0; i < match_.form_count; ++i) {
        const Form& form = tables_.forms[match_.forms[i]];
        tables_.note(&form);
        if (info(form.function).group == Group::Units) feed_stays_metric_ = form.feed_stays_metric;
        if (form.group >= 0) last_forms_[static_cast<std::size_t>(form.group)] = match_.forms[i];
    }
    const ModalFunctions before = modal_;
    follow_modal(block, modal_);
    follow_units();
    bool is_fine = true;
    for (std::size_t i = 0; i < match_.claim_count && is_fine; ++i) {
        is_fine = apply_claim(match_.claims[i], block, line);
    }
    if (!is_fine) modal_ = before;
    return is_fine;
}

bool LineReader::apply_claim(const Claim& claim, Block& block, std::string_view line) {
    const GivenWord& word = lexed_->words[claim.word];
    Invocation* invocation = claim.is_parameter ? &block.functions[claim.invocation] : nullptr;
    if (claim.dimension == Dimension::Text) return true;
    if (claim.argument >= 0) {
        const double number =
            lexed_->arguments[word.first_argument + static_cast<std::size_t>(claim.argument)]
                .number;
        const double value =
            (number / text_scale(claim.dimension, units_, false) - claim.offset) / claim.factor;
        const double old = claim.adds ? block.argument(*invocation, claim.parameter) : 0;
        block.set_argument(*invocation, claim.parameter, old + value);
        return true;
    }
    if (word.is_text && !word.is_known) return true;  // a name; it stands in the block's text
    if (word.is_text) block.text.clear();
    if (claim.is_named_only) {
        block.set_argument(*invocation, claim.parameter, 0);
        return true;
    }
    const Decimal& decimal = lexed_->decimals[claim.word];
    if (claim.in_increments || claim.tail_digits > 0) return apply_whole(claim, block, line);
    const NumberFormat& own = tables_.addresses[word.address].format;
    std::optional<NumberFormat> lead;
    if (claim.is_lead || (invocation == nullptr && is_pitch(claim, block))) lead = lead_format(own);
    const NumberFormat& format = lead ? *lead : own;
    const double meaning = word.is_computed
                               ? rounded(decimal.value, format, claim.dimension)
                               : read_meaning(decimal, format, claim.dimension, units_);
    Decimal written = decimal;
    if (word.is_computed) written.has_point = format.point != PointRule::Never;
    const bool is_plain = claim.plain_factor > 0 && !decimal.has_point;
    const double factor = is_plain ? claim.plain_factor : claim.factor;
    const NumberFault fault =
        check_read(written, lexed_->minus[claim.word], meaning, format, claim.dimension, units_);
    if (fault != NumberFault::None) {
        const DiagnosticRow& row = fault == NumberFault::Point      ? diag::IsoPointNotAllowed
                                   : fault == NumberFault::Negative ? diag::IsoMinusNotAllowed
                                                                    : diag::IsoTooManyDigits;
        report(line, LineFault{&row, lexed_->spans[claim.word], {word_text(line, claim.word)}});
        return false;
    }
    if (invocation == nullptr) {
        const double scale = text_scale(claim.dimension, units_, true);
        block.set(static_cast<Slot>(claim.place), scale == 1 ? meaning : meaning / scale);
        return true;
    }
    const double scaled = meaning / text_scale(claim.dimension, units_, false);
    block.set_argument(*invocation, claim.parameter, (scaled - claim.offset) / factor);
    return true;
}

/// Whether the word is F of a thread, where F is the pitch.
bool LineReader::is_pitch(const Claim& claim, const Block& block) const {
    if (static_cast<Slot>(claim.place) != Slot::Feed || !feed_is_pitch_) return false;
    const Function modal = modal_[static_cast<std::size_t>(Group::Motion)];
    return (block.motion != Function::None ? block.motion : modal) == Function::Thread;
}

/// A whole number that counts increments, or holds two parameters.
bool LineReader::apply_whole(const Claim& claim, Block& block, std::string_view line) {
    Decimal decimal = lexed_->decimals[claim.word];
    if (lexed_->words[claim.word].is_computed) {
        decimal.value = std::round(decimal.value);
        decimal.has_point = false;
    }
    const DiagnosticRow* fault = decimal.has_point           ? &diag::IsoPointNotAllowed
                                 : lexed_->minus[claim.word] ? &diag::IsoMinusNotAllowed
                                                             : nullptr;
    if (fault != nullptr) {
        report(line, LineFault{fault, lexed_->spans[claim.word], {word_text(line, claim.word)}});
        return false;
    }
    Invocation& invocation = block.functions[claim.invocation];
    if (claim.in_increments) {
        const double size = increment_size(tables_, claim.dimension, units_);
        const double value = decimal.value * size / text_scale(claim.dimension, units_, false);
        block.set_argument(invocation, claim.parameter, round_to(value, 9));
        return true;
    }
    const double front = std::pow(10.0, claim.tail_digits);
    block.set_argument(invocation, claim.parameter, std::floor(decimal.value / front));
    if (claim.tail_parameter >= 0) {
        block.set_argument(invocation, static_cast<std::size_t>(claim.tail_parameter),
                           std::fmod(decimal.value, front));
    }
    return true;
}

// ---------------------------------------------------------------- modal state

void LineReader::follow(const Block& block) {
    if (block.kind != Block::Kind::Nc) return;
    follow_modal(block, modal_);
    if (block.skip < 0) return;
    // Nobody knows here whether the operator lets the block run.
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Group group = info(block.functions[i].function).group;
        const bool scales =
            group == Group::Units || group == Group::FeedMode || group == Group::SpeedMode;
        if (!scales) modal_[static_cast<std::size_t>(group)] = Function::None;
    }
}

void LineReader::restore(const ModalFunctions& wanted, Block& block) {
    for (std::size_t i = 1; i < kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        if (wanted[i] == modal_[i] || wanted[i] == Function::None) continue;
        // The spindle and the coolant run on; offsets come back with the frames.
        const bool is_state = group == Group::Spindle || group == Group::Coolant ||
                              group == Group::WorkOffsets || group == Group::LengthComp ||
                              group == Group::CycleMode || group == Group::SpeedMode;
        if (is_state) continue;
        if (group == Group::Motion) {
            block.motion = wanted[i];
        } else {
            block.add(wanted[i]);
        }
    }
    follow_modal(block, modal_);
    follow_units();
}

void LineReader::follow_units() {
    const auto active = [&](Group group) { return modal_[static_cast<std::size_t>(group)]; };
    units_.inch = active(Group::Units) == Function::Inch;
    units_.inch_feed = units_.inch && !feed_stays_metric_;
    units_.per_revolution = active(Group::FeedMode) == Function::FeedPerRevolution;
    units_.inverse_time = active(Group::FeedMode) == Function::FeedInverseTime;
    units_.cutting_speed = active(Group::SpeedMode) == Function::CuttingSpeedOn;
    for (std::size_t i = 0; i < slot_scales_.size(); ++i)
        slot_scales_[i] = text_scale(static_cast<Dimension>(i), units_, true);
}

// ---------------------------------------------------------------- messages

namespace {

/// Whether codes of the address are the machine builder's as well; the control passes them on.
bool is_for_builder(const DialectTables& tables, AddressId address) {
    const auto& forms = tables.forms_of[static_cast<std::size_t>(Function::MachineFunction)];
    return !forms.empty() && tables.forms[forms[0]].words[0].address == address;
}

bool writes_data(Function function) {
    return function == Function::WorkOffsetData || function == Function::ToolOffsetData;
}

bool is_tool_offset(Function function) {
    return function == Function::LengthOffset || function == Function::LengthCompOn ||
           function == Function::RadiusOffset;
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

}  // namespace

LinePlace LineReader::place(const std::string& file, std::string_view line, std::uint64_t number,
                            const Span& span) {
    constexpr std::size_t kShown = 400;  // bytes of a line that a message keeps
    LinePlace place;
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

void LineReader::report(std::string_view line, const LineFault& fault) {
    note_fault();
    DiagnosticBuilder builder = sink_.report(*fault.row, place(line, line_number_, fault.span));
    for (const std::string& argument : fault.arguments) builder.arg(argument);
    const std::string_view detail =
        fault.arguments.empty() ? std::string_view() : fault.arguments[0];
    if (const auto alarm = dialect_.alarm(*fault.row, detail))
        builder.alarm(alarm->number, alarm->text);
    write_notes(builder);
}

void LineReader::report(std::string_view line, const MatchFault& fault) {
    using Kind = MatchFault::Kind;
    LineFault out;
    if (fault.kind == Kind::Full && lexed_->words.size() > kMaxWords) {
        out = {&diag::IsoTooManyWords, {0, static_cast<std::uint32_t>(line.size())}, {}};
        return report(line, out);
    }
    const std::string word = word_text(line, fault.word);
    const std::string other = word_text(line, fault.other);
    const std::string form = fault.form == kNoForm ? "" : first_line(tables_.forms[fault.form]);
    out.span = lexed_->spans[fault.word];
    switch (fault.kind) {
        case Kind::UnknownCode:
        case Kind::CodeComputed: {
            const std::string known = tables_.unsupported_words(word);
            out.row = known.empty() ? &diag::IsoUnknownCode : &diag::IsoNotSupported;
            out.arguments = {known.empty() ? word : known};
            if (known.empty() && is_for_builder(tables_, lexed_->words[fault.word].address)) {
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
            out.row = &diag::IsoWordsMissing, out.arguments = {word, form};
            if (fault.form != kNoForm && writes_data(tables_.forms[fault.form].function))
                out.row = &diag::OffsetDataFormat;
            break;
        case Kind::Value:
            out.row = &diag::IsoValueWrong, out.arguments = {word, form};
            if (fault.argument >= 0) {
                const Address& call = tables_.addresses[lexed_->words[fault.word].address];
                out.row = &diag::IsoNotSupported;
                out.arguments = {argument_words(*lexed_, fault, call.name)};
            }
            if (fault.form != kNoForm && tables_.forms[fault.form].function == Function::WorkOffset)
                out.row = &diag::WorkOffsetUnknown, out.arguments = {other + ' ' + word};
            if (fault.form != kNoForm && writes_data(tables_.forms[fault.form].function))
                out.row = &diag::OffsetDataNumber, out.arguments = {other + ' ' + word};
            if (fault.form != kNoForm && is_tool_offset(tables_.forms[fault.form].function))
                out.row = &diag::IsoToolOffset, out.arguments = {word};
            break;
        case Kind::Conflict:
            out.row = &diag::IsoWordsConflict, out.arguments = {word, other};
            break;
        case Kind::Unused: out.row = &diag::IsoWordUnused, out.arguments = {word}; break;
        case Kind::Alone: out.row = &diag::IsoAlone, out.arguments = {word}; break;
        case Kind::Company: out.row = &diag::IsoCompany, out.arguments = {word, other}; break;
        case Kind::NotSupported:
            out.row = &diag::IsoNotSupported;
            out.arguments = {'`' + word + "` (" + tables_.forms[fault.form].unsupported + ')'};
            break;
        case Kind::Mode: out.row = &diag::IsoModeMisplaced, out.arguments = {word}; break;
        case Kind::Full: out.row = &diag::IsoTooManyWords; break;
    }
    report(line, out);
}

}  // namespace kadr::nc
