// statement_watch.h — who looks on while a program is evaluated, and what can be seen then.
#pragma once

#include <cstdint>
#include <string>

#include "sema/code.h"

namespace kadr::expand {

class StatementWatch {
  public:
    virtual ~StatementWatch() = default;
    enum class Answer : std::uint8_t {
        GoOn,
        Again,  // it stands there until the next pull, then it comes to the statement once more
        End,    // the evaluation ends in front of it, without an error
    };
    /// A statement is next, by its index in CodeNames::statements; nothing of it is done. All
    /// blocks of the statements before were asked for if they are pulled one by one.
    virtual Answer comes_to(std::uint32_t statement) = 0;
    /// Whether it has ended the evaluation.
    virtual bool has_ended() const = 0;
};

/// A call that has not returned.
struct RunningCall {
    const sema::FunctionCode* function = nullptr;
    std::uint32_t at = 0;  // the instruction that is next; of one that has called another, the call
    std::uint32_t base = 0;       // of its registers
    std::uint32_t return_to = 0;  // instruction behind its own call; 0: it is the program
};

/// A value as a person reads it, and of how many parts it is made: members of a struct, elements
/// of an array.
struct SeenValue {
    std::string text;  // "not given" if it is not
    const sema::ShownForm* form = nullptr;
    std::int64_t parts = 0;
};

}  // namespace kadr::expand
