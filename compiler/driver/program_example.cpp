#include "driver/program_example.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "interp/interpreter.h"
#include "macro/program.h"
#include "nc/tables.h"

namespace kadr::driver {

namespace {

/// A text that can be read again from any position, as a file can.
class ExampleText final : public nc::TextSource {
  public:
    explicit ExampleText(std::string text) : text_(std::move(text)) {}
    std::string_view next() override {
        return std::string_view(text_).substr(std::exchange(at_, text_.size()));
    }
    bool seek(std::uint64_t offset) override {
        at_ = std::min<std::size_t>(offset, text_.size());
        return true;
    }

  private:
    std::string text_;
    std::size_t at_ = 0;
};

/// The lines of the example as a program of its own, with the control's end behind them.
std::string program_of(const nc::Dialect& dialect, const std::string& text) {
    std::string program = text;
    for (const std::string& line : dialect.tables().program.finish) program += '\n' + line;
    return program + '\n';
}

std::string value_text(const macro::ControlVariable& variable) {
    using Kind = macro::ControlVariable::Kind;
    if (variable.kind == Kind::Text) return '"' + variable.text + '"';
    if (variable.kind == Kind::Bool) return variable.number != 0 ? "TRUE" : "FALSE";
    constexpr int kShown = 9;  // decimals; the last bits are no matter of an example
    return format_shortest(round_to(variable.number, kShown));
}

std::string alarm_text(const Diagnostic& message) {
    std::string text = "alarm ";
    text += message.alarm_number.empty() ? std::string(message.row->code) : message.alarm_number;
    return text;
}

}  // namespace

std::string outcome_of(Session& session, const nc::Dialect& dialect, const std::string& text,
                       const std::string& asked) {
    const machine::Machine* machine = session.machine();
    if (machine == nullptr) return "no machine";
    DiagnosticList messages;
    ExampleText source(program_of(dialect, text));
    macro::ProgramOptions options;
    options.max_turns = 10'000;
    options.max_repeated = 10'000;
    macro::NcProgram program(dialect, source, "example", options, messages);
    interp::Interpreter interpreter(dialect, *machine, program, &program, nullptr, {}, messages);
    program.follow(interpreter);
    std::array<path::Command, 8> batch;
    while (interpreter.pull(batch) > 0) continue;
    for (const Diagnostic& message : messages.all()) {
        if (message.severity >= Severity::Error) return alarm_text(message);
    }
    const std::vector<macro::ControlVariable> variables = program.variables();
    std::istringstream items(asked);
    std::string found;
    for (std::string item; items >> item;) {
        const std::string name = item.substr(0, item.find('='));
        const auto variable = std::ranges::find(variables, name, &macro::ControlVariable::name);
        if (!found.empty()) found += ' ';
        found += name + '=' + (variable == variables.end() ? "unset" : value_text(*variable));
    }
    return found;
}

}  // namespace kadr::driver
