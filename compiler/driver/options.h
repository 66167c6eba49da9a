// options.h — what a user can ask of a session, as plain values.
//
// The command line fills these; so will the prompt and the language server. Parsing of arguments
// is theirs, meaning is here.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "motion/operator_panel.h"
#include "sema/check.h"

namespace kadr::driver {

/// How a command ended; the exit status of the program.
enum class Status : std::uint8_t {
    Done = 0,
    Failed = 1,  // the program has errors
    Usage = 2,   // wrong usage, or a file that cannot be read or written
    Alarm = 3,   // the control would have stopped while it ran
};

/// Blocks that a program may make unless the options set another number.
inline constexpr std::uint64_t kMaxBlocks = 20'000'000;

/// What holds for everything that a session does.
struct Options {
    std::string dialect;                // name or file; empty: as the source suggests
    std::string machine;                // name or file; empty: the stock mill
    std::string tools;                  // file of the tool library; empty: the machine's, if any
    bool has_stand_in_tools = false;    // its tools are nobody's: calls may name other cutters
    std::string program;                // which program of the file; empty: the only one
    std::vector<sema::Define> defines;  // values of the program's parameters
    std::vector<std::string> folders;   // searched for imports before the standard library
    std::vector<std::string> search;    // … for programs that ISO-7bit text calls, behind its own
    std::vector<std::string> allow_read;                // … whose files programs may read besides
    std::uint64_t max_input = Files::kMostBytes;        // bytes of a file that is read whole
    std::uint64_t max_output = std::uint64_t{4} << 30;  // … of all outputs together
    bool native_cycles = true;            // cycles as the control's own where it has them
    bool modal_cycles = true;             // … equal calls of them as one modal call
    bool verbose_modal = false;           // repeat modal words in the text
    std::uint64_t max_blocks = 0;         // blocks after which expanding and executing are cut;
                                          // 0: kMaxBlocks made, any number executed
    double max_time = 0;                  // s of computing after which they are cut; 0: no limit
    std::uint16_t skip_levels = 0;        // bit n: blocks with skip level n are left out
    bool optional_stop = false;           // M1 stops
    std::optional<std::uint64_t> passes;  // of a main program that begins itself again
    std::vector<std::string> variable_files;  // what the machine gives before a program begins …
    std::optional<std::string> call;          // arguments with which ISO-7bit text is called
    std::vector<std::string> sets;            // … `NAME=VALUE`, which comes behind the files
    std::optional<double> tick;               // s; nothing: as the machine has it
    const std::atomic<bool>* stop = nullptr;  // set from outside, by any thread: what works ends
                                              // soon, with an error
    sema::CheckOptions check;                 // what a prompt may do
    std::vector<std::string>* shown = nullptr;  // gets their values, as texts
};

/// Where the results of an expansion go; `-` is standard output.
struct ExpandJob {
    std::string source;
    std::string output = "-";
    std::string map;  // source map; empty: none
};

enum class ParameterFormat : std::uint8_t { Text, Json };

/// `kadr expand --parameters`: where the list of a program's parameters goes.
struct ParameterJob {
    std::string source;
    std::string output = "-";
    ParameterFormat format = ParameterFormat::Text;
};

enum class SummaryFormat : std::uint8_t { Text, Json };

/// Somebody who looks on while a program runs.
struct Onlooker {
    std::function<void(std::string_view)> say;  // shows a text; empty: nobody reads it
    /// The next command, without its line end; nothing: there are no more. Empty: nobody answers,
    /// and a break point ends the run.
    std::function<std::optional<std::string>()> ask;
    bool reads_json = false;
};

/// What is run, how, and what it puts out.
struct RunJob {
    std::string source;
    /// What was asked for, by the flags of driver/outputs.h: names of files, and settings.
    std::map<std::string, std::string, std::less<>> outputs;
    std::vector<std::string> breaks;  // points in front of which the run stops
    std::vector<std::string> until;   // … in front of which the program ends
    Onlooker onlooker;
    std::optional<bool> threads;  // planning, sampling and writing of setpoints at the same time;
                                  // nothing: with more than one processor
    double feed_override = 1;     // > 0; multiplies what the program asks for, never a limit
    double rapid_override = 1;    // > 0, at most 1
    std::string events;           // file with what the operator does meanwhile; empty: none
    std::vector<motion::OperatorEvent> operator_events;  // what else; then overrides may be 0

    /// Of an output or a setting; empty: nobody asked.
    const std::string& value_of(std::string_view flag) const {
        static const std::string nothing;
        const auto found = outputs.find(flag);
        return found == outputs.end() ? nothing : found->second;
    }
};

/// Two programs whose motion is compared, or one for two controls.
struct CompareJob {
    std::array<std::string, 2> sources;
    std::array<std::string, 2> dialects;  // names or files; empty: as the source suggests
    double tolerance = 0.003;             // mm; half an increment of each text, and rounded arcs
    SummaryFormat summary = SummaryFormat::Text;
};

/// Which tests are run, and how hard the properties are tried.
struct TestJob {
    std::vector<std::string> sources;
    std::string filter;        // part of the name; empty: all
    std::uint64_t seed = 1;    // of the random values
    std::uint64_t runs = 100;  // sets of values of each property
    std::string output = "-";  // for the list of the tests
};

}  // namespace kadr::driver
