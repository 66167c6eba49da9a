// code_names.h — what the registers and instructions of the code are called in the source, for who
// looks on while it runs.
//
// Made only on wish (CheckOptions::keeps_names): the code runs without it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/source.h"
#include "sema/slot.h"

namespace kadr::sema {

struct NamedVariable {
    enum class Storage : std::uint8_t {
        Register,   // of the function's call
        Reference,  // a register of the call, which refers to the value
        Global,
        Constant,  // takes no register
    };
    static constexpr std::uint32_t kOpen = 0xffffffffu;

    std::string name;
    std::string type;  // as a person writes it: `length`, `hole[]`, `real&`
    Storage storage = Storage::Register;
    bool is_parameter = false;
    std::uint32_t first = 0;  // register of the call; of a Global among those of all files
    Slot constant{};          // of a Constant; of a text its index in Code::texts
    std::uint32_t form = 0;   // index into Code::shown_forms
    // Instructions in front of which it holds a value; not of globals.
    std::uint32_t from = 0;
    std::uint32_t to = kOpen;
    SourceRange range;  // of the name where it is declared
};

/// Where a statement begins; of one with a body its head alone.
struct StatementStart {
    std::uint32_t at = 0;  // its first instruction
    SourceRange range;
};

struct CodeNames {
    std::vector<NamedVariable> variables;    // of all functions, in the order of `from`
    std::vector<NamedVariable> globals;      // of all files
    std::vector<StatementStart> statements;  // in the order of `at`, one an instruction
    /// By instruction: 1 + index of the statement that begins there; 0 none.
    std::vector<std::uint32_t> starts;
};

}  // namespace kadr::sema
