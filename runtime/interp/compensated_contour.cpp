#include "interp/compensated_contour.h"

#include <algorithm>
#include <utility>

namespace kadr::interp {

using path::Command;
using path::CompFault;
using path::CompPiece;
using path::Element;
using path::Vec2;

void CompensatedContour::restart(const path::CompRules& rules) {
    corners_ = path::RadiusComp(rules);
    last_.reset();
    open_approach_.reset();
}

const Command* CompensatedContour::command_of(std::size_t element) const {
    const auto waiting = std::ranges::find(waiting_, element, &Waiting::element);
    return waiting == waiting_.end() ? nullptr : &waiting->motion.command;
}

const Command* CompensatedContour::command_of_last() const {
    return last_ ? command_of(elements_) : nullptr;
}

const Command* CompensatedContour::newest() const {
    return waiting_.empty() ? nullptr : &waiting_.back().motion.command;
}

void CompensatedContour::end_last_at(const AxisValues& programmed) {
    const auto last = std::ranges::find(waiting_, elements_, &Waiting::element);
    last->motion.command.motion().to = programmed;
    last->motion.is_departure = true;
}

// ------------------------------------------------------------------------------ in

void CompensatedContour::wait_for_first(Command approach) {
    waiting_.push_back({{std::move(approach)}, ++elements_});
}

CutterMotion CompensatedContour::take_approach() {
    CutterMotion approach = std::move(waiting_.front().motion);
    waiting_.pop_front();
    return approach;
}

std::optional<CompFault> CompensatedContour::push_approach(const Element& element,
                                                           double distance) {
    return corners_.push(element, distance, waiting_.front().element);
}

void CompensatedContour::open_approach() {
    open_approach_ = take_approach();
    corners_.begin_open();
}

void CompensatedContour::wait(Command command) { waiting_.push_back({{std::move(command)}, 0}); }

std::optional<CompFault> CompensatedContour::push(const Element& element, double distance,
                                                  CutterMotion motion) {
    waiting_.push_back({std::move(motion), ++elements_});
    last_ = Last{element, distance};
    return corners_.push(element, distance, elements_);
}

// ------------------------------------------------------------------------------ out

void CompensatedContour::release(CutterPath& cutter) {
    for (const CompPiece& piece : corners_.pieces()) {
        if (open_approach_) put_open_approach(piece.element.from, cutter);
        put_piece(piece, cutter);
    }
    corners_.pieces().clear();
}

void CompensatedContour::put_piece(const CompPiece& piece, CutterPath& cutter) {
    // Blocks without motion come before the corner, elements that were left out not at all.
    for (; waiting_.front().element != piece.index; waiting_.pop_front()) {
        if (waiting_.front().element == 0)
            cutter.put_standing(std::move(waiting_.front().motion.command));
    }
    cutter.put_piece(waiting_.front().motion, piece);
    if (!piece.is_inserted) waiting_.pop_front();
}

/// The path to the contour, of which is known now where it begins.
void CompensatedContour::put_open_approach(const Vec2& to, CutterPath& cutter) {
    const CutterMotion approach = *std::exchange(open_approach_, std::nullopt);
    cutter.put_line(approach, to);
    cutter.set_programmed(approach.command.motion().to);
}

std::optional<CompFault> CompensatedContour::finish(const ContourEnd& end, CutterPath& cutter) {
    const auto fault = end.direction ? corners_.finish_towards(*end.direction)
                       : end.is_open ? corners_.finish_open()
                                     : corners_.finish();
    if (fault) return fault;
    release(cutter);
    const auto unled = [&](const CutterMotion& motion) -> Vec2 {
        return cutter.plane().point(motion.command.motion().to) - end.aside;
    };
    if (open_approach_) put_open_approach(unled(*open_approach_), cutter);
    for (; !waiting_.empty(); waiting_.pop_front()) {
        // An approach to no contour at all goes where it is programmed; an element that the end
        // has left out goes nowhere.
        CutterMotion& motion = waiting_.front().motion;
        if (waiting_.front().element == 0) cutter.put_standing(std::move(motion.command));
        else if (!last_) cutter.put_line(motion, unled(motion));
    }
    return std::nullopt;
}

}  // namespace kadr::interp
