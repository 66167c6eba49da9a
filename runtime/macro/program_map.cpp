#include "macro/program_map.h"

#include <algorithm>
#include <vector>

#include "nc/control_words.h"

namespace kadr::macro {

using nc::Statement;

namespace {

/// Positions that are remembered; a program has fewer as a rule.
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
        if (nc::program_of_header(tables_.language.calls, line, tables_.notation.ignores_case)) {
            if (is_behind_head) break;
            is_behind_head = true;
        }
        const ProgramLine program_line{here, {source_.offset(), here.line + 1}};
        if (!look(line, program_line)) break;
        here = program_line.next;
    }
    return Fault::None;
}

bool ProgramMap::is_target(const nc::LineFront& front, const LineTarget& target) const {
    if (target.label.empty()) return front.number == target.number;
    return nc::ControlWords(tables_, front.label).is_same(front.label, target.label);
}

ProgramMap::Fault ProgramMap::find(const LineTarget& target, Direction direction,
                                   const ProgramLine& from, ProgramLine& out) {
    const std::tuple key{from.line.offset, direction, target};
    if (const auto known = targets_.find(key); known != targets_.end()) {
        out = known->second;
        return Fault::None;
    }
    std::optional<ProgramLine> found;
    Fault fault = Fault::None;
    if (direction != Direction::Backward) {
        fault = scan(from.next, [&](std::string_view line, const ProgramLine& program_line) {
            if (is_target(nc::front_of(tables_, line), target)) found = program_line;
            return !found;
        });
    }
    if (!found && fault == Fault::None && direction != Direction::Forward) {
        // Backward the nearest one is the last before the jump; from the head on it is the first.
        fault = scan(begin_, [&](std::string_view line, const ProgramLine& program_line) {
            if (program_line.line.offset > from.line.offset) return false;
            if (is_target(nc::front_of(tables_, line), target)) found = program_line;
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
        scan(begin_, [&](std::string_view line, const ProgramLine& program_line) {
            const nc::LineFront front = nc::front_of(tables_, line);
            if (!front.label.empty())
                note({nc::ControlWords(tables_, front.label).normal(front.label), -1},
                     program_line.line.line);
            if (front.number >= 0) note({"", front.number}, program_line.line.line);
            return program_line.line.offset - begin_.offset < kSearchedForTwice &&
                   seen.size() < kMostPlaces;
        });
    }
    LineTarget wanted = target;
    if (!target.label.empty())
        wanted = {nc::ControlWords(tables_, target.label).normal(target.label), -1};
    const auto found = twice_->find(wanted);
    return found == twice_->end() ? std::nullopt : std::optional(found->second);
}

namespace {

/// The structures that are open behind a head, line by line, until its own end.
class OpenStructures {
  public:
    explicit OpenStructures(const nc::LineFront& head) : open_{head} {}

    enum class Step : std::uint8_t { On, Done, Crossed, SecondElse, NumberedTwice };

    /// The line of the innermost structure; 0: of the one that was begun with.
    std::uint64_t innermost() const { return open_.size() == 1 ? 0 : heads_.back(); }

    Step take(const nc::LineFront& line, const ProgramLine& program_line, StructureParts& out) {
        if (begins_structure(line.statement)) return begin(line, program_line);
        if (line.statement == Statement::Else) return take_else(program_line, out);
        return is_end(line.statement) ? end(line, program_line, out) : Step::On;
    }

  private:
    Step begin(const nc::LineFront& line, const ProgramLine& program_line) {
        const bool is_numbered_twice =
            line.loop != 0 &&
            std::ranges::any_of(open_, [&](const auto& open) { return open.loop == line.loop; });
        open_.push_back(line);
        heads_.push_back(program_line.line.line);
        return is_numbered_twice ? Step::NumberedTwice : Step::On;
    }

    /// Of a condition inside, its own map looks at the order.
    Step take_else(const ProgramLine& program_line, StructureParts& out) {
        const bool is_own = open_.size() == 1;
        if (open_.back().statement != Statement::If) return Step::Crossed;
        if (is_own && out.otherwise) return Step::SecondElse;
        if (is_own) out.otherwise = program_line;
        return Step::On;
    }

    Step end(const nc::LineFront& line, const ProgramLine& program_line, StructureParts& out) {
        // An end of a condition inside of a loop that none has opened there: it is passed over.
        if (line.statement == Statement::EndIf && open_.back().statement != Statement::If)
            return Step::On;
        if (!closes(line, open_.back().statement) || line.loop != open_.back().loop)
            return Step::Crossed;
        open_.pop_back();
        if (!open_.empty()) heads_.pop_back();
        if (!open_.empty()) return Step::On;
        out.end = program_line;
        return Step::Done;
    }

    std::vector<nc::LineFront> open_;
    std::vector<std::uint64_t> heads_;  // lines of those inside, one fewer
};

}  // namespace

ProgramMap::Fault ProgramMap::find_end(const ProgramLine& head, const nc::LineFront& front,
                                       const StructureParts*& out, Crossing& crossing) {
    if (const auto known = structures_.find(head.line.offset); known != structures_.end()) {
        out = &known->second;
        return Fault::None;
    }
    using Step = OpenStructures::Step;
    OpenStructures open(front);
    StructureParts structure;
    Step step = Step::On;
    const Fault fault =
        scan(head.next, [&](std::string_view line, const ProgramLine& program_line) {
            step = open.take(nc::front_of(tables_, line), program_line, structure);
            if (step != Step::On && step != Step::Done)
                crossing = {program_line.line.line, std::string(line), step == Step::SecondElse,
                            open.innermost()};
            return step == Step::On;
        });
    if (fault != Fault::None) return fault;
    if (step == Step::NumberedTwice) return Fault::LoopNumber;
    if (step != Step::Done) return Fault::Missing;
    if (structures_.size() >= kMostPlaces) structures_.clear();
    out = &structures_.emplace(head.line.offset, structure).first->second;
    return Fault::None;
}

ProgramMap::Fault ProgramMap::find_label_between(std::string_view label, const LinePosition& from,
                                                 const LinePosition& to, ProgramLine& out) {
    const LineTarget target{std::string(label), -1};
    std::optional<ProgramLine> found;
    const Fault fault = scan(from, [&](std::string_view line, const ProgramLine& program_line) {
        if (program_line.line.offset >= to.offset) return false;
        if (is_target(nc::front_of(tables_, line), target)) found = program_line;
        return !found;
    });
    if (fault != Fault::None) return fault;
    if (!found) return Fault::Missing;
    out = *found;
    return Fault::None;
}

bool ProgramMap::finds_nothing_between(const LinePosition& from, const LinePosition& to) {
    bool all_empty = true;
    const Fault fault = scan(from, [&](std::string_view line, const ProgramLine& program_line) {
        if (program_line.line.offset >= to.offset) return false;
        all_empty = nc::front_of(tables_, line).is_empty;
        return all_empty;
    });
    return fault == Fault::None && all_empty;
}

}  // namespace kadr::macro
