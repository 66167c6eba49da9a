#include "driver/debug/next_lines.h"

#include <utility>

namespace kadr::driver {

NextLines::NextLines(Session& session, const KadrProgram& program, const nc::Dialect& dialect,
                     std::string name)
    : program_(program),
      name_(std::move(name)),
      text_(session, program, dialect, {.keeps_calls = true, .is_only_looked_at = true}, silence_) {
}

/// False: there is no more text.
bool NextLines::read_more() {
    if (!has_started_ && !text_.start()) return false;
    has_started_ = true;
    std::string_view piece = text_.next();
    if (piece.empty()) return false;
    while (!piece.empty()) {
        const std::size_t end = std::min(piece.find('\n'), piece.size());
        lines_.emplace_back(piece.substr(0, end));
        piece.remove_prefix(std::min(end + 1, piece.size()));
    }
    return true;
}

std::optional<TraceStep> NextLines::line(std::uint32_t number) {
    while (true) {
        for (; first_ < number && !lines_.empty(); ++first_) lines_.pop_front();
        if (first_ == number && !lines_.empty()) break;
        if (!read_more()) return std::nullopt;
    }
    TraceStep step;
    step.file = name_;
    step.line = number;
    step.text = lines_.front();
    const SourceId source = text_.lines().find(number);
    if (source.is_valid() && source.index < program_.code->statements.size())
        step.statement = program_.code->statements[source.index];
    // Behind an error comes nothing but the end of a program.
    else if (text_.failed() && number > text_.body_lines()) return std::nullopt;
    if (const expand::BlockOrigin* calls = text_.calls_behind(number)) {
        step.has_calls = true;
        step.calls = *calls;
    }
    return step;
}

}  // namespace kadr::driver
