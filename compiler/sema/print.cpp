// print.cpp — code as text: one instruction a line, operands as opcodes.def has them.
#include <array>
#include <string_view>

#include "base/numbers.h"
#include "sema/code.h"

namespace kadr::sema {

namespace {

struct OpRow {
    std::string_view name;
    std::string_view operands;
};

constexpr OpRow kOps[] = {
#define KADR_OP(name, operands) {#name, operands},
#include "sema/opcodes.def"
#undef KADR_OP
};

void print_instruction(const Instruction& instruction, std::string& out) {
    const OpRow& row = kOps[static_cast<std::size_t>(instruction.op)];
    out += row.name;
    char separator = ' ';
    for (const char operand : row.operands) {
        out += separator;
        separator = ',';
        switch (operand) {
            case 'a': out += 'r' + std::to_string(instruction.a); break;
            case 'b': out += 'r' + std::to_string(instruction.b); break;
            case 'c': out += 'r' + std::to_string(instruction.c); break;
            case 'n': out += std::to_string(static_cast<std::int16_t>(instruction.c)); break;
            case 'i': out += std::to_string(instruction.immediate.integer); break;
            case 'f': append_shortest(out, instruction.immediate.number); break;
            case 't': out += '@' + std::to_string(instruction.immediate.pair.first); break;
            case 'x': out += std::to_string(instruction.immediate.pair.first); break;
            case 'y': out += std::to_string(instruction.immediate.pair.second); break;
            default: break;
        }
    }
}

}  // namespace

namespace {

std::string describe(const NamedVariable& variable) {
    const std::string words = variable.type + ' ' + variable.name;
    using S = NamedVariable::Storage;
    switch (variable.storage) {
        case S::Register: return words + " in r" + std::to_string(variable.first);
        case S::Reference: return words + " by r" + std::to_string(variable.first);
        case S::Global: return words + " in global " + std::to_string(variable.first);
        case S::Constant: break;
    }
    return words + " constant";
}

}  // namespace

std::string print(const Code& code, const FunctionCode& function) {
    std::string out = function.name + ": " + std::to_string(function.registers) + " registers\n";
    for (std::uint32_t at = function.entry; at < function.end; ++at) {
        out += "  " + std::to_string(at) + ' ';
        print_instruction(code.instructions[at], out);
        out += '\n';
    }
    return out;
}

std::string print(const Code& code) {
    std::string out;
    for (const FunctionCode& function : code.functions) {
        if (function.end > function.entry) out += print(code, function);
    }
    return out;
}

std::string print_names(const Code& code, const Sources& sources) {
    std::string out;
    for (const NamedVariable& global : code.names.globals) out += describe(global) + '\n';
    for (const FunctionCode& function : code.functions) {
        const auto is_inside = [&](std::uint32_t at) {
            return at >= function.entry && at < function.end;
        };
        if (function.end == function.entry) continue;
        out += function.name + ":\n";
        for (const NamedVariable& variable : code.names.variables) {
            if (!is_inside(variable.from)) continue;
            out += "  " + std::to_string(variable.from) + " to " + std::to_string(variable.to) +
                   ": " + describe(variable) + '\n';
        }
        for (const StatementStart& statement : code.names.statements) {
            if (!is_inside(statement.at)) continue;
            out += "  " + std::to_string(statement.at) + " | ";
            out += sources.text(statement.range);
            out += '\n';
        }
    }
    return out;
}

}  // namespace kadr::sema
