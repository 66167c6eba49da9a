#include "interp/program_map.h"

#include <algorithm>
#include <vector>

#include "nc/control_words.h"

namespace kadr::interp {

using nc::Statement;

namespace {

/// Places that are remembered; a program has fewer as a rule.
constexpr std::size_t kMostPlaces = 100'000;

/// Bytes of a program that are searched for targets that stand twice.
constexpr std::uint64_t kSearchedForTwice = std::uint64_t{1} << 20;

bool begins_structure(Statement statement) {
    switch (statement) {
        case Statement::If:
        case Statement::While:
        case Statement::Loop:
        case Statement::For:
        case Statement::Repeat: return true;
        default: return false;
    }
}

/// Whether a line with this statement closes a structure of the other one.
bool closes(const nc::LineFront& front, Statement open) {
    switch (front.statement) {
        case Statement::EndIf: return open == Statement::If;
        case Statement::Until: return open == Statement::Repeat;
        case Statement::EndLoop: return (front.closes >> static_cast<unsigned>(open) & 1u) != 0;
        default: return false;
    }
}

bool is_end(Statement statement) {
    return statement == Statement::EndIf || statement == Statement::Until ||
           statement == Statement::EndLoop;
}

}  // namespace

template <typename Look>
ProgramMap::Fault ProgramMap::scan(const LinePosition& from, Look look) {
    if (!source_.seek(from.offset)) return Fault::TextGone;
    LinePosition here = from;
    std::string_view line;
    bool is_too_long = false;
    const std::vector<std::string>& ends = tables_.program.end;
    bool is_behind_head = !(from == begin_);
    while (source_.next(line, is_too_long)) {
        // The mark at the head of a file looks like the one at its end.
        if (here.line > begin_.line && std::ranges::find(ends, line) != ends.end()) break;
        if (nc::program_of_header(tables_.language.calls, line, tables_.rules.ignores_case)) {
            if (is_behind_head) break;
            is_behind_head = true;
        }
        const Place place{here, {source_.offset(), here.line + 1}};
        if (!look(line, place)) break;
        here = place.next;
    }
    return Fault::None;
}

bool ProgramMap::is_target(const nc::LineFront& front, const LineTarget& target) const {
    if (target.label.empty()) return front.number == target.number;
    return nc::ControlWords(tables_, front.label).is_same(front.label, target.label);
}

ProgramMap::Fault ProgramMap::find(const LineTarget& target, Direction direction, const Place& from,
                                   Place& out) {
    const std::tuple key{from.line.offset, direction, target};
    if (const auto known = targets_.find(key); known != targets_.end()) {
        out = known->second;
        return Fault::None;
    }
    std::optional<Place> found;
    Fault fault = Fault::None;
    if (direction != Direction::Backward) {
        fault = scan(from.next, [&](std::string_view line, const Place& place) {
            if (is_target(nc::front_of(tables_, line), target)) found = place;
            return !found;
        });
    }
    if (!found && fault == Fault::None && direction != Direction::Forward) {
        // Backward the nearest one is the last before the jump; from the head on it is the first.
        fault = scan(begin_, [&](std::string_view line, const Place& place) {
            if (place.line.offset > from.line.offset) return false;
            if (is_target(nc::front_of(tables_, line), target)) found = place;
            return !found || direction == Direction::Backward;
        });
    }
    if (fault != Fault::None) return fault;
    if (!found) return Fault::Missing;
    out = *found;
    if (targets_.size() < kMostPlaces) targets_.emplace(key, out);
    return Fault::None;
}

std::optional<ProgramMap::Twice> ProgramMap::twice(const LineTarget& target) {
    if (!twice_) {
        twice_.emplace();
        std::map<LineTarget, std::uint64_t> seen;
        const auto note = [&](const LineTarget& each, std::uint64_t line) {
            const auto [known, is_new] = seen.emplace(each, line);
            if (!is_new) twice_->emplace(each, Twice{known->second, line});
        };
        scan(begin_, [&](std::string_view line, const Place& place) {
            const nc::LineFront front = nc::front_of(tables_, line);
            if (!front.label.empty())
                note({nc::ControlWords(tables_, front.label).normal(front.label), -1},
                     place.line.line);
            if (front.number >= 0) note({"", front.number}, place.line.line);
            return place.line.offset - begin_.offset < kSearchedForTwice &&
                   seen.size() < kMostPlaces;
        });
    }
    LineTarget wanted = target;
    if (!target.label.empty())
        wanted = {nc::ControlWords(tables_, target.label).normal(target.label), -1};
    const auto found = twice_->find(wanted);
    return found == twice_->end() ? std::nullopt : std::optional(found->second);
}

ProgramMap::Fault ProgramMap::find_end(const Place& head, const nc::LineFront& front,
                                       const Structure*& out) {
    if (const auto known = structures_.find(head.line.offset); known != structures_.end()) {
        out = &known->second;
        return Fault::None;
    }
    std::vector<nc::LineFront> open{front};
    Structure structure;
    bool is_wrong = false;
    bool is_numbered_twice = false;
    const Fault fault = scan(head.next, [&](std::string_view line, const Place& place) {
        const nc::LineFront here = nc::front_of(tables_, line);
        if (begins_structure(here.statement)) {
            is_numbered_twice |= here.loop != 0 && std::ranges::any_of(open, [&](const auto& o) {
                                     return o.loop == here.loop;
                                 });
            open.push_back(here);
            return !is_numbered_twice;
        }
        if (here.statement == Statement::Else) {
            is_wrong =
                open.back().statement != Statement::If || (open.size() == 1 && structure.otherwise);
            if (open.size() == 1) structure.otherwise = place;
            return !is_wrong;
        }
        if (!is_end(here.statement)) return true;
        // An end of a condition inside of a loop that none has opened there: it is passed over.
        if (here.statement == Statement::EndIf && open.back().statement != Statement::If)
            return true;
        is_wrong = !closes(here, open.back().statement) || here.loop != open.back().loop;
        if (!is_wrong) open.pop_back();
        if (open.empty()) structure.end = place;
        return !is_wrong && !open.empty();
    });
    if (fault != Fault::None) return fault;
    if (is_numbered_twice) return Fault::LoopNumber;
    if (is_wrong || !open.empty()) return Fault::Missing;
    if (structures_.size() >= kMostPlaces) structures_.clear();
    out = &structures_.emplace(head.line.offset, structure).first->second;
    return Fault::None;
}

ProgramMap::Fault ProgramMap::find_label_between(std::string_view label, const LinePosition& from,
                                                 const LinePosition& to, Place& out) {
    const LineTarget target{std::string(label), -1};
    std::optional<Place> found;
    const Fault fault = scan(from, [&](std::string_view line, const Place& place) {
        if (place.line.offset >= to.offset) return false;
        if (is_target(nc::front_of(tables_, line), target)) found = place;
        return !found;
    });
    if (fault != Fault::None) return fault;
    if (!found) return Fault::Missing;
    out = *found;
    return Fault::None;
}

bool ProgramMap::is_empty_between(const LinePosition& from, const LinePosition& to) {
    bool all_empty = true;
    const Fault fault = scan(from, [&](std::string_view line, const Place& place) {
        if (place.line.offset >= to.offset) return false;
        all_empty = nc::front_of(tables_, line).is_empty;
        return all_empty;
    });
    return fault == Fault::None && all_empty;
}

}  // namespace kadr::interp
