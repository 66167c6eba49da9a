// shape_cycles.cpp — cycles of the control along a shape whose numbered blocks stand in the
// program.
#include "expand/shape_cycles.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "base/assert.h"
#include "expand/blocks.h"
#include "expand/contour_values.h"
#include "expand/cuts.h"
#include "expand/cycles.h"
#include "expand/follow.h"
#include "nc/parameters.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;

namespace {

/// What the call gives, in the order of the control's parameters.
struct ShapeCall {
    PlaneContour shape;
    std::uint32_t given = 0;
    std::array<double, nc::kMaxArguments> values{};
    bool is_asked = false;  // whether the control would have it: nothing is written

    void set(int parameter, double value) {
        values[static_cast<std::size_t>(parameter)] = value;
        given |= 1u << parameter;
    }
};

ShapeCall call_of(Running& run, const nc::CycleInfo& cycle, const Slot* registers) {
    ShapeCall call;
    using Kind = sema::ParameterInfo::Kind;
    for (const sema::ParameterInfo& parameter : run.vm.calls.back().function->parameters) {
        const Slot slot = registers[parameter.slot];
        if (parameter.kind == Kind::Contour) call.shape = read_contour(run, slot);
        if (parameter.name == "is_asked") call.is_asked = slot.integer != 0;
        const auto index = nc::find_parameter(cycle.parameters, parameter.name);
        if (!index) continue;
        const bool is_number = parameter.kind == Kind::Number;
        const double value = is_number ? slot.number : static_cast<double>(slot.integer);
        // An allowance of nothing is said by no word.
        if (is_number && value == 0) continue;
        call.set(static_cast<int>(*index), value);
    }
    return call;
}

/// Whether all is known that the blocks behind the cycle would need, and nothing else waits for
/// them.
bool is_known_state(const Running& run) {
    const ModalState& modal = run.modal;
    const AxisMask lathe = bit(Axis::X) | bit(Axis::Z);
    return modal.lost.what() == 0 && modal.lost.restate() == 0 && modal.drifts.unplaced() == 0 &&
           !modal.compensation.is_choice() && !modal.feed.is_lost() && !modal.has_ended &&
           !is_between_positions(run) && (modal.position.known() & lathe) == lathe;
}

/// Whether the shape's blocks, passed over and executed by the cycle, are what moves would be.
bool is_plain_state(const Running& run) {
    const ModalState& modal = run.modal;
    if (nc::has_fact(modal[Group::RadiusComp], nc::Fact::CompSide)) return false;
    if (modal[Group::FeedMode] == Function::FeedInverseTime) return false;
    if (modal.tcp.acts() || !modal.frame.now().is_shift()) return false;
    return modal[Group::Distance] == Function::Absolute && modal[Group::Plane] == Function::PlaneZx;
}

std::int64_t greatest_number(const sema::Code& code) {
    std::int64_t greatest = 0;
    for (const sema::Plan& plan : code.plans)
        greatest = std::max(greatest, std::int64_t{plan.number});
    return greatest + nc::kMostSections;
}

/// A further number; nothing: the control has none above those of the program. Between both lies
/// room for the numbers of the sections.
std::optional<std::int32_t> next_number(Running& run) {
    constexpr std::int64_t kStep = 10;
    const nc::BlockNumbers& numbers = run.target.tables().block_numbers;
    std::int64_t& greatest = run.shapes.greatest;
    const std::int64_t next = (greatest / kStep + 1) * kStep;
    if (next > std::min<std::int64_t>(numbers.most, std::numeric_limits<std::int32_t>::max()))
        return std::nullopt;
    greatest = next;
    return static_cast<std::int32_t>(next);
}

bool is_same(const path::Vec2& a, const path::Vec2& b) {
    return (a - b).norm() <= path::kSamePoint;
}

/// Whether one cut goes along both: they may leave the part differently far by their last line.
bool is_same_cut(const path::Contour& a, const path::Contour& b) {
    if (a.size() != b.size() || a.empty()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool is_last = i + 1 == a.size();
        if (!is_same(a[i].from, b[i].from) || a[i].is_arc() != b[i].is_arc()) return false;
        if (a[i].is_arc()) {
            const bool turn_alike = (a[i].sweep > 0) == (b[i].sweep > 0);
            if (!turn_alike || !is_same(a[i].center, b[i].center)) return false;
        }
        if (is_last && !a[i].is_arc()) {
            const path::Vec2 one = path::start_direction(a[i]);
            return is_same(one, path::start_direction(b[i]));
        }
        if (!is_same(a[i].to, b[i].to)) return false;
    }
    return true;
}

/// Whether the way to the beginning of an element is none, or goes on straight in it.
bool leads_straight(const path::Vec2& from, const path::Element& element) {
    if (is_same(from, element.from)) return true;
    const path::Vec2 way = (element.from - from).normalized();
    return !element.is_arc() && is_same(way, path::start_direction(element));
}

const WrittenShape* written(const WrittenShapes& shapes, const path::Contour& elements) {
    const auto found = std::find_if(
        shapes.all.rbegin(), shapes.all.rend(),
        [&](const WrittenShape& shape) { return is_same_cut(shape.elements, elements); });
    return found == shapes.all.rend() ? nullptr : &*found;
}

/// The block of the call.
Done emit_call(Running& run, nc::CycleId cycle, const ShapeCall& call, SourceId source,
               std::uint32_t at) {
    if (!require_room(run, at)) return kFailed;
    const std::size_t count = run.target.cycles()[cycle].parameters.size();
    Block& block = next_block(run, source);
    nc::Invocation* const invocation = block.add(Function::Cycle, count);
    KADR_ASSERT(invocation != nullptr, "a cycle has more parameters than a block holds");
    block.cycle = cycle;
    for (std::size_t i = 0; i < count; ++i) {
        if ((call.given >> i & 1u) != 0) block.set_argument(*invocation, i, call.values[i]);
    }
    if (run.options.trace) keep_trace_of_caller(run, at, 0, source);
    return kDone;
}

/// The first block of the shape, which moves across the cuts alone, at rapid: so begin the cuts.
Done emit_first(Running& run, std::size_t across, double to, const FollowedBlock& next,
                std::uint32_t at) {
    if (!require_room(run, at)) return kFailed;
    Block& block = next_block(run, next.source);
    block.number = next.number;
    block.motion = Function::Rapid;
    block.set(static_cast<nc::Slot>(across), to);
    return finish_followed(run, block, next, at);
}

Done emit_shape(Running& run, const ShapeCall& call, std::size_t across, const WrittenShape& shape,
                FollowedBlock next, std::uint32_t at) {
    const Wording wording{call.shape.plane, run.modal.is_diameter};
    const PlaneIndices axes = wording.axes();
    const path::Contour& elements = call.shape.elements;
    const path::Vec2 begin = elements.front().from;
    const path::Vec2 begin_words = wording.words(begin);
    next.number = shape.first;
    const double to = across == axes.first ? begin_words[0] : begin_words[1];
    if (!emit_first(run, across, to, next, at)) return kFailed;
    next.number = -1;
    const path::Vec2 here =
        wording.point({run.modal.position[axes.first], run.modal.position[axes.second]});
    if (!leads_straight(here, elements.front()) &&
        !emit_element(run, path::line_element(here, begin), next, at))
        return kFailed;
    for (const path::Element& element : elements) {
        if (&element == &elements.back()) next.number = shape.last;
        if (!emit_element(run, element, next, at)) return kFailed;
    }
    return kDone;
}

}  // namespace

CycleOutcome emit_shape_cycle(Running& run, nc::CycleId cycle, const Slot* registers) {
    const nc::BlockNumbers& numbers = run.target.tables().block_numbers;
    if (!run.options.native_cycles || numbers.is_on || !is_known_state(run) || !is_plain_state(run))
        return CycleOutcome::Moves;
    const nc::CycleInfo& info = run.target.cycles()[cycle];
    ShapeCall call = call_of(run, info, registers);
    if (call.shape.elements.empty() || call.shape.plane != path::Plane::Zx ||
        run.status.has_failed())
        return CycleOutcome::Moves;
    WrittenShapes& shapes = run.shapes;
    if (shapes.greatest < 0) shapes.greatest = greatest_number(run.code);
    const auto facing = nc::find_parameter(info.parameters, "facing");
    WrittenShape shape{call.shape.elements};
    if (const WrittenShape* const before = facing ? nullptr : written(shapes, shape.elements)) {
        shape.first = before->first;
        shape.last = before->last;
    } else if (facing) {
        const std::int64_t greatest = shapes.greatest;
        const auto first = next_number(run);
        const auto last = first ? next_number(run) : first;
        if (!last || call.is_asked) shapes.greatest = greatest;
        if (!last) return CycleOutcome::Moves;
        shape.first = *first;
        shape.last = *last;
    } else {
        return CycleOutcome::Moves;
    }
    call.set(info.roles.first_block, shape.first);
    call.set(info.roles.last_block, shape.last);
    const std::span<const double> values(call.values.data(), info.parameters.size());
    if (!run.target.has_native_cycle(cycle, call.given, values, run.options.refusals))
        return CycleOutcome::Moves;
    if (call.is_asked) return CycleOutcome::Block;

    const CallFrame& frame = run.vm.calls.back();
    const std::uint32_t at = frame.return_to > 0 ? frame.return_to - 1 : 0;
    const Instruction& from = run.code.instructions[at];
    FollowedBlock next;
    next.source = {static_cast<std::uint32_t>(from.immediate.pair.first)};
    next.depth = from.c;
    next.feed = sema::kNotGivenNumber;
    next.is_diameter = run.modal.is_diameter;
    const double x = run.modal.position[index(Axis::X)];
    const double z = run.modal.position[index(Axis::Z)];
    if (!emit_call(run, cycle, call, next.source, at)) return CycleOutcome::Failed;
    if (facing) {
        const bool is_facing = call.values[*facing] != 0;
        if (!emit_shape(run, call, index(is_facing ? Axis::Z : Axis::X), shape, next, at))
            return CycleOutcome::Failed;
        shapes.all.push_back(std::move(shape));
    }
    // The cycle ends where it began, after a move at rapid.
    run.modal.position.set(index(Axis::X), x);
    run.modal.position.set(index(Axis::Z), z);
    run.modal.note(Group::Motion, Function::Rapid, next.source);
    run.modal.owed.owe_motion();
    return CycleOutcome::Block;
}

}  // namespace kadr::expand
