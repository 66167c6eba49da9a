#include "tests/fuzz/world.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <utility>

#include "base/diagnostics/driver.h"
#include "base/render.h"
#include "interp/interpreter.h"
#include "macro/program.h"
#include "motion/pipeline.h"

namespace kadr::fuzz {

namespace {

namespace fs = std::filesystem;

const std::string kRoot = KADR_ROOT;
constexpr std::size_t kPieceBytes = 7;
constexpr std::uint64_t kExecutedBlocks = 200;
constexpr int kSampledBatches = 8;

/// `cycles/drilling.kadr` → `cycles.drilling`.
std::string module_name(const fs::path& file) {
    std::string name = fs::relative(file, kRoot + "/stdlib").replace_extension().string();
    for (char& c : name) c = c == '/' ? '.' : c;
    return name;
}

class Pieces final : public nc::TextSource {
  public:
    explicit Pieces(std::string_view text) : rest_(text) {}
    std::string_view next() override {
        const std::string_view piece = rest_.substr(0, kPieceBytes);
        rest_.remove_prefix(piece.size());
        return piece;
    }

  private:
    std::string_view rest_;
};

/// By their numbers in front of a text. Inputs that were kept count on them: new ones come last.
constexpr const char* kControls[] = {"iso",
                                     "sinumerik",
                                     "fanuc",
                                     "axioma",
                                     "fanuc-lathe",
                                     "fanuc-lathe-b",
                                     "fanuc-lathe-c",
                                     "haas",
                                     "heidenhain-iso",
                                     "fanuc-calculator",
                                     "fanuc-lathe-calculator",
                                     "fanuc-commons",
                                     "haas-lathe",
                                     "nc210"};

/// Every dialect file of the house has a number.
void check_controls(const fs::path& folder) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".xml") continue;
        const std::string name = entry.path().stem().string();
        if (std::find(std::begin(kControls), std::end(kControls), name) == std::end(kControls))
            broken("every dialect of the house has a number", name);
    }
}

}  // namespace

World::World() {
    DiagnosticList messages;
    const std::vector<std::string> folders = {kRoot + "/dialects", kRoot + "/examples/dialects"};
    for (const std::string& folder : folders) check_controls(folder);
    for (const char* name : kControls) {
        auto loaded = nc::load_dialect(name, folders, sources, messages);
        if (!loaded) broken("the dialects of the house load", name);
        controls.push_back(&dialects.emplace(name, std::move(*loaded)).first->second);
    }
    for (const char* name : {"en", "ru", "uk", "pl"}) {
        auto loaded =
            syntax::load_keywords(name, {kRoot + "/dialects/languages"}, sources, messages);
        if (!loaded) broken("the languages of the house load", name);
        languages.emplace(name, std::move(*loaded));
    }
    for (machine::Machine* const machine : {&mill, &lathe}) {
        const char* const name = machine == &mill ? "mill" : "lathe";
        auto loaded = machine::load_machine(name, {kRoot + "/runtime/machines"}, sources, messages);
        if (!loaded) broken("the machines of the house load", name);
        *machine = std::move(*loaded);
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot + "/stdlib")) {
        if (entry.path().extension() != ".kadr") continue;
        const FileId file = *sources.read(entry.path().string());
        library.emplace(module_name(entry.path()), syntax::parse(sources, file, languages.at("en"),
                                                                 dialects.at("iso"), messages));
    }
    if (messages.has_errors()) {
        broken("the standard library parses", messages.all().front().message());
    }
}

const nc::Dialect& World::dialect_for(std::string_view source) const {
    const auto found = dialects.find(syntax::scan_header(source).dialect);
    return found == dialects.end() ? dialects.at("iso") : found->second;
}

const syntax::KeywordTable& World::keywords_for(std::string_view source) const {
    const auto found = languages.find(syntax::scan_header(source).language);
    return found == languages.end() ? languages.at("en") : found->second;
}

const machine::Machine& World::machine_for(const nc::Dialect& dialect) const {
    const bool is_lathe = dialect.power_on(nc::Group::Diameter) == nc::Function::DiameterOn;
    return is_lathe ? lathe : mill;
}

const World& world() {
    static const World loaded;
    return loaded;
}

sema::ModuleLoader::Module LibraryOnly::load(std::string_view import, bool, FileId,
                                             const SourceRange& place) {
    const auto found = world().library.find(import);
    if (found != world().library.end()) return {&found->second, &world().dialects.at("iso")};
    sink_.report(diag::ModuleMissing, place).arg(import);
    return {};
}

std::unique_ptr<Checked> parse(std::string_view source) {
    auto checked = std::make_unique<Checked>();
    checked->sources = world().sources;
    const FileId file = checked->sources.add("fuzz.kadr", std::string(source));
    const std::string_view text = checked->sources.text(file);
    checked->ast = syntax::parse(checked->sources, file, world().keywords_for(text),
                                 world().dialect_for(text), checked->messages);
    return checked;
}

std::unique_ptr<Checked> check(std::string_view source) {
    auto checked = parse(source);
    if (checked->messages.has_errors()) return checked;
    LibraryOnly modules(checked->messages);
    const std::string_view text = checked->sources.text(checked->ast.file);
    checked->code = sema::check(checked->ast, world().dialect_for(text), modules, checked->sources,
                                checked->messages)
                        .code;
    return checked;
}

expand::RunLimits small_limits() {
    return {.call_depth = 200, .loop_turns = 5000, .blocks = 500, .array_elements = 5000};
}

void execute(const nc::Dialect& dialect, std::string_view text) {
    DiagnosticList messages;
    Pieces pieces(text);
    macro::ProgramOptions program_options;
    program_options.max_turns = 2000;
    program_options.max_repeated = kExecutedBlocks;
    macro::NcProgram program(dialect, pieces, "fuzz", program_options, messages);
    interp::InterpreterOptions options;
    options.max_blocks = kExecutedBlocks;
    const machine::Machine& machine = world().machine_for(dialect);
    interp::Interpreter interpreter(dialect, machine, program, &program, nullptr, options,
                                    messages);
    program.follow(interpreter);
    motion::Planner planner(interpreter, machine, {}, messages);
    motion::Sampler sampler(planner, machine, 0.01);
    std::vector<motion::Setpoint> setpoints(256);
    for (int i = 0; i < kSampledBatches && sampler.pull(setpoints) != 0; ++i) {
    }
    show(messages, world().sources);
}

std::string complaint_about(const nc::Dialect& dialect, std::string_view text) {
    DiagnosticList messages;
    Pieces pieces(text);
    nc::Reader reader(dialect, pieces, "fuzz", messages);
    std::vector<nc::Block> blocks(64);
    while (reader.pull(blocks) != 0) {
    }
    return messages.all().empty() ? "" : render_text(messages.all().front(), world().sources);
}

void show(const DiagnosticList& messages, const Sources& sources) {
    for (const Diagnostic& message : messages.all()) {
        if (render_text(message, sources).empty() || render_json(message, sources).empty()) {
            broken("every message has words", message.row->code);
        }
    }
}

void broken(std::string_view promise, std::string_view details) {
    std::fprintf(stderr, "broken promise: %.*s\n%.*s\n", static_cast<int>(promise.size()),
                 promise.data(), static_cast<int>(details.size()), details.data());
    std::abort();
}

}  // namespace kadr::fuzz

/// Loads the world before the first input, whose time is then its own.
extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*arguments*/) {
    (void)kadr::fuzz::world();
    return 0;
}
