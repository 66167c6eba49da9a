#include "macro/program_units.h"

#include <algorithm>

namespace kadr::macro {

namespace {

/// Ids of lines outside of the main text: above all its lines, in windows that texts take in turn.
constexpr std::uint32_t kFirstId = std::uint32_t{1} << 31;
constexpr unsigned kWindowBits = 14;

}  // namespace

ProgramText::ProgramText(nc::TextSource& text, std::string name_, std::size_t kept,
                         std::size_t longest)
    : name(std::move(name_)),
      kept_text(text, kept),
      is_kept(!text.seek(0)),
      source(is_kept ? static_cast<nc::TextSource&>(kept_text) : text, longest) {}

ProgramUnits::ProgramUnits(const nc::Dialect& dialect, nc::TextSource& main, std::string name,
                           std::size_t kept, ProgramFiles* files)
    : dialect_(dialect), tables_(dialect.tables()), kept_(kept), files_(files) {
    texts_.push_back(
        std::make_unique<ProgramText>(main, std::move(name), kept_, tables_.notation.max_line));
    main_ = std::make_unique<ProgramUnit>(tables_, *texts_[0], LinePosition{}, std::string());
}

void ProgramUnits::settle_main() {
    const LinePosition begin = main_begin();
    if (begin.offset != 0)
        main_ = std::make_unique<ProgramUnit>(tables_, *texts_[0], begin, std::string());
}

/// Where subprograms stand first, behind them: at the first head of another kind, if there is one.
LinePosition ProgramUnits::main_begin() const {
    const nc::CallLanguage& calls = tables_.language.calls;
    const bool has_kinds = std::ranges::any_of(calls.headers, &nc::ProgramPattern::is_subprogram);
    ProgramText& text = *texts_[0];
    if (!has_kinds) return {};
    LinePosition here;
    LinePosition begin;
    std::string_view line;
    bool is_too_long = false;
    bool is_behind_subprogram = false;
    while (text.source.next(line, is_too_long)) {
        const bool is_blank = line.find_first_not_of(" \t\r") == std::string_view::npos;
        const nc::ProgramPattern* const head =
            nc::header_of(calls, line, tables_.notation.ignores_case);
        if (head != nullptr && !head->is_subprogram) {
            if (is_behind_subprogram) begin = here;
            break;
        }
        // A text that does not begin with the head of a subprogram begins with its main program.
        if (head == nullptr && !is_behind_subprogram && !is_blank) break;
        if (head != nullptr && !is_behind_subprogram) {
            is_behind_subprogram = true;
            if (text.is_kept && !text.kept_text.keep_all()) break;
        }
        if (head != nullptr) {
            const auto name = nc::program_of_header(calls, line, tables_.notation.ignores_case);
            if (name) text.programs[*name].emplace(nc::kind_of(*head), here);
        }
        here = {text.source.offset(), here.line + 1};
    }
    text.source.seek(0);
    return begin;
}

ProgramUnit* ProgramUnits::find(const std::string& name, ProgramText& near,
                                const std::string& kind) {
    if (const auto known = units_.find({name, kind}); known != units_.end())
        return known->second.get();
    ProgramText* text = &near;
    std::optional<LinePosition> begin = find_in(near, name, kind);
    if (!begin && text != texts_[0].get()) {
        text = texts_[0].get();
        begin = find_in(*text, name, kind);
    }
    if (!begin) begin = find_in_file(name, kind, text);
    return begin ? &keep(name, kind, *text, *begin) : nullptr;
}

ProgramUnit* ProgramUnits::find_definitions(const std::string& name) {
    // A look for it in the whole text would read that before it runs.
    ProgramText* text = texts_[0].get();
    if (const LinePosition* known = first_of(*text, name, {}, true))
        return &keep(name, {}, *text, *known);
    const std::optional<LinePosition> begin = find_in_file(name, {}, text);
    return begin ? &keep(name, {}, *text, *begin) : nullptr;
}

ProgramUnit& ProgramUnits::add(std::unique_ptr<nc::TextSource> source, std::string name) {
    texts_.push_back(
        std::make_unique<ProgramText>(*source, std::move(name), kept_, tables_.notation.max_line));
    texts_.back()->own = std::move(source);
    added_.push_back(
        std::make_unique<ProgramUnit>(tables_, *texts_.back(), LinePosition{}, std::string()));
    return *added_.back();
}

/// text  is set to that of the file
std::optional<LinePosition> ProgramUnits::find_in_file(const std::string& name,
                                                       const std::string& kind,
                                                       ProgramText*& text) {
    if (files_ == nullptr) return std::nullopt;
    auto file = files_->open(dialect_, name, kind);
    if (!file) return std::nullopt;
    texts_.push_back(std::make_unique<ProgramText>(*file->text, std::move(file->name), kept_,
                                                   tables_.notation.max_line));
    text = texts_.back().get();
    text->own = std::move(file->text);
    // One that stands behind another in its file begins at its own head.
    const std::optional<LinePosition> begin = find_in(*text, name, kind);
    return begin && text->programs.size() != 1 ? *begin : LinePosition{};
}

ProgramUnit& ProgramUnits::keep(const std::string& name, const std::string& kind, ProgramText& text,
                                const LinePosition& begin) {
    auto unit = std::make_unique<ProgramUnit>(tables_, text, begin, name);
    look_for_head(*unit);
    return *units_.emplace(std::pair(name, kind), std::move(unit)).first->second;
}

/// Of the heads that were seen, the one that the control finds first; nullptr: none, or a better
/// one may come still.
///
/// is_whole  nothing more is to be seen
const LinePosition* ProgramUnits::first_of(const ProgramText& text, const std::string& name,
                                           const std::string& kind, bool is_whole) const {
    const auto known = text.programs.find(name);
    if (known == text.programs.end()) return nullptr;
    const auto& kinds = known->second;
    const auto place_of = [&](const std::string& wanted) {
        const auto found = kinds.find(wanted);
        return found == kinds.end() ? nullptr : &found->second;
    };
    if (!kind.empty()) return place_of(kind);
    if (const LinePosition* line = place_of({})) return line;
    for (const nc::ProgramPattern& pattern : tables_.language.calls.files) {
        if (const LinePosition* line = place_of(nc::kind_of(pattern))) return line;
        if (!is_whole) return nullptr;  // one of the first kind may come still
    }
    return &kinds.begin()->second;
}

/// Where the program begins in the text; heads before it are remembered.
std::optional<LinePosition> ProgramUnits::find_in(ProgramText& text, const std::string& name,
                                                  const std::string& kind) const {
    const nc::CallLanguage& calls = tables_.language.calls;
    const bool ignores_case = tables_.notation.ignores_case;
    const auto seen = [&]() -> std::optional<LinePosition> {
        const LinePosition* const place = first_of(text, name, kind, text.is_seen_whole);
        return place != nullptr ? std::optional(*place) : std::nullopt;
    };
    if (auto place = seen()) return place;
    if (text.is_seen_whole || calls.headers.empty()) return std::nullopt;
    if (text.is_kept && !text.kept_text.keep_all()) return std::nullopt;
    if (!text.source.seek(text.seen.offset)) return std::nullopt;
    std::string_view line;
    bool is_too_long = false;
    while (text.source.next(line, is_too_long)) {
        const LinePosition here = text.seen;
        text.seen = {text.source.offset(), here.line + 1};
        const auto found = nc::program_of_header(calls, line, ignores_case);
        if (!found) continue;
        text.programs[*found].emplace(nc::kind_of(*nc::header_of(calls, line, ignores_case)), here);
        if (*found != name) continue;
        if (auto place = seen()) return place;
    }
    text.is_seen_whole = true;
    return seen();
}

/// The first line that is more than a number or a comment may be the head of a procedure.
void ProgramUnits::look_for_head(ProgramUnit& unit) const {
    const auto& statements = tables_.language.statements;
    const bool has_procedures = std::ranges::any_of(statements, [](const nc::StatementForm& form) {
        return form.statement == nc::Statement::Procedure;
    });
    if (!has_procedures || !unit.text->source.seek(unit.begin.offset)) return;
    std::string_view line;
    bool is_too_long = false;
    bool is_first = true;
    LinePosition here = unit.begin;
    LinePosition next = unit.begin;
    while (unit.text->source.next(line, is_too_long)) {
        here = std::exchange(next, {unit.text->source.offset(), next.line + 1});
        const bool is_header =
            nc::program_of_header(tables_.language.calls, line, tables_.notation.ignores_case)
                .has_value();
        if (is_header && !is_first) return;
        is_first = false;
        const nc::LineFront front = nc::front_of(tables_, line);
        if (is_header || front.is_empty) continue;
        if (front.statement != nc::Statement::Procedure) return;
        nc::ControlLine head;
        unit.has_wrong_head = compile_line(tables_, nc::SymbolTable(), line, head).has_value();
        if (!unit.has_wrong_head && !head.statements.empty()) unit.head = std::move(head);
        unit.head_line = here;
        return;
    }
}

std::uint32_t ProgramUnits::line_id(ProgramText& text, std::uint64_t line) {
    if (&text == texts_[0].get()) return static_cast<std::uint32_t>(line);
    const std::uint64_t window = line >> kWindowBits;
    while (text.windows.size() <= window) {
        windows_.push_back({&text, std::uint64_t{text.windows.size()} << kWindowBits});
        text.windows.push_back(static_cast<std::uint32_t>(windows_.size() - 1));
    }
    const std::uint64_t in_window = line & ((std::uint64_t{1} << kWindowBits) - 1);
    return kFirstId + static_cast<std::uint32_t>(
                          (std::uint64_t{text.windows[window]} << kWindowBits) + in_window);
}

ProgramUnits::Line ProgramUnits::line_of(std::uint32_t id) const {
    const std::size_t window = id < kFirstId ? windows_.size() : (id - kFirstId) >> kWindowBits;
    if (window >= windows_.size()) return {texts_[0].get(), id};
    const std::uint32_t in_window = (id - kFirstId) & ((std::uint32_t{1} << kWindowBits) - 1);
    return {windows_[window].text, windows_[window].first + in_window};
}

}  // namespace kadr::macro
