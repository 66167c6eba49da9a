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

}  // namespace kadr::sema
