#include "nc/reader.h"

#include <algorithm>

#include "base/diagnostics/iso.h"
#include "nc/kept_lines.h"
#include "nc/line_reader.h"
#include "nc/line_source.h"

namespace kadr::nc {

struct Reader::State {
    State(const Dialect& dialect, TextSource& text, std::string name, DiagnosticSink& sink)
        : source(text, dialect.tables().notation.max_line),
          lines(dialect, std::move(name), sink),
          kept(lines) {}

    LineSource source;
    LineReader lines;
    KeptLines kept;
    std::uint64_t line_number = 0;
};

Reader::Reader(const Dialect& dialect, TextSource& text, std::string name, DiagnosticSink& sink)
    : state_(std::make_unique<State>(dialect, text, std::move(name), sink)) {}
Reader::~Reader() = default;

std::size_t Reader::pull(std::span<Block> out) {
    State& s = *state_;
    s.kept.clear();
    std::size_t count = 0;
    std::string_view line;
    bool is_too_long = false;
    while (count < out.size() && !s.lines.bounds().has_ended() &&
           s.source.next(line, is_too_long)) {
        ++s.line_number;
        if (is_too_long) {
            s.lines.report_too_long(line, s.line_number);
            continue;
        }
        Block& block = out[count];
        block.reset();
        if (s.lines.read(line, s.line_number, block) == LineReader::Makes::Nothing) continue;
        block.line = static_cast<std::uint32_t>(s.line_number);
        s.kept.add(block.line, line);
        ++count;
    }
    return count;
}

bool Reader::failed() const { return state_->lines.faults().failed(); }
std::uint64_t Reader::lines() const { return state_->line_number; }
std::uint64_t Reader::first_fault() const { return state_->lines.faults().first_fault(); }

TextLocation Reader::location(const Block& block) const { return state_->kept.location(block); }
TextLocation Reader::location(const Block& block, Slot slot) const {
    return state_->kept.location(block, slot);
}
TextLocation Reader::location(const Block& block, Function function) const {
    return state_->kept.location(block, function);
}

}  // namespace kadr::nc
