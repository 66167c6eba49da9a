// match.h — words → functions and slots, by the forms of a dialect.
//
// Serves the reader (values are numbers) and the planner of source words (values may be computed
// later). The order of the words in a block does not matter.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "nc/modal_functions.h"
#include "nc/tables.h"

namespace kadr::nc {

inline constexpr std::size_t kMaxWords = 64;
inline constexpr std::size_t kMaxCallArguments = 64;

/// A word as it stands in a block.
struct GivenWord {
    enum class Mode : std::uint8_t {
        Modal,
        Absolute,
        Incremental,
        DiameterAbsolute,
        DiameterIncremental,
        RadiusAbsolute,
        RadiusIncremental,
        Shortest,
        Positive,
        Negative,
        Indexed,  // by the index into a table
    };
    AddressId address = kNoAddress;
    bool has_value = false;
    bool is_known = false;  // the number is known now
    bool is_text = false;   // the value is a text
    bool is_call = false;
    bool is_computed = false;  // the number was worked out by the control's own language
    bool is_left_out = false;  // … and came to nothing: the word does not stand there
    bool names_first = false;  // a word of the spindle that names the first one: `S1=500`
    Mode mode = Mode::Modal;
    std::uint16_t first_argument = 0;  // of a call
    std::uint16_t argument_count = 0;
    double number = 0;
};

struct GivenArgument {
    enum class Kind : std::uint8_t { Empty, Number, Text, Computed, Letter };
    Kind kind = Kind::Empty;        // Computed: a number that is known when the program runs
    AddressId letter = kNoAddress;  // in front of the number, or alone (Kind::Letter)
    double number = 0;
};

/// Where the value of a word belongs.
struct Claim {
    std::uint16_t word = 0;
    std::int16_t argument = -1;  // of a call; -1: the word itself
    bool is_parameter = false;   // false: `index` is a Slot
    std::uint8_t index = 0;      // Slot, or index into Block::arguments
    std::uint8_t invocation = 0;
    std::uint8_t parameter = 0;
    Dimension dimension = Dimension::Number;
    bool adds = false;
    bool is_named_only = false;
    bool is_pitch = false;
    bool in_increments = false;  // the number counts least increments
    int tail_digits = 0;         // that are another parameter, or none
    int tail_parameter = -1;
    bool has_point_tail = false;           // … the digits behind the point
    const NumberFormat* format = nullptr;  // of the form; null: of the word's address
    double factor = 1;                     // number in the text = value · factor + offset
    double plain_factor = 0;               // as factor, of a number without a point; 0: the same
    double offset = 0;
};

/// Why words make no block.
struct MatchFault {
    enum class Kind : std::uint8_t {
        UnknownCode,   // `word`: the address has no such code
        CodeComputed,  // `word`: a code must be a number
        NoValue,       // `word`: an address without value
        NoNumber,      // `word`: a text where a number is expected
        AddressTwice,  // `word` repeats `other`
        GroupTwice,    // `word` and `other` exclude each other
        Missing,       // `word` needs further words, as in `form`
        Value,         // `word` stands in `form` with another value
        Conflict,      // `word` and `other` belong to different forms of one code
        Unused,        // `word` means nothing here
        Alone,         // `word` must stand in a block of its own, without `other` at least
        Company,       // `word` does not stand beside `other`
        NotSupported,  // `word` in `form` is known, and not executed
        Mode,          // `word`: AC(), IC() or the like does not fit here
        Full,          // the block holds too much
    };
    Kind kind;
    std::size_t word = 0;
    std::size_t other = 0;
    FormId form = kNoForm;
    int argument = -1;
};

struct Match {
    std::array<Claim, kMaxWords + kMaxCallArguments> claims;
    std::size_t claim_count = 0;
    std::array<FormId, kMaxInvocations + 1> forms;  // that were used
    std::size_t form_count = 0;
};

/// What the words are: a text, where words of modal cycles may have been programmed before and
/// other cycles' words wait for their turn, or a block of a source, which gives all of its own.
enum class WordsOf : std::uint8_t { Text, Source };

/// Fills the block's functions and motion and tells which word's value goes where. The block is
/// empty before; values of words are the caller's matter.
std::optional<MatchFault> match_words(const DialectTables& tables, std::span<const GivenWord> words,
                                      std::span<const GivenArgument> arguments,
                                      const ModalFunctions& modal, Block& block, Match& match,
                                      WordsOf words_of = WordsOf::Text);

}  // namespace kadr::nc
