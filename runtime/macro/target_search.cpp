#include "macro/target_search.h"

#include <algorithm>
#include <optional>

#include "nc/control_words.h"

namespace kadr::macro {

using Rule = OpenUse::Rule;

namespace {

/// A line of which nothing but its beginning is known: what is looked for stands behind that.
ProgramLine line_at(const LinePosition& at) { return {at, {at.offset + 1, at.line + 1}}; }

/// The head of a program, from which a search finds the line itself as well.
ProgramLine head_at(const LinePosition& begin) { return {begin, begin}; }

/// A line of a text; empty: it cannot be read again.
std::string read_line(nc::LineSource& source, const LinePosition& at) {
    std::string_view line;
    bool is_too_long = false;
    const bool is_there = source.seek(at.offset) && source.next(line, is_too_long);
    return is_there ? std::string(line) : std::string();
}

TextRange range_of(std::string_view line, std::string_view part, const LinePosition& at) {
    const auto begin = at.offset + static_cast<std::uint64_t>(part.data() - line.data());
    return {begin, begin + part.size(), at.line};
}

}  // namespace

std::uint32_t OutsideNames::add(NamedPlace declaration) {
    const auto index = static_cast<std::uint32_t>(out_.outside.size());
    const auto [known, is_new] =
        known_.emplace(std::pair(declaration.file, declaration.range.begin), index);
    if (is_new) out_.outside.push_back(std::move(declaration));
    return known->second;
}

TargetSearch::TargetSearch(const nc::DialectTables& tables, ProgramUnits& units, ProgramText& text,
                           ScannedText& scanned, OutsideNames& outside)
    : tables_(tables), units_(units), text_(text), scanned_(scanned), outside_(outside) {
    for (std::uint32_t i = 0; i < scanned.programs.size(); ++i) {
        places_.emplace(scanned.programs[i].begin.offset, i);
        places_.emplace(scanned.programs[i].head.offset, i);
    }
}

/// Returns depend on all calls, and parts on what stands in front of them.
void TargetSearch::run() {
    found_.resize(scanned_.open.size());
    for (std::uint32_t i = 0; i < scanned_.open.size(); ++i)
        if (scanned_.open[i].rule != Rule::OfReturn) settle(i);
    for (const OpenUse& open : scanned_.open)
        if (open.rule == Rule::OfReturn) settle_return(open);
    settle_arguments();
}

void TargetSearch::settle(std::uint32_t index) {
    const OpenUse& open = scanned_.open[index];
    Found& found = found_[index];
    const LinePosition& begin = scanned_.programs[open.place].begin;
    switch (open.rule) {
        case Rule::Program: return settle_program(open, found);
        case Rule::Nearest:
            return settle_in_text(
                open, scanned_.index.find(open.target, open.direction, open.from, begin), found);
        case Rule::FromHead: return settle_in_text(open, first_in(open.place, open.target), found);
        case Rule::Around: return settle_in_text(open, around(open), found);
        case Rule::Counted: return settle_counted(open, found);
        case Rule::Behind: return settle_behind(open, found);
        case Rule::InCalled:
            if (open.other == OpenUse::kNone) {
                scanned_.references.uses[open.use].outcome = Outcome::Computed;
                return;
            }
            if (const ProgramUnit* const unit = found_[open.other].unit)
                settle_called(open, open.other, head_at(unit->begin), found);
            return;
        case Rule::OfReturn: return;
    }
}

// ------------------------------------------------------------------------------ programs

ProgramUnit* TargetSearch::unit_of(const std::string& name, const std::string& kind) {
    const auto [known, is_new] = programs_.emplace(std::pair(name, kind), nullptr);
    if (is_new) known->second = units_.find(name, text_, kind);
    return known->second;
}

/// The program of this text that it is; OpenUse::kNone: it stands in another one.
std::uint32_t TargetSearch::place_of(const ProgramUnit& unit) const {
    if (unit.text != &text_ && unit.text->name != scanned_.references.file) return OpenUse::kNone;
    const auto found = places_.find(unit.begin.offset);
    return found == places_.end() ? OpenUse::kNone : found->second;
}

void TargetSearch::settle_program(const OpenUse& open, Found& found) {
    TextUse& use = scanned_.references.uses[open.use];
    found.unit = unit_of(use.name, open.kind);
    if (found.unit == nullptr) return;
    found.place = place_of(*found.unit);
    if (found.place == OpenUse::kNone) {
        use.outcome = Outcome::Elsewhere;
        use.target = outside_.add(declaration_of(*found.unit));
        return;
    }
    use.outcome = Outcome::Here;
    use.target = scanned_.programs[found.place].declaration;
    if (use.kind == TextUse::Kind::Call) callers_[found.place].insert(open.place);
}

/// Its name stands in its own head, else in that of its procedure; the name of a file alone stands
/// nowhere.
NamedPlace TargetSearch::declaration_of(const ProgramUnit& unit) const {
    NamedPlace out{unit.text->name,
                   TextDeclaration::Kind::Program,
                   unit.name,
                   {unit.begin.offset, unit.begin.offset, unit.begin.line}};
    nc::LineSource& source = unit.text->source;
    LinePosition here = unit.begin;
    std::string_view line;
    bool is_too_long = false;
    bool is_more = source.seek(here.offset);
    while (is_more && source.next(line, is_too_long)) {
        const bool ignores_case = tables_.notation.ignores_case;
        if (const auto name = nc::name_in_header(tables_.language.calls, line, ignores_case)) {
            out.range = range_of(line, *name, here);
            break;
        }
        const bool is_mark =
            std::ranges::find(tables_.program.end, line) != tables_.program.end.end();
        is_more = is_mark || nc::front_of(tables_, line).is_empty;
        here = {source.offset(), here.line + 1};
    }
    const nc::ControlStatement* const head = unit.procedure();
    if (head == nullptr || out.range.end != out.range.begin) return out;
    const std::uint64_t begin = unit.head_line.offset;
    out.range = {begin + head->span.begin, begin + head->span.end, unit.head_line.line};
    return out;
}

NamedPlace TargetSearch::declaration_of(const ProgramUnit& unit, const ProgramLine& line,
                                        const LineTarget& target) const {
    using Kind = TextDeclaration::Kind;
    const std::string text = read_line(unit.text->source, line.line);
    const nc::LineFront front = nc::front_of(tables_, text);
    if (!target.label.empty())
        return {unit.text->name, Kind::Label, target.label, range_of(text, front.label, line.line)};
    const std::uint64_t begin = line.line.offset;
    return {unit.text->name,
            Kind::Block,
            std::to_string(target.number),
            {begin + front.number_span.begin, begin + front.number_span.end, line.line.line}};
}

// ------------------------------------------------------------------------------ targets

const TargetIndex::Hit* TargetSearch::first_in(std::uint32_t place,
                                               const LineTarget& target) const {
    const LinePosition& begin = scanned_.programs[place].begin;
    return scanned_.index.find(target, Direction::Forward, head_at(begin), begin);
}

const TargetIndex::Hit* TargetSearch::around(const OpenUse& open) const {
    const LinePosition& begin = scanned_.programs[open.place].begin;
    const auto* const hit = scanned_.index.find(open.target, Direction::Backward, open.from, begin);
    return hit != nullptr ? hit
                          : scanned_.index.find(open.target, Direction::Forward, open.from, begin);
}

void TargetSearch::settle_in_text(const OpenUse& open, const TargetIndex::Hit* hit, Found& found) {
    if (hit == nullptr) return;
    TextUse& use = scanned_.references.uses[open.use];
    use.outcome = Outcome::Here;
    use.target = hit->declaration;
    found.line = line_at(hit->line);
}

void TargetSearch::settle_counted(const OpenUse& open, Found& found) {
    const TargetIndex::Hit* const called = first_in(open.place, open.target);
    const TargetIndex::Hit* const repeated = around(open);
    if (called == repeated) return settle_in_text(open, called, found);
    scanned_.references.uses[open.use].outcome = Outcome::Ambiguous;
}

/// The end of a section, behind its beginning.
void TargetSearch::settle_behind(const OpenUse& open, Found& found) {
    TextUse& use = scanned_.references.uses[open.use];
    if (open.other == OpenUse::kNone) {
        use.outcome = Outcome::Computed;
        return;
    }
    const Found& first = found_[open.other];
    if (!first.line) return;
    if (first.called != OpenUse::kNone)
        return settle_called(open, first.called, *first.line, found);
    const LinePosition& begin = scanned_.programs[open.place].begin;
    settle_in_text(open, scanned_.index.find(open.target, Direction::Forward, *first.line, begin),
                   found);
}

/// A target in the program that is called, wherever that stands.
void TargetSearch::settle_called(const OpenUse& open, std::uint32_t called, const ProgramLine& from,
                                 Found& found) {
    const Found& program = found_[called];
    found.called = called;
    if (program.place != OpenUse::kNone) {
        const LinePosition& begin = scanned_.programs[program.place].begin;
        const bool is_head = from.line == from.next;
        return settle_in_text(open,
                              scanned_.index.find(open.target, Direction::Forward,
                                                  is_head ? head_at(begin) : from, begin),
                              found);
    }
    ProgramLine line;
    if (program.unit->map.find(open.target, Direction::Forward, from, line) !=
        ProgramMap::Fault::None)
        return;
    found.line = line;
    TextUse& use = scanned_.references.uses[open.use];
    use.outcome = Outcome::Elsewhere;
    use.target = outside_.add(declaration_of(*program.unit, line, open.target));
}

/// In the main program it is a jump, where a return begins that again. Else the callers have the
/// target, as far as they stand in this text.
void TargetSearch::settle_return(const OpenUse& open) {
    TextUse& use = scanned_.references.uses[open.use];
    if (use.outcome == Outcome::OfCaller) return;
    Found ignored;
    if (scanned_.programs[open.place].is_main && tables_.language.rules.return_restarts_main)
        return settle_in_text(open, first_in(open.place, open.target), ignored);
    const auto callers = callers_.find(open.place);
    if (callers == callers_.end()) {
        use.outcome = Outcome::OfCaller;
        return;
    }
    std::set<const TargetIndex::Hit*> hits;
    for (const std::uint32_t caller : callers->second) hits.insert(first_in(caller, open.target));
    if (hits.size() == 1) return settle_in_text(open, *hits.begin(), ignored);
    use.outcome = Outcome::Ambiguous;
}

/// What a procedure takes as the caller's variable itself, it may set.
void TargetSearch::settle_arguments() {
    for (const OpenArgument& argument : scanned_.arguments) {
        const ProgramUnit* const unit = found_[argument.call].unit;
        const nc::ControlStatement* const head = unit != nullptr ? unit->procedure() : nullptr;
        if (head == nullptr || argument.position >= head->parameters.size()) continue;
        if (head->parameters[argument.position].is_reference)
            scanned_.references.uses[argument.use].kind = TextUse::Kind::Write;
    }
}

}  // namespace kadr::macro
