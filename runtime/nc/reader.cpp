#include "nc/reader.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstring>

#include "base/diagnostics/iso.h"
#include "base/numbers.h"
#include "base/text.h"
#include "nc/lexer.h"
#include "nc/number_text.h"

namespace kadr::nc {

namespace {

bool is_digit(char c) { return static_cast<unsigned char>(c - '0') <= 9; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// How a letter is treated on the fast way; made once a reader.
struct FastLetter {
    enum class Kind : std::uint8_t { None, Slot, Code, Number };
    Kind kind = Kind::None;
    Slot slot = Slot::X;
    AddressId address = kNoAddress;
    Dimension dimension = Dimension::Number;
    const NumberFormat* format = nullptr;
    bool is_literal = false;  // a number means what it says, and the control takes every one
};

/// Whether no number of the format needs a second look.
bool is_literal(const NumberFormat& format) {
    return format.increment == 0 && format.inch_increment == 0 &&
           format.revolution_increment == 0 && !format.truncates && format.max_digits == 0 &&
           format.point == PointRule::Needed && format.allows_minus;
}

/// A number as nearly all are: `-12.345`, no more than 15 digits, whose value is then the exact
/// quotient of two exact numbers. False: it is another one, and `p` is where it was.
inline bool take_short_number(const char*& p, const char* end, double& value) {
    constexpr std::array<double, 16> kPowersOfTen = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const char* at = p;
    const bool is_negative = at != end && *at == '-';
    if (is_negative) ++at;
    const char* const first = at;
    std::uint64_t mantissa = 0;
    for (; at != end && is_digit(*at); ++at)
        mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
    std::ptrdiff_t digits = at - first;
    std::ptrdiff_t decimals = 0;
    if (at != end && *at == '.') {
        const char* const point = at++;
        for (; at != end && is_digit(*at); ++at)
            mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
        decimals = at - point - 1;
        digits += decimals;
    }
    if (digits == 0 || digits > 15) return false;
    value = static_cast<double>(mantissa) / kPowersOfTen[static_cast<std::size_t>(decimals)];
    if (is_negative) value = -value;
    p = at;
    return true;
}

/// Lines out of pieces of text; a line inside one piece is not copied.
class LineSource {
  public:
    LineSource(TextSource& source, std::size_t longest) : source_(source), longest_(longest) {}

    /// The next line without its end; false at the end of the text. `is_too_long`: only the front
    /// of the line is kept.
    bool next(std::string_view& line, bool& is_too_long) {
        carry_.clear();
        is_too_long = false;
        while (true) {
            if (at_ == piece_.size()) {
                piece_ = source_.next();
                at_ = 0;
                if (piece_.empty()) {
                    if (carry_.empty() && !is_too_long) return false;
                    line = carry_;
                    return true;
                }
            }
            const char* const begin = piece_.data() + at_;
            const auto* end =
                static_cast<const char*>(std::memchr(begin, '\n', piece_.size() - at_));
            const std::size_t length =
                end == nullptr ? piece_.size() - at_ : static_cast<std::size_t>(end - begin);
            at_ += length + (end == nullptr ? 0 : 1);
            if (end != nullptr && carry_.empty() && !is_too_long) {
                is_too_long = length > longest_;
                line = std::string_view(begin, std::min(length, longest_));
                if (!line.empty() && line.back() == '\r' && !is_too_long) line.remove_suffix(1);
                return true;
            }
            const std::size_t room = longest_ - carry_.size();
            if (length > room) is_too_long = true;
            carry_.append(begin, std::min(length, room));
            if (end == nullptr) continue;
            if (!is_too_long && !carry_.empty() && carry_.back() == '\r') carry_.pop_back();
            line = carry_;
            return true;
        }
    }

  private:
    TextSource& source_;
    std::size_t longest_;
    std::string_view piece_;
    std::size_t at_ = 0;
    std::string carry_;
};

}  // namespace

struct Reader::State {
    State(const Dialect& dialect_, TextSource& text, std::string name_, DiagnosticSink& sink_)
        : dialect(dialect_),
          tables(dialect_.tables()),
          source(text, tables.rules.max_line),
          name(std::move(name_)),
          sink(sink_) {
        for (std::size_t letter = 0; letter < letters.size(); ++letter) prepare(letter);
        modal = tables.power_on;
        modal[static_cast<std::size_t>(Group::Motion)] = Function::None;
        follow_units();
    }

    /// Where a block of the latest batch stood.
    struct Kept {
        std::uint32_t line = 0;
        std::uint32_t offset = 0;
        std::uint32_t length = 0;
    };

    const Dialect& dialect;
    const DialectTables& tables;
    LineSource source;
    std::string name;
    DiagnosticSink& sink;
    std::array<FastLetter, 128> letters;
    ModalFunctions modal{};
    std::bitset<kFunctions> closely_read;  // motions under which words have other meanings
    TextUnits units;
    std::array<double, static_cast<std::size_t>(Dimension::Text) + 1> slot_scales{};
    bool feed_stays_metric = false;
    std::uint64_t line_number = 0;
    bool failed = false;
    std::uint64_t first_fault = 0;
    bool has_content = false;
    bool has_ended = false;
    LexedLine lexed;
    Match match;
    std::vector<Kept> kept;
    std::string kept_text;

    /// Whether a word of the address means its slot but under certain motions, which are noted.
    bool are_of_motions(const Address& address) {
        for (const FormId id : address.forms) {
            const std::vector<Function>& during = tables.forms[id].during;
            const bool is_of_motion = during.size() == 1 && info(during[0]).group == Group::Motion;
            if (!is_of_motion) return false;
            closely_read.set(static_cast<std::size_t>(during[0]));
        }
        return true;
    }
    void prepare(std::size_t letter) {
        const AddressId id = tables.letters[letter];
        FastLetter& fast = letters[letter];
        if (id != kNoAddress) {
            const Address& address = tables.addresses[id];
            fast.address = id;
            fast.format = &address.format;
            fast.dimension = address.dimension;
            fast.is_literal = is_literal(address.format);
            if (address.is_block_number) {
                fast.kind = FastLetter::Kind::Number;
            } else if (address.kind == Address::Kind::Code) {
                fast.kind = FastLetter::Kind::Code;
            } else if (address.slot >= 0 && !address.is_incremental && are_of_motions(address) &&
                       tables.code_index[id].empty()) {
                fast.kind = FastLetter::Kind::Slot;
                fast.slot = static_cast<Slot>(address.slot);
            }
        }
        if (letter >= 'A' && letter <= 'Z' && tables.rules.ignores_case)
            letters[letter + 32] = fast;
    }

    bool read(std::string_view line, Block& block);
    bool read_fast(std::string_view line, Block& block) const;
    bool read_slow(std::string_view line, Block& block);
    bool read_verbatim(std::string_view line, Block& block) const;
    bool match_verbatim(const Form& form, std::string_view text, Block& block) const;
    bool apply(Block& block, std::string_view line);
    bool apply_claim(const Claim& claim, Block& block, std::string_view line);
    bool apply_whole(const Claim& claim, Block& block, std::string_view line);
    /// What a line is before its words are looked at.
    enum class LineKind : std::uint8_t { Nothing, Words, Misplaced };
    LineKind kind_of(std::string_view line);
    void follow(const Block& block);
    void follow_units();
    void note_fault() {
        failed = true;
        if (first_fault == 0) first_fault = line_number;
    }
    void report(std::string_view line, const LineFault& fault);
    void report(std::string_view line, const MatchFault& fault);
    LinePlace place(std::string_view line, std::uint64_t number, const Span& span) const;
    std::string word_text(std::string_view line, std::size_t word) const;
    const Kept* find(const Block& block) const;
};

// ---------------------------------------------------------------- lines

Reader::State::LineKind Reader::State::kind_of(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    if (line.empty()) return LineKind::Nothing;
    const std::vector<std::string>& ends = tables.program.end;
    if (has_content && std::ranges::find(ends, line) != ends.end()) has_ended = true;
    if (has_ended) return LineKind::Nothing;
    const bool is_header = std::ranges::any_of(
        tables.program.skipped, [&](const std::string& front) { return line.starts_with(front); });
    if (!is_header) return LineKind::Words;
    if (!has_content) return LineKind::Nothing;
    // Where a mark ends the text, another program may begin before it.
    has_ended = !ends.empty();
    return has_ended ? LineKind::Nothing : LineKind::Misplaced;
}

/// False: the line makes no block.
bool Reader::State::read(std::string_view line, Block& block) {
    if (read_fast(line, block)) {
        has_content = true;
        // Later forms depend on modal functions: G68 on its plane, G53 on absolute dimensions.
        if (block.function_count != 0) follow_modal(block, modal);
        return true;
    }
    block.reset();
    const LineKind kind = kind_of(line);
    if (kind == LineKind::Nothing) return false;
    if (kind == LineKind::Misplaced) {
        const std::size_t begin = line.find_first_not_of(" \t");
        const auto at = static_cast<std::uint32_t>(begin);
        report(line, LineFault{&diag::IsoSyntax, {at, at + 1}, {std::string(1, line[begin])}});
        return false;
    }
    if (read_slow(line, block)) {
        has_content |= block.kind != Block::Kind::Comment;
        follow(block);
        return true;
    }
    note_fault();
    return false;
}

/// Plain codes and numbers behind letters: nearly every block. Gives up, without a word, on
/// anything that needs a second look; the slow way reads the line again from its start.
bool Reader::State::read_fast(std::string_view line, Block& block) const {
    const char* p = line.data();
    const char* const end = p + line.size();
    std::uint32_t groups = 0;
    bool has_word = false;
    const Function motion = modal[static_cast<std::size_t>(Group::Motion)];
    if (closely_read[static_cast<std::size_t>(motion)]) return false;
    while (true) {
        while (p != end && is_blank(*p)) ++p;
        if (p == end) return has_word;
        const auto letter = static_cast<unsigned char>(*p);
        if (letter >= 128) return false;
        const FastLetter& fast = letters[letter];
        ++p;
        if (fast.kind == FastLetter::Kind::Slot) {
            if (block.has(fast.slot)) return false;
            double meaning = 0;
            if (!fast.is_literal || !take_short_number(p, end, meaning)) {
                const Decimal decimal = parse_decimal(p, end);
                if (decimal.end == p) return false;
                const bool is_minus = *p == '-';
                p = decimal.end;
                meaning = read_meaning(decimal, *fast.format, fast.dimension, units);
                if (check_read(decimal, is_minus, meaning, *fast.format, fast.dimension, units) !=
                    NumberFault::None)
                    return false;
            }
            if (p != end && (*p == '=' || *p == 'E' || *p == 'e' || *p == '#' || *p == '['))
                return false;
            const double scale = slot_scales[static_cast<std::size_t>(fast.dimension)];
            block.set(fast.slot, scale == 1 ? meaning : meaning / scale);
        } else if (fast.kind == FastLetter::Kind::Code) {
            std::size_t code = 0;
            const char* const digits = p;
            while (p != end && is_digit(*p) && p - digits < 4)
                code = code * 10 + static_cast<std::size_t>(*p++ - '0');
            if (p == digits || (p != end && (*p == '.' || *p == '=' || is_digit(*p)))) return false;
            const std::vector<std::uint16_t>& index = tables.code_index[fast.address];
            if (code * 10 >= index.size() || index[code * 10] == 0) return false;
            const Code& known = tables.codes[index[code * 10] - 1u];
            if (!known.is_plain) return false;
            const Group group = info(known.function).group;
            const std::uint32_t mask = 1u << static_cast<unsigned>(group);
            // What changes the meaning of numbers, and groups said twice, are looked at closely.
            if (group == Group::Units || group == Group::FeedMode || group == Group::SpeedMode)
                return false;
            if ((groups & mask) != 0) return false;
            groups |= mask;
            if (group == Group::Motion) {
                block.motion = known.function;
            } else if (!block.add(known.function)) {
                return false;
            }
        } else if (fast.kind == FastLetter::Kind::Number && block.number < 0 && !has_word) {
            std::int32_t number = 0;
            const char* const digits = p;
            while (p != end && is_digit(*p) && p - digits < 8) number = number * 10 + (*p++ - '0');
            if (p == digits || (p != end && is_digit(*p)) || number > tables.block_numbers.most)
                return false;
            block.number = number;
        } else {
            return false;
        }
        // A blank may stand inside a number, or a name begin with a known letter.
        if (p != end && (is_digit(*p) || *p == '.')) return false;
        if (tables.rules.blanks_inside_words && p != end && is_blank(*p)) {
            const char* next = p;
            while (next != end && is_blank(*next)) ++next;
            if (next != end && (is_digit(*next) || *next == '.')) return false;
        }
        has_word = true;
    }
}

/// A line of the control's own language that the dialect knows by its letters.
bool Reader::State::read_verbatim(std::string_view line, Block& block) const {
    if (tables.verbatim_forms.empty()) return false;
    const char* begin = line.data();
    const char* const end = begin + line.size();
    const auto skip_blanks = [&] {
        while (begin != end && is_blank(*begin)) ++begin;
    };
    skip_blanks();
    std::int8_t skip = -1;
    if (begin != end && *begin == '/') {
        ++begin;
        skip = static_cast<std::int8_t>(tables.rules.default_skip);
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
    for (const FormId id : tables.verbatim_forms) {
        const Form& form = tables.forms[id];
        if (!match_verbatim(form, {begin, end}, block)) continue;
        block.number = number;
        block.skip = skip;
        return true;
    }
    return false;
}

/// Fills the block if the text has the letters of the form and numbers between them; blanks do not
/// count.
bool Reader::State::match_verbatim(const Form& form, std::string_view text, Block& block) const {
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
            if (!is_quantity(word, decimal.value, argument_format(tables), units)) return false;
            continue;
        }
        const auto parameter = static_cast<std::size_t>(word.parameter);
        const double scale = text_scale(word.dimension, units, false);
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
    const std::size_t count = tables.parameters(form).size();
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

bool Reader::State::read_slow(std::string_view line, Block& block) {
    if (read_verbatim(line, block)) return true;
    if (auto fault = lex_line(tables, line, lexed)) {
        report(line, *fault);
        return false;
    }
    block.skip = lexed.skip;
    block.number = lexed.number;
    block.comment = lexed.comment;
    block.text = lexed.text;
    if (!lexed.label.empty()) {
        if (lexed.words.empty()) {
            block.kind = Block::Kind::Label;
            block.text = lexed.label;
            return true;
        }
        report(line,
               LineFault{&diag::IsoNotSupported, lexed.spans[0], {"a label in front of words"}});
        return false;
    }
    if (lexed.comment_form != kNoForm) block.add(tables.forms[lexed.comment_form].function);
    if (lexed.words.empty()) {
        if (lexed.has_comment && block.number < 0 && block.skip < 0 && block.function_count == 0) {
            block.kind = Block::Kind::Comment;
        }
        return true;
    }
    if (const auto fault = match_words(tables, lexed.words, lexed.arguments, modal, block, match)) {
        report(line, *fault);
        return false;
    }
    return apply(block, line);
}

/// Puts the numbers where they belong. The block's own changes of units act in it already.
bool Reader::State::apply(Block& block, std::string_view line) {
    for (std::size_t i = 0; i < match.form_count; ++i) {
        const Form& form = tables.forms[match.forms[i]];
        if (info(form.function).group == Group::Units) feed_stays_metric = form.feed_stays_metric;
    }
    const ModalFunctions before = modal;
    follow_modal(block, modal);
    follow_units();
    bool is_fine = true;
    for (std::size_t i = 0; i < match.claim_count && is_fine; ++i) {
        is_fine = apply_claim(match.claims[i], block, line);
    }
    if (!is_fine) modal = before;
    return is_fine;
}

bool Reader::State::apply_claim(const Claim& claim, Block& block, std::string_view line) {
    const GivenWord& word = lexed.words[claim.word];
    Invocation* invocation = claim.is_parameter ? &block.functions[claim.invocation] : nullptr;
    if (claim.dimension == Dimension::Text) return true;
    if (claim.argument >= 0) {
        const double number =
            lexed.arguments[word.first_argument + static_cast<std::size_t>(claim.argument)].number;
        const double value =
            (number / text_scale(claim.dimension, units, false) - claim.offset) / claim.factor;
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
    const Decimal& decimal = lexed.decimals[claim.word];
    if (claim.in_increments || claim.tail_digits > 0) return apply_whole(claim, block, line);
    const NumberFormat& own = tables.addresses[word.address].format;
    NumberFormat lead;
    if (claim.is_lead) lead = lead_format(own);
    const NumberFormat& format = claim.is_lead ? lead : own;
    const double meaning = read_meaning(decimal, format, claim.dimension, units);
    const NumberFault fault =
        check_read(decimal, lexed.minus[claim.word], meaning, format, claim.dimension, units);
    if (fault != NumberFault::None) {
        const DiagnosticRow& row = fault == NumberFault::Point      ? diag::IsoPointNotAllowed
                                   : fault == NumberFault::Negative ? diag::IsoMinusNotAllowed
                                                                    : diag::IsoTooManyDigits;
        report(line, LineFault{&row, lexed.spans[claim.word], {word_text(line, claim.word)}});
        return false;
    }
    if (invocation == nullptr) {
        const double scale = text_scale(claim.dimension, units, true);
        block.set(static_cast<Slot>(claim.place), scale == 1 ? meaning : meaning / scale);
        return true;
    }
    const double scaled = meaning / text_scale(claim.dimension, units, false);
    block.set_argument(*invocation, claim.parameter, (scaled - claim.offset) / claim.factor);
    return true;
}

/// A whole number that counts increments, or holds two parameters.
bool Reader::State::apply_whole(const Claim& claim, Block& block, std::string_view line) {
    const Decimal& decimal = lexed.decimals[claim.word];
    const DiagnosticRow* fault = decimal.has_point         ? &diag::IsoPointNotAllowed
                                 : lexed.minus[claim.word] ? &diag::IsoMinusNotAllowed
                                                           : nullptr;
    if (fault != nullptr) {
        report(line, LineFault{fault, lexed.spans[claim.word], {word_text(line, claim.word)}});
        return false;
    }
    Invocation& invocation = block.functions[claim.invocation];
    if (claim.in_increments) {
        const double size = increment_size(tables, claim.dimension, units);
        const double value = decimal.value * size / text_scale(claim.dimension, units, false);
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

void Reader::State::follow(const Block& block) {
    if (block.kind != Block::Kind::Nc) return;
    follow_modal(block, modal);
    if (block.skip < 0) return;
    // Nobody knows here whether the operator lets the block run.
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Group group = info(block.functions[i].function).group;
        const bool scales =
            group == Group::Units || group == Group::FeedMode || group == Group::SpeedMode;
        if (!scales) modal[static_cast<std::size_t>(group)] = Function::None;
    }
}

void Reader::State::follow_units() {
    const auto active = [&](Group group) { return modal[static_cast<std::size_t>(group)]; };
    units.inch = active(Group::Units) == Function::Inch;
    units.inch_feed = units.inch && !feed_stays_metric;
    units.per_revolution = active(Group::FeedMode) == Function::FeedPerRevolution;
    units.inverse_time = active(Group::FeedMode) == Function::FeedInverseTime;
    units.cutting_speed = active(Group::SpeedMode) == Function::CuttingSpeedOn;
    for (std::size_t i = 0; i < slot_scales.size(); ++i)
        slot_scales[i] = text_scale(static_cast<Dimension>(i), units, true);
}

// ---------------------------------------------------------------- messages

LinePlace Reader::State::place(std::string_view line, std::uint64_t number,
                               const Span& span) const {
    constexpr std::size_t kShown = 400;  // bytes of a line that a message keeps
    LinePlace place;
    place.file = name;
    place.line = static_cast<std::uint32_t>(number);
    const std::size_t begin = std::min<std::size_t>(span.begin, line.size());
    const std::size_t end = std::clamp<std::size_t>(span.end, begin, line.size());
    place.column = static_cast<std::uint32_t>(count_code_points(line.substr(0, begin)) + 1);
    place.length = static_cast<std::uint32_t>(
        std::max<std::size_t>(1, count_code_points(line.substr(begin, end - begin))));
    place.text = line.substr(0, std::max(kShown, std::min(end, line.size())));
    return place;
}

std::string Reader::State::word_text(std::string_view line, std::size_t word) const {
    const Span& span = lexed.spans[word];
    return std::string(line.substr(span.begin, span.end - span.begin));
}

void Reader::State::report(std::string_view line, const LineFault& fault) {
    note_fault();
    DiagnosticBuilder builder = sink.report(*fault.row, place(line, line_number, fault.span));
    for (const std::string& argument : fault.arguments) builder.arg(argument);
    if (const auto alarm = dialect.alarm(*fault.row)) builder.alarm(alarm->number, alarm->text);
}

void Reader::State::report(std::string_view line, const MatchFault& fault) {
    using Kind = MatchFault::Kind;
    LineFault out;
    if (fault.kind == Kind::Full && lexed.words.size() > kMaxWords) {
        out = {&diag::IsoTooManyWords, {0, static_cast<std::uint32_t>(line.size())}, {}};
        return report(line, out);
    }
    const std::string word = word_text(line, fault.word);
    const std::string other = word_text(line, fault.other);
    const std::string form = fault.form == kNoForm ? "" : first_line(tables.forms[fault.form]);
    out.span = lexed.spans[fault.word];
    switch (fault.kind) {
        case Kind::UnknownCode:
        case Kind::CodeComputed: {
            const std::string known = tables.unsupported_words(word);
            out.row = known.empty() ? &diag::IsoUnknownCode : &diag::IsoNotSupported;
            out.arguments = {known.empty() ? word : known};
            break;
        }
        case Kind::NoValue:
        case Kind::NoNumber: out.row = &diag::IsoNoValue, out.arguments = {word}; break;
        case Kind::AddressTwice:
            out.row = &diag::IsoAddressTwice;
            out.arguments = {tables.addresses[lexed.words[fault.word].address].name};
            break;
        case Kind::GroupTwice: out.row = &diag::IsoGroupTwice, out.arguments = {word, other}; break;
        case Kind::Missing: out.row = &diag::IsoWordsMissing, out.arguments = {word, form}; break;
        case Kind::Value:
            out.row = &diag::IsoValueWrong, out.arguments = {word, form};
            if (fault.form != kNoForm && tables.forms[fault.form].function == Function::WorkOffset)
                out.row = &diag::WorkOffsetUnknown, out.arguments = {other + ' ' + word};
            break;
        case Kind::Conflict:
            out.row = &diag::IsoWordsConflict, out.arguments = {word, other};
            break;
        case Kind::Unused: out.row = &diag::IsoWordUnused, out.arguments = {word}; break;
        case Kind::Alone: out.row = &diag::IsoAlone, out.arguments = {word}; break;
        case Kind::Mode: out.row = &diag::IsoModeMisplaced, out.arguments = {word}; break;
        case Kind::Full: out.row = &diag::IsoTooManyWords; break;
    }
    report(line, out);
}

// ---------------------------------------------------------------- the reader

Reader::Reader(const Dialect& dialect, TextSource& text, std::string name, DiagnosticSink& sink)
    : state_(std::make_unique<State>(dialect, text, std::move(name), sink)) {}
Reader::~Reader() = default;

std::size_t Reader::pull(std::span<Block> out) {
    State& s = *state_;
    s.kept.clear();
    s.kept_text.clear();
    std::size_t count = 0;
    std::string_view line;
    bool is_too_long = false;
    while (count < out.size() && !s.has_ended && s.source.next(line, is_too_long)) {
        ++s.line_number;
        if (is_too_long) {
            const auto shown = static_cast<std::uint32_t>(std::min<std::size_t>(line.size(), 1));
            s.report(line.substr(0, 80), LineFault{&diag::IsoLineTooLong,
                                                   {0, shown},
                                                   {std::to_string(s.tables.rules.max_line)}});
            continue;
        }
        Block& block = out[count];
        block.reset();
        if (!s.read(line, block)) continue;
        block.line = static_cast<std::uint32_t>(s.line_number);
        s.kept.push_back({block.line, static_cast<std::uint32_t>(s.kept_text.size()),
                          static_cast<std::uint32_t>(line.size())});
        s.kept_text += line;
        ++count;
    }
    return count;
}

bool Reader::failed() const { return state_->failed; }
std::uint64_t Reader::lines() const { return state_->line_number; }
std::uint64_t Reader::first_fault() const { return state_->first_fault; }

const Reader::State::Kept* Reader::State::find(const Block& block) const {
    const auto found =
        std::lower_bound(kept.begin(), kept.end(), block.line,
                         [](const Kept& k, std::uint32_t line) { return k.line < line; });
    return found != kept.end() && found->line == block.line ? &*found : nullptr;
}

namespace {

/// The word of the line that `is_wanted` accepts; else the first word, else the whole line.
template <typename IsWanted>
Span find_word(const DialectTables& tables, std::string_view line, IsWanted is_wanted) {
    LexedLine lexed;
    (void)lex_line(tables, line, lexed);
    for (std::size_t i = 0; i < lexed.words.size(); ++i) {
        if (is_wanted(lexed.words[i])) return lexed.spans[i];
    }
    if (!lexed.spans.empty()) return lexed.spans[0];
    return {0, static_cast<std::uint32_t>(line.size())};
}

}  // namespace

LinePlace Reader::place(const Block& block) const {
    const auto* kept = state_->find(block);
    if (kept == nullptr) return state_->place({}, block.line, {});
    const std::string_view line =
        std::string_view(state_->kept_text).substr(kept->offset, kept->length);
    return state_->place(line, block.line,
                         find_word(state_->tables, line, [](const GivenWord&) { return true; }));
}

LinePlace Reader::place(const Block& block, Slot slot) const {
    const auto* kept = state_->find(block);
    if (kept == nullptr) return state_->place({}, block.line, {});
    const DialectTables& tables = state_->tables;
    const std::string_view line =
        std::string_view(state_->kept_text).substr(kept->offset, kept->length);
    const auto sets = [&](const GivenWord& word) {
        return tables.addresses[word.address].slot == static_cast<int>(slot);
    };
    return state_->place(line, block.line, find_word(tables, line, sets));
}

LinePlace Reader::place(const Block& block, Function function) const {
    const auto* kept = state_->find(block);
    if (kept == nullptr) return state_->place({}, block.line, {});
    const DialectTables& tables = state_->tables;
    const std::string_view line =
        std::string_view(state_->kept_text).substr(kept->offset, kept->length);
    const auto says = [&](const GivenWord& word) {
        const Address& head = tables.addresses[word.address];
        const Code* code = word.is_known ? tables.find_code(word.address, word.number) : nullptr;
        const std::vector<FormId>& forms = code != nullptr ? code->forms : head.forms;
        return std::ranges::any_of(
            forms, [&](FormId id) { return tables.forms[id].function == function; });
    };
    return state_->place(line, block.line, find_word(tables, line, says));
}

}  // namespace kadr::nc
