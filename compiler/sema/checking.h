// checking.h — one check at work: what it is given, what it makes, and who owns which state of it.
//
// The functions that check take a Check first and stand by subject: check.cpp (the road through a
// program), declarations.h (files and their names), type_declarations.h, functions.h, globals.h;
// scope.h and unknown_names.h; expressions.h, values.h, convert.h (units and dimensions),
// operators.h, conditions.h, optionals.h, composites.h, lvalues.h, texts.h, origins.h; calls.h,
// builtin_calls.h; statements.h, loops.h, with.h, preserves.h; blocks.h (NC blocks),
// cycle_blocks.h, native_cycles.h, orienting.h, contours.h, curves.h; tests.h. For the room sema
// only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/done.h"
#include "sema/check.h"
#include "sema/code.h"
#include "sema/declared_names.h"
#include "sema/emitter.h"
#include "sema/names.h"
#include "sema/recorder.h"
#include "sema/scopes.h"
#include "sema/types.h"

namespace kadr::sema {

/// Something that can be read, assigned, referred to: a variable, a member, an element.
struct Lvalue {
    enum class Storage : std::uint8_t { Local, Global, Reference, Element };
    Storage storage = Storage::Local;
    Type type;
    Reg reg = 0;               // Local; Reference: the register that refers; Element: the array
    Reg index = 0;             // Element
    std::uint32_t offset = 0;  // Global: its register; Reference, Element: slots further
    std::uint16_t stride = 1;  // Element: slots of a whole element
    bool is_const = false;
    bool is_temporary = false;  // part of a value that nobody else sees
    bool is_contour_part = false;
    bool may_be_unset = false;
    std::int32_t symbol = -1;  // local symbol, if this is a whole local variable
    std::string_view root;     // name of the variable, for messages
    SourceRange root_range;    // where it was declared
};

/// How a statement ends: what stands behind it is reached, or not (`return`, `break`).
enum class Completion : std::uint8_t { Normal, Abrupt };
constexpr Completion completion(bool is_normal) {
    return is_normal ? Completion::Normal : Completion::Abrupt;
}

/// What stands behind the words of a block: a point to which it goes, and how the tool stands.
struct BehindWords {
    syntax::ExprId point;
    syntax::ExprId orient;
};

/// Counts errors on their way to the caller's sink.
class CheckSink final : public DiagnosticSink {
  public:
    explicit CheckSink(DiagnosticSink& next) : next_(next) {}
    void take(Diagnostic diagnostic) override {
        if (is_quiet) return;
        if (diagnostic.severity != Severity::Warning) ++errors;
        next_.take(std::move(diagnostic));
    }
    std::size_t errors = 0;
    bool is_quiet = false;

  private:
    DiagnosticSink& next_;
};

struct LoopScope {
    Label* on_break = nullptr;
    Label* on_continue = nullptr;  // null: a switch
    std::size_t with_depth = 0;
};

/// Where the check is.
struct Location {
    std::uint32_t module = 0;
    Units units = Units::Metric;
    bool is_startup = false;                 // the globals get their values
    const FunctionDecl* function = nullptr;  // whose body it is; null: of no function
    std::vector<LoopScope> loops;            // around, innermost last
    std::size_t with_depth = 0;
    int loop_depth = 0;
    int contour_depth = 0;        // bodies of contours around
    syntax::StmtId block;         // the statement whose blocks are being planned
    std::uint32_t statement = 0;  // SourceId of the statement
    SourceRange target;           // the point behind words that is being looked at
    std::string_view declared;    // name of the variable whose value is being calculated
};

/// What holds for the body that is being checked.
struct BodyState {
    static constexpr std::size_t kNoDefault = ~std::size_t{0};

    bool has_preserves = false;
    std::size_t defaults_from = kNoDefault;  // the parameter whose default is being checked
    std::optional<nc::CycleId> native;       // the control's cycle that it is the body of
    bool native_pending = false;             // the body's checks are still being emitted
    Reg for_limit = kNoReg;                  // register of the constant that ends a `for`
    bool last_unset = false;                 // what was read unchecked last may be without a value
};

/// Constants of the code by what they are, so that each stands in it once.
struct Pools {
    std::unordered_map<std::uint64_t, Type> known_types;  // of expressions, by file and index
    std::unordered_map<std::string, std::uint32_t> texts;
    std::unordered_map<std::string, std::uint32_t> plans;
    std::unordered_map<std::uint32_t, std::uint32_t> layouts;  // by type
    std::unordered_map<std::uint32_t, std::uint32_t> showns;   // by type, parts and inches apart
};

/// What is reported once, or only in the end.
struct Reported {
    struct Unused {
        SourceRange range;
        std::string_view name;
    };
    std::vector<Unused> unused;   // local variables
    SourceRange ambiguous;        // name that was reported last
    SourceRange unit;             // apart from its number, reported last
    std::uint32_t proposals = 0;  // that were looked for in the library
    bool no_tools = false;        // that no tool library is named
};

/// Whether there is time left; asked now and then.
struct Clock {
    std::uint32_t looked = 0;  // statements ago
    bool is_late = false;
};

struct Check {
    Check(ModuleLoader& modules, const Sources& all_sources, DiagnosticSink& messages,
          const CheckOptions& chosen);

    ModuleLoader& loader;
    const Sources& sources;
    CheckSink sink;
    const CheckOptions options;

    std::unique_ptr<Code> code;
    Emitter emit;
    Pools pools;
    Checked checked;
    TypeTable& types = checked.types;
    Recorder record{checked};

    DeclaredNames names;
    Scopes scopes;
    Location here;
    BodyState body;
    Reported told;
    Clock clock;
    std::vector<Type> open_structs;
    std::uint32_t asked_figures = 0;  // of those that are functions

    const syntax::Ast& ast() const { return *names.module(here.module).ast; }
    const nc::Dialect& dialect() const { return *names.module(here.module).dialect; }
    std::string_view text(syntax::TextId id) const { return ast().text(id); }
    Units units() const { return here.units; }
    DiagnosticBuilder report(const DiagnosticRow& row, const SourceRange& range) {
        return sink.report(row, range);
    }
    std::string type_name(Type type) const { return types.name(type); }
    const TypeInfo& type_info(Type type) const { return types[type]; }
    TypeKind kind(Type type) const { return types[type].kind; }
    bool is_error(const Value& value) const { return kind(value.type) == TypeKind::Error; }
    bool is_contour(Type type) const { return type_info(type).is_contour; }
    bool is_optional_type(const syntax::Decl& decl) const {
        return decl.type.is_valid() && ast()[decl.type].is_optional;
    }
};

/// While it lives, what is checked is only tried: nothing is reported or recorded.
class DryRun {
  public:
    explicit DryRun(Check& check)
        : sink_(check.sink),
          was_quiet_(std::exchange(sink_.is_quiet, true)),
          dry_run_(check.record) {}
    DryRun(const DryRun&) = delete;
    DryRun& operator=(const DryRun&) = delete;
    ~DryRun() { sink_.is_quiet = was_quiet_; }

  private:
    CheckSink& sink_;
    bool was_quiet_;
    Recorder::DryRun dry_run_;
};

/// While it lives, mistakes count, whoever tries something around it.
class Finding {
  public:
    explicit Finding(Check& check)
        : sink_(check.sink),
          was_quiet_(std::exchange(sink_.is_quiet, check.clock.is_late)),
          finding_(check.record) {}
    Finding(const Finding&) = delete;
    Finding& operator=(const Finding&) = delete;
    ~Finding() { sink_.is_quiet = was_quiet_; }

  private:
    CheckSink& sink_;
    bool was_quiet_;
    Recorder::Finding finding_;
};

/// Looks at the clock now and then: once the time is over, nothing is reported any more.
void look_at_clock(Check& check);

/// In backticks, as code stands in messages.
std::string quoted(std::string_view text);
/// An operator as it is written, without the `=` of a compound assignment.
std::string_view spelling(syntax::Operator op);

}  // namespace kadr::sema
