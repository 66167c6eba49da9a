// options.h — the command line, parsed. The only door to CLI11.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "driver/format.h"
#include "driver/machine_solve.h"
#include "driver/messages.h"
#include "driver/options.h"

namespace kadr::cli {

enum class Verb : std::uint8_t {
    Expand,
    Parameters,  // expand --parameters
    Run,
    Compare,
    Check,
    Test,
    Format,
    Repl,
    Explain,
    DialectList,
    DialectCheck,
    DialectExplain,
    MachineList,
    MachineCheck,
    MachineSolve,
};

struct CommandLine {
    Verb verb = Verb::Check;
    driver::Options options;
    driver::ExpandJob expand;
    driver::ParameterJob parameters;
    driver::RunJob run;
    driver::CompareJob compare;
    driver::TestJob test;
    driver::SolveJob solve;
    std::vector<std::string> sources;  // check, fmt
    driver::FormatMode format = driver::FormatMode::Write;
    std::string file;  // dialect and machine: a name or a file
    std::string word;  // dialect explain: a word; explain: a message
    driver::MessageFormat messages = driver::MessageFormat::Text;
};

/// What to do instead of a command: the text of the help, or what is wrong with the arguments.
struct Answer {
    driver::Status status = driver::Status::Usage;
    std::string text;  // to standard output if the status is Done, else to standard error
};

std::variant<CommandLine, Answer> parse_command_line(int count, const char* const* arguments);

}  // namespace kadr::cli
