// The modal state in words, for the prompt and for traces.
#include <array>

#include "base/numbers.h"
#include "interp/answers.h"
#include "interp/channel.h"
#include "interp/path_smoothing.h"

namespace kadr::interp {

namespace {

constexpr int kDecimals = 3;

std::string number(double value) {
    std::string out;
    append_shortest(out, round_to(value, kDecimals));
    return out;
}

std::string_view plane_name(path::Plane plane) {
    switch (plane) {
        case path::Plane::Xy: return "XY";
        case path::Plane::Zx: return "ZX";
        case path::Plane::Yz: return "YZ";
    }
    return "";
}

std::string_view spindle_name(path::SpindleMode mode) {
    switch (mode) {
        case path::SpindleMode::Stop: return "stopped";
        case path::SpindleMode::Cw: return "clockwise";
        case path::SpindleMode::Ccw: return "counter-clockwise";
        case path::SpindleMode::Orient: return "oriented";
    }
    return "";
}

/// By their numbers.
constexpr std::array<std::string_view, machine::kMostSpindles + 1> kSpindles = {
    "", "spindle 1", "spindle 2", "spindle 3", "spindle 4"};

std::string spindle_text(const ProgrammedSpindle& spindle) {
    std::string text(spindle_name(spindle.mode));
    if (spindle.has_cutting_speed) {
        text += ", " + number(spindle.cutting_speed) + " m/min";
        if (spindle.limit > 0) text += ", at most " + number(spindle.limit) + " rpm";
    } else if (spindle.speed > 0) {
        text += ", " + number(spindle.speed) + " rpm";
    }
    return text;
}

std::string_view coolant_name(path::CoolantMode mode) {
    switch (mode) {
        case path::CoolantMode::Off: return "off";
        case path::CoolantMode::Flood: return "flood";
        case path::CoolantMode::Mist: return "mist";
    }
    return "";
}

std::string feed_text(const Modal& modal) {
    if (!modal.has_feed) return "none";
    switch (modal.feed_mode) {
        case path::FeedMode::PerMinute: return number(modal.feed) + " mm/min";
        case path::FeedMode::PerRevolution: return number(modal.feed) + " mm/rev";
        case path::FeedMode::InverseTime: return number(modal.feed) + " 1/min";
    }
    return "";
}

std::string corners_text(const Modal& modal, const path::Blending& blending) {
    if (modal.has_exact_stop) return "exact stop";
    const std::string size = number(blending.size) + " mm";
    switch (blending.kind) {
        case path::BlendKind::None: return "continuous";
        case path::BlendKind::Distance: return "rounded from " + size;
        case path::BlendKind::Tolerance: return "rounded within " + size;
    }
    return "";
}

}  // namespace

std::vector<StateItem> Answers::state() const {
    std::vector<StateItem> items;
    const auto add = [&items](std::string_view name, std::string value) {
        items.push_back({name, std::move(value)});
    };
    add("motion", std::string(nc::info(modal_.motion).name));
    add("plane", std::string(plane_name(modal_.plane)));
    add("distances", modal_.is_incremental ? "incremental" : "absolute");
    add("feed", feed_text(modal_));
    add("corners", corners_text(modal_, channel_.smoothing.blending(path::Op::Line)));
    add("spindle", spindle_text(spindle_));
    if (!other_spindles_.empty()) add("master spindle", std::to_string(spindle_.number));
    for (const ProgrammedSpindle& other : other_spindles_)
        add(kSpindles.at(static_cast<std::size_t>(other.number)), spindle_text(other));
    add("coolant", std::string(coolant_name(coolant_)));
    add("tool", tool_.current == 0 ? "none" : std::to_string(tool_.current));
    std::string lengths =
        number(tool_.lengths[static_cast<Eigen::Index>(index(tool_.axis))]) + " mm";
    for (std::size_t i = 0; i < 3; ++i) {
        const double length = tool_.lengths[static_cast<Eigen::Index>(i)];
        if (i == index(tool_.axis) || length == 0) continue;
        lengths += ", along " + std::string(kAxisNames[i]) + " " + number(length) + " mm";
    }
    add("tool length", std::move(lengths));
    std::string frame;
    const AxisValues origin = frames_.to_base(AxisValues{});
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        if (round_to(origin[index(axis)], kDecimals) == 0) continue;
        frame += (frame.empty() ? "" : " ") + std::string(kAxisNames[index(axis)]) +
                 number(origin[index(axis)]);
    }
    if (!frames_.is_shift()) frame += frame.empty() ? "turned" : ", turned";
    add("origin", frame.empty() ? "as the machine's" : frame);
    if (modal_cycles_.modal.is_active) {
        add("cycle", dialect_.cycles()[modal_cycles_.modal.cycle].name);
    }
    return items;
}

}  // namespace kadr::interp
