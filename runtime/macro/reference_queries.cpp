#include "macro/reference_queries.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "macro/line_compiler.h"
#include "macro/line_uses.h"
#include "macro/program_run.h"
#include "nc/letters.h"

namespace kadr::macro {

using Declared = TextDeclaration::Kind;

namespace {

bool covers(const TextRange& range, std::uint64_t byte) {
    return range.begin <= byte && byte <= range.end && range.begin != range.end;
}

NamedPlace place_of(const References& references, const TextDeclaration& declaration) {
    return {references.file, declaration.kind, declaration.name, declaration.range};
}

/// Whether two places are the same name; what the files call it need not be.
bool is_same(const NamedPlace& a, const NamedPlace& b) {
    return a.file == b.file && a.kind == b.kind && a.range.begin == b.range.begin;
}

}  // namespace

const TextUse* use_at(const References& references, std::uint64_t byte) {
    // Backward: the word that begins at the byte comes before the one that ends there.
    const auto behind = std::ranges::upper_bound(
        references.uses, byte, {}, [](const TextUse& use) { return use.range.begin; });
    for (auto use = behind; use != references.uses.begin();) {
        --use;
        if (covers(use->range, byte)) return &*use;
        if (use->range.line != std::prev(behind)->range.line) break;
    }
    return nullptr;
}

std::optional<NamedPlace> target_of(const References& references, const TextUse& use) {
    if (use.outcome == TextUse::Outcome::Here)
        return place_of(references, references.declarations[use.target]);
    if (use.outcome == TextUse::Outcome::Elsewhere) return references.outside[use.target];
    return std::nullopt;
}

std::optional<NamedPlace> declaration_at(const References& references, std::uint64_t byte) {
    if (const TextUse* const use = use_at(references, byte)) return target_of(references, *use);
    const auto found =
        std::ranges::find_if(references.declarations,
                             [&](const TextDeclaration& each) { return covers(each.range, byte); });
    if (found == references.declarations.end()) return std::nullopt;
    return place_of(references, *found);
}

std::uint32_t program_at(const References& references, std::uint64_t byte) {
    std::uint32_t program = 0;
    for (std::uint32_t i = 0; i < references.declarations.size(); ++i) {
        const TextDeclaration& each = references.declarations[i];
        if (each.kind == Declared::Program && each.lines.begin <= byte) program = i;
    }
    return program;
}

std::vector<NameOccurrence> occurrences_of(std::span<const References> texts,
                                           const NamedPlace& name) {
    std::vector<NameOccurrence> all;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const References& text = texts[i];
        for (const TextDeclaration& each : text.declarations) {
            const bool is_written = each.range.begin != each.range.end;
            if (is_written && is_same(place_of(text, each), name))
                all.push_back({i, each.range, true, {}});
        }
        for (const TextUse& use : text.uses) {
            const auto target = target_of(text, use);
            if (target && is_same(*target, name)) all.push_back({i, use.range, false, use.kind});
        }
    }
    std::ranges::sort(all, {}, [](const NameOccurrence& each) {
        return std::tuple(each.text, each.range.begin);
    });
    return all;
}

std::vector<OutlineRow> outline_of(const References& references) {
    using RowKind = OutlineRow::Kind;
    std::vector<OutlineRow> rows;
    for (const TextDeclaration& each : references.declarations) {
        if (each.kind == Declared::Program)
            rows.push_back({RowKind::Program, each.name, each.range, each.program});
        if (each.kind == Declared::Label)
            rows.push_back({RowKind::Label, each.name, each.range, each.program});
    }
    for (const TextUse& use : references.uses) {
        if (use.kind == TextUse::Kind::Call)
            rows.push_back({RowKind::Call, use.name, use.range, use.program});
    }
    std::ranges::stable_sort(rows, {}, [](const OutlineRow& row) { return row.range.begin; });
    return rows;
}

std::vector<TextDeclaration> blocks_of(const nc::Dialect& dialect, nc::TextSource& text,
                                       const References& references, std::uint32_t program,
                                       std::size_t most) {
    const nc::DialectTables& tables = dialect.tables();
    const TextRange& lines = references.declarations[program].lines;
    std::vector<TextDeclaration> blocks;
    nc::LineSource source(text, tables.notation.max_line);
    if (!source.seek(lines.begin)) return blocks;
    LinePosition here{lines.begin, lines.line};
    std::string_view line;
    bool is_too_long = false;
    while (here.offset < lines.end && blocks.size() < most && source.next(line, is_too_long)) {
        const LinePosition at = std::exchange(here, {source.offset(), here.line + 1});
        const nc::LineFront front = nc::front_of(tables, line);
        if (front.number < 0) continue;
        TextDeclaration block;
        block.kind = Declared::Block;
        block.name = std::to_string(front.number);
        block.range = {at.offset + front.number_span.begin, at.offset + front.number_span.end,
                       at.line};
        block.program = program;
        blocks.push_back(std::move(block));
    }
    return blocks;
}

// ------------------------------------------------------------------------------ what could stand

namespace {

/// A name that no program has.
constexpr std::string_view kTrialName = "QZQZ";
/// Blocks that are looked through for a proposal.
constexpr std::size_t kMostBlocks = 1000;

/// Finds out what the control would take a word for by compiling the line with one in its place.
class TrialLine {
  public:
    TrialLine(const nc::DialectTables& tables, const References& references,
              const LineCursor& cursor, std::uint32_t program)
        : tables_(tables), references_(references), cursor_(cursor), program_(program) {}

    /// What the word from `begin` to the cursor would be if it were `word`; nothing: no name.
    bool take(std::uint32_t begin, std::string_view word, bool is_variable) {
        scanned_ = {};
        scanned_.programs.push_back({});
        scanned_.references.declarations.push_back({});
        NamesOfProgram names;
        const auto add = [&](const TextDeclaration& each) {
            names.symbols.add(symbol_of(each));
            names.known.emplace(each.name, KnownName{});
        };
        for (const TextDeclaration& each : references_.declarations) {
            const bool is_value =
                each.kind == Declared::Variable || each.kind == Declared::Parameter;
            if (is_value && each.program == program_) add(each);
        }
        TextDeclaration trial;
        trial.name = kTrialName;
        if (is_variable) add(trial);
        const std::string line = std::string(cursor_.line.substr(0, begin)).append(word);
        nc::ControlLine code;
        if (compile_block(tables_, names.symbols, line, {}, code)) return false;
        LineUses(tables_, scanned_)
            .take({line, {{cursor_.begin, 1}, {}}, 0, nullptr, nullptr}, code, names);
        const auto found = std::ranges::find_if(scanned_.references.uses, [&](const TextUse& use) {
            return use.range.begin == begin && use.range.end > begin;
        });
        if (found == scanned_.references.uses.end()) return false;
        use_ = *found;
        const auto index = static_cast<std::uint32_t>(found - scanned_.references.uses.begin());
        const auto opened = std::ranges::find(scanned_.open, index, &OpenUse::use);
        open_ = opened == scanned_.open.end() ? OpenUse() : *opened;
        return true;
    }

    const TextUse& use() const { return use_; }
    const OpenUse& open() const { return open_; }

  private:
    const nc::DialectTables& tables_;
    const References& references_;
    const LineCursor& cursor_;
    std::uint32_t program_;
    ScannedText scanned_;
    TextUse use_;
    OpenUse open_;
};

/// Finds what could stand at the cursor, the longest word first.
bool find_use(TrialLine& trial, const LineCursor& cursor, bool& is_number) {
    std::uint32_t begin = cursor.column;
    const auto is_of_word = [&](std::uint32_t at) {
        return nc::is_letter(cursor.line[at]) || nc::is_digit(cursor.line[at]);
    };
    while (begin > 0 && is_of_word(begin - 1)) --begin;
    std::uint32_t digits = cursor.column;
    while (digits > begin && nc::is_digit(cursor.line[digits - 1])) --digits;
    const std::string_view front = cursor.line.substr(0, begin);
    const bool is_in_text = std::ranges::count(front, '"') % 2 == 1;
    const std::string quoted = std::string(kTrialName) + '"';
    is_number = false;
    if (trial.take(begin, is_in_text ? quoted : kTrialName, false)) return true;
    is_number = true;
    if (trial.take(digits, "1", false)) return true;
    is_number = false;
    return trial.take(begin, kTrialName, true);
}

/// Whether a jump from the cursor's line finds what stands there.
bool is_in_direction(const OpenUse& open, const TextRange& range, const LineCursor& cursor) {
    if (open.rule != OpenUse::Rule::Nearest || open.direction == Direction::Both) return true;
    const bool is_behind = range.begin > cursor.begin;
    return is_behind == (open.direction == Direction::Forward);
}

}  // namespace

std::vector<std::string> names_at(const nc::Dialect& dialect, nc::TextSource& text,
                                  const References& references, const LineCursor& cursor,
                                  ProgramFiles* files) {
    const std::uint32_t program = program_at(references, cursor.begin);
    TrialLine trial(dialect.tables(), references, cursor, program);
    bool is_number = false;
    if (!find_use(trial, cursor, is_number)) return {};
    using UseKind = TextUse::Kind;
    const bool is_value = trial.use().kind == UseKind::Read || trial.use().kind == UseKind::Write;
    const bool is_program = !is_value && trial.open().rule == OpenUse::Rule::Program;
    std::set<std::string> names;
    const auto add = [&](const std::string& name) {
        const bool is_digits = std::ranges::all_of(name, nc::is_digit);
        if (!name.empty() && (is_digits || !is_number)) names.insert(name);
    };
    for (const TextDeclaration& each : references.declarations) {
        const bool is_own = each.program == program;
        const bool is_variable =
            each.kind == Declared::Variable || each.kind == Declared::Parameter;
        const bool is_target = is_own && each.kind == Declared::Label &&
                               is_in_direction(trial.open(), each.range, cursor);
        const bool fits = is_program ? each.kind == Declared::Program
                          : is_value ? is_own && is_variable
                                     : is_target;
        if (fits) add(each.name);
    }
    for (const NamedPlace& each : references.outside) {
        const bool fits = is_program ? each.kind == Declared::Program
                                     : is_value && each.kind == Declared::Variable;
        if (fits) add(each.name);
    }
    if (is_program && files != nullptr)
        for (const std::string& name : files->names(dialect)) add(name);
    if (is_program || is_value || !is_number) return {names.begin(), names.end()};
    for (const TextDeclaration& each : blocks_of(dialect, text, references, program, kMostBlocks)) {
        if (is_in_direction(trial.open(), each.range, cursor)) add(each.name);
    }
    return {names.begin(), names.end()};
}

}  // namespace kadr::macro
