// test_bench.h — what a test asks of the world: to have a call executed, and to measure it.
//
// The evaluator sees nothing but blocks. Writing, reading, interpreting and planning them is
// further up the road, so the driver brings a bench, and the running test asks it through here.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/done.h"
#include "sema/code.h"

namespace kadr::expand {

class Heap;

/// A call with its arguments, frozen where the test stands. Valid until the bench returns.
struct CallUnderTest {
    const sema::TestCall* call = nullptr;
    std::uint32_t at = 0;  // its instruction
    const sema::Slot* options = nullptr;
    const sema::Slot* arguments = nullptr;
    const Heap* heap = nullptr;  // where their texts and arrays are
    SourceRange range;
    std::optional<std::string> text;  // the dialect or the code, if one is given
};

/// What is known of a figure; the one that its result needs holds.
struct FigureAnswer {
    std::int64_t count = 0;           // Count, Truth
    std::array<double, 3> numbers{};  // Length, Time, Point; NaN: there is none
    std::string text;
    std::vector<double> list;  // Counts, Lengths
    /// Why the answer is no, or not none: what a reader of the failed test wants to know.
    std::string reason;
    SourceId reason_at;
};

class TestBench {
  public:
    virtual ~TestBench() = default;

    /// Executes the call: the number under which `ask` knows it. Nothing: it failed, which has been
    /// reported and ends the test.
    virtual std::optional<std::int64_t> execute(const CallUnderTest& call) = 0;
    /// The call as ISO-7bit text. Nothing: as for `execute`.
    virtual std::optional<std::string> write(const CallUnderTest& call) = 0;
    /// The call ends with the error or alarm that `text` names.
    virtual Done require_error(const CallUnderTest& call) = 0;

    virtual FigureAnswer ask(std::int64_t execution, sema::Figure figure,
                             std::span<const sema::Slot> arguments) = 0;

    /// Name of the dialect under test, and of all that the tests are run for.
    virtual std::string dialect() const = 0;
    virtual std::vector<std::string> dialects() const = 0;
};

}  // namespace kadr::expand
