// program_bench.h — programs with variables through the control's own language and the interpreter.
#pragma once

#include "macro/program.h"
#include "tests/interp/text_bench.h"

namespace kadr::interp {

/// As read(), of a text whose lines may set variables and jump.
inline Ran run_program(std::string_view dialect_name, std::string text,
                       const machine::Machine& machine) {
    Sources sources;
    DiagnosticList messages;
    const std::optional<nc::Dialect> dialect =
        nc::load_dialect(std::string(dialect_name), {KADR_ROOT "/dialects"}, sources, messages);
    Ran ran;
    if (!dialect) {
        ADD_FAILURE() << dialect_name << " cannot be loaded";
        return ran;
    }
    Text source(std::move(text));
    macro::NcProgram program(*dialect, source, "test", {}, messages);
    Interpreter interpreter(*dialect, machine, program, &program, nullptr, {}, messages);
    program.follow(interpreter);
    std::vector<path::Command> batch(7);
    while (const std::size_t count = interpreter.pull(batch))
        ran.commands.insert(ran.commands.end(), batch.begin(),
                            batch.begin() + static_cast<std::ptrdiff_t>(count));
    ran.messages = messages.all();
    ran.alarmed = interpreter.alarmed();
    return ran;
}

}  // namespace kadr::interp
