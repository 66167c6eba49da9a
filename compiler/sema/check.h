// check.h — Ast → Code: names, types, dimensions.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/done.h"
#include "base/file_access.h"
#include "nc/dialect.h"
#include "sema/checked.h"
#include "sema/code.h"
#include "syntax/ast.h"

namespace kadr::machine {
struct ToolLibrary;
}

namespace kadr::sema {

/// How the checker reaches imported files; the driver wires it (search path, parser).
class ModuleLoader {
  public:
    struct Module {
        const syntax::Ast* ast = nullptr;      // lives as long as the loader
        const nc::Dialect* dialect = nullptr;  // input dialect of the file
    };
    virtual ~ModuleLoader() = default;
    /// `cycles.drilling` (or a file name, if is_file) as seen from the file `from`. Null ast: not
    /// found or not parsed; the loader has reported it at `location`. The same file is loaded once.
    virtual Module load(std::string_view import, bool is_file, FileId from,
                        const SourceRange& location) = 0;
    /// The tool library in a file, `tools.csv`, as seen from the file `from`, for
    /// CheckOptions::tools. Not done: it cannot be read or has mistakes, which has been reported.
    virtual Done load_tools(std::string_view /*file*/, FileId /*from*/,
                            const SourceRange& /*location*/) {
        return kFailed;
    }
    /// The module of the library that declares this function or cycle, as an import names it; for
    /// messages. Nothing: none does, or there is no library.
    virtual std::optional<std::string> library_module_of(std::string_view /*function*/) {
        return std::nullopt;
    }
    /// The library's cycle for a word of some control (`G83`, `CYCLE81`); for messages.
    struct ControlCycle {
        std::string function;  // "drill_peck"
        std::string module;    // "cycles.drilling"
        std::string dialect;   // "fanuc"
    };
    virtual std::optional<ControlCycle> cycle_of_control(std::string_view /*word*/) {
        return std::nullopt;
    }
    /// The command for a word of some control that begins no cycle (`G68`); for messages.
    struct ControlCommand {
        std::string function;  // "rotate"; empty: the word calls a subprogram (`M98`, `G65`)
        std::string dialect;   // "fanuc"
    };
    virtual std::optional<ControlCommand> command_of_control(std::string_view /*word*/) {
        return std::nullopt;
    }
};

/// A value for a parameter of the program, from the command line: `width=100mm`.
struct Define {
    std::string name;
    std::string value;
};

inline constexpr std::uint32_t kNothingShown = 0xffffffffu;

/// What a prompt may do and a program may not.
struct CheckOptions {
    /// An expression that is a statement of the main file and begins at this byte or later shows
    /// its value (Op::Show).
    std::uint32_t shown_from = kNothingShown;
    /// The program of the main file that may call others as if they were cycles.
    std::string_view calls_programs;
    /// Knows which tables and images may be read; null: none.
    FileAccess* access = nullptr;
    /// Whether the command has no time left; then there is no code, and whoever asked reports why.
    std::function<bool()> is_over = {};
    bool keeps_names = false;  // Code::names is filled
    /// The tools that `tool("MILL_10")` means; asked when one is met. Empty, null: none are named.
    std::function<const machine::ToolLibrary*()> tools = {};
};

struct CheckResult {
    std::unique_ptr<Code> code;  // null: there was an error
    Checked checked;             // as far as the check came; the trees live in the loader
};

/// Checks the file and everything it imports. Mistakes are reported, all of them.
CheckResult check(const syntax::Ast& main, const nc::Dialect& dialect, ModuleLoader& modules,
                  const Sources& sources, DiagnosticSink& sink, const CheckOptions& options = {});

}  // namespace kadr::sema
