#include "driver/cycles.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostics/driver.h"
#include "base/done.h"
#include "base/text.h"
#include "expand/expander.h"
#include "nc/tables.h"

namespace kadr::driver {

namespace {

namespace fs = std::filesystem;

/// Blocks of one cycle call; each bears the source of the call.
class CycleBlocks final : public Stream<nc::Block> {
  public:
    CycleBlocks(const KadrProgram& library, const nc::Dialect& dialect,
                const interp::CycleCall& call, CycleMessages& sink)
        // Only moves: the control's own cycle is what is being executed.
        : expander_(*library.code, dialect, {.limits = {}, .native_cycles = false, .trace = false},
                    sink),
          source_(call.source),
          messages_(sink),
          caller_{std::string(call.name), call.location} {}

    Done start(const interp::CycleCall& call) {
        expand::Expander::Surroundings at{.position = call.position,
                                          .feed = call.feed,
                                          .speed = call.speed,
                                          .spindle = call.spindle,
                                          .x_is_diameter = call.x_is_diameter};
        if (call.shape != nullptr) {
            at.shape = &call.shape->elements;
            at.plane = call.shape->plane;
            at.is_diameter = call.shape->is_diameter;
        }
        messages_.follow(caller_);
        const Done started = expander_.start_cycle(call.name, call.arguments, call.given, at);
        messages_.follow_nobody();
        return started;
    }

    std::size_t pull(std::span<nc::Block> out) override {
        messages_.follow(caller_);
        const std::size_t count = expander_.pull(out);
        messages_.follow_nobody();
        for (nc::Block& block : out.first(count)) block.source = source_;
        return count;
    }

  private:
    expand::Expander expander_;
    SourceId source_;
    CycleMessages& messages_;
    CycleMessages::Caller caller_;
};

const sema::FunctionCode* find_cycle(const KadrProgram& program, std::string_view name) {
    const auto& functions = program.code->functions;
    const auto found = std::ranges::find_if(functions, [name](const auto& function) {
        return function.kind == sema::FunctionKind::Cycle && function.is_main_file &&
               function.name == name;
    });
    return found == functions.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string> cycle_files(const std::string& library, const Files& files) {
    std::vector<std::string> found;
    const fs::path folder = fs::path(library) / "cycles";
    for (const FolderEntry& entry : files.list(folder.string())) {
        const fs::path file = folder / entry.name;
        if (file.extension() == ".kadr") found.push_back(file.string());
    }
    return found;
}

void CycleMessages::take(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::Warning) {
        if (caller_ != nullptr && caller_->location) {
            Diagnostic::Note inside{diagnostic.range, std::move(diagnostic.line),
                                    "inside the cycle `" + caller_->cycle + '`'};
            diagnostic.notes.insert(diagnostic.notes.begin(), std::move(inside));
            diagnostic.line = caller_->location;
            diagnostic.range = {};
        }
        return next_->take(std::move(diagnostic));
    }
    if (!refusal_) refusal_ = diagnostic.message();
}

/// The control's own cycles are looked for first: their names are their own.
const KadrProgram* LibraryCycles::find(std::string_view cycle) {
    if (const auto known = found_.find(cycle); known != found_.end()) return known->second;
    const KadrProgram* found = find_in(files_of_control(), cycle);
    if (found == nullptr) found = find_in(files_that_declare(cycle), cycle);
    found_.emplace(cycle, found);
    return found;
}

const KadrProgram* LibraryCycles::find_in(const std::vector<std::string>& files,
                                          std::string_view cycle) {
    for (const std::string& file : files) {
        auto known = programs_.find(file);
        if (known == programs_.end()) {
            auto program = load_program(session_, file, dialect_.tables().file);
            known = programs_.emplace(file, std::move(program)).first;
        }
        const std::optional<KadrProgram>& program = known->second;
        if (program && find_cycle(*program, cycle) != nullptr) return &*program;
    }
    return nullptr;
}

std::vector<std::string> LibraryCycles::files_of_control() const {
    std::vector<std::string> files;
    for (const nc::CycleInfo& cycle : dialect_.cycles()) {
        const bool is_new = std::ranges::find(files, cycle.file) == files.end();
        if (!cycle.file.empty() && is_new) files.push_back(cycle.file);
    }
    return files;
}

/// Reading a file takes a thousandth of checking it with all that it imports.
std::vector<std::string> LibraryCycles::files_that_declare(std::string_view cycle) const {
    std::vector<std::string> files = cycle_files(session_.share().library, session_.files());
    const std::string declaration = "\ncycle " + std::string(cycle) + '(';
    std::erase_if(files, [&](const std::string& file) {
        const auto text = session_.files().read(file);
        return ('\n' + (text ? *text : std::string())).find(declaration) == std::string::npos;
    });
    return files;
}

/// A cycle that counts X as a diameter turns.
bool LibraryCycles::turns(std::string_view cycle) {
    const KadrProgram* const library = find(cycle);
    if (library == nullptr) return false;
    const std::vector<nc::Function>& needs = find_cycle(*library, cycle)->needs;
    return std::ranges::find(needs, nc::Function::DiameterOn) != needs.end();
}

std::unique_ptr<Stream<nc::Block>> LibraryCycles::expand(const interp::CycleCall& call) {
    const KadrProgram* library = find(call.name);
    if (library == nullptr) {
        sink_->report(diag::CycleUnknown).arg(call.name);
        return nullptr;
    }
    messages_.forget();
    auto blocks = std::make_unique<CycleBlocks>(*library, dialect_, call, messages_);
    if (!blocks->start(call)) return nullptr;
    return blocks;
}

}  // namespace kadr::driver
