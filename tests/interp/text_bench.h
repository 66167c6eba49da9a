// text_bench.h — texts of a control through the reader and the interpreter.
#pragma once

#include "bench.h"
#include "nc/reader.h"

namespace kadr::interp {

/// A whole text in two pieces, so that a line is cut somewhere.
class Text final : public nc::TextSource {
  public:
    explicit Text(std::string text) : text_(std::move(text)) {}
    std::string_view next() override {
        const std::size_t from = at_;
        at_ = at_ == 0 ? text_.size() / 2 : text_.size();
        return std::string_view(text_).substr(from, at_ - from);
    }

  private:
    std::string text_;
    std::size_t at_ = 0;
};

inline Ran read(std::string_view dialect_name, std::string text,
                const machine::Machine& machine = mill()) {
    Sources sources;
    DiagnosticList messages;
    const std::optional<nc::Dialect> dialect =
        nc::load_dialect(std::string(dialect_name), {KADR_ROOT "/dialects"}, sources, messages);
    Ran ran;
    if (!dialect) {
        ADD_FAILURE() << dialect_name << " cannot be loaded";
        return ran;
    }
    Text source(std::move(text));
    nc::Reader reader(*dialect, source, "test.nc", messages);
    Interpreter interpreter(*dialect, machine, reader, &reader, nullptr, {}, messages);
    std::vector<path::Command> batch(7);
    while (const std::size_t count = interpreter.pull(batch)) {
        for (std::size_t i = 0; i < count; ++i) ran.commands.push_back(batch[i]);
    }
    ran.messages = messages.all();
    ran.alarmed = interpreter.alarmed();
    return ran;
}

/// Alarm numbers of the control, or codes of other messages.
inline std::string alarms(const Ran& ran) {
    std::string out;
    for (const Diagnostic& message : ran.messages) {
        if (!out.empty()) out += ' ';
        out += message.alarm_number.empty() ? std::string(message.row->code) : message.alarm_number;
    }
    return out;
}

}  // namespace kadr::interp
