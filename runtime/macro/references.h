// references.h — what a text of a control declares and uses: programs, labels, block numbers,
// variables, and where each call, jump and name leads.
//
// Found by reading alone, nothing is executed: lines are compiled as they are for a run, targets
// and programs are looked for by the control's own rules (program_map.h, program_units.h). Where a
// value decides, the target is Computed. A line with a mistake has no uses and hides no other one.
// `reference_queries.h` answers questions from them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "macro/program_files.h"
#include "nc/control_line.h"

namespace kadr::macro {

/// A piece of one line, or of several: bytes from the head of the text.
struct TextRange {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    std::uint64_t line = 0;  // in which it begins, from 1; 0: nowhere
    friend bool operator==(const TextRange&, const TextRange&) = default;
};

/// Something that has a name in a text.
struct TextDeclaration {
    enum class Kind : std::uint8_t { Program, Label, Block, Variable, Parameter, Macro };
    Kind kind = Kind::Program;
    std::string name;           // as the control compares names; of a Block its number
    TextRange range;            // of the name; empty where none is written, as of a main program
    std::uint32_t program = 0;  // index of the declaration in which it stands; of a Program itself
    TextRange lines;            // of a Program: all of it
    nc::ValueType type = nc::ValueType::Real;  // of a Variable or a Parameter
    std::uint8_t dimensions = 0;               // likewise
    bool is_reference = false;                 // of a Parameter: the caller's variable itself
    bool is_twin = false;  // of a Label or a Block: an earlier one of its program has this name
};

/// A place where something is named.
struct TextUse {
    enum class Kind : std::uint8_t {
        Call,     // a program or a section runs, then the text goes on
        Jump,     // the program goes on there
        Repeat,   // a section from there on, or up to there, runs once more, or is a cycle's shape
        Read,     // of a variable; of a Macro its text
        Write,    // of a variable
        Mention,  // of a program without a call: its own head, a declaration of what it takes
    };
    enum class Outcome : std::uint8_t {
        Here,       // `target` is an index into References::declarations
        Elsewhere,  // … into References::outside
        Computed,   // a value of the run decides
        Missing,    // there is none
        Ambiguous,  // several callers decide, or a count
        OfCaller,   // a block of whoever calls the program, and nobody in the text does
    };
    static constexpr std::uint32_t kNoTarget = 0xffffffffu;

    Kind kind = Kind::Call;
    Outcome outcome = Outcome::Missing;
    TextRange range;            // of the name alone; of a Computed target the expression
    std::string name;           // as it is looked for; of a block its number; of Computed empty
    std::uint32_t program = 0;  // index of the declaration in which it stands
    std::uint32_t target = kNoTarget;
};

/// Something that is declared, wherever that is.
struct NamedPlace {
    std::string file;
    TextDeclaration::Kind kind = TextDeclaration::Kind::Program;
    std::string name;
    TextRange range;  // of the name, in that file
    friend bool operator==(const NamedPlace&, const NamedPlace&) = default;
};

struct References {
    std::string file;
    /// Of the blocks with numbers only those at which something of this text aims: a text has as
    /// many as lines. `blocks_of` of the queries finds the others.
    std::vector<TextDeclaration> declarations;  // programs, names, then blocks, each in text order
    std::vector<TextUse> uses;                  // in text order
    std::vector<NamedPlace> outside;            // each once
};

struct ReferenceOptions {
    ProgramFiles* files = nullptr;  // programs that do not stand in the text; may be null
    /// The text that was begun with, in which programs are looked for, too; null: this one.
    nc::TextSource* main = nullptr;
    std::string main_name;
    nc::MachineAxisNames axis_names;  // empty: as machines call them
};

/// Looks through the whole text, in time that grows with its length alone. Empty if the text cannot
/// be read again from its head.
///
/// file  the name of the text, as `options.files` would give it
References find_references(const nc::Dialect& dialect, nc::TextSource& text, std::string file,
                           const ReferenceOptions& options = {});

}  // namespace kadr::macro
