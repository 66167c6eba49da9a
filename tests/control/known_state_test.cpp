// What the expander knows of the control behind a block is what the control does, and what the
// writer believes of its text is what the text says there (DESIGN 3): all Kadr programs of this
// repository, and random ones, are evaluated and written block by block, their text is executed
// line by line, and behind each block all are asked. Where nothing is known there is nothing to
// contradict.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "base/disk_files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "driver/cycles.h"
#include "driver/messages.h"
#include "driver/program.h"
#include "driver/session.h"
#include "driver/share.h"
#include "expand/expander.h"
#include "expand/modal.h"
#include "interp/interpreter.h"
#include "macro/program.h"
#include "tests/common/inputs.h"
#include "tests/control/random_program.h"
#include "write/modal.h"
#include "write/writer.h"

namespace kadr::control_testing::known_state_test {
namespace {

namespace fs = std::filesystem;
using expand::ModalState;
using nc::Function;
using nc::Group;

/// A text rounds each number to an increment, and increments add up.
constexpr double kRounded = 0.003;
constexpr std::uint64_t kMostBlocks = 3000;  // of a program: behind these nothing new comes

/// What the expander knows behind a block. F is the author's; the text has another one where a
/// control counts it otherwise, along a helix or beside rotary axes, and for threads.
struct Known {
    ModalState state;
    write::WriterModal text;
    bool is_inch = false;
    bool has_feed_of_text = true;
};

/// The numbered blocks behind the call of a cycle along a shape.
struct OpenShape {
    std::set<std::int32_t> numbers;  // that the text has so far
    std::int32_t last = -1;          // of the block with which the open one ends; -1: none is open
};

bool is_of_shape(const nc::Dialect& dialect, const nc::Block& block, OpenShape& shape) {
    if (block.number >= 0) shape.numbers.insert(block.number);
    if (shape.last >= 0) {
        if (block.number == shape.last) shape.last = -1;
        return true;
    }
    const nc::Invocation* cycle = block.find(Function::Cycle);
    if (cycle == nullptr || !dialect.cycles()[block.cycle].takes_shape()) return false;
    const int at = dialect.cycles()[block.cycle].roles.last_block;
    const auto last =
        static_cast<std::int32_t>(block.argument(*cycle, static_cast<std::size_t>(at), -1));
    if (!shape.numbers.contains(last)) shape.last = last;
    return false;
}

/// The text of a program, and what the expander knows behind the lines that end a block.
struct Evaluated {
    std::string text;
    std::map<std::uint32_t, Known> known;
};

/// Whether the text may say another F than the block.
bool converts_feed(const nc::Block& block, const ModalState& state) {
    const Function motion = state[Group::Motion];
    const bool is_arc = motion == Function::ArcCw || motion == Function::ArcCcw;
    const nc::SlotMask targets = block.given & nc::kTargetSlots;
    const nc::SlotMask linear = nc::bit(nc::Slot::X) | nc::bit(nc::Slot::Y) | nc::bit(nc::Slot::Z);
    return is_arc || (targets & ~linear) != 0 || block.find(Function::Thread) != nullptr ||
           block.motion == Function::Thread;
}

Evaluated evaluated(const sema::Code& code, const nc::Dialect& dialect, DiagnosticSink& sink) {
    Evaluated out;
    expand::ExpandOptions options;
    options.limits.blocks = kMostBlocks;
    expand::Expander expander(code, dialect, options, sink);
    if (!expander.start("", {})) return out;
    const auto& functions = code.functions;
    const auto entry = std::ranges::find_if(functions, [](const sema::FunctionCode& function) {
        return function.kind == sema::FunctionKind::Program;
    });
    write::Writer writer(dialect, {.number_blocks = false}, sink);
    const bool is_inch = entry != functions.end() && entry->units == sema::Units::Inch;
    writer.begin({"known", 1, "", is_inch}, out.text);
    std::vector<nc::Block> block(1);
    OpenShape shape;
    bool is_converted = false;
    while (expander.pull(block) > 0) {
        writer.write(block[0], out.text);
        // What the program has chosen comes with the line in front of the next block.
        if (writer.holds_codes()) continue;
        // What stands behind a call for its shape the control passes over.
        if (is_of_shape(dialect, block[0], shape)) {
            out.known.erase(writer.lines());
            continue;
        }
        const ModalState* known = expander.known();
        if (known == nullptr) {
            out.known.erase(writer.lines());
            continue;
        }
        is_converted =
            converts_feed(block[0], *known) || (is_converted && !block[0].has(nc::Slot::Feed));
        out.known.insert_or_assign(writer.lines(),
                                   Known{*known, writer.believed(), is_inch, !is_converted});
    }
    writer.end(out.text);
    return out;
}

/// Hands out one block at a time, and has the state compared behind it when the next one is asked
/// for.
class OneByOne final : public Stream<nc::Block> {
  public:
    OneByOne(macro::NcProgram& program, std::function<void(std::uint32_t)> behind)
        : program_(program), behind_(std::move(behind)) {}
    std::size_t pull(std::span<nc::Block> out) override {
        if (line_ > 0) behind_(line_);
        const std::size_t count = program_.pull(out.first(1));
        line_ = count > 0 ? out[0].line : 0;
        return count;
    }

  private:
    macro::NcProgram& program_;
    std::function<void(std::uint32_t)> behind_;
    std::uint32_t line_ = 0;
};

// ---------------------------------------------------------------- comparing

/// Not known, or not before the output has said it again: behind a block that may be left out.
bool is_lost(const ModalState& known, sema::ModalMask what) {
    return ((known.lost.what() | known.lost.restate()) & what) != 0;
}
bool is_lost(const ModalState& known, Group group) {
    return is_lost(known, sema::group_bit(group));
}

/// The mode of the feed as the interpreter has it; nothing where the expander does not know it.
std::optional<path::FeedMode> feed_mode_of(const ModalState& known) {
    if (is_lost(known, Group::FeedMode)) return std::nullopt;
    switch (known[Group::FeedMode]) {
        case Function::FeedPerMinute: return path::FeedMode::PerMinute;
        case Function::FeedPerRevolution: return path::FeedMode::PerRevolution;
        case Function::FeedInverseTime: return path::FeedMode::InverseTime;
        default: return std::nullopt;
    }
}

std::optional<path::SpindleMode> spindle_of(const ModalState& known) {
    if (is_lost(known, Group::Spindle) || known.speed.is_turning_in_doubt()) return std::nullopt;
    switch (known[Group::Spindle]) {
        case Function::SpindleOrient: return path::SpindleMode::Orient;
        case Function::SpindleCw: return path::SpindleMode::Cw;
        case Function::SpindleCcw: return path::SpindleMode::Ccw;
        case Function::SpindleStop: return path::SpindleMode::Stop;
        default: return std::nullopt;
    }
}

std::string pair(std::string_view what, double known, double found) {
    return std::string(what) + ' ' + format_shortest(known) + " is " + format_shortest(found);
}

/// What the expander knows and the interpreter contradicts; empty: nothing.
std::string contradiction(const Known& behind, const interp::Interpreter& interpreter) {
    const ModalState& known = behind.state;
    const interp::Snapshot now = interpreter.snapshot();
    for (std::size_t i = 0; i < kAxes; ++i) {
        if (!known.position.knows(i) || (now.axes >> i & 1u) == 0) continue;
        if (std::abs(known.position[i] - now.work[i]) > kRounded)
            return pair(kAxisNames[i], known.position[i], now.work[i]);
    }
    const auto mode = feed_mode_of(known);
    if (mode && *mode != now.feed_mode) return "another feed mode";
    const bool has_feed =
        behind.has_feed_of_text && known.feed.is_known() && !is_lost(known, sema::kFeedBit);
    if (has_feed && mode && now.feed &&
        std::abs(known.feed.value() - *now.feed) > 0.006 + 1e-6 * known.feed.value())
        return pair("F", known.feed.value(), *now.feed);
    if (has_feed && mode && !now.feed) return "no F";
    const bool has_speed = known.speed.is_known() && !is_lost(known, sema::kSpeedBit);
    if (has_speed && std::abs(known.speed.value() - now.speed) > 0.6)
        return pair("S", known.speed.value(), now.speed);
    const auto spindle = spindle_of(known);
    if (spindle && *spindle != now.spindle)
        return pair("the spindle", static_cast<double>(*spindle), static_cast<double>(now.spindle));
    if (known.tool.in() && *known.tool.in() != static_cast<double>(now.tool))
        return pair("T", *known.tool.in(), static_cast<double>(now.tool));
    if (known[Group::WorkOffsets] == Function::WorkOffset && !is_lost(known, Group::WorkOffsets) &&
        known.owed.work_offset() == 0 && known.work_offset != static_cast<double>(now.work_offset))
        return pair("the work offset", known.work_offset, static_cast<double>(now.work_offset));
    return {};
}

/// What is told of the state, by its name.
std::string item(const std::vector<interp::StateItem>& items, std::string_view name) {
    const auto found = std::ranges::find(items, name, &interp::StateItem::name);
    return found == items.end() ? std::string() : found->value;
}

/// What the state shows where a function acts; empty: it does not show it.
std::string shown(Function function) {
    switch (function) {
        case Function::PlaneXy: return "XY";
        case Function::PlaneZx: return "ZX";
        case Function::PlaneYz: return "YZ";
        case Function::Absolute: return "absolute";
        case Function::Incremental: return "incremental";
        default: return {};
    }
}

/// What the writer believes of its text and the one who reads and executes it contradicts.
std::string misreading(const Known& behind, const interp::Interpreter& interpreter) {
    constexpr double kWritten = 1e-6;  // both add up the same words
    const write::WriterModal& text = behind.text;
    const interp::Snapshot now = interpreter.snapshot();
    const std::vector<interp::StateItem> items = interpreter.state();
    for (std::size_t i = 0; i < kAxes; ++i) {
        const nc::SlotMask axis = nc::SlotMask{1} << i;
        if ((text.position.known & ~text.position.written & axis) == 0) continue;
        if ((now.axes >> i & 1u) != 0 && std::abs(text.position.text[i] - now.work[i]) > kWritten)
            return "of the text " + pair(kAxisNames[i], text.position.text[i], now.work[i]);
    }
    for (const auto& [group, name] :
         {std::pair(Group::Plane, "plane"), std::pair(Group::Distance, "distances")}) {
        const std::string believed = shown(text.text_of(group));
        if (!believed.empty() && believed != item(items, name))
            return "of the text " + believed + " is " + item(items, name);
    }
    const Function motion = text.text_of(Group::Motion);
    if (motion != Function::None && item(items, "motion") != nc::info(motion).name)
        return "of the text " + std::string(nc::info(motion).name) + " is " + item(items, "motion");
    if (text.feed.is_known && now.feed && !behind.is_inch &&
        std::abs(text.feed.value - *now.feed) > kWritten * (1 + text.feed.value))
        return "of the text " + pair("F", text.feed.value, *now.feed);
    if (text.speed.is_known && std::abs(text.speed.value - now.speed) > kWritten * (1 + now.speed))
        return "of the text " + pair("S", text.speed.value, now.speed);
    return {};
}

// ---------------------------------------------------------------- programs

std::string machine_of(const std::string& text, bool is_for_lathe) {
    static const std::regex kSaid("machine: ([\\w-]+)");
    std::smatch said;
    const bool is_given = std::regex_search(text, said, kSaid);
    if (is_given && said[1] == "five-axis") return "trunnion-ac";
    if (is_given && fs::exists(KADR_ROOT "/runtime/machines/" + said[1].str() + ".xml"))
        return said[1];
    return is_for_lathe ? "lathe" : "";
}

struct Compared {
    std::size_t blocks = 0;
    std::string contradiction;
};

constexpr std::uint16_t kAllLevels = 0x3ff;

/// Executes the text line by line, and asks behind each.
///
/// skip_levels  of the blocks that the operator leaves out
void execute(const Evaluated& evaluated, std::uint16_t skip_levels, driver::Session& session,
             const nc::Dialect& dialect, const machine::Machine& machine, Compared& out) {
    DiagnosticList messages;
    struct Text final : nc::TextSource {
        explicit Text(std::string_view all) : rest(all) {}
        std::string_view next() override { return std::exchange(rest, {}); }
        std::string_view rest;
    } source(evaluated.text);
    driver::LibraryCycles cycles(session, dialect);
    macro::ProgramOptions reading;
    reading.skip_levels = skip_levels;
    macro::NcProgram lines(dialect, source, "known", reading, messages);
    const interp::Interpreter* onlooker = nullptr;
    OneByOne blocks(lines, [&](std::uint32_t line) {
        const auto known = evaluated.known.find(line);
        if (known == evaluated.known.end() || !out.contradiction.empty()) return;
        ++out.blocks;
        std::string found = contradiction(known->second, *onlooker);
        if (found.empty()) found = misreading(known->second, *onlooker);
        if (found.empty()) return;
        std::istringstream in(evaluated.text);
        std::string shown;
        for (std::uint32_t i = 0; i < line; ++i) std::getline(in, shown);
        out.contradiction = "line " + std::to_string(line) + " `" + shown + "`: " + found;
        if (skip_levels != 0) out.contradiction += ", where `/` is left out";
    });
    interp::InterpreterOptions stepping;
    stepping.in_step = true;
    stepping.skip_levels = skip_levels;
    interp::Interpreter interpreter(dialect, machine, blocks, &lines, &cycles, stepping, messages);
    onlooker = &interpreter;
    lines.follow(interpreter);
    std::vector<path::Command> batch(64);
    while (interpreter.pull(batch) > 0) {
    }
}

Compared compared(const std::string& path, const std::string& text, const std::string& target,
                  bool is_for_lathe = false) {
    Compared out;
    Sources sources = test::inputs().new_sources();
    driver::Messages messages(sources, {}, [](std::string_view) {});
    driver::Options options;
    options.dialect = target;
    options.machine = machine_of(text, is_for_lathe);
    driver::Session session(options, test::inputs(), sources, messages);
    const nc::Dialect* dialect = session.chosen_dialect(target);
    const machine::Machine* machine = session.machine();
    const auto program = driver::load_program(session, sources.add(path, text));
    if (!program || dialect == nullptr || machine == nullptr) return out;
    const Evaluated text_of_it = evaluated(*program->code, *dialect, messages);
    if (messages.errors() > 0) return out;  // such a text is never given to a control
    execute(text_of_it, 0, session, *dialect, *machine, out);
    if (text_of_it.text.find("\n/") != std::string::npos)
        execute(text_of_it, kAllLevels, session, *dialect, *machine, out);
    return out;
}

TEST(KnownState, IsWhatTheControlDoes) {
    std::size_t blocks = 0;
    std::size_t programs = 0;
    for (const char* folder : {"/tests", "/examples", "/stdlib"}) {
        for (const auto& entry :
             fs::recursive_directory_iterator(KADR_ROOT + std::string(folder))) {
            if (entry.path().extension() != ".kadr") continue;
            const std::string path = entry.path().string();
            const auto text = read_file(path);
            ASSERT_TRUE(text.has_value());
            const bool turns = path.find("lathe") != std::string::npos ||
                               text->find("-m lathe") != std::string::npos ||
                               text->find("machine: lathe") != std::string::npos;
            for (const char* target :
                 {"sinumerik", turns ? "fanuc-lathe" : "fanuc", "axioma", "iso"}) {
                const Compared result = compared(path, *text, target, turns);
                blocks += result.blocks;
                programs += result.blocks > 0;
                EXPECT_EQ(result.contradiction, "") << path << " on " << target;
            }
        }
    }
    EXPECT_GT(programs, 700u);
    EXPECT_GT(blocks, 10000u);
}

TEST(KnownState, OfRandomProgramsIsWhatTheControlDoes) {
    std::size_t blocks = 0;
    for (std::uint64_t seed = 1; seed <= 700; ++seed) {
        const auto program = rc::gen::exec(any_program)(rc::Random(seed), rc::kNominalSize).value();
        const std::string text = text_of(program, Language::Kadr);
        const char* target = seed % 2 == 0 ? "sinumerik" : "fanuc";
        const Compared result = compared("random.kadr", text, target);
        blocks += result.blocks;
        EXPECT_EQ(result.contradiction, "") << seed << " on " << target << "\n" << text;
    }
    EXPECT_GT(blocks, 6000u);
}

/// A program of which the operator may leave out some blocks.
std::string any_with_skips(std::uint64_t seed) {
    static const std::vector<const char*> kBlocks = {
        "G0 X{} Y{};", "G1 X{} F{}00;", "G1 Y{};",   "X{};",     "Z{};",          "G0 Z{};",
        "M3;",         "M4;",           "M5;",       "S{}00;",   "F{}0;",         "M8;",
        "M9;",         "G95 F0.{};",    "G94 F{}0;", "A={}deg;", "G0 A=0deg X{};"};
    static const std::vector<const char*> kAlways = {
        "G91;",          "G90;", "T{} M6;", "M3 T{} M6;", "shift(x: {}mm);", "rotate({}deg);",
        "rotate_off();", "G55;", "G54;",    "M3 S{}00;",  "G1 X{} Y{} F200;"};
    std::mt19937_64 random(seed);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    std::string text = "program p() {\nG90 G17 G54; T1 M6; S500 M3; G0 X1 Y2 Z3 A=0deg;\nF100;\n";
    for (int i = 0; i < 16; ++i) {
        const bool is_skipped = below(3) == 0;
        const auto& from = is_skipped || below(2) == 0 ? kBlocks : kAlways;
        std::string line = from[below(from.size())];
        for (std::size_t at; (at = line.find("{}")) != std::string::npos;)
            line.replace(at, 2, std::to_string(1 + below(8)));
        text += (is_skipped ? "/ " : "") + line + '\n';
    }
    return text + "G1 X9 Y9 Z9 F150;\n}\n";
}

/// What is known holds whether the operator lets such a block run or not.
TEST(KnownState, OfBlocksThatMayBeLeftOut) {
    std::size_t blocks = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        const std::string text = "// machine: five-axis\n" + any_with_skips(seed);
        const char* target = seed % 2 == 0 ? "sinumerik" : "fanuc";
        const Compared result = compared("skips.kadr", text, target);
        blocks += result.blocks;
        EXPECT_EQ(result.contradiction, "") << seed << " on " << target << "\n" << text;
    }
    EXPECT_GT(blocks, 4000u);
}

}  // namespace
}  // namespace kadr::control_testing::known_state_test
