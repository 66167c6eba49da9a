#include "write/writer.h"

#include <utility>

#include "write/block_writer.h"
#include "write/safety_line.h"
#include "write/sections.h"

namespace kadr::write {

namespace {

bool changes_tool(const Block& block) {
    return block.function_count != 0 && block.skip_level < 0 &&
           (block.find(Function::Tool) != nullptr || block.find(Function::ToolChange) != nullptr);
}

bool ends_program(const Block& block) {
    return block.function_count != 0 && block.find(Fact::EndsProgram) != nullptr;
}

}  // namespace

/// The frame of the program around the block writer: header, safety line, sections, end.
struct Writer::State {
    State(const Dialect& dialect, const WriteOptions& options, DiagnosticSink& sink)
        : tables(dialect.tables()),
          blocks(dialect, options, sink),
          safety(blocks.text_state(), blocks.text_lines()),
          sections(dialect.is_of_lathe()),
          takes_codes(!options.verbose_modal) {}

    bool takes_into_line(const Block& block);
    void begin_block(const Block& block, std::string& out);
    std::uint32_t write_in_section(const Block& block, std::string& out);
    bool can_begin_section() const;
    std::uint32_t write_tool(const Block& block, std::string& out);
    void write_shift(const Block& block, std::string& out);

    const DialectTables& tables;
    BlockWriter blocks;
    nc::ProgramLines lines;
    SafetyLine safety;
    Sections sections;
    std::vector<Block> before;  // of the block that is being written
    SourceId taken;  // statement of the latest block whose codes stand in a line of the frame
    bool takes_codes;
    bool has_started = false;     // the first block that does something was written
    bool is_at_start = false;     // … and was the line with which programs begin
    bool is_section_due = false;  // a tool was changed, and the line behind it is not written
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
    s.safety.begin();
    s.sections.begin_program();
    s.lines = program_lines(s.tables, program);
    for (const std::string& line : s.lines.header) s.blocks.text_lines().write(line, false, out);
    s.has_started = s.is_at_start = s.is_section_due = false;
}

void Writer::write_start(std::string& out) {
    State& s = *state_;
    if (std::exchange(s.has_started, true)) return;
    s.safety.write_start(s.lines.start, out);
    if (s.blocks.modal().work_offset.is_known) s.sections.say_offset();
    s.is_at_start = true;
}

bool Writer::has_started() const { return state_->has_started; }
SourceId Writer::taken() const { return state_->taken; }
bool Writer::holds_codes() const { return state_->safety.holds_codes(); }

/// Codes that a program chooses before it does anything stand in the line that comes first.
bool Writer::State::takes_into_line(const Block& block) {
    const bool is_open = has_started ? is_section_due : !lines.start.empty();
    return is_open && takes_codes && safety.take(block);
}

/// The line behind a tool change, where the block is one of the section.
void Writer::State::begin_block(const Block& block, std::string& out) {
    const bool does = block.kind == Block::Kind::Nc || block.kind == Block::Kind::Raw;
    if (!is_section_due || !does) return;
    is_section_due = false;
    if (ends_program(block)) return;
    safety.write_section(lines.section, out);
    sections.say_offset();
    write_shift(block, out);
}

/// A shift that acts goes on behind the tool change; who starts there has none.
void Writer::State::write_shift(const Block& block, std::string& out) {
    const TextFrame& frame = blocks.modal().frame;
    bool is_shifted = false;
    Block again;
    again.source = block.source;
    Invocation* shift = again.add(Function::Shift, frame.origin.size());
    for (std::size_t axis = 0; axis < frame.origin.size(); ++axis) {
        if (!frame.origin[axis].is_known || frame.origin[axis].value == 0) continue;
        again.set_argument(*shift, axis, frame.origin[axis].value);
        is_shifted = true;
    }
    if (is_shifted && !frame.is_more_than_shift()) blocks.write(again, out);
}

std::uint32_t Writer::State::write_in_section(const Block& block, std::string& out) {
    Block whole = block;
    before.clear();
    sections.complete(blocks.modal(), blocks.view().plane_axes(), whole, before);
    for (const Block& line : before) {
        blocks.write(line, out);
        sections.follow(line);
    }
    sections.follow(whole);
    const std::uint32_t lines_before = blocks.lines();
    const std::uint32_t first = blocks.write(whole, out);
    const bool is_line = blocks.lines() != lines_before && block.kind != Block::Kind::Comment;
    is_at_start = is_at_start && !is_line;
    return first;
}

/// Whether an operator can begin again at the next tool: nothing acts that no line of a section
/// would bring back.
bool Writer::State::can_begin_section() const {
    return !lines.section.empty() && !blocks.view().leads_tip() &&
           !blocks.modal().frame.is_more_than_shift();
}

std::uint32_t Writer::State::write_tool(const Block& block, std::string& out) {
    Block numbered = block;
    const bool is_section = can_begin_section();
    if (block.number < 0 && is_section) numbered.number = blocks.text_lines().next_section();
    is_section_due = is_section && !is_at_start;
    const bool has_said_offset = sections.has_said_offset();
    const std::uint32_t first = write_in_section(numbered, out);
    if (has_said_offset) sections.say_offset();
    is_at_start = false;
    if (is_section) sections.begin_section();
    return first;
}

std::uint32_t Writer::write(const Block& block, std::string& out) {
    State& s = *state_;
    const bool is_open = !s.has_started || s.is_section_due;
    if (is_open && block.kind != Block::Kind::Comment) {
        if (s.takes_into_line(block)) {
            s.taken = block.source;
            return lines();
        }
        write_start(out);
        s.begin_block(block, out);
    }
    if (changes_tool(block)) return s.write_tool(block, out);
    if (s.sections.owes() || s.is_at_start) return s.write_in_section(block, out);
    if (block.function_count != 0) s.sections.follow(block);
    return s.blocks.write(block, out);
}

void Writer::end(std::string& out) {
    State& s = *state_;
    write_start(out);
    Lines& text = s.blocks.text_lines();
    if (!s.blocks.has_ended()) {
        for (const std::string& line : s.lines.finish) text.write(line, true, out);
    }
    for (const std::string& line : s.lines.end) text.write(line, false, out);
}

std::uint32_t Writer::lines() const { return state_->blocks.lines(); }
bool Writer::failed() const { return state_->blocks.failed(); }
const WriterModal& Writer::believed() const { return state_->blocks.modal(); }
Function Writer::means(Group group) const { return believed().meant_of(group); }
std::array<std::size_t, 3> Writer::plane_axes() const { return state_->blocks.view().plane_axes(); }
bool Writer::is_ready_for(const Block& cycle, const Block& move) const {
    return state_->blocks.is_ready_for(cycle, move);
}

}  // namespace kadr::write
