#include "expand/running.h"

namespace kadr::expand {

namespace {

/// By function: the mask of a call that gives every argument.
std::vector<std::uint32_t> masks_of_all(const sema::Code& code) {
    std::vector<std::uint32_t> masks;
    masks.reserve(code.functions.size());
    for (const sema::FunctionCode& function : code.functions) {
        const std::size_t count = function.parameters.size();
        masks.push_back(count >= 32 ? ~0u : (1u << count) - 1u);
    }
    return masks;
}

}  // namespace

VirtualMachine::VirtualMachine(const sema::Code& code, const RunLimits& limits)
    : heap(code, {limits.array_elements, limits.heap_bytes}), all_given(masks_of_all(code)) {}

Running::Running(const sema::Code& program, const nc::Dialect& dialect, const ExpandOptions& wanted,
                 DiagnosticSink& messages)
    : vm(program, wanted.limits),
      budget(wanted.limits, wanted.stop),
      code(program),
      target(dialect),
      options(wanted),
      sink(messages) {}

}  // namespace kadr::expand
