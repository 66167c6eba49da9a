// What is written reads back: random blocks, random numbers, random paths, for every dialect.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "nc/match.h"
#include "nc/reader.h"
#include "nc/tables.h"
#include "tests/nc/nc_testing.h"
#include "write/writer.h"

namespace kadr::write::property_test {

using namespace nc;
namespace testing = nc::testing;

namespace {

using testing::read_blocks;
using testing::shipped;

/// The same cases in every run; RC_PARAMS in the environment asks for others.
const bool kIsSeeded = setenv("RC_PARAMS", "seed=20240229 max_success=300", 0) == 0;

/// A number with three decimals, as positions have on every control.
double any_length() { return *rc::gen::inRange(-200000, 200000) / 1000.0; }

std::string any_name() {
    return *rc::gen::container<std::string>(rc::gen::elementOf(std::string("ABCXYZ019 .-")));
}

Function any_of(std::initializer_list<Function> functions) {
    return *rc::gen::elementOf(std::vector<Function>(functions));
}

bool maybe() { return *rc::gen::inRange(0, 2) == 1; }

void add_function(Block& block, const DialectTables& tables, Function function) {
    if (tables.forms_of[static_cast<std::size_t>(function)].empty()) return;
    const auto parameters = info(function).parameters;
    Invocation* invocation = block.add(function, parameters.size());
    if (invocation == nullptr) return;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].is_optional && maybe()) continue;
        switch (parameters[i].dimension) {
            case Dimension::Count:
                block.set_argument(*invocation, i, *rc::gen::inRange(1, 7));
                break;
            case Dimension::Speed:
                block.set_argument(*invocation, i, *rc::gen::inRange(1, 20000));
                break;
            case Dimension::Time:
                block.set_argument(*invocation, i, *rc::gen::inRange(1, 20000) / 1000.0);
                break;
            case Dimension::Text:
                block.text = any_name();
                while (!block.text.empty() && block.text.back() == ' ') block.text.pop_back();
                break;
            default:
                block.set_argument(*invocation, i,
                                   has_fact(function, Fact::NamesAxes) ? 0 : any_length());
                break;
        }
    }
}

void add_motion(Block& block, const DialectTables& tables) {
    block.motion = any_of({Function::Rapid, Function::Line, Function::ArcCw, Function::ArcCcw});
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (!maybe()) continue;
        const auto slot = static_cast<Slot>(axis);
        block.set(slot, any_length());
        const int mode = tables.notation.has_modes ? *rc::gen::inRange(0, 3) : 0;
        if (mode == 1) block.absolute |= bit(slot);
        if (mode == 2) block.incremental |= bit(slot);
    }
    if (!is_arc(block.motion)) return;
    if (maybe()) {
        block.set(Slot::Radius, any_length());
    } else {
        block.set(Slot::CenterX, any_length());
        block.set(Slot::CenterY, any_length());
    }
}

Block any_block(const DialectTables& tables) {
    using F = Function;
    Block block;
    if (maybe()) add_motion(block, tables);
    if (maybe()) block.set(Slot::Feed, *rc::gen::inRange(1, 99999) / 100.0);
    if (maybe()) block.set(Slot::Speed, *rc::gen::inRange(1, 20000));
    if (maybe()) add_function(block, tables, any_of({F::PlaneXy, F::PlaneZx, F::PlaneYz}));
    if (maybe()) add_function(block, tables, any_of({F::Absolute, F::Incremental}));
    if (maybe()) {
        add_function(block, tables,
                     any_of({F::FeedPerMinute, F::FeedPerRevolution, F::FeedInverseTime}));
    }
    if (maybe()) add_function(block, tables, any_of({F::CuttingSpeedOn, F::CuttingSpeedOff}));
    if (maybe()) {
        add_function(block, tables,
                     any_of({F::RadiusCompOff, F::RadiusCompLeft, F::RadiusCompRight}));
    }
    if (maybe()) add_function(block, tables, any_of({F::ExactStop, F::ContinuousPath}));
    if (maybe()) {
        add_function(block, tables,
                     any_of({F::SpindleCw, F::SpindleCcw, F::SpindleStop, F::SpindleOrient}));
    }
    if (maybe())
        add_function(block, tables, any_of({F::CoolantFlood, F::CoolantMist, F::CoolantOff}));
    if (maybe()) {
        add_function(block, tables,
                     any_of({F::SpeedLimit,
                             F::LengthCompOn,
                             F::LengthCompOff,
                             F::WorkOffset,
                             F::Shift,
                             F::ShiftAdd,
                             F::Rotate,
                             F::Mirror,
                             F::SetPosition,
                             F::RadiusOffset,
                             F::ReferenceReturn,
                             F::TapRigid,
                             F::TapFloating,
                             F::DiameterOn,
                             F::DiameterOff,
                             F::ScaleOff,
                             F::ToolSelect,
                             F::ToolChange,
                             F::ToolEdge,
                             F::Dwell,
                             F::Stop,
                             F::OptionalStop,
                             F::End,
                             F::EndRewind,
                             F::Message,
                             F::ExactStopOnce}));
    }
    if (maybe()) block.skip_level = static_cast<std::int8_t>(*rc::gen::inRange(0, 10));
    if (maybe()) block.number = *rc::gen::inRange(1, 99999);
    if (maybe()) block.comment = any_name().substr(0, 60);
    while (block.comment.ends_with(' ')) block.comment.pop_back();
    while (block.comment.starts_with(' ')) block.comment.erase(0, 1);
    return block;
}

/// The blocks of all lines as one: a block may need several lines.
Block merged(const std::vector<Block>& blocks) {
    Block all;
    for (const Block& one : blocks) {
        if (one.motion != Function::None) all.motion = one.motion;
        for (std::size_t slot = 0; slot < kSlots; ++slot) {
            if (one.has(static_cast<Slot>(slot)))
                all.set(static_cast<Slot>(slot), one.values[slot]);
        }
        all.incremental |= one.incremental;
        all.absolute |= one.absolute;
        for (std::size_t i = 0; i < one.function_count; ++i) {
            const Invocation& from = one.functions[i];
            const std::size_t count = info(from.function).parameters.size();
            Invocation* to = all.add(from.function, count);
            for (std::size_t p = 0; p < count; ++p) {
                if ((from.given >> p & 1u) != 0) all.set_argument(*to, p, one.argument(from, p));
            }
        }
        if (one.skip_level >= 0) all.skip_level = one.skip_level;
        if (one.number >= 0) all.number = one.number;
        if (!one.comment.empty()) all.comment = one.comment;
        if (!one.text.empty()) all.text = one.text;
    }
    return all;
}

/// A control may say more than was asked: a shift names the axes that it sets to zero.
void complete_shift(Block& block) {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        Invocation& invocation = block.functions[i];
        if (invocation.function == Function::ReferenceReturn) {
            block.set_argument(invocation, 0, block.argument(invocation, 0, 1));
        }
        // The centre of a rotation stands behind its angle.
        const bool is_rotation = invocation.function == Function::Rotate;
        if (invocation.function != Function::Shift && !is_rotation) continue;
        const std::size_t first = is_rotation ? 1 : 0;
        for (std::size_t p = first; p < first + 3; ++p)
            block.set_argument(invocation, p, block.argument(invocation, p));
    }
}

/// A control without a centre of rotation says it as a shift to the centre, the rotation, and the
/// shift back.
void fold_center(Block& block) {
    for (std::size_t i = 0; i + 2 < block.function_count; ++i) {
        const Invocation to = block.functions[i];
        Invocation rotation = block.functions[i + 1];
        const Invocation back = block.functions[i + 2];
        if (to.function != Function::ShiftAdd || rotation.function != Function::Rotate ||
            back.function != Function::ShiftAdd || to.given != back.given)
            continue;
        for (std::size_t p = 0; p < 3; ++p) {
            if ((to.given >> p & 1u) == 0) continue;
            RC_ASSERT(block.argument(to, p) == -block.argument(back, p));
            block.set_argument(rotation, p + 1, block.argument(to, p));
        }
        block.functions[i] = rotation;
        for (std::size_t j = i + 1; j + 2 < block.function_count; ++j)
            block.functions[j] = block.functions[j + 2];
        block.function_count = static_cast<std::uint8_t>(block.function_count - 2);
    }
}

/// What was in force before need not be said: on some controls one code says two modes.
void drop_standing(Block& block) {
    std::uint8_t kept = 0;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Function function = block.functions[i].function;
        if (function == Function::FeedPerMinute || function == Function::CuttingSpeedOff) continue;
        block.functions[kept++] = block.functions[i];
    }
    block.function_count = kept;
}

/// Header, first lines and the block; false if the control cannot say it.
bool write_program(const Dialect& dialect, const Block& block, std::string& text) {
    DiagnosticList sink;
    Writer writer(dialect, {.verbose_modal = true, .number_blocks = false}, sink);
    writer.begin({}, text);
    writer.write(block, text);
    return !writer.failed();
}

void check_round_trip(const Dialect& dialect) {
    Block block = any_block(dialect.tables());
    // F of a helix as the control counts it; the writer's tests have the numbers of the others.
    block.feed_along_arc = dialect.rules().helix_feed_along_arc;
    block.feed_of_all_axes = dialect.rules().feed_of_all_axes;
    std::string text;
    RC_PRE(write_program(dialect, block, text));  // else it has no spelling, and the writer said so
    std::string head;
    write_program(dialect, {}, head);
    RC_ASSERT(text.starts_with(head));
    text.erase(0, head.size());
    const auto result = read_blocks(dialect, text);
    Block back = merged(result.blocks);
    const bool says_nothing = back.given == 0 && back.number < 0 && back.function_count == 0 &&
                              back.motion == Function::None;
    if (says_nothing) block.skip_level = -1;  // there is nothing that could be left out
    // G04 without a time and the like exist on some controls only; what is compared is the meaning.
    fold_center(back);
    complete_shift(block);
    complete_shift(back);
    drop_standing(block);
    drop_standing(back);
    if (block.find(Function::FeedInverseTime) != nullptr && is_arc(block.motion)) {
        // On some controls F of such an arc is feed/radius; the writer's tests have the numbers.
        block.given &= ~bit(Slot::Feed);
        back.given &= ~bit(Slot::Feed);
    }
    block.feed_along_arc = block.feed_of_all_axes = false;  // what is read does not say it
    RC_LOG() << text << "meant " << describe(block) << "\nread  " << describe(back) << '\n';
    for (const Diagnostic& one : result.messages.all()) RC_LOG() << one.message() << '\n';
    RC_ASSERT(!result.failed);
    RC_ASSERT(back == block);
}

RC_GTEST_PROP(RoundTrip, Iso, ()) { check_round_trip(shipped("iso")); }
RC_GTEST_PROP(RoundTrip, Sinumerik, ()) { check_round_trip(shipped("sinumerik")); }
RC_GTEST_PROP(RoundTrip, Fanuc, ()) { check_round_trip(shipped("fanuc")); }
RC_GTEST_PROP(RoundTrip, Axioma, ()) { check_round_trip(shipped("axioma")); }

// ---------------------------------------------------------------- nothing is lost

void add_cycle(Block& block, const Dialect& dialect) {
    block.cycle = static_cast<CycleId>(*rc::gen::inRange<std::size_t>(0, dialect.cycles().size()));
    const auto parameters = dialect.cycles()[block.cycle].parameters;
    Invocation* invocation = block.add(Function::Cycle, parameters.size());
    for (std::size_t i = 0; invocation != nullptr && i < parameters.size(); ++i) {
        if (!parameters[i].is_optional || maybe())
            block.set_argument(*invocation, i, *rc::gen::inRange(1, 90) / 10.0);
    }
}

/// A block in which every field may be set, also such as do not go together.
Block any_crowded_block(const Dialect& dialect) {
    Block block;
    block.motion = any_of({Function::None, Function::Rapid, Function::Line, Function::ArcCw,
                           Function::ArcCcw, Function::Spline});
    const int crowd = *rc::gen::inRange(1, 14);  // one field in so many is set
    const auto is_set = [&] { return *rc::gen::inRange(0, crowd) == 0; };
    for (std::size_t i = 0; i < kSlots; ++i) {
        const auto slot = static_cast<Slot>(i);
        if (!is_set()) continue;
        const bool is_position = (bit(slot) & (kTargetSlots | kCenterSlots)) != 0;
        if (slot == Slot::Turns) block.set(slot, *rc::gen::inRange(0, 4));
        else if (slot == Slot::Feed) block.set(slot, *rc::gen::inRange(1, 99999) / 100.0);
        else if (slot == Slot::Speed) block.set(slot, *rc::gen::inRange(1, 20000));
        else block.set(slot, any_length());
        const int mode = is_position ? *rc::gen::inRange(0, 6) : 0;
        if (mode == 1) block.absolute |= bit(slot);
        if (mode == 2) block.incremental |= bit(slot);
    }
    const bool is_plain_arc = is_arc(block.motion) && *rc::gen::inRange(0, 4) != 0;
    if (is_plain_arc) {  // such as a control takes
        block.given &= ~kArcSlots;
        const bool is_by_radius = maybe();
        if (is_by_radius) block.set(Slot::Radius, 400);
        if (!is_by_radius || maybe()) block.set(is_by_radius ? Slot::X : Slot::CenterX, 5);
        if (maybe()) block.set(Slot::Turns, *rc::gen::inRange(0, 4));
    }
    if (block.motion == Function::Rapid || block.motion == Function::Line) {
        if (!maybe()) block.given &= ~kArcSlots;
    }
    for (const FunctionInfo& one : all_functions()) {
        const bool is_motion = one.group == Group::Motion || one.function == Function::None;
        if (is_motion || *rc::gen::inRange(0, 4 * crowd) != 0) continue;
        // What is read may be one more than what was said: `T1 M6` is two functions, `tool` is one.
        if (block.function_count + 1u == kMaxInvocations) break;
        if (one.function == Function::Cycle) {
            add_cycle(block, dialect);
            continue;
        }
        bool has_rival = false;
        for (std::size_t i = 0; i < block.function_count; ++i) {
            const Group other = info(block.functions[i].function).group;
            has_rival |= other == one.group && other != Group::NonModal;
        }
        if (!has_rival) add_function(block, dialect.tables(), one.function);
    }
    if (is_set()) block.skip_level = static_cast<std::int8_t>(*rc::gen::inRange(0, 10));
    if (is_set()) block.number = *rc::gen::inRange(1, 99999);
    if (is_set()) block.comment = "REMARK";
    return block;
}

constexpr double kHalfIncrement = 0.5 * 25.4e-4 + 1e-9;  // mm; of the coarsest, 0.0001 inch

/// Parameters that the control says nothing of, as its file knows (`drops`).
std::uint32_t dropped(Function function, const Dialect& dialect) {
    std::uint32_t mask = 0;
    const DialectTables& tables = dialect.tables();
    for (const FormId id : tables.forms_of[static_cast<std::size_t>(function)]) {
        for (const int parameter : tables.forms[id].drops) mask |= 1u << parameter;
    }
    return mask;
}

/// Whether the block is a reference return of the axes, and to the point, that are meant.
bool goes_to_reference(const Block& block, const Block& meant, const Invocation& point) {
    const Invocation* found = block.find(Function::ReferenceReturn);
    if (found == nullptr || block.argument(*found, 0, 1) != meant.argument(point, 0, 1))
        return false;
    const SlotMask axes = point.given >> 1 & (bit(Slot::X) | bit(Slot::Y) | bit(Slot::Z));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto slot = static_cast<Slot>(i);
        if ((axes & bit(slot)) != 0 && !(block.has(slot) && block.at(slot) == 0)) return false;
    }
    return true;
}

/// Whether the block says a tilted plane, or its end, as the control reads it: its own cycle for
/// planes, or the code that ends a rotation as well.
bool says_tilt(const Block& block, const Block& meant, const Invocation& plane) {
    const Invocation* swivel = block.find(Function::Swivel);
    if (plane.function == Function::TiltedPlaneOff)
        return block.find(Function::RotateOff) != nullptr || (swivel && swivel->given == 0);
    if (plane.function != Function::Tilt || swivel == nullptr) return false;
    const auto expressions = info(Function::Swivel).parameters;
    const auto asked = info(Function::Tilt).parameters;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto same = std::ranges::find(expressions, asked[i].name, &Parameter::name);
        const auto index = static_cast<std::size_t>(same - expressions.begin());
        const double difference = block.argument(*swivel, index) - meant.argument(plane, i, 0);
        if (std::fabs(difference) > kHalfIncrement) return false;
    }
    return true;
}

/// The first field of `meant` that none of the blocks has; empty: all of them are there.
std::string lost_field(const Block& meant, std::span<const Block> blocks, const Dialect& dialect) {
    ModalFunctions modal{dialect.tables().power_on};
    for (const Block& one : blocks) follow_modal(dialect.rules(), one, modal);
    const auto any = [&](const auto& has) { return std::ranges::any_of(blocks, has); };
    if (meant.motion != Function::None &&
        !any([&](const Block& b) { return b.motion == meant.motion; }))
        return std::string(info(meant.motion).name);
    for (std::size_t i = 0; i < kSlots; ++i) {
        const auto slot = static_cast<Slot>(i);
        // Where machine coordinates count, no other coordinate says what a distance does.
        const bool is_distance = meant.find(Function::MachineCoordinates) != nullptr &&
                                 (meant.incremental & kTargetSlots & bit(slot)) != 0;
        if (is_distance && !any([&](const Block& b) { return (b.incremental & bit(slot)) != 0; }))
            return "IC";
        if (!meant.has(slot) || any([&](const Block& b) { return b.has(slot); })) continue;
        const bool is_center_instead = slot == Slot::Radius && any([](const Block& b) {
                                           return (b.given & kCenterSlots) != 0;
                                       });
        const auto arcs = std::ranges::count_if(blocks, [](const Block& b) {
            return (b.given & (kCenterSlots | bit(Slot::Radius))) != 0;
        });
        const bool are_blocks_instead =
            slot == Slot::Turns && (meant.at(slot) == 0 || arcs == std::lround(meant.at(slot)) + 1);
        if (!is_center_instead && !are_blocks_instead) return std::string(slot_name(slot));
    }
    for (std::size_t i = 0; i < meant.function_count; ++i) {
        const Invocation& invocation = meant.functions[i];
        Function function = invocation.function;
        if (function == Function::Tool) function = Function::ToolSelect;
        // One factor for all axes may be said as three, and about a centre as two shifts more.
        if (function == Function::Scale &&
            any([](const Block& b) { return b.find(Function::Scale) != nullptr; }))
            continue;
        const bool is_there = any([&](const Block& b) {
            const Invocation* found = b.find(function);
            // `G43 H1` says both.
            if (found == nullptr && function == Function::LengthOffset)
                found = b.find(Function::LengthCompOn);
            // Distances of 0 on the way to the reference point are the axes that go there.
            if (found == nullptr && function == Function::ReferencePoint)
                return goes_to_reference(b, meant, invocation);
            if (found == nullptr) return says_tilt(b, meant, invocation);
            for (std::size_t p = 0; p < kMaxArguments && p < 32; ++p) {
                if ((invocation.given & found->given) >> p % 32 & 1u) {
                    if (std::fabs(meant.argument(invocation, p) - b.argument(*found, p)) >
                        kHalfIncrement)
                        return false;
                }
            }
            // What a cycle takes from its position has no word.
            const std::uint32_t unsaid = invocation.given & ~found->given;
            return function == Function::Cycle || (unsaid & ~dropped(function, dialect)) == 0;
        });
        const bool is_in_force = modal[static_cast<std::size_t>(info(function).group)] == function;
        if (!is_there && !is_in_force) return std::string(info(function).name);
    }
    if (meant.number >= 0 && !any([&](const Block& b) { return b.number == meant.number; }))
        return "N";
    if (meant.skip_level >= 0 &&
        !any([&](const Block& b) { return b.skip_level == meant.skip_level; }) &&
        (meant.given != 0 || meant.number >= 0))
        return "/";
    if (!meant.comment.empty() &&
        !any([&](const Block& b) { return b.comment.find(meant.comment) != std::string::npos; }))
        return "comment";
    return {};
}

/// Every word of a block is written, or there is a message: known positions and unknown ones, words
/// that do not go together, modal words repeated or not.
/// Adds to the blocks that were read a rotation with its centre for each one that stands between a
/// shift to the centre and the shift back, in blocks of their own.
void add_centred_rotations(std::vector<Block>& blocks) {
    const std::size_t count = blocks.size();
    for (std::size_t i = 0; i + 2 < count; ++i) {
        Block three;
        for (std::size_t j = i; j < i + 3; ++j) {
            if (blocks[j].function_count != 1) break;
            const Invocation& from = blocks[j].functions[0];
            Invocation* to = three.add(from.function, info(from.function).parameters.size());
            for (std::size_t p = 0; p < info(from.function).parameters.size(); ++p) {
                if ((from.given >> p & 1u) != 0)
                    three.set_argument(*to, p, blocks[j].argument(from, p));
            }
        }
        if (three.function_count != 3) continue;
        fold_center(three);
        if (three.function_count == 1) blocks.push_back(three);
    }
}

/// Words that the text has for something else: those of the first spindle are read as the ones
/// without a number (`M1=3` is M3), and I J K are the tool's direction where that is led.
bool has_other_words(const Block& block) {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Invocation& call = block.functions[i];
        const auto& parameters = info(call.function).parameters;
        const bool is_of_spindle = !parameters.empty() && parameters[0].name == "spindle";
        if (is_of_spindle && (call.given & 1u) != 0 && block.argument(call, 0) == 1) return true;
    }
    return block.find(Function::TcpVector) != nullptr && (block.given & kCenterSlots) != 0;
}

void check_nothing_lost(const Dialect& dialect) {
    const Block block = any_crowded_block(dialect);
    RC_PRE(!has_other_words(block));
    DiagnosticList sink;
    Writer writer(dialect, {.verbose_modal = maybe(), .number_blocks = false}, sink);
    std::string text;
    writer.begin({}, text);
    const int before = *rc::gen::inRange(0, 3);
    Block first;
    if (before == 1) first.kind = Block::Kind::Modal;
    if (before == 2) {
        first.motion = Function::Rapid;
        for (const Slot slot : {Slot::X, Slot::Y, Slot::Z}) first.set(slot, 10);
    }
    writer.write(first, text);
    const std::size_t start = text.size();
    writer.write(block, text);
    RC_CLASSIFY(writer.failed(), "refused");
    if (writer.failed()) {
        RC_ASSERT(sink.has_errors());
        return;
    }
    // Modal words of the safety line are not said again.
    auto read = read_blocks(dialect, text);
    RC_LOG() << text << "meant " << describe(block) << '\n';
    for (const Diagnostic& one : read.messages.all()) RC_LOG() << one.message() << '\n';
    RC_ASSERT(!read.failed);
    for (Block& one : read.blocks) {
        RC_LOG() << "read  " << describe(one) << '\n';
        if (one.line > std::count(text.begin(), text.begin() + std::ptrdiff_t(start), '\n'))
            continue;
        one.given = 0;  // positions of the start are no words of the block
    }
    add_centred_rotations(read.blocks);
    RC_ASSERT(lost_field(block, read.blocks, dialect) == "");
}

RC_GTEST_PROP(NothingLost, Iso, ()) { check_nothing_lost(shipped("iso")); }
RC_GTEST_PROP(NothingLost, Sinumerik, ()) { check_nothing_lost(shipped("sinumerik")); }
RC_GTEST_PROP(NothingLost, Fanuc, ()) { check_nothing_lost(shipped("fanuc")); }

/// Any number comes back within half an increment, in mm and in inches.
RC_GTEST_PROP(RoundTrip, NumbersWithinHalfAnIncrement, ()) {
    const bool is_inch = maybe();
    const double value = *rc::gen::inRange(-99999999, 99999999) / 7919.0;
    for (const char* name : {"iso", "sinumerik", "fanuc"}) {
        const Dialect& dialect = shipped(name);
        DiagnosticList sink;
        Writer writer(dialect, {}, sink);
        std::string text;
        writer.begin({"x", 1, "", is_inch}, text);
        Block block;
        block.motion = Function::Line;
        block.set(Slot::X, value);
        block.set(Slot::A, value);
        writer.write(block, text);
        const auto result = read_blocks(dialect, text);
        const NumberFormat& format =
            dialect.tables().addresses[dialect.tables().find_address("X")].format;
        const double increment = is_inch ? 25.4 * std::pow(10.0, -format.inch_decimals)
                                         : std::pow(10.0, -format.decimals);
        RC_ASSERT(!result.failed);
        RC_ASSERT(std::fabs(result.blocks.back().at(Slot::X) - value) <= 0.5 * increment + 1e-9);
        RC_ASSERT(std::fabs(result.blocks.back().at(Slot::A) - value) <= 0.0005 + 1e-9);
    }
}

/// However many increments there are, their sum stays within half an increment of the position.
RC_GTEST_PROP(RoundTrip, IncrementsDoNotDrift, ()) {
    for (const char* name : {"sinumerik", "fanuc"}) {
        const Dialect& dialect = shipped(name);
        DiagnosticList sink;
        Writer writer(dialect, {.number_blocks = false}, sink);
        std::string text;
        writer.begin({}, text);
        Block block;
        block.add(Function::Incremental);
        writer.write(block, text);
        double meant = 0;
        const int steps = *rc::gen::inRange(1, 60);
        for (int i = 0; i < steps; ++i) {
            block.reset();
            block.motion = Function::Line;
            const double step = *rc::gen::inRange(-100000, 100000) / 7777.0;
            block.set(Slot::X, step);
            meant += step;
            writer.write(block, text);
        }
        double sum = 0;
        for (const Block& one : read_blocks(dialect, text).blocks) {
            if (one.has(Slot::X)) sum += one.at(Slot::X);
        }
        RC_ASSERT(std::fabs(sum - meant) <= 0.0005 + 1e-9);
    }
}

/// The fast way of the reader and the slow one see the same block.
RC_GTEST_PROP(RoundTrip, FastAndSlowReadersAgree, ()) {
    for (const char* name : {"sinumerik", "fanuc"}) {
        const Dialect& dialect = shipped(name);
        DiagnosticList sink;
        Writer writer(dialect, {.number_blocks = false}, sink);
        std::string text;
        Block block = any_block(dialect.tables());
        block.comment.clear();
        writer.write(block, text);
        if (writer.failed() || text.empty()) return;
        std::string slow;
        for (const char c : text) {
            if (c == '\n') slow += std::string_view(name) == "fanuc" ? " ()" : " ;";
            slow += c;
        }
        const auto a = read_blocks(dialect, text);
        const auto b = read_blocks(dialect, slow);
        RC_ASSERT(a.blocks.size() == b.blocks.size());
        for (std::size_t i = 0; i < a.blocks.size(); ++i)
            RC_ASSERT(describe(a.blocks[i]) == describe(b.blocks[i]));
    }
}

/// The fast way of the writer and the long one write the same.
RC_GTEST_PROP(RoundTrip, FastAndSlowWritersAgree, ()) {
    const bool is_verbose = maybe();
    const bool is_inch = maybe();
    for (const char* name : {"sinumerik", "fanuc"}) {
        DiagnosticList sink;
        const WriteOptions options{.verbose_modal = is_verbose};
        Writer fast(shipped(name), options, sink);
        Writer slow(shipped(name), options, sink);
        std::string fast_text;
        std::string slow_text;
        const ProgramInfo program{"x", 1, "", is_inch};
        fast.begin(program, fast_text);
        slow.begin(program, slow_text);
        const int count = *rc::gen::inRange(1, 20);
        for (int i = 0; i < count; ++i) {
            Block block;
            block.motion = any_of({Function::Rapid, Function::Line});
            block.set(Slot::X, i * 1.23456);  // every block says something
            for (std::size_t axis = 1; axis < 5; ++axis) {
                if (maybe()) block.set(static_cast<Slot>(axis), *rc::gen::inRange(-30, 30) / 3.0);
            }
            if (maybe()) block.set(Slot::Feed, *rc::gen::inRange(1, 3) * 100.0);
            fast.write(block, fast_text);
            block.comment.assign(1, 'C');  // goes the long way
            slow.write(block, slow_text);
        }
        const std::string_view comment = std::string_view(name) == "fanuc" ? " (C)" : " ; C";
        std::size_t at = 0;
        while ((at = slow_text.find(comment, at)) != std::string::npos)
            slow_text.erase(at, comment.size());
        RC_LOG() << fast_text << slow_text;
        RC_ASSERT(fast_text == slow_text);
    }
}

/// Whatever stands in a text, the reader makes blocks or messages of it, and comes to its end.
RC_GTEST_PROP(AnyText, IsReadToItsEnd, ()) {
    const auto pieces = *rc::gen::container<
        std::vector<std::string>>(rc::gen::elementOf(std::vector<std::string>{
        "G1", "G01",      "G54.1",  "G4",  "G92", "G68",  "X",    "X10",   "X-1.5",
        "Y=", "=AC(",     "=IC(5)", ")",   "(",   "CR=",  "R5",   "P2",    "MSG(\"",
        "\"", "CYCLE83(", ",",      ",,",  "5",   "1EX9", "/",    "/3",    "N10",
        "N",  ":",        "%",      ";",   "\n",  "\r\n", " ",    "TRANS", "#1",
        "[",  "]",        "T=\"A",  "M30", "O1",  "Ж",    "\xff", "\t",    "99999999999999999999",
        ".",  "-",        "+",      "H",   "S=3", "(MSG,"}));
    std::string text;
    for (const std::string& piece : pieces) text += piece;
    for (const char* name : {"iso", "sinumerik", "fanuc"}) {
        const auto result = read_blocks(shipped(name), text);
        RC_ASSERT(result.failed == result.messages.has_errors());
        for (const Block& block : result.blocks) (void)describe(block);
    }
}

/// The radii of a written arc agree as well as the grid allows.
RC_GTEST_PROP(RoundTrip, ArcCentresFit, ()) {
    const double radius = *rc::gen::inRange(1000, 900000) / 7919.0;
    const double from = *rc::gen::inRange(0, 3600) / 573.0;
    const double sweep = *rc::gen::inRange(200, 6200) / 1000.0;
    const double cx = any_length() / 3;
    const double cy = any_length() / 7;
    DiagnosticList sink;
    Writer writer(shipped("fanuc"), {}, sink);
    std::string text;
    writer.begin({}, text);
    Block block;
    block.motion = Function::Rapid;
    block.set(Slot::X, cx + radius * std::cos(from));
    block.set(Slot::Y, cy + radius * std::sin(from));
    writer.write(block, text);
    const double i = cx - block.at(Slot::X);
    const double j = cy - block.at(Slot::Y);
    block.reset();
    block.motion = Function::ArcCcw;
    block.set(Slot::X, cx + radius * std::cos(from + sweep));
    block.set(Slot::Y, cy + radius * std::sin(from + sweep));
    block.set(Slot::CenterX, i);
    block.set(Slot::CenterY, j);
    writer.write(block, text);
    const auto blocks = read_blocks(shipped("fanuc"), text).blocks;
    const Block& start = blocks[blocks.size() - 2];
    const Block& arc = blocks.back();
    const double mx = start.at(Slot::X) + arc.at(Slot::CenterX);
    const double my = start.at(Slot::Y) + arc.at(Slot::CenterY);
    const double r0 = std::hypot(arc.at(Slot::CenterX), arc.at(Slot::CenterY));
    const double r1 = std::hypot(arc.at(Slot::X) - mx, arc.at(Slot::Y) - my);
    RC_LOG() << text << r0 << " " << r1 << '\n';
    // Near half a turn a step of the grid along the chord changes the difference by two increments.
    RC_ASSERT(std::fabs(r0 - r1) <= 0.0012);
    // A short arc says little about its centre: the error of the end points is magnified.
    const double chord =
        std::hypot(arc.at(Slot::X) - start.at(Slot::X), arc.at(Slot::Y) - start.at(Slot::Y));
    RC_ASSERT(std::hypot(mx - cx, my - cy) <= 0.003 + 0.002 * radius / std::max(chord, 0.001));
}

}  // namespace
}  // namespace kadr::write::property_test
