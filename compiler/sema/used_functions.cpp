#include "sema/used_functions.h"

#include <vector>

namespace kadr::sema {

namespace {

constexpr nc::Function function_of(WithFrame frame) {
    switch (frame) {
        case WithFrame::Shift: return nc::Function::Shift;
        case WithFrame::Rotate: return nc::Function::Rotate;
        case WithFrame::Scale: return nc::Function::Scale;
        case WithFrame::Mirror: return nc::Function::Mirror;
    }
    return nc::Function::None;
}

class UsedFunctions {
  public:
    explicit UsedFunctions(const Code& code) : code_(code), is_seen_(code.functions.size()) {}

    nc::FunctionSet from(const FunctionCode& entry) {
        take(static_cast<std::size_t>(&entry - code_.functions.data()));
        while (!open_.empty()) {
            const FunctionCode& function = code_.functions[open_.back()];
            open_.pop_back();
            for (std::uint32_t i = function.entry; i < function.end; ++i)
                look_at(code_.instructions[i]);
        }
        return used_;
    }

  private:
    void take(std::size_t function) {
        if (function >= is_seen_.size() || is_seen_[function]) return;
        is_seen_[function] = true;
        open_.push_back(function);
    }

    void add(nc::Function function) { used_.set(static_cast<std::size_t>(function)); }

    void look_at(const Instruction& instruction) {
        const auto x = static_cast<std::size_t>(instruction.immediate.pair.first);
        switch (instruction.op) {
            case OpCode::Emit:
                add(code_.plans[x].motion);
                for (const nc::Invocation& invocation : code_.plans[x].functions)
                    add(invocation.function);
                break;
            case OpCode::ChangeFrame:
                add(function_of(static_cast<WithFrame>(instruction.b)));
                break;
            case OpCode::Call: take(instruction.b); break;
            case OpCode::SayCycle: take(code_.cycles[x].function); break;
            case OpCode::FollowCurve: take(x); break;
            default: break;
        }
    }

    const Code& code_;
    std::vector<bool> is_seen_;  // by function
    std::vector<std::size_t> open_;
    nc::FunctionSet used_;
};

}  // namespace

nc::FunctionSet used_functions(const Code& code, const FunctionCode& entry) {
    return UsedFunctions(code).from(entry);
}

}  // namespace kadr::sema
