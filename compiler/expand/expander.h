// expander.h — runs Code and yields Blocks.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/diagnostic.h"
#include "base/done.h"
#include "base/stream.h"
#include "expand/statement_watch.h"
#include "expand/test_bench.h"
#include "nc/block.h"
#include "path/command.h"
#include "path/contour.h"
#include "sema/check.h"
#include "sema/code.h"

namespace kadr::machine {
struct Machine;
struct Chain;
}  // namespace kadr::machine

namespace kadr {
class FileAccess;
}  // namespace kadr

namespace kadr::expand {

struct RunLimits {
    std::uint32_t call_depth = 1000;
    std::uint64_t loop_turns = 1'000'000'000;  // of all loops together, calls counted like turns
    std::uint64_t blocks = 100'000'000;
    std::uint64_t array_elements = 50'000'000;
    std::uint64_t heap_bytes = std::uint64_t{1} << 30;  // of all texts and arrays
    double seconds = 0;  // of computing, counted from the expander's making; 0: no limit
};

/// One frame of the call stack behind a block, for messages and the source map.
struct SourceCall {
    SourceRange range;          // of the call
    std::string_view function;  // called
    std::size_t loops = 0;      // around the call, of Trace::loop_counts
};

/// How the block that was yielded last came to be.
struct BlockOrigin {
    SourceRange statement;
    std::vector<SourceCall> calls;           // outermost first
    std::vector<std::uint64_t> loop_counts;  // of the loops around the statement, outermost first
};

struct ExpandOptions {
    RunLimits limits;
    bool native_cycles = true;   // a call of a mapped cycle stays one block
    bool trace = false;          // keep a Trace for every block of the batch
    bool warns_of_cuts = false;  // without feed or tool, spindle off; of dives
    /// The machine for which tilted planes are worked out where the target has no words for them;
    /// asked when one is met, null if it cannot be loaded.
    std::function<const machine::Machine*()> machine = nullptr;
    bool checks_cutters = true;  // that a call names the cutter that this machine has
    /// Whether the source allows this warning at this location; empty: nothing is allowed.
    std::function<bool(const DiagnosticRow&, const SourceRange&)> is_allowed = nullptr;
    std::vector<nc::Refusal>* refusals = nullptr;  // gets forms of cycles that do not fit a call
    const std::atomic<bool>* stop = nullptr;  // set from outside: the evaluation ends with an error
    FileAccess* access = nullptr;  // knows which tables and images may be read; null: none
    std::vector<std::string>* shown = nullptr;  // gets the values that the code shows; null: nobody
    StatementWatch* watch =
        nullptr;  // is shown every statement, if the code has names; with `trace`
};

struct ModalState;
struct Running;

/// Evaluates a program, batch by batch. Errors while it runs are reported with the call stack and
/// end the stream.
class Expander final : public Stream<nc::Block> {
  public:
    /// code and sink outlive the expander. `target` is asked which cycles are native.
    Expander(const sema::Code& code, const nc::Dialect& target, const ExpandOptions& options,
             DiagnosticSink& sink);
    ~Expander() override;

    /// Chooses the program and sets its parameters (checked, with units).
    Done start(std::string_view program, const std::vector<sema::Define>& defines);
    /// What a cycle finds where it is called; values as in a Block.
    struct Surroundings {
        AxisValues position{};
        double feed = 0;                                      // mm/min; 0: none is set
        double speed = 0;                                     // rpm; 0: none is set
        path::SpindleMode spindle = path::SpindleMode::Stop;  // Cw and Ccw: it turns
        const path::Contour* shape = nullptr;  // for a parameter that is a contour, …
        path::Plane plane = path::Plane::Zx;   // its plane,
        bool is_diameter = false;              // and whether X of its points is a diameter
        bool x_is_diameter = true;             // X of the position; else the cycle sets it
    };
    /// Starts a cycle by name with arguments as the interpreter has them (mm, deg, s). A contour
    /// stands for all that its argument has more of them: the numbers of its first and last block,
    /// or its name.
    Done start_cycle(std::string_view cycle, std::span<const double> arguments, std::uint32_t given,
                     const Surroundings& at);

    /// Starts a test or a property of the code with the values of its parameters, in the order of
    /// its registers. It makes no blocks unless it is wrong. `bench` outlives the expander.
    void start_test(std::uint32_t function, std::span<const sema::Slot> values, TestBench& bench);
    /// The values of a property's parameters as the command line has them. Nothing: reported.
    std::optional<std::vector<sema::Slot>> read_values(std::uint32_t function,
                                                       const std::vector<sema::Define>& defines);
    /// Starts the call that a test has executed, as a program of its own: globals are fresh. A
    /// cycle or a function begins with the spindle on, a feed set, at a position that a test
    /// names.
    void start_call(const CallUnderTest& call);

    /// Warns of cuts that the interpreter would warn of, for whom only makes the text.
    void warn_of_cuts(decltype(ExpandOptions::is_allowed) is_allowed);

    std::size_t pull(std::span<nc::Block> out) override;
    /// An error ended the program; of a test: something did not hold.
    bool failed() const;
    /// The values of a property are not among those that it assumes.
    bool rejected() const;
    /// What is known of the control behind the block that was yielded last; null while blocks wait
    /// that were made together with it.
    const ModalState* known() const;
    /// Of block `i` of the latest batch, if ExpandOptions::trace.
    const BlockOrigin& trace(std::size_t i) const;

    /// Behind a pull that gave no block: the watch wants it to go on.
    bool is_waiting() const;

    // For ExpandOptions::watch, while it is shown a statement, and between blocks.
    /// The calls that have not returned, outermost first.
    std::vector<RunningCall> running_calls() const;
    /// The value of a variable of a call (globals: of any), or by `path` of a part of it: an index
    /// of a member or an element at each level.
    SeenValue see(const RunningCall& call, const sema::NamedVariable& variable,
                  std::span<const std::uint32_t> path) const;

  private:
    std::unique_ptr<Running> run_;
};

}  // namespace kadr::expand
