// dialect.h — what a control's XML file holds, compiled into tables.
//
// One description, both directions: the writer and the reader use the same tables. No code asks
// which control it is.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "nc/block.h"
#include "nc/rules.h"

namespace kadr::nc {

struct DialectTables;  // tables.h, for the rooms of nc only
struct Refusal;        // refusals.h

/// A machining cycle that dialects may map to a control's own. All dialects share the list of the
/// common core, so a CycleId means the same everywhere.
struct CycleInfo {
    std::string name;                   // as in stdlib: "drill_peck"
    std::vector<Parameter> parameters;  // names live in the Dialect
    std::string meaning;
    std::string module;      // of the library that has it, if a block of a source can be this cycle
    std::string file;        // of a control's own cycle: the Kadr file that defines what it does
    std::string curve;       // … or the kind of curve that it moves along (path/curve_registry.h)
    SourceRange file_range;  // where the dialect names either
    bool is_modal = true;    // where cycles are modal: a call is repeated by further axis words
    bool taps = false;  // no override acts on its lines, and a hold waits until they are through

    /// Which parameters the words of modal cycles set; -1: none.
    struct Roles {
        int depth = -1;    // the word of the tool axis
        int retract = -1;  // where rapid ends and feed begins
        int stroke = -1;   // left out: the whole depth in one
        int shift = -1;    // given by the same word as a stroke
        int dwell = -1;
        int start = -1;        // angle at which a thread begins; given in its block alone
        int first_block = -1;  // number of the block with which the shape begins …
        int last_block = -1;   // … and ends, of a cycle that works along a shape in the program
    };
    Roles roles;
    bool takes_shape() const { return roles.first_block >= 0 && roles.last_block >= 0; }

    /// A parameter that the machine's builder has set for calls which do not give it.
    struct Setting {
        int parameter = 0;
        double value = 0;
    };
    std::vector<Setting> settings;
};

/// A control's own alarm for an error that the interpreter raises.
struct AlarmText {
    std::string number;
    std::string text;
};

/// What stands beside an entry: a statement and its text, for the reader of the file and as a test.
struct Example {
    std::string source;  // a Kadr statement; empty: the control reads more than Kadr writes
    std::string text;    // what the control reads; lines joined by line ends
    std::string block;   // `describe` of what it means, if it differs from what the source means
    std::string meaning;
    std::string gives;         // of the control's language: what its program leaves in variables
    SourceRange source_range;  // of the attributes' values; of the element where there is none
    SourceRange text_range;
    SourceRange block_range;
    SourceRange gives_range;
};

/// Entries of the tables that texts have used, by their addresses in memory.
using UsedEntries = std::set<const void*>;

/// Immutable. Movable, not copyable.
class Dialect {
  public:
    explicit Dialect(std::unique_ptr<DialectTables> tables);
    Dialect(Dialect&&) noexcept;
    Dialect& operator=(Dialect&&) noexcept;
    ~Dialect();

    std::string_view name() const;    // "fanuc"
    std::string_view title() const;   // "FANUC 30i/31i/32i-B, machining centre"
    std::string_view suffix() const;  // of files: "nc"

    std::span<const CycleInfo> cycles() const;
    std::optional<CycleId> find_cycle(std::string_view name) const;
    /// Whether a cycle of the control takes these parameters (bit i: given), and needs no others.
    /// Where the dialect wants moves otherwise, their values count too; elsewhere a value that the
    /// control cannot take is an error of the writer.
    /// `refusals` gets the forms that do not fit; null: nobody asks.
    bool has_native_cycle(CycleId cycle, std::uint32_t given, std::span<const double> values = {},
                          std::vector<Refusal>* refusals = nullptr) const;
    /// Whether the control can write this function at all.
    bool can_write(Function function) const;
    /// The increment to which X is written, mm; 0 if the control has no X.
    double written_increment(bool is_inch) const;
    /// Member of a modal group at power-on; None if the dialect does not have one.
    Function power_on(Group group) const;
    /// Whether the control is a lathe's: X is a diameter at power-on.
    bool is_of_lathe() const { return power_on(Group::Diameter) == Function::DiameterOn; }
    /// The control's alarm for a diagnostic row; nothing if the dialect names none.
    /// `detail`: what the message has in words that are not the row's, where that decides.
    std::optional<AlarmText> alarm(const DiagnosticRow& row, std::string_view detail = {}) const;
    /// How the control behaves: what the files set, of what extends the last, and defaults.
    const Rules& rules() const;
    /// Whether a file sets the rule.
    bool names_rule(Rule rule) const;
    /// The work offset that acts where a program begins, before it programs one; 0: none.
    int first_work_offset() const;
    /// The motion that is modal where a program begins, before it programs one.
    Function first_motion() const;
    /// The common core, in which the library and most sources are written: it extends nothing.
    bool is_core() const;
    /// `X=AC(10)` and `X=IC(5)`: coordinates and distances can stand beside each other.
    bool has_distance_words() const;
    /// Offsets have the numbers of tools and are named apart from them (`T3 M6`, then `G43 H3`),
    /// so `D3` means the third tool's radius; else `D` is an edge of the tool that is in.
    bool counts_offsets_by_tool() const;

    /// The word that makes the call of a cycle behind it modal, and ends it where it stands alone;
    /// empty: the control has none.
    std::string_view modal_call() const;

    /// Of this file; those of the files that it extends are checked with them.
    std::span<const Example> examples() const;
    /// Whether a text that begins so has the header of this control (`O0001`, `%_N_PART_MPF`).
    bool has_header(std::string_view text) const;

    /// From now on notes every entry that a text of the control uses (nc/coverage.h); null: no
    /// more.
    void record(UsedEntries* used);

    const DialectTables& tables() const { return *tables_; }

  private:
    std::unique_ptr<DialectTables> tables_;
};

/// Folders in which dialect files are looked for, first match wins.
using SearchPath = std::vector<std::string>;

/// Loads a dialect by name ("fanuc") or by file. Everything wrong in the file is reported with its
/// location; nothing is returned then.
std::optional<Dialect> load_dialect(const std::string& name_or_file, const SearchPath& folders,
                                    Sources& sources, DiagnosticSink& sink);

/// What the first tag of a dialect file holds.
struct DialectSummary {
    std::string name;
    std::string title;
    std::string suffix;
    std::string extends;
    std::string file;
};

/// All dialects in the folders, by name. Only the first tags are read: a file may have mistakes
/// behind it, and one whose first tag cannot be read has a name alone.
std::vector<DialectSummary> list_dialects(const SearchPath& folders, const Files& files);

/// Whether loading the dialect reports no mistakes. As slow as loading it.
bool can_be_loaded(const std::string& name, const SearchPath& folders, const Files& files);

/// What a word of the control (`G83`, `CR`), a function of the vocabulary (`dwell`) or a cycle
/// means and how it is written: one line of text an entry. Empty if the dialect does not know the
/// word.
std::vector<std::string> explain(const Dialect& dialect, std::string_view word);

// ---------------------------------------------------------------- words of blocks in a source

/// How a word stands in a Kadr source block.
struct SourceWord {
    enum class Value : std::uint8_t { None, Literal, Computed };
    enum class Mode : std::uint8_t {
        Modal,
        Absolute,
        Incremental
    };                         // X=…; X=AC(…); X=IC(…) or X+=…
    std::string_view address;  // "X", "CR", "G"; without its number
    Value value = Value::None;
    double number = 0;  // of a Literal
    Mode mode = Mode::Modal;
    SourceRange range;
};

/// An argument of a call of the control (`CYCLE81(50,2,,-10)`) in a Kadr source.
struct SourceArgument {
    enum class Kind : std::uint8_t { Empty, Number, Text, Computed };
    Kind kind = Kind::Empty;
    double number = 0;  // of a Number
    SourceRange range;
};

/// Where the value of a word belongs in the block that is made from it.
struct Hole {
    std::uint16_t word = 0;  // index of the SourceWord, or of the argument of a call
    Dimension dimension = Dimension::Number;
    bool is_argument = false;  // false: `index` is a Slot; true: index into Block::arguments
    std::uint8_t index = 0;
    std::uint8_t invocation = 0;  // index into Block::functions, if is_argument
    std::uint8_t parameter = 0;   // … and which of its parameters
    // A bare number n of the source stands for n · factor + offset (`G54.1 P2` is work offset 8, a
    // control's `P500` is 0.5 s). A value with a unit of its own is taken as it is, plus offset.
    double factor = 1;
    double offset = 0;
    bool adds = false;  // it is added to what another argument gives for the same parameter
};

/// The working planes as a set: bit 0 X-Y, 1 Z-X, 2 Y-Z.
using PlaneMask = std::uint8_t;
constexpr PlaneMask kAllPlanes = 7;
/// plane  one of the functions of Group::Plane
constexpr PlaneMask bit_of_plane(Function plane) {
    return static_cast<PlaneMask>(
        1u << (static_cast<unsigned>(plane) - static_cast<unsigned>(Function::PlaneXy)));
}
static_assert((bit_of_plane(Function::PlaneZx) | bit_of_plane(Function::PlaneYz)) == 6);

/// A block with everything that is known before the program runs; values of the words named by
/// `holes` are to be filled in (also those of literals: units are the language's matter).
struct BlockPlan {
    Block block;
    std::vector<Hole> holes;
    PlaneMask planes = kAllPlanes;   // in which its words mean this; in the others something else
    bool feed_stays_metric = false;  // it means inches, but F stays in mm (`G70` of some controls)
};

/// Recognises source words with the tables of the input dialect. Mistakes are reported at the word.
std::optional<BlockPlan> plan_block(const Dialect& dialect, std::span<const SourceWord> words,
                                    DiagnosticSink& sink);

/// The same for a call of the control that stands in a block of its own. `range`: of its name.
std::optional<BlockPlan> plan_call(const Dialect& dialect, std::string_view name,
                                   const SourceRange& range,
                                   std::span<const SourceArgument> arguments, DiagnosticSink& sink);

/// The cycle that a literal word of the source (`G83`) begins; nothing if it begins none.
std::optional<CycleId> cycle_of(const Dialect& dialect, std::string_view address, double number);
/// The same of a word as it is spelled, `G83`, and of the name of a call, `CYCLE81`.
std::optional<CycleId> cycle_of_word(const Dialect& dialect, std::string_view word);
/// Whether a block of a source can be this cycle as the control has it: the text gives all that it
/// does (no parameter of the machine's builder), and the library has it for every control.
bool can_be_source(const Dialect& dialect, CycleId cycle);

/// What 1 means behind this address where the number has no decimal point, in the unit of the
/// address: 0.001 if the control counts positions in increments; 1 if the number stands for itself.
struct PlainNumber {
    double time = 1;        // … and for a feed, a feed per minute
    double revolution = 1;  // a feed per revolution
};
PlainNumber plain_number(const Dialect& dialect, std::string_view address, bool is_inch);

/// What a call of the control (`MSG("…")`, `CYCLE81(…)`) means.
struct CallMeaning {
    Function function = Function::None;  // None: the control has no such call
    CycleId cycle = 0;
};
CallMeaning call_meaning(const Dialect& dialect, std::string_view name);

/// What an identifier of the source is in the input dialect, for the parser: an address that takes
/// a value (`X`, `CR`, `G`), a word by itself (`TRANS`, `DIAMON`), the name of a call (`CYCLE81`),
/// or nothing.
enum class WordKind : std::uint8_t { None, Address, Word, Call };
WordKind word_kind(const Dialect& dialect, std::string_view identifier);

}  // namespace kadr::nc
