// running.h — a small program from its text to blocks and messages, for the tests of sema and
// expand.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "expand/expander.h"
#include "sema/check.h"
#include "sema/code.h"
#include "syntax/parse.h"

namespace kadr::testing {

struct RunOptions {
    std::string program;  // empty: the first
    std::vector<sema::Define> defines;
    expand::ExpandOptions expand;
    std::string source = "iso";                  // input dialect of the program
    std::string target = "iso";                  // dialect that is asked for native cycles
    std::map<std::string, std::string> modules;  // what can be imported, by name
    bool with_stdlib = false;                    // … or the real library
    bool with_broken_text = false;               // what has syntax errors is checked as well
    bool keeps_names = false;                    // Code::names is filled
    std::string file = "test.kadr";
};

/// What became of a program: blocks as `describe` shows them, messages as `line:column code`.
struct Outcome {
    std::vector<std::string> blocks;
    std::vector<std::string> messages;  // "3:5 K2001"
    std::vector<std::string> texts;     // the wording of each
    std::vector<std::string> notes;     // "2:1 it is declared here", of all messages in order
    std::vector<expand::BlockOrigin> traces;
    std::string code;  // printed, if it was checked without errors

    std::string all_blocks() const;  // one a line
    std::string all_messages() const;
};

Outcome run(const std::string& source, const RunOptions& options = {});
/// The statements as the body of a program.
Outcome run_body(const std::string& statements, const RunOptions& options = {});
/// Only the check.
Outcome check(const std::string& source, const RunOptions& options = {});

/// A checked program that stays alive, for benchmarks and for pulling in batches.
struct Checked {
    std::unique_ptr<Sources> sources;
    std::unique_ptr<DiagnosticList> messages;
    std::shared_ptr<void> modules;
    std::unique_ptr<sema::Code> code;  // null: the program has errors
    sema::Checked facts;
};
Checked check_program(const std::string& source, const RunOptions& options = {});
const nc::Dialect& dialect(const std::string& name);
const syntax::KeywordTable& keywords();

}  // namespace kadr::testing
