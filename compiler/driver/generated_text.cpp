#include "driver/generated_text.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <span>
#include <utility>

#include "base/assert.h"
#include "base/diagnostics/dialect.h"
#include "base/diagnostics/expand.h"
#include "driver/source_map.h"
#include "nc/tables.h"
#include "sema/used_functions.h"

namespace kadr::driver {

namespace {

// Blocks evaluated at a time: few enough to stay in the cache.
constexpr std::size_t kBlocksAtOnce = 64;
constexpr std::size_t kPieceBytes = std::size_t{1} << 13;  // text handed on at a time

/// Passes of loops in a text that is only looked at: a second or less.
constexpr std::uint64_t kTurnsToLookAt = 20'000'000;

write::WriteOptions write_options(const Options& options) {
    return {.verbose_modal = options.verbose_modal,
            .number_blocks = true,
            .native_cycles = options.native_cycles};
}

}  // namespace

const sema::FunctionCode* chosen_program(const sema::Code& code, std::string_view name) {
    const auto is_chosen = [name](const sema::FunctionCode& function) {
        return function.kind == sema::FunctionKind::Program && function.is_main_file &&
               (name.empty() || function.name == name);
    };
    const auto found = std::find_if(code.functions.begin(), code.functions.end(), is_chosen);
    return found == code.functions.end() ? nullptr : &*found;
}

GeneratedText::GeneratedText(Session& session, const KadrProgram& program,
                             const nc::Dialect& target, const TextAside& aside)
    : GeneratedText(session, program, target, aside, session.messages()) {}

GeneratedText::GeneratedText(Session& session, const KadrProgram& program,
                             const nc::Dialect& target, const TextAside& aside,
                             DiagnosticSink& sink)
    : session_(session),
      program_(program),
      target_(target),
      expander_messages_(*this, sink),
      expander_(*program.code, target, expand_options(aside), expander_messages_),
      writer_messages_(*this, sink),
      writer_(target, write_options(session.options()), writer_messages_),
      aside_(aside),
      line_map_(std::make_unique<LineMap>()),
      call_map_(aside.keeps_calls ? std::make_unique<CallMap>() : nullptr),
      batch_(aside.watch != nullptr ? 1 : kBlocksAtOnce),
      deadline_(session.options().max_time, nullptr) {
    // Who looks on sees each block where it is made.
    const Options& options = session.options();
    if (aside.watch != nullptr || !options.modal_cycles || options.verbose_modal) return;
    groups_.emplace(target, writer_, [this](const nc::Block& block, std::uint64_t number) {
        write_block(block, number);
    });
}

GeneratedText::~GeneratedText() = default;

expand::ExpandOptions GeneratedText::expand_options(const TextAside& aside) const {
    const Options& options = session_.options();
    expand::RunLimits limits;
    limits.blocks = options.max_blocks > 0 ? options.max_blocks : kMaxBlocks;
    limits.seconds = options.max_time;
    if (aside.is_only_looked_at) limits.loop_turns = kTurnsToLookAt;
    return {.limits = limits,
            .native_cycles = options.native_cycles,
            .trace = aside.map != nullptr || aside.keeps_calls,
            .machine = [this] { return session_.machine(); },
            .checks_cutters = !options.has_stand_in_tools,
            .stop = options.stop,
            .access = &session_.access(),
            .shown = aside.is_only_looked_at ? nullptr : options.shown,
            .watch = aside.watch};
}

void GeneratedText::warn_of_cuts(const Messages& messages) {
    expander_.warn_of_cuts([&messages](const DiagnosticRow& row, const SourceRange& location) {
        return messages.is_allowed(row.code, location);
    });
}

Done GeneratedText::start() {
    const Options& options = session_.options();
    Entry entry;
    if (const sema::FunctionCode* chosen = chosen_program(*program_.code, options.program)) {
        entry.name = chosen->name;
        entry.is_inch = chosen->units == sema::Units::Inch;
        entry.range = chosen->range;
        entry.function = chosen;
    }
    entry.start = [&](expand::Expander& expander) {
        return expander.start(options.program, options.defines);
    };
    return start(entry);
}

/// `O1234` has the number 1234 where programs have numbers; every other name has the first one.
static std::int64_t program_number(std::string_view name) {
    constexpr std::size_t kMostDigits = 8;
    constexpr std::int64_t kFirst = 1;
    const std::string_view digits = name.substr(std::min<std::size_t>(1, name.size()));
    std::int64_t number = 0;
    const bool is_short = !digits.empty() && digits.size() <= kMostDigits;
    if (!is_short || (name[0] != 'O' && name[0] != 'o')) return kFirst;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool is_number = fault == std::errc() && end == digits.data() + digits.size();
    return is_number && number > 0 ? number : kFirst;
}

/// The control can be given the units of the program, or stands in them anyway.
Done GeneratedText::require_units(const Entry& entry) {
    const nc::Function wanted = entry.is_inch ? nc::Function::Inch : nc::Function::Metric;
    const nc::Function standing = target_.power_on(nc::Group::Units);
    const bool stands =
        wanted == standing || (standing == nc::Function::None && wanted == nc::Function::Metric);
    if (stands || target_.can_write(wanted)) return kDone;
    session_.messages()
        .report(diag::CannotExpress, entry.range)
        .arg(target_.name())
        .arg(entry.is_inch ? "a program in inches" : "a program in millimetres");
    return kFailed;
}

Done GeneratedText::start(const Entry& entry) {
    if (!require_units(entry)) return kFailed;
    start_ = entry.start;
    if (!entry.start(expander_)) return kFailed;
    writer_.set_statements(program_.code->statements, &session_.sources());
    nc::ProgramInfo info;
    info.name = entry.name;
    info.number = program_number(entry.name);
    info.is_inch = entry.is_inch;
    for (const sema::Plan& plan : program_.code->plans)
        info.greatest_number = std::max(info.greatest_number, std::int64_t{plan.number});
    nc::FunctionSet used;
    if (entry.function != nullptr) {
        used = sema::used_functions(*program_.code, *entry.function);
        info.used = &used;
    }
    writer_.begin(info, text_);
    return kDone;
}

/// Of a text that is made in step: what was written at the start, then the lines of one block.
void GeneratedText::make_block() {
    if (has_given_head_) text_.clear();
    has_given_head_ = true;
    while (!is_at_end_ && text_.empty()) write_batch();
    piece_bytes_ += text_.size();
    if (piece_bytes_ >= kPieceBytes) piece_bytes_ = 0;
}

void GeneratedText::finish_piece() {
    if (aside_.watch == nullptr) return;
    text_.clear();
    while (!is_at_end_ && piece_bytes_ + text_.size() < kPieceBytes) write_batch();
    if (tap_) tap_(text_);
}

/// The text of `start` is part of the first piece.
void GeneratedText::make_piece() {
    if (made_.taken > 0 || is_at_end_) text_.clear();
    while (!is_at_end_ && text_.size() < kPieceBytes) write_batch();
}

std::string_view GeneratedText::next() {
    if (aside_.watch != nullptr) make_block();
    else make_piece();
    if (!is_at_end_ && deadline_.is_over()) {
        is_late_ = is_at_end_ = true;
        expander_messages_.report(diag::TimeLimit, last_statement())
            .arg(deadline_.seconds())
            .fix("if it is to work longer, raise the limit: `--max-time`");
    }
    if (tap_) tap_(text_);
    return text_;
}

/// The statement that made the latest block.
SourceRange GeneratedText::last_statement() const {
    const std::vector<SourceRange>& statements = program_.code->statements;
    const bool is_known = last_source_.is_valid() && last_source_.index < statements.size();
    return is_known ? statements[last_source_.index] : SourceRange{};
}

static bool ends_program(const nc::Block& block) {
    return block.find(nc::Fact::EndsProgram) != nullptr;
}

/// Whether a function of the block is written letter by letter, in the control's own language.
static bool has_phrase(const nc::DialectTables& tables, const nc::Block& block) {
    return std::ranges::any_of(
        std::span(block.functions).first(block.function_count),
        [&](const nc::Invocation& invocation) {
            return std::ranges::any_of(
                tables.forms_of[static_cast<std::size_t>(invocation.function)],
                [&](nc::FormId id) { return tables.forms[id].is_verbatim; });
        });
}

bool GeneratedText::is_phrase(std::uint64_t line) const {
    return std::ranges::binary_search(phrases_, line);
}

void GeneratedText::write_batch() {
    const std::size_t count = expander_.pull(batch_);
    if (count == 0 && aside_.watch != nullptr && expander_.is_waiting())
        return writer_.write_start(text_);
    if (count > 0) last_source_ = batch_[count - 1].source;
    sound_.reset();
    made_.batch_begin = made_.taken;
    for (std::size_t i = 0; i < count; ++i, ++made_.taken) {
        if (!groups_ || groups_->lets_pass(batch_[i])) write_block(batch_[i], made_.taken);
        else groups_->take(batch_[i], made_.taken);
    }
    keep_origins_of_held();
    is_at_end_ = count == 0 || failed();
    if (!is_at_end_) return;
    if (groups_) groups_->finish();
    body_lines_ = writer_.lines();
    // Nobody executes what has its error already.
    if (sound_) text_.resize(*sound_);
    // Who looks on sees where it has ended, not the end of the program.
    const bool is_cut = aside_.watch != nullptr && (aside_.watch->has_ended() || failed());
    if (!is_cut) writer_.end(text_);
}

/// number  of the block among those of the expander
void GeneratedText::write_block(const nc::Block& block, std::uint64_t number) {
    // Behind an error the rest is looked at for errors only, and the end is written apart.
    if (writer_.failed() && ends_program(block)) return;
    const std::uint32_t before = writer_.lines();
    const std::size_t length = text_.size();
    made_.writing = number;
    const std::uint32_t first = writer_.write(block, text_);
    if (writer_.failed() && !sound_) sound_ = length;
    // What was modal already gets no line, and the line before belongs to another statement.
    if (writer_.lines() == before) return;
    if (first > before + 1 && writer_.taken().is_valid())
        line_map_->add(before + 1, first - 1, writer_.taken());
    line_map_->add(first, writer_.lines(), block.source);
    if (has_phrase(target_.tables(), block)) {
        for (std::uint32_t line = first; line <= writer_.lines(); ++line) phrases_.push_back(line);
    }
    if (block.source.is_valid()) statement_lines_ += writer_.lines() + 1 - first;
    if (aside_.map != nullptr) map_block(number, first);
    if (call_map_) call_map_->add(first, writer_.lines(), origin_of(number));
}

bool GeneratedText::keeps_origins() const { return aside_.map != nullptr || call_map_; }

/// Of a block of this batch, or of one that was held back from an earlier one.
const expand::BlockOrigin& GeneratedText::origin_of(std::uint64_t number) const {
    if (number >= made_.batch_begin) return expander_.trace(number - made_.batch_begin);
    const auto held = std::ranges::find(held_origins_, number, &HeldOrigin::number);
    KADR_ASSERT(held != held_origins_.end(), "a block that is held back keeps its origin");
    return held->origin;
}

/// The next batch takes the place of the origins of this one.
void GeneratedText::keep_origins_of_held() {
    if (!groups_ || !keeps_origins()) return;
    std::erase_if(held_origins_,
                  [&](const HeldOrigin& held) { return !groups_->holds(held.number); });
    for (std::uint64_t number = made_.batch_begin; number < made_.taken; ++number) {
        if (groups_->holds(number))
            held_origins_.push_back({number, expander_.trace(number - made_.batch_begin)});
    }
}

/// The expander is ahead of the writer and keeps no calls, which would cost every program. An error
/// is rare: the program is evaluated once more up to the block, this time with its calls.
std::vector<Diagnostic::Note> GeneratedText::calls_of_block(std::uint64_t number) const {
    std::vector<Diagnostic::Note> notes;
    DiagnosticList said_before;
    expand::ExpandOptions options = expand_options({.keeps_calls = true});
    options.shown = nullptr;
    expand::Expander again(*program_.code, target_, options, said_before);
    if (!start_ || !start_(again)) return notes;
    std::vector<nc::Block> batch(kBlocksAtOnce);
    std::uint64_t first = 0;
    std::size_t count = again.pull(batch);
    for (; count > 0 && first + count <= number; count = again.pull(batch)) first += count;
    if (count == 0) return notes;
    const std::vector<expand::SourceCall>& calls = again.trace(number - first).calls;
    for (auto call = calls.rbegin(); call != calls.rend(); ++call) {
        notes.push_back({call->range, {}, "`" + std::string(call->function) + "` was called here"});
    }
    return notes;
}

bool GeneratedText::is_in_library(const SourceRange& range) const {
    return session_.sources().name(range.file).starts_with(session_.share().library);
}

/// What stands in the library gets the location of the innermost call that does not; its own
/// location becomes a note. False: it stands where it belongs.
bool GeneratedText::move_to_call(Diagnostic& diagnostic, std::vector<Diagnostic::Note>& calls,
                                 const char* words) const {
    if (!diagnostic.range.file.is_valid() || !is_in_library(diagnostic.range)) return false;
    const auto users = std::ranges::find_if(calls, [&](const Diagnostic::Note& call) {
        return call.range.file.is_valid() && !is_in_library(call.range);
    });
    if (users == calls.end()) return false;
    const SourceRange found = std::exchange(diagnostic.range, users->range);
    calls.erase(users);
    diagnostic.notes.push_back({found, {}, words});
    return true;
}

void GeneratedText::move_to_statement(Diagnostic& diagnostic) const {
    if (!diagnostic.line) return;
    const SourceId source = line_map_->find(diagnostic.line->line);
    if (!source.is_valid() || source.index >= program_.code->statements.size()) return;
    const SourceRange statement = program_.code->statements[source.index];
    std::erase_if(diagnostic.notes, [&](const auto& note) { return note.range == statement; });
    diagnostic.range = statement;
    diagnostic.notes.push_back({{}, std::exchange(diagnostic.line, {}), "it writes this line"});
    const expand::BlockOrigin* trace = calls_behind(diagnostic.notes.back().line->line);
    if (trace == nullptr) return;
    std::vector<Diagnostic::Note> calls;
    for (auto call = trace->calls.rbegin(); call != trace->calls.rend(); ++call)
        calls.push_back({call->range, {}, "`" + std::string(call->function) + "` was called here"});
    move_to_call(diagnostic, calls, "this statement makes the block");
}

void GeneratedText::ExpanderMessages::take(Diagnostic diagnostic) {
    std::vector<Diagnostic::Note> notes = std::move(diagnostic.notes);
    diagnostic.notes.clear();
    text_.move_to_call(diagnostic, notes, "it is found here");
    std::ranges::move(notes, std::back_inserter(diagnostic.notes));
    sink_.take(std::move(diagnostic));
}

void GeneratedText::WriterMessages::take(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::Error && diagnostic.range.file.is_valid()) {
        std::vector<Diagnostic::Note> calls = text_.calls_of_block(text_.made_.writing);
        if (text_.move_to_call(diagnostic, calls, "this statement makes the block")) {
            if (diagnostic.range == last_call_ && diagnostic.row == last_row_) return;
            last_call_ = diagnostic.range;
            last_row_ = diagnostic.row;
        }
        std::ranges::move(calls, std::back_inserter(diagnostic.notes));
    }
    sink_.take(std::move(diagnostic));
}

void GeneratedText::map_block(std::uint64_t number, std::uint32_t line) {
    entry_.clear();
    append_map_entry(entry_, {line, writer_.lines() + 1 - line}, origin_of(number), session_);
    aside_.map->write(entry_);
}

bool GeneratedText::failed() const { return is_late_ || expander_.failed() || writer_.failed(); }

}  // namespace kadr::driver
