#include "expand/follow.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/diagnostics/expand.h"
#include "expand/block_values.h"
#include "expand/blocks.h"
#include "expand/contour_recording.h"
#include "expand/contour_values.h"
#include "expand/corners.h"
#include "expand/cuts.h"
#include "expand/cycles.h"
#include "expand/faults.h"
#include "expand/input.h"
#include "expand/orienting.h"
#include "expand/text_format.h"
#include "expand/unknown.h"
#include "path/contour_lead.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using path::Contour;
using path::Element;
using path::Vec2;
using sema::FollowSlot;

namespace {

constexpr std::size_t at(FollowSlot slot) { return static_cast<std::size_t>(slot); }

/// What `follow` travels: beside the contour, leads included. Nothing: reported.
std::optional<PlaneContour> followed(Running& run, const Slot* arguments, std::uint32_t where) {
    PlaneContour contour = read_contour(run, arguments[at(FollowSlot::Contour)]);
    if (contour.elements.empty()) {
        fault(run, diag::ContourEmpty, where);
        return std::nullopt;
    }
    const auto size_of = [&](FollowSlot slot, std::string_view name) -> std::optional<double> {
        const Slot value = arguments[at(slot)];
        if (!is_given(value)) return 0;
        if (value.number >= 0 && value.number < 1e6) return value.number;
        fault(run, diag::LeadSize, where)
            .arg(name)
            .arg(quantity_text(run, value.number, sema::kLength));
        return std::nullopt;
    };
    const auto line_in = size_of(FollowSlot::LeadIn, "lead_in");
    const auto line_out = line_in ? size_of(FollowSlot::LeadOut, "lead_out") : line_in;
    const auto arc_in = line_out ? size_of(FollowSlot::ArcIn, "arc_in") : line_out;
    const auto arc_out = arc_in ? size_of(FollowSlot::ArcOut, "arc_out") : arc_in;
    if (!arc_out) return std::nullopt;
    const Slot left = arguments[at(FollowSlot::Left)];
    const Slot right = arguments[at(FollowSlot::Right)];
    const double distance = is_given(left) ? left.number : is_given(right) ? -right.number : 0;
    const Contour wall = contour.elements;
    if (distance != 0) {
        const auto pieces =
            path::offset(contour.elements, distance, [&run] { return run.budget.look_for_end(); });
        if (!pieces) {
            offset_fault(run, pieces.error(), distance, where);
            return std::nullopt;
        }
        if (pieces->size() != 1) {
            fault(run, diag::ToolDoesNotFit, where)
                .arg(quantity_text(run, std::fabs(distance), sema::kLength))
                .arg(pieces->empty() ? std::string("nothing is left")
                                     : std::to_string(pieces->size()) + " pieces are left");
            return std::nullopt;
        }
        const Element& first = contour.elements.front();
        const Vec2 along = path::start_direction(first);
        const Vec2 beside = first.from + Vec2(-along.y(), along.x()) * distance;
        const bool is_ring = path::is_closed(contour.elements);
        contour.elements = is_ring ? path::begun_near((*pieces)[0], beside) : (*pieces)[0];
    }
    path::LeadInOut leads;
    leads.line_in = *line_in;
    leads.line_out = *line_out;
    leads.arc_in = *arc_in;
    leads.arc_out = *arc_out;
    leads.is_left = is_given(left) ? left.number >= 0 : is_given(right) && right.number < 0;
    const bool has_side = is_given(left) || is_given(right);
    auto whole = path::with_leads(contour.elements, leads, {wall, std::fabs(distance), has_side});
    if (!whole) {
        fault(run, diag::LeadCuts, where)
            .arg(whole.error() == path::LeadFault::InCuts ? "lead-in" : "lead-out");
        return std::nullopt;
    }
    contour.elements = std::move(whole).value();
    return contour;
}

}  // namespace

Done follow_start(Running& run, const Instruction& instruction, Slot* registers,
                  std::uint32_t where) {
    const auto contour = followed(run, registers + instruction.b, where);
    if (!contour) return kFailed;
    put_point(registers + instruction.a, wording_of(*contour), contour->elements.front().from);
    return kDone;
}

Done follow_contour(Running& run, const Instruction& instruction, const Slot* registers,
                    std::uint32_t where) {
    if (is_between_positions(run)) return refuse_beside_cycle(run, "a contour", where);
    const Slot* arguments = registers + instruction.a;
    const auto contour = followed(run, arguments, where);
    if (!contour) return kFailed;
    const path::Plane plane = plane_of(run.modal[Group::Plane]);
    if (contour->plane != plane) {
        fault(run, diag::ContourPlane, where)
            .arg("a contour")
            .arg(axes_text({contour->plane}))
            .arg("the program")
            .arg(axes_text({plane}));
        return kFailed;
    }
    FollowedBlock next;
    next.source = statement_of(instruction);
    next.depth = instruction.c;
    next.feed = arguments[at(FollowSlot::Feed)].number;
    // X is what the program, or a contour that is being made, has it; else what the contour's words
    // were.
    const bool is_given = run.recordings.is_open() || run.modal[Group::Diameter] != Function::None;
    const Wording wording{plane, is_given ? run.modal.is_diameter : contour->is_diameter};
    next.is_diameter = wording.is_diameter;
    const PlaneIndices axes = wording.axes();
    const Vec2 begin = contour->elements.front().from;
    const bool is_known =
        run.modal.position.knows(axes.first) && run.modal.position.knows(axes.second);
    const Vec2 here =
        wording.point({run.modal.position[axes.first], run.modal.position[axes.second]});
    const bool is_there = is_known && (here - begin).norm() <= path::kSamePoint;
    if (!is_there) {
        if (!emit_element(run, path::line_element(here, begin), next, where)) return kFailed;
        next.feed = sema::kNotGivenNumber;
    }
    for (const Element& element : contour->elements) {
        if (!emit_element(run, element, next, where)) return kFailed;
        next.feed = sema::kNotGivenNumber;
    }
    return kDone;
}

Done emit_element(Running& run, const Element& element, const FollowedBlock& next,
                  std::uint32_t where) {
    if (!require_room(run, where)) return kFailed;
    const Wording wording{plane_of(run.modal[Group::Plane]), next.is_diameter};
    const PlaneIndices axes = wording.axes();
    const Vec2 words = wording.words(element.to);
    Block& block = next_block(run, next.source);
    block.number = next.number;
    block.motion = !element.is_arc()   ? Function::Line
                   : element.sweep > 0 ? Function::ArcCcw
                                       : Function::ArcCw;
    const std::size_t plane_axes[2] = {axes.first, axes.second};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto component = static_cast<Eigen::Index>(i);
        const auto word = static_cast<nc::Slot>(plane_axes[i]);
        block.set(word, words[component]);
        if (run.modal[Group::Distance] == Function::Incremental) block.absolute |= nc::bit(word);
        if (!element.is_arc()) continue;
        const auto center =
            static_cast<nc::Slot>(static_cast<std::size_t>(nc::Slot::CenterX) + plane_axes[i]);
        block.set(center, element.center[component] - element.from[component]);
    }
    return finish_followed(run, block, next, where);
}

Done finish_followed(Running& run, Block& block, const FollowedBlock& next, std::uint32_t where) {
    const bool owes_behind = run.modal.take_functions(block, run.target.rules());
    if (next.feed == next.feed) {
        sema::Filling filling;
        filling.form = sema::Filling::Form::Feed;
        if (!fill_feed(run, block, filling, next.feed, where)) {
            drop_block(run, block);
            return kFailed;
        }
    }
    const bool leads = run.modal.tcp.acts() && !run.recordings.is_open();
    if ((!run.recordings.is_open() && !check_move(run, block, where)) ||
        (leads && !check_leading(run, block, where))) {
        drop_block(run, block);
        return kFailed;
    }
    if (run.modal.lost.needs_care() && !settle_unknown(run, block, where)) {
        drop_block(run, block);
        return kFailed;
    }
    if (run.modal.is_compensation_due() && !check_pitch(run, block, where)) {
        drop_block(run, block);
        return kFailed;
    }
    if (run.modal.has_ended && !run.recordings.is_open()) warn_after_end(run, where);
    if (run.modal.owed.diameter() != Function::None && !run.recordings.is_open())
        say_diameter(run, block);
    const bool has_corner = is_about_corner(run);
    const KnownPosition before = has_corner ? run.modal.position : KnownPosition();
    run.modal.take_words(block);
    if (owes_behind) run.modal.take_behind(block, run.target.rules());
    if (run.recordings.is_open()) return keep(run, block, where);
    if (is_cut_doubtful(run) && !check_cut(run, block, where)) {
        drop_block(run, block);
        return kFailed;
    }
    if (run.options.trace) keep_trace(run, where, next.depth, next.source);
    return has_corner ? finish_side(run, before, where) : kDone;
}

}  // namespace kadr::expand
