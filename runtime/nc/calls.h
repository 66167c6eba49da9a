// calls.h — how a control calls programs, as its dialect describes it: what programs are called in
// texts and in files, the words that call one, and what becomes of their arguments.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr::nc {

/// `O{n}`, `%_N_{name}_SPF`, `{name}.SPF`: a name of a program inside other text.
struct ProgramPattern {
    std::string form;
    std::string before;
    std::string behind;
    bool is_number = false;
    bool is_subprogram = false;  // of a head: never the main program of a text
};

/// Reads `form`; false: it has not one hole, {n} or {name}.
bool read_program_pattern(std::string_view form, ProgramPattern& out);
/// The name in the text, numbers without leading zeros. `is_whole`: nothing stands behind. Letters
/// of the pattern fit in either case; those of the name go into upper case if `ignores_case`.
/// behind  what stands behind the name; may be null
std::optional<std::string> match_program(const ProgramPattern& pattern, std::string_view text,
                                         bool ignores_case, bool is_whole,
                                         std::string_view* behind = nullptr);

/// A code or a name that calls a program, or ends one.
struct CallForm {
    enum class Kind : std::uint8_t { Subprogram, Macro, Return, EndModal };
    enum class Modal : std::uint8_t { None, Motion, Block };
    Kind kind = Kind::Subprogram;
    Modal modal = Modal::None;
    std::string code;          // `M98`, `T{n}`, `{name}`, `L{digits}`
    char letter = '\0';        // of the code
    double number = 0;         // of the code
    bool any_number = false;   // `T{n}`
    bool is_name = false;      // the word itself names the program
    char program = '\0';       // the address that gives the program
    char repeats = '\0';       // … how often; of a return: how often still
    char start = '\0';         // … the block number where it begins
    char target = '\0';        // of a return: the block of the caller where that goes on
    std::string fixed;         // the program that the code always calls
    std::string value;         // the variable that gets the number of the code
    int split = 0;             // longer numbers of a program hold repeats before so many digits
    bool is_external = false;  // from outside of the control's memory; not inside of each other
    std::string doc;
};

/// The variable that an argument sets.
struct ArgumentForm {
    char letter = '\0';
    char like = '\0';         // the address whose numbers it has; none: as it stands
    std::string variable;     // `#24`
    std::uint32_t slot = 0;   // among the variables of the level
    bool in_series = false;   // given again, it sets the next of its kind
    bool only_block = false;  // only where whole blocks are arguments
};

struct CallLanguage {
    std::vector<ProgramPattern> headers;  // lines that begin a program
    std::vector<ProgramPattern> files;    // names of files, in the order of search
    std::vector<CallForm> calls;
    std::vector<ArgumentForm> arguments;
    std::string reference_word;        // before a parameter that is the caller's variable: `VAR`
    std::string save_word;             // of a procedure that leaves the modal state as it was
    std::vector<std::string> options;  // words of a procedure that change nothing here
    /// Programs that hold definitions for all the others, in the order in which they are read, and
    /// the words before the type of what they define.
    std::vector<std::string> definitions;
    std::vector<std::string> scope_words;
};

/// The head that this line is; nullptr: none. `behind`, where it is given, gets what stands behind
/// the program's name.
const ProgramPattern* header_of(const CallLanguage& calls, std::string_view line, bool ignores_case,
                                std::string_view* behind = nullptr);
/// The program that begins with this line.
std::optional<std::string> program_of_header(const CallLanguage& calls, std::string_view line,
                                             bool ignores_case);
/// Where such a line names its program, a part of it; nothing: the line is no head.
std::optional<std::string_view> name_in_header(const CallLanguage& calls, std::string_view line,
                                               bool ignores_case);
/// The program that a path or the name of a file means: `/_N_SPF_DIR/_N_POCK_SPF` is POCK.
std::string program_of_path(const CallLanguage& calls, std::string_view path, bool ignores_case);
/// The kind that programs of a form have, the letters behind their names: SPF of `{name}.SPF`.
std::string kind_of(const ProgramPattern& pattern);
/// The kind that a path gives with its program; empty: it leaves that open.
std::string kind_of_path(const CallLanguage& calls, std::string_view path, bool ignores_case);
/// `O12` for the program 12: as a header writes it, for messages.
std::string shown_program(const CallLanguage& calls, std::string_view name);

}  // namespace kadr::nc
