// parameters.h — what a program, a cycle or a function takes: for a person, and for a program that
// asks before it runs one.
#pragma once

#include <span>
#include <string>

#include "driver/options.h"
#include "driver/session.h"
#include "syntax/contract.h"

namespace kadr::driver {

/// A row of the table of parameters; each text may be empty.
struct ParameterRow {
    std::string name;
    std::string type;
    std::string unit;  // of a number without one
    std::string initial;
    std::string range;
    std::string meaning;
};

/// What a declaration says about a parameter of a file.
ParameterRow parameter_row(const syntax::Ast& ast, const syntax::ParameterContract& parameter);

/// The rows in columns that stand under their heads, each line indented; a column without a text
/// is left out. Ends with a line end.
std::string parameter_table(std::span<const ParameterRow> rows);

/// Lists the parameters of the programs of a file, or of the one that the options name. The file
/// is checked as for a run, so what is listed can be set; nothing is written if it has errors.
Status list_parameters(Session& session, const ParameterJob& job);

}  // namespace kadr::driver
