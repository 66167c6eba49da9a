// tables.h — a dialect compiled: what the writer, the reader and the planner of source words share.
//
// An Address is the head of a word: a letter or name that takes a value (`X10`, `CR=5`), a code
// whose number selects a function (`G1`, `M8`), a word by itself (`TRANS`) or a call (`MSG("…")`).
// A Form is a pattern of such words that spells one function; the same form is written and read.
// For the rooms of nc only.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "nc/dialect.h"
#include "nc/language.h"

namespace kadr::nc {

enum class PointRule : std::uint8_t {
    Needed,  // `X10`, `X10.5`
    Always,  // `X10.`, `X10.5`
    Never,   // whole numbers only
};

/// How the number of an address is written and what it means when it is read.
struct NumberFormat {
    int decimals = 3;             // written, metric
    int inch_decimals = 4;        // written for lengths and feeds while lengths are inches
    int lead_decimals = -1;       // of the pitch of a thread; -1: as other numbers
    int inch_lead_decimals = -1;  // the same in inches
    int frame_decimals = -1;      // of a length that shifts, turns or scales the frame
    PointRule point = PointRule::Needed;
    int digits = 1;        // least digits of a whole number: 2 gives `T03`
    int max_digits = 0;    // most digits after the value is in increments; 0: no limit
    double increment = 0;  // what 1 means without a point; 0: as it stands
    double inch_increment = 0;
    double revolution_increment = 0;  // the same for a feed per revolution; 0: as `increment`
    bool truncates = false;           // digits beyond `decimals` are dropped when read
    bool allows_minus = true;
    bool writes_plus = false;  // `X+10`
};

using AddressId = std::uint16_t;
inline constexpr AddressId kNoAddress = 0xffff;
using FormId = std::uint16_t;
inline constexpr FormId kNoForm = 0xffff;

struct Address {
    enum class Kind : std::uint8_t { Value, Code, Word, Call };
    std::string name;
    std::string doc;
    Kind kind = Kind::Value;
    int order = 50;  // position of its words in a block, lowest first
    int slot = -1;   // Slot that a word sets by itself; -1 none
    Dimension dimension = Dimension::Number;
    std::uint8_t write_max = 1;  // words of it in a block: written
    std::uint8_t read_max = 1;   // … and read
    bool is_block_number = false;
    bool is_incremental = false;  // its words are distances: U on a lathe is a distance along X
    bool is_coordinate = false;   // of a centre: counts as the axis words do, not from the start
    bool is_word_too = false;     // of a call: it also stands by itself, without brackets
    NumberFormat format;
    std::vector<FormId> forms;  // that begin with it, any value (Value, Word, Call)
};

/// What a code (`G1`) can begin.
struct CodeStart {
    FormId simple = kNoForm;             // the form that is this one word and needs no other
    Function function = Function::None;  // of `simple`, if it sets nothing else: for plain lines
    bool is_plain = false;               // nothing but `function` has to be looked at
    std::vector<FormId> forms;           // all of them
};

/// One word of a form, or one argument of a call.
struct FormWord {
    enum class Kind : std::uint8_t {
        Fixed,   // address and number: `G04`, `X0`
        Name,    // a word by itself: `TRANS`
        Value,   // address and parameter: `P{time:ms}`
        Quoted,  // address and parameter between quotes: `T="{tool}"`
        Call,    // name and arguments in parentheses
        Empty,   // an argument that is left out
        Text,    // an argument between quotes: `"{text}"`
        Rest,    // `{...}`: whatever arguments follow; read only
    };
    Kind kind = Kind::Fixed;
    AddressId address = kNoAddress;
    std::string text;   // written as it stands (Fixed, Name), or what stands before the value
    double number = 0;  // Fixed
    // Fixed, `{=0.5:length}`: the number is a quantity, written and read in the units of the text;
    // `text` is what stands before it.
    bool is_quantity = false;
    bool is_work_offset = false;  // Fixed, `{=work_offset}`: the number of the one that acts
    int parameter = -1;           // Value, Quoted, Text
    Dimension dimension = Dimension::Number;
    double factor = 1;  // written = value · factor + offset
    double offset = 0;
    bool in_increments = false;  // the number counts least increments and has no point
    // The last digits of the number are another parameter (`T{tool}{offset:2}`), or always the same
    // (`P{finish}0060`).
    int tail_digits = 0;
    int tail_parameter = -1;
    int tail_value = 0;
    bool has_point_tail = false;   // … its digits behind the point: `T{tool}.{offset}`
    bool is_letter_alone = false;  // of a call in brackets: the letter without a number, `(MIR,X)`
    bool is_named_only = false;    // the word stands for itself, its number is always 0 …
    bool is_placeholder = false;   // … or, where it is read, any number, which means nothing
    bool is_absolute = false;      // absolute by itself, `AC(…)`; in forms that are read
    bool is_incremental = false;   // incremental by itself: `IC(…)`
    bool takes_rotary_approaches =
        false;  // an angle that may give its rotary approach: `DC(…)`, `ACP(…)`, `ACN(…)`
    bool is_pitch = false;     // the pitch of a thread, which counts in every revolution
    bool is_any = false;       // `{}`: a number on which nothing depends; read only
    double plain_factor = 0;   // `s|ms`: as `factor`, of a number without a point; 0: the same
    bool adds = false;         // read: added to the parameter; written: 0
    bool has_default = false;  // written with `fallback` if the parameter was not given
    double fallback = 0;
    bool is_optional = false;
    std::optional<NumberFormat> format;  // of the command; else that of the address
    bool is_kept = false;             // optional because a cycle before it may have given the word
    std::vector<FormWord> arguments;  // Call; with an address: `X{x}`, found by its letter
};

/// The parameter lies in this range, whole numbers.
struct Constraint {
    int parameter = 0;
    double least = 0;
    double most = 0;
};

struct Form {
    Function function = Function::None;
    CycleId cycle = 0;
    std::string pattern;                       // as in the file
    std::vector<FormWord> words;               // of the first line
    std::vector<std::vector<FormWord>> extra;  // further lines, written behind it
    std::vector<FormWord> lead;                // a line that is written before it
    std::vector<Constraint> when;
    std::vector<std::pair<int, double>> fixed;  // parameters that the form has by itself
    std::vector<int> implied;    // parameters that the control takes from its position
    std::vector<int> drops;      // parameters that the control needs not know
    int spindle_parameter = -1;  // asks for the spindle behind a cycle: 3, 4, 5; -1: none does
    Function leaves = Function::None;  // what the spindle does behind it
    std::vector<Function> sets;        // further functions that it programs
    std::vector<Function> first;       // functions that act before its own where it is read
    std::vector<Function> needs;       // modal functions that are written before it in the line
    std::vector<Function> before;      // functions that are written on lines of their own before it
    std::vector<Function> during;      // modal functions of which one must be active
    std::optional<CycleId> of_cycle;   // the modal cycle whose words these are
    std::vector<Function> outside;   // rotate, scale, mirror that must not act where it is written
    std::vector<AddressId> without;  // words that must not stand beside it
    int group = -1;                  // modal group of the dialect; -1 none
    std::uint64_t excludes = 0;      // groups of the form and of the codes in it, a bit each
    int order = 0;                   // position in the block: the order of its first word
    bool is_written = true;
    bool is_read = true;
    bool owns_block = false;    // stands alone
    bool owns_axes = false;     // no motion and no axis word stands beside it
    bool owns_line = false;     // stands alone where it is written; read, no axis word beside it
    bool joins = false;         // its code may stand together with another of its forms
    bool owns_address = false;  // no other word of its address stands in the block
    bool remembers = false;     // parameters that are left out keep their value
    bool is_verbatim = false;   // a line of the control's own language, letter by letter
    bool is_comment = false;    // stands between the comment signs
    bool is_by_number = false;  // of all codes that are the builder's by their number
    bool feed_every_block = false;   // F has to be repeated in every block
    bool feed_by_radius = false;     // … and of an arc it is feed/radius
    bool feed_is_pitch = false;      // of a `thread` code: F is the pitch
    bool is_preset = false;          // gives parameters to the next call of the cycle
    bool feed_stays_metric = false;  // of an `inch` code: F is not an inch feed
    bool feed_is_time = false;       // of a code for inverse time: F is the time itself, s
    bool keeps_length = false;  // the tool length acts in its block unless edge 0 is programmed
    std::string doc;
    std::string note;
    std::vector<std::string> names;  // of a call's arguments, as the control's manual has them
    std::string unsupported;         // what it is, if Kadr does not execute it
    std::string passed;              // … and if it passes over it with a message
    std::string lost;                // what a source does not get for it; "nothing": it misses none
    SourceRange range;               // in the file
};

/// The pattern of the form's own line: what has to stand in one block.
inline std::string first_line(const Form& form) {
    std::string line = form.pattern.substr(0, form.pattern.find('\n'));
    while (line.ends_with(' ') || line.ends_with('\t') || line.ends_with('\r')) line.pop_back();
    return line;
}

struct DialectGroup {
    std::string name;
    std::vector<Function> power_on;
    bool stands_together = false;  // several of its codes may stand in one block
};

/// What stands around a comment; one without a closing sign goes to the end of its line.
struct CommentMarks {
    std::string open;
    std::string close;
};

struct CommentStyle {
    std::string open = "(";
    std::string close = ")";
    bool is_upper = false;
    bool is_ascii = false;
    std::size_t max_length = 0;           // characters; 0: no limit
    std::vector<CommentMarks> also_read;  // other signs, which are never written
    std::vector<std::pair<char, std::string>> replacements;
};

/// Tool changes of a program that get a number of their own, where nothing else does.
inline constexpr std::int64_t kMostSections = 990;

struct BlockNumbers {
    bool is_on = false;
    bool at_sections = false;  // only the blocks with which an operator may begin again
    std::int64_t start = 10;
    std::int64_t step = 10;
    std::int64_t least = 0;  // that is read
    std::int64_t most = 99999999;
};

/// A line in front of the program's first block.
struct StartLine {
    std::string text;            // template
    std::vector<Function> uses;  // it stands only if the program may use one of these; none: always
};

struct ProgramTemplates {
    SourceRange range;                 // of the element, in the file
    bool is_inherited = false;         // that file is one which this dialect extends
    std::vector<std::string> header;   // templates, written at once, without block numbers
    std::vector<StartLine> start;      // before the first block that does something
    std::vector<std::string> section;  // templates, behind each tool change but the first
    std::vector<std::string> end;      // templates, at the very end
    std::vector<std::string> finish;   // before `end` if the program did not end itself
    std::vector<std::string> skipped;  // beginnings of lines that stand before the first block
    std::size_t name_length = 24;
    bool name_needs_two_letters = false;
    std::int64_t least_number = 0;  // program numbers; 0 and 0: no numbers
    std::int64_t most_number = 0;
    std::int64_t most_read_number = 0;  // the greatest that is read; 0: none is looked at
};

/// What happens if a block programs something twice.
enum class Repeated : std::uint8_t { Alarm, LastWins };

/// Codes from one number to another; none if there are none between.
struct CodeRange {
    double least = 0;
    double most = -1;
};

/// How lines are written, whatever they mean.
struct Notation {
    Repeated address = Repeated::Alarm;
    Repeated group = Repeated::Alarm;
    bool ignores_case = false;         // of letters outside comments and texts
    bool has_assignment = true;        // `X=10`
    bool has_modes = true;             // `X=AC(10)`, `X=IC(5)`
    bool number_first = true;          // N behind other words is an alarm
    bool blanks_inside_words = false;  // `X 10`, `G 0 1`
    bool has_several_skips = false;    // `/1/3`: left out at either level
    char end_sign = '\0';              // that may end a block before the line ends
    std::string front_signs;           // each may stand in front of a block, and means nothing here
    std::string block_end;             // written behind the words of every block
    std::string modal_call;            // word that makes the cycle behind it modal; empty: none
    std::vector<std::string> spindle_words;  // that may name the spindle: `S1=500`, `SPOS[1]=90`
    std::vector<std::string> code_words;     // codes whose number cannot stand behind `=`
    CodeRange builder_codes;       // M functions that are the builder's, unless a form has them
    double most_builder_code = 0;  // … and up to this one where they are read
    int skip_levels = 10;          // `/0` … `/9`
    int default_skip = 0;          // what `/` alone means; the lowest level
    std::size_t max_line = 512;    // bytes, read
    std::size_t write_line = 512;  // bytes, written
    bool crlf = false;             // written line ends
};

/// An alarm for a row whose detail holds these words.
struct AlarmAbout {
    std::string row;
    std::string words;
    AlarmText alarm;
};

/// A word of the control on which nothing that Kadr executes depends, with its brackets and value.
struct PassedWord {
    std::string meaning;
    bool is_given = false;      // that it has no effect here: on the control it has one
    bool takes_rest = false;    // whatever stands behind it in the line belongs to it
    std::uint8_t read_max = 0;  // words of the name in a block; 0: no limit
    // What a number behind `=` may be; another one is an alarm.
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
};

/// Words that are held back until a block programs an axis or a function.
struct Deferred {
    int axis = -1;  // Slot; -1: functions
    std::vector<Function> functions;
    std::vector<FormWord> words;
    std::string pattern;
};

/// Hashes a name whether a string or a part of a line holds it, so that a look-up copies nothing.
struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const {
        return std::hash<std::string_view>{}(name);
    }
};
using AddressNames = std::unordered_map<std::string, AddressId, NameHash, std::equal_to<>>;

struct DialectTables {
    std::string name;
    std::string title;
    std::string suffix;
    std::string extends;
    std::string file;
    SourceRange root;  // the outermost element of the file
    std::string doc;

    std::vector<Address> addresses;
    std::vector<Form> forms;  // in the order of the file: the first that fits is written
    std::vector<DialectGroup> groups;
    std::vector<CycleInfo> cycles;
    std::vector<CycleId> cycles_else_moves;  // written as moves where no form takes their values
    std::deque<std::string> texts;           // names of cycle parameters; stay where they are
    std::map<std::string, AlarmText, std::less<>> alarms;  // by row name
    std::vector<AlarmAbout> alarms_about;                  // looked at first
    std::map<std::string, std::string, std::less<>>
        unsupported;  // words that the control has and Kadr does not read, with their meaning
    std::map<std::string, std::string, std::less<>>
        foreign;  // words of other controls, and what this one has instead
    /// By the word alone, or with all that belongs to it: `SETMS(1)`.
    std::map<std::string, PassedWord, std::less<>> passed;
    std::vector<Deferred> deferred;
    std::vector<Example> examples;
    ProgramTemplates program;
    BlockNumbers block_numbers;
    CommentStyle comment;
    Notation notation;
    Rules rules;
    NamedRules named_rules;  // which of them a file names
    Language language;

    // Made from the above when the file is loaded.
    std::array<AddressId, 128> letters{};  // single-letter addresses; kNoAddress
    AddressNames names;                    // all addresses by name
    bool has_names = false;                // of two letters and more (`CR`, `MSG`)
    bool has_comma_words = false;          // `,C`
    bool has_bracket_calls = false;        // `(UAO,{number})`: the brackets stand around the name
    std::vector<std::vector<std::uint16_t>>
        code_index;  // [address][number·10] → index + 1 into `codes`
    std::vector<CodeStart> codes;
    std::array<std::vector<FormId>, kFunctions> forms_of;
    std::vector<std::vector<FormId>> forms_of_cycle;
    std::array<AddressId, kSlots> slot_address{};         // that writes the slot; kNoAddress
    std::array<AddressId, kSlots> incremental_address{};  // whose words are distances along it
    bool has_incremental_letters = false;  // distances have letters of their own; no code does
    std::vector<Slot> slot_order;          // in which slots are written
    std::array<Function, kGroups> power_on{};
    AddressId builder_address = kNoAddress;     // of the codes that are the builder's: M
    std::vector<FormId> verbatim_forms;         // in the order of the file
    std::vector<FormId> comment_forms;          // `(MSG,{text})`
    std::bitset<kFunctions> given_with_others;  // functions of forms that also set others

    UsedEntries* used = nullptr;  // notes what texts use; as a rule nobody does

    void note(const void* entry) const {
        if (used != nullptr) used->insert(entry);
    }
    AddressId find_address(std::string_view text) const {
        if (text.size() == 1) {
            const auto letter = static_cast<unsigned char>(text[0]);
            return letter < 128 ? letters[letter] : kNoAddress;
        }
        const auto found = names.find(text);
        return found == names.end() ? kNoAddress : found->second;
    }
    /// "`MCALL` (modal call)": a word of the control that Kadr does not read; empty for others.
    std::string unsupported_words(std::string_view word) const;
    /// Whether a word with this name is passed over, at least with some values.
    bool is_passed(std::string_view word) const;
    /// The code with this number (`54.1`), nullptr if the control has none.
    const CodeStart* find_code(AddressId address, double number) const {
        const std::vector<std::uint16_t>& index = code_index[address];
        const double tenths = number * 10;
        if (!(tenths >= 0) || tenths >= static_cast<double>(index.size())) return nullptr;
        const double above = tenths + 0.5;  // not negative: cutting it off rounds
        const auto whole = static_cast<std::size_t>(above);
        if (whole >= index.size() || index[whole] == 0) return nullptr;
        const double difference = tenths - static_cast<double>(whole);
        if (difference > 1e-6 || difference < -1e-6) return nullptr;
        return &codes[index[whole] - 1u];
    }
    /// The parameters of what the form programs: the vocabulary's, or the cycle's.
    std::span<const Parameter> parameters(const Form& form) const {
        if (form.function == Function::Cycle) return cycles[form.cycle].parameters;
        return info(form.function).parameters;
    }
};

}  // namespace kadr::nc
