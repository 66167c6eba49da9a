#include "write/writer.h"

#include <utility>

#include "write/block_writer.h"

namespace kadr::write {

/// The frame of the program around the block writer: header, safety line, end.
struct Writer::State {
    State(const Dialect& dialect, const WriteOptions& options, DiagnosticSink& sink)
        : tables(dialect.tables()), blocks(dialect, options, sink) {}

    const DialectTables& tables;
    BlockWriter blocks;
    nc::ProgramLines lines;
    bool has_started = false;  // the first block that does something was written
};

Writer::Writer(const Dialect& dialect, WriteOptions options, DiagnosticSink& sink)
    : state_(std::make_unique<State>(dialect, options, sink)) {}
Writer::~Writer() = default;

void Writer::set_statements(std::span<const SourceRange> statements, const Sources* sources) {
    state_->blocks.set_statements(statements, sources);
}

void Writer::begin(const ProgramInfo& program, std::string& out) {
    State& s = *state_;
    s.blocks.begin(program);
    s.lines = program_lines(s.tables, program);
    for (const std::string& line : s.lines.header) s.blocks.write_line(line, false, out);
    s.has_started = false;
}

void Writer::write_start(std::string& out) {
    State& s = *state_;
    if (std::exchange(s.has_started, true)) return;
    for (const std::string& line : s.lines.start) s.blocks.write_start_line(line, out);
}

bool Writer::has_started() const { return state_->has_started; }

std::uint32_t Writer::write(const Block& block, std::string& out) {
    State& s = *state_;
    if (!s.has_started && block.kind != Block::Kind::Comment) write_start(out);
    return s.blocks.write(block, out);
}

void Writer::end(std::string& out) {
    State& s = *state_;
    write_start(out);
    if (!s.blocks.has_ended()) {
        for (const std::string& line : s.lines.finish) s.blocks.write_line(line, true, out);
    }
    for (const std::string& line : s.lines.end) s.blocks.write_line(line, false, out);
}

std::uint32_t Writer::lines() const { return state_->blocks.lines(); }
bool Writer::failed() const { return state_->blocks.failed(); }
const WriterModal& Writer::believed() const { return state_->blocks.modal(); }
Function Writer::means(Group group) const { return believed().meant_of(group); }
std::array<std::size_t, 3> Writer::plane_axes() const { return state_->blocks.plane_axes(); }
bool Writer::is_ready_for(const Block& cycle, const Block& move) const {
    return state_->blocks.is_ready_for(cycle, move);
}

}  // namespace kadr::write
