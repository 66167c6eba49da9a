#include "nc/plain_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers.h"
#include "base/powers.h"
#include "base/short_number.h"
#include "nc/letters.h"

namespace kadr::nc {

namespace {

/// What a byte behind the digits of a number tells about it.
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

}  // namespace

PlainLines::PlainLines(const DialectTables& tables, const ReadingModes& modes, PointWatch& points)
    : tables_(tables), modes_(modes), points_(points) {
    for (std::size_t letter = 0; letter < letters_.size(); ++letter) prepare_letter(letter);
    prepare_names();
    if (!modes.is_feed_pitch()) return;
    for (const FunctionInfo& thread : all_functions()) {
        if (has_fact(thread.function, Fact::Pitch) && !is_tapping(thread.function))
            closely_read_.set(static_cast<std::size_t>(thread.function));
    }
}

/// Whether a word of the address means its slot but under certain motions and length
/// compensations, which are noted.
bool PlainLines::are_of_motions(const Address& address) {
    for (const FormId id : address.forms) {
        const std::vector<Function>& during = tables_.forms[id].during;
        const Group group = during.size() == 1 ? info(during[0]).group : Group::NonModal;
        if (group != Group::Motion && group != Group::LengthComp) return false;
        closely_read_.set(static_cast<std::size_t>(during[0]));
    }
    return true;
}

/// What a word of the address is on a plain line.
PlainLines::PlainWord PlainLines::word_of(AddressId id) {
    const Address& address = tables_.addresses[id];
    PlainWord word;
    word.address = id;
    word.format = &address.format;
    word.dimension = address.dimension;
    word.is_literal = is_literal(address.format);
    word.is_position = address.slot >= 0 && nc::is_position(static_cast<Slot>(address.slot)) &&
                       counts_increments(address);
    if (address.is_block_number) {
        word.kind = PlainWord::Kind::Number;
    } else if (address.kind == Address::Kind::Code) {
        word.kind = PlainWord::Kind::Code;
    } else if (address.slot >= 0 && !address.is_incremental && !address.is_coordinate &&
               are_of_motions(address) && tables_.code_index[id].empty()) {
        word.kind = PlainWord::Kind::Slot;
        word.slot = static_cast<Slot>(address.slot);
    }
    return word;
}

void PlainLines::prepare_letter(std::size_t letter) {
    const AddressId id = tables_.letters[letter];
    PlainWord& word = letters_[letter];
    // Any number of it calls a program: `S{n}`.
    const bool calls =
        std::ranges::any_of(tables_.language.calls.calls, [letter](const CallForm& call) {
            return call.any_number && static_cast<unsigned char>(call.letter) == letter;
        });
    if (id != kNoAddress && !calls) word = word_of(id);
    if (letter >= 'A' && letter <= 'Z' && tables_.notation.ignores_case)
        letters_[letter + 32] = word;
}

/// Words of several letters with a value behind `=`.
void PlainLines::prepare_names() {
    if (!tables_.has_names || !tables_.notation.has_assignment) return;
    const auto is_large = [](char c) { return c >= 'A' && c <= 'Z'; };
    for (std::size_t i = 0; i < tables_.addresses.size(); ++i) {
        const std::string_view name = tables_.addresses[i].name;
        if (name.size() < 2 || !std::ranges::all_of(name, is_large)) continue;
        const PlainWord word = word_of(static_cast<AddressId>(i));
        if (word.kind == PlainWord::Kind::Slot && word.is_literal) names_.push_back({name, word});
    }
    std::ranges::sort(names_, {}, &PlainName::name);
}

/// The word of several letters that begins in front of `p`, which is led behind its `=`.
const PlainLines::PlainWord* PlainLines::named_word(const char*& p, const char* end) const {
    constexpr std::size_t kLongest = 8;
    std::array<char, kLongest> letters;
    std::size_t length = 0;
    for (const char* at = p - 1; at != end && length < kLongest; ++at, ++length) {
        const char c = *at;
        if (c == '=') {
            const std::string_view name(letters.data(), length);
            const auto found = std::ranges::lower_bound(names_, name, {}, &PlainName::name);
            if (found == names_.end() || found->name != name) return nullptr;
            p = at + 1;
            return &found->word;
        }
        const bool is_small = c >= 'a' && c <= 'z' && tables_.notation.ignores_case;
        letters[length] = is_small ? static_cast<char>(c - 32) : c;
    }
    return nullptr;
}

bool PlainLines::read(std::string_view line, Block& block) const {
    const char* p = line.data();
    const char* const end = p + line.size();
    std::uint32_t groups = 0;
    bool has_word = false;
    const TextUnits& units = modes_.units();
    block.has_inch_feed = units.inch_feed;
    const auto motion = static_cast<std::size_t>(modes_.active(Group::Motion));
    const auto length = static_cast<std::size_t>(modes_.active(Group::LengthComp));
    if (closely_read_[motion] || closely_read_[length] || tables_.used != nullptr ||
        modes_.may_be_feed_time())
        return false;
    while (p != end && is_blank(*p)) ++p;
    while (p != end) {
        const auto letter = static_cast<unsigned char>(*p);
        if (letter >= 128) return false;
        const PlainWord* word = &letters_[letter];
        ++p;
        if (p != end && *p == '=') {
            // `X=10` means what `X10` means.
            const bool is_value = word->kind == PlainWord::Kind::Slot && word->is_literal;
            if (!is_value || !tables_.notation.has_assignment) return false;
            ++p;
        } else if (p != end && is_letter(*p)) {
            word = named_word(p, end);
            if (word == nullptr) return false;
        }
        const PlainWord& fast = *word;
        std::uint8_t wrong_ends = kGoesOn;
        if (fast.kind == PlainWord::Kind::Slot) {
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
                if (fast.is_position) {
                    if (!decimal.has_point && points_.is_open() && decimal.value != 0) return false;
                    if (decimal.has_point) points_.note_point();
                }
                meaning = read_meaning(decimal, *fast.format, fast.dimension, units);
                if (check_read(decimal, is_minus, meaning, *fast.format, fast.dimension, units) !=
                    NumberFault::None)
                    return false;
            }
            const double scale = modes_.slot_scale(fast.dimension);
            block.set(fast.slot, scale == 1 ? meaning : meaning / scale);
            wrong_ends = kGoesOn | kIsExpression;
        } else if (fast.kind == PlainWord::Kind::Code) {
            const ShortWhole whole = read_short_whole(p, line);
            p = whole.end;
            if (p == nullptr || (p != end && *p == '=')) return false;
            const std::size_t code = whole.value;
            const std::vector<std::uint16_t>& index = tables_.code_index[fast.address];
            if (code * 10 >= index.size() || index[code * 10] == 0) return false;
            const CodeStart& known = tables_.codes[index[code * 10] - 1u];
            if (!known.is_plain) return false;
            const Group group = info(known.function).group;
            const std::uint32_t mask = 1u << static_cast<unsigned>(group);
            // What changes the meaning of numbers, and groups given twice, are looked at closely.
            if (group == Group::Units || group == Group::FeedMode || group == Group::SpeedMode)
                return false;
            if ((groups & mask) != 0) return false;
            groups |= mask;
            if (group == Group::LengthComp &&
                closely_read_[static_cast<std::size_t>(known.function)])
                return false;
            if (group == Group::Motion) {
                if (closely_read_[static_cast<std::size_t>(known.function)]) return false;
                block.motion = known.function;
            } else if (!block.add(known.function)) {
                return false;
            }
        } else if (fast.kind == PlainWord::Kind::Number && block.number < 0 && !has_word) {
            const ShortWhole whole = read_short_whole(p, line);
            p = whole.end;
            if (p == nullptr) return false;
            block.number = static_cast<std::int32_t>(whole.value);
            if (block.number > tables_.block_numbers.most ||
                block.number < tables_.block_numbers.least)
                return false;
            // A number alone is no block: it goes the long path, which finds what it is.
            while (p != end && is_blank(*p)) ++p;
            if (p == end) return false;
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

}  // namespace kadr::nc
