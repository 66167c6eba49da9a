#include "driver/test.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/driver.h"
#include "base/diagnostics/expand.h"
#include "base/diagnostics/test.h"
#include "base/done.h"
#include "base/text.h"
#include "driver/bench.h"
#include "driver/execution.h"
#include "driver/output.h"
#include "driver/program.h"
#include "driver/property_values.h"
#include "expand/expander.h"

namespace kadr::driver {

namespace {

using sema::FunctionCode;
using sema::FunctionKind;

/// The controls for which tests are run if nobody names one: a program is written for all of them.
constexpr std::array<const char*, 3> kControls = {"sinumerik", "fanuc", "axioma"};

/// Sets of values that may be thrown away for each one that is tried.
constexpr std::uint64_t kMostRejected = 20;
constexpr int kMostSimpler = 500;  // tries to make a failing set simpler

enum class TestOutcome : std::uint8_t { Holds, Fails, Rejected };

/// What one test reported under one control.
struct Verdict {
    std::string dialect;
    std::vector<Diagnostic> messages;
};

std::string signature(const Diagnostic& diagnostic) {
    std::string text(diagnostic.row->code);
    text += '|' + std::to_string(diagnostic.range.file.index) + '|' +
            std::to_string(diagnostic.range.begin) + '|' + diagnostic.message();
    if (diagnostic.line)
        text += '|' + diagnostic.line->file + '|' + std::to_string(diagnostic.line->line);
    return text;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
    return all;
}

/// For a shell: in quotes that nothing in it can end.
std::string shell_word(const std::string& word) {
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

class TestRun {
  public:
    TestRun(Session& session, const TestJob& job) : session_(session), job_(job) {}
    Status perform();

  private:
    void run_file(const std::string& source);
    void run_test(const KadrProgram& program, std::uint32_t index);
    TestOutcome run_once(std::uint32_t index, const std::vector<sema::Slot>& values,
                         const std::string& dialect, DiagnosticList& messages);
    void run_property(std::uint32_t index, const std::string& dialect, DiagnosticList& messages);
    void run_given(std::uint32_t index, const std::string& dialect, DiagnosticList& messages);
    Diagnostic counterexample(std::uint32_t index, const PropertyValues& values,
                              const PropertyValues::Set& set, const Diagnostic& first) const;
    Done require_known_defines(const FunctionCode& property);
    void report(const FunctionCode& function, const std::vector<Verdict>& verdicts);
    bool is_chosen(const FunctionCode& function) const;

    Session& session_;
    const TestJob& job_;
    std::vector<std::string> dialects_;
    CycleShelf cycles_;
    const KadrProgram* program_ = nullptr;
    std::string source_;
    std::unique_ptr<Bench> bench_;
    std::string lines_;
    std::size_t run_ = 0;
    std::size_t failed_ = 0;
};

bool TestRun::is_chosen(const FunctionCode& function) const {
    const bool is_property = function.kind == FunctionKind::Property;
    const bool is_test = function.kind == FunctionKind::Test;
    // Values from the command line are for a property.
    const bool is_wanted =
        session_.options().defines.empty() ? is_test || is_property : is_property;
    return is_wanted && function.name.find(job_.filter) != std::string::npos;
}

TestOutcome TestRun::run_once(std::uint32_t index, const std::vector<sema::Slot>& values,
                              const std::string& dialect, DiagnosticList& messages) {
    const nc::Dialect* target = session_.dialect(dialect, {});
    if (target == nullptr) return TestOutcome::Fails;
    bench_->begin(dialect, messages);
    const sema::Code& code = *program_->code;
    expand::Expander expander(code, *target, {}, messages);
    expander.start_test(index, values, *bench_);
    std::array<nc::Block, 1> block;
    if (expander.pull(block) > 0) {
        const bool has_place =
            block[0].source.is_valid() && block[0].source.index < code.statements.size();
        messages
            .report(diag::TestBlocks, has_place ? code.statements[block[0].source.index]
                                                : code.functions[index].range)
            .arg(code.functions[index].kind == FunctionKind::Test ? "test" : "property")
            .note(code.functions[index].range, "of this")
            .fix("execute what makes it: `execute(…)`");
        return TestOutcome::Fails;
    }
    if (expander.rejected()) return TestOutcome::Rejected;
    return expander.failed() || messages.has_errors() ? TestOutcome::Fails : TestOutcome::Holds;
}

/// What a failed property reports: the message, the values, and how to see it again.
Diagnostic TestRun::counterexample(std::uint32_t index, const PropertyValues& values,
                                   const PropertyValues::Set& set, const Diagnostic& first) const {
    const std::string& name = program_->code->functions[index].name;
    const std::vector<std::string> words = values.words(set);
    Diagnostic diagnostic = first;
    diagnostic.notes.push_back({program_->code->functions[index].range, std::nullopt,
                                "found with " + joined(words, ", ")});
    std::string again = "kadr test " + source_ + " --filter " + shell_word(name);
    for (const std::string& word : words) again += " -D " + word;
    diagnostic.notes.push_back({{}, std::nullopt, "again: " + again});
    return diagnostic;
}

void TestRun::run_property(std::uint32_t index, const std::string& dialect,
                           DiagnosticList& messages) {
    const FunctionCode& property = program_->code->functions[index];
    const PropertyValues values(*program_->code, property);
    // Each property has numbers of its own, so that a new one before it does not change them.
    std::uint64_t seed = job_.seed;
    for (const char c : property.name)
        seed = (seed ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    Dice dice(seed);
    std::uint64_t tried = 0;
    std::uint64_t chosen = 0;
    bool was_asked = false;
    while (tried < job_.runs && chosen < job_.runs * kMostRejected) {
        PropertyValues::Set set = values.choose(chosen++, dice);
        DiagnosticList first;
        const TestOutcome outcome = run_once(index, values.slots(set), dialect, first);
        was_asked = was_asked || bench_->was_asked();
        if (outcome == TestOutcome::Rejected) continue;
        ++tried;
        if (outcome == TestOutcome::Holds) continue;
        std::vector<Diagnostic> found = first.all();
        int tries = 0;
        for (bool is_simpler = true; is_simpler && tries < kMostSimpler;) {
            is_simpler = false;
            for (const PropertyValues::Set& other : values.simpler(set)) {
                if (++tries > kMostSimpler) break;
                DiagnosticList again;
                if (run_once(index, values.slots(other), dialect, again) != TestOutcome::Fails)
                    continue;
                set = other;
                found = again.all();
                is_simpler = true;
                break;
            }
        }
        for (const Diagnostic& diagnostic : found)
            messages.take(counterexample(index, values, set, diagnostic));
        return;
    }
    if (tried < job_.runs) {
        messages.report(diag::PropertyStarved, property.range)
            .arg(static_cast<std::int64_t>(tried))
            .arg(static_cast<std::int64_t>(chosen));
    }
}

Done TestRun::require_known_defines(const FunctionCode& property) {
    Done known = kDone;
    for (const sema::Define& define : session_.options().defines) {
        const auto& parameters = property.parameters;
        const bool is_known =
            std::any_of(parameters.begin(), parameters.end(),
                        [&](const auto& parameter) { return parameter.name == define.name; });
        if (is_known) continue;
        session_.messages()
            .report(diag::DefineUnknown)
            .arg(property.name)
            .arg(define.name)
            .note(property.range, "the property is declared here");
        known = kFailed;
    }
    return known;
}

/// One set of values, from the command line.
void TestRun::run_given(std::uint32_t index, const std::string& dialect, DiagnosticList& messages) {
    const nc::Dialect* target = session_.dialect(dialect, {});
    if (target == nullptr) return;
    expand::Expander reader(*program_->code, *target, {}, messages);
    const auto values = reader.read_values(index, session_.options().defines);
    if (!values) return;
    if (run_once(index, *values, dialect, messages) == TestOutcome::Rejected) {
        messages.report(diag::PropertyStarved, program_->code->functions[index].range)
            .arg(0)
            .arg(1);
    }
}

void TestRun::report(const FunctionCode& function, const std::vector<Verdict>& verdicts) {
    // The same words under several controls are reported once.
    struct SharedMessage {
        Diagnostic diagnostic;
        std::string signature;
        std::vector<std::string> dialects;
    };
    std::vector<SharedMessage> all;
    for (const Verdict& verdict : verdicts) {
        for (const Diagnostic& diagnostic : verdict.messages) {
            const std::string words = signature(diagnostic);
            const auto known =
                std::find_if(all.begin(), all.end(),
                             [&](const SharedMessage& other) { return other.signature == words; });
            if (known == all.end()) all.push_back({diagnostic, words, {verdict.dialect}});
            else if (known->dialects.back() != verdict.dialect)
                known->dialects.push_back(verdict.dialect);
        }
    }
    const auto is_error = [](const SharedMessage& said) {
        return said.diagnostic.severity != Severity::Warning;
    };
    const auto first = std::find_if(all.begin(), all.end(), is_error);
    ++run_;
    if (first == all.end()) {
        lines_ += "ok      " + function.name + '\n';
    } else {
        ++failed_;
        const Diagnostic& diagnostic = first->diagnostic;
        std::string text;
        if (diagnostic.line) {
            text = diagnostic.line->file + ':' + std::to_string(diagnostic.line->line);
        } else if (diagnostic.range.file.is_valid()) {
            text = session_.source_name(diagnostic.range);
        }
        lines_ += "failed  " + function.name + ": " + text + ": " + diagnostic.message();
        if (first->dialects.size() < verdicts.size())
            lines_ += " (" + joined(first->dialects, ", ") + ")";
        lines_ += '\n';
    }
    for (SharedMessage& said : all) {
        if (said.dialects.size() < verdicts.size()) {
            said.diagnostic.notes.push_back(
                {{}, std::nullopt, "only under " + joined(said.dialects, ", ")});
        }
        session_.messages().take(std::move(said.diagnostic));
    }
}

void TestRun::run_test(const KadrProgram& program, std::uint32_t index) {
    const FunctionCode& function = program.code->functions[index];
    const bool has_values = !session_.options().defines.empty();
    if (has_values && !require_known_defines(function)) return;
    std::vector<Verdict> verdicts;
    for (const std::string& dialect : dialects_) {
        DiagnosticList messages;
        bool depends = true;
        if (function.kind == FunctionKind::Test) {
            run_once(index, {}, dialect, messages);
            depends = bench_->was_asked();
        } else if (has_values) {
            run_given(index, dialect, messages);
        } else {
            run_property(index, dialect, messages);
            depends = bench_->was_asked();
        }
        verdicts.push_back({dialect, messages.all()});
        if (!depends) break;  // plain arithmetic is the same for all
    }
    report(function, verdicts);
}

void TestRun::run_file(const std::string& source) {
    const std::unique_ptr<FileText> text = open_source(session_, source);
    if (!text) return;
    if (!is_kadr_source(source, *text)) {
        session_.messages()
            .report(diag::TestsInText)
            .arg(source)
            .fix(
                "what is text of a control already is executed with `kadr run`, examined with "
                "`kadr check`");
        session_.mark_usage();
        ++failed_;
        return;
    }
    const std::optional<KadrProgram> program =
        load_program(session_, keep_source(session_, source, *text));
    if (!program) {
        ++failed_;
        return;
    }
    program_ = &*program;
    source_ = source;
    bench_ = std::make_unique<Bench>(session_, *program, dialects_, cycles_);
    for (std::uint32_t i = 0; i < program->code->functions.size(); ++i) {
        if (is_chosen(program->code->functions[i])) run_test(*program, i);
    }
}

Status TestRun::perform() {
    const std::string& asked = session_.options().dialect;
    if (asked.empty()) dialects_.assign(kControls.begin(), kControls.end());
    else dialects_ = {asked};
    for (const std::string& name : dialects_) {
        if (session_.dialect(name, {}) == nullptr) session_.mark_usage();
    }
    if (session_.machine() == nullptr || session_.status() != Status::Done)
        return session_.status();
    const std::unique_ptr<Output> out =
        Output::open(session_.files(), job_.output, session_.messages(), session_.output_rules());
    if (!out) return Status::Usage;
    for (const std::string& source : job_.sources) run_file(source);
    const bool has_none = run_ == 0 && failed_ == 0;
    if (has_none) {
        session_.messages()
            .report(diag::NoTests)
            .arg(job_.filter.empty() ? "" : ": no name contains `" + job_.filter + '`');
        ++failed_;
    }
    out->write(lines_);
    if (run_ > 0) {
        out->write(std::to_string(run_) + (run_ == 1 ? " test, " : " tests, ") +
                   std::to_string(failed_) + " failed\n");
    }
    if (!out->commit(session_.messages())) return Status::Usage;
    if (session_.status() == Status::Usage) return Status::Usage;
    return failed_ > 0 || session_.status() != Status::Done ? Status::Failed : Status::Done;
}

}  // namespace

Status test(Session& session, const TestJob& job) { return TestRun(session, job).perform(); }

}  // namespace kadr::driver
