#include "sema/diameters.h"

#include <algorithm>

namespace kadr::sema {

namespace {

struct DiameterWords {
    bool in_program = false;  // DIAMON or DIAMOF
    bool in_contour = false;  // DIAMON
};

/// What the blocks of a function set for X themselves, and those of its contours.
DiameterWords diameter_words(const Check& check, const FunctionCode& function) {
    DiameterWords words;
    int contours = 0;
    for (std::uint32_t at = function.entry; at < function.end; ++at) {
        const Instruction& instruction = check.code->instructions[at];
        contours += static_cast<int>(instruction.op == OpCode::BeginContour) -
                    static_cast<int>(instruction.op == OpCode::EndContour);
        if (instruction.op != OpCode::Emit) continue;
        const Plan& plan =
            check.code->plans[static_cast<std::size_t>(instruction.immediate.pair.first)];
        for (const nc::Invocation& invocation : plan.functions) {
            if (nc::info(invocation.function).group != nc::Group::Diameter) continue;
            if (contours == 0) words.in_program = true;
            else words.in_contour |= invocation.function == nc::Function::DiameterOn;
        }
    }
    return words;
}

}  // namespace

/// A function works with diameters, unless it sets what X is, if it makes a contour of diameters,
/// or calls what works with them: a cycle of a lathe is written for DIAMON. So does what is written
/// for a control where X always is one.
void mark_diameters(Check& check) {
    std::vector<FunctionCode>& functions = check.code->functions;
    std::vector<bool> decides(functions.size());
    for (std::size_t i = 0; i < functions.size(); ++i) {
        const std::vector<nc::Function>& needs = functions[i].needs;
        const DiameterWords words = diameter_words(check, functions[i]);
        const bool is_of_lathe =
            i > 0 &&
            check.names.module(check.names.function(static_cast<std::uint32_t>(i - 1)).module)
                    .dialect->power_on(nc::Group::Diameter) == nc::Function::DiameterOn;
        decides[i] = words.in_program;
        functions[i].has_diameters =
            is_of_lathe || (words.in_contour && !words.in_program) ||
            std::find(needs.begin(), needs.end(), nc::Function::DiameterOn) != needs.end();
    }
    // From what turns to what calls it, and on to what calls that.
    std::vector<std::vector<std::uint32_t>> callers(functions.size());
    for (std::uint32_t i = 0; i < functions.size(); ++i) {
        for (std::uint32_t at = functions[i].entry; at < functions[i].end; ++at) {
            const Instruction& instruction = check.code->instructions[at];
            if (instruction.op == OpCode::Call) callers[instruction.b].push_back(i);
        }
    }
    std::vector<std::uint32_t> pending;
    const auto mark = [&](std::uint32_t i) {
        functions[i].has_diameters = true;
        pending.push_back(i);
    };
    for (std::uint32_t i = 0; i < functions.size(); ++i) {
        if (functions[i].has_diameters) pending.push_back(i);
    }
    while (!pending.empty()) {
        const std::uint32_t turning = pending.back();
        pending.pop_back();
        // A contour of the file is everybody's.
        for (std::uint32_t i = 0; turning == 0 && i < functions.size(); ++i) {
            if (!functions[i].has_diameters && !decides[i]) mark(i);
        }
        for (const std::uint32_t i : callers[turning]) {
            if (!functions[i].has_diameters && !decides[i]) mark(i);
        }
    }
}

}  // namespace kadr::sema
