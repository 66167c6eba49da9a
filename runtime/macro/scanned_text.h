// scanned_text.h — what one look through a text has found, before it is known where its names lead.
// Internal to macro.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "macro/references.h"
#include "macro/target_index.h"
#include "macro/text_macros.h"

namespace kadr::macro {

/// What a name stands for in a program.
struct KnownName {
    TextUse::Outcome outcome = TextUse::Outcome::Here;
    std::uint32_t target = 0;  // as TextUse has it
};

/// The names that a program may use besides those of the control.
struct NamesOfProgram {
    nc::SymbolTable symbols;
    TextMacros macros;
    std::map<std::string, KnownName, std::less<>> known;  // variables and macros
};

/// A program of the text.
struct ProgramPlace {
    LinePosition begin;             // from which targets are looked for
    LinePosition head;              // of the line that names it; else as `begin`
    std::uint32_t declaration = 0;  // index into References::declarations
    bool has_head = false;
    bool is_main = false;
};

/// How the target of a use is looked for, once the whole text is known.
struct OpenUse {
    enum class Rule : std::uint8_t {
        Nearest,   // as a jump: in `direction` from the line
        FromHead,  // the first one of the program that runs
        Around,    // toward the head first, then forward: a section that is repeated
        Counted,   // as FromHead or Around: the count decides
        Behind,    // the first one behind the target of `other`
        InCalled,  // the first one of the program that `other` calls
        OfReturn,  // in the caller, or in the main program itself
        Program,   // a program by its name
    };
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::uint32_t use = 0;  // index into References::uses
    Rule rule = Rule::Nearest;
    Direction direction = Direction::Both;
    LineTarget target;            // not of a Program
    ProgramLine from;             // the line of the use
    std::string kind;             // of a Program
    std::uint32_t place = 0;      // index into ScannedText::programs of the one with the use
    std::uint32_t other = kNone;  // index into ScannedText::open, below this one's
};

/// An argument that is a variable: the program that is called may set it.
struct OpenArgument {
    std::uint32_t use = 0;       // index into References::uses, of a Read
    std::uint32_t call = 0;      // index into ScannedText::open
    std::uint32_t position = 0;  // among the arguments
};

struct ScannedText {
    References references;
    std::vector<ProgramPlace> programs;
    std::vector<OpenUse> open;
    std::vector<OpenArgument> arguments;
    TargetIndex index;
};

}  // namespace kadr::macro
