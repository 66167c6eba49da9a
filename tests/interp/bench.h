// bench.h — the bench on which interpreter tests stand: a control, a machine, and blocks.
//
// Blocks are built from words, not read from text: what is tested here is what blocks do. A control
// is the common core with some rules set, so a test names the one switch that it is about.
#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/numbers.h"
#include "interp/interpreter.h"
#include "interp/listing.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Slot;

/// A block under construction: `Words().g(Function::Line).x(10).f(200)`.
class Words {
  public:
    Words() = default;
    explicit Words(Block block) : block_(std::move(block)) {}
    Words& motion(Function function) {
        block_.motion = function;
        return *this;
    }
    Words& set(Slot slot, double value) {
        block_.set(slot, value);
        return *this;
    }
    Words& x(double value) { return set(Slot::X, value); }
    Words& y(double value) { return set(Slot::Y, value); }
    Words& z(double value) { return set(Slot::Z, value); }
    Words& i(double value) { return set(Slot::CenterX, value); }
    Words& j(double value) { return set(Slot::CenterY, value); }
    Words& k(double value) { return set(Slot::CenterZ, value); }
    Words& r(double value) { return set(Slot::Radius, value); }
    Words& turns(double value) { return set(Slot::Turns, value); }
    Words& f(double value) { return set(Slot::Feed, value); }
    Words& s(double value) { return set(Slot::Speed, value); }
    /// `X=IC(5)`, `X=AC(5)`
    Words& ic(Slot slot, double value) {
        block_.incremental |= bit(slot);
        return set(slot, value);
    }
    Words& ac(Slot slot, double value) {
        block_.absolute |= bit(slot);
        return set(slot, value);
    }
    Words& skip(int level) {
        block_.skip_level = static_cast<std::int8_t>(level);
        return *this;
    }
    Words& text(std::string_view text) {
        block_.text = text;
        return *this;
    }
    Words& kind(Block::Kind kind) {
        block_.kind = kind;
        return *this;
    }
    /// A function, with parameters by their place in the vocabulary.
    Words& fn(Function function,
              std::initializer_list<std::pair<std::size_t, double>> arguments = {}) {
        nc::Invocation* invocation = block_.add(function, nc::info(function).parameters.size());
        EXPECT_NE(invocation, nullptr);
        for (const auto& [parameter, value] : arguments) {
            block_.set_argument(*invocation, parameter, value);
        }
        return *this;
    }
    Words& cycle(nc::CycleId cycle, std::size_t count,
                 std::initializer_list<std::pair<std::size_t, double>> arguments) {
        block_.cycle = cycle;
        nc::Invocation* invocation = block_.add(Function::Cycle, count);
        EXPECT_NE(invocation, nullptr);
        for (const auto& [parameter, value] : arguments) {
            block_.set_argument(*invocation, parameter, value);
        }
        return *this;
    }
    operator Block() const { return block_; }

  private:
    Block block_{};
};

inline Words rapid() { return Words().motion(Function::Rapid); }
inline Words line() { return Words().motion(Function::Line); }
inline Words cw() { return Words().motion(Function::ArcCw); }
inline Words ccw() { return Words().motion(Function::ArcCcw); }
inline Words fn(Function function,
                std::initializer_list<std::pair<std::size_t, double>> arguments = {}) {
    return Words().fn(function, arguments);
}

/// Blocks one after the other, in small batches so that their seams are tested too.
class BlockList final : public Stream<Block> {
  public:
    explicit BlockList(std::vector<Block> blocks) : blocks_(std::move(blocks)) {
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            if (blocks_[i].line == 0) blocks_[i].line = static_cast<std::uint32_t>(i + 1);
        }
    }
    std::size_t pull(std::span<Block> out) override {
        const std::size_t count = std::min({out.size(), blocks_.size() - next_, std::size_t{3}});
        for (std::size_t i = 0; i < count; ++i) out[i] = blocks_[next_++];
        return count;
    }

  private:
    std::vector<Block> blocks_;
    std::size_t next_ = 0;
};

/// A three-axis mill from −1000 to 1000 with a rotary table C and three tools; G54 is shifted.
inline machine::Machine mill() {
    machine::Machine machine;
    machine.name = "mill";
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        machine.axes.push_back({.name = std::string(kAxisNames[index(axis)]),
                                .axis = axis,
                                .is_rotary = false,
                                .lower = -1000,
                                .upper = 1000,
                                .velocity = 500,
                                .acceleration = 5000,
                                .jerk = 1e5,
                                .home = 0});
    }
    machine.axes.push_back({.name = "C",
                            .axis = Axis::C,
                            .is_rotary = true,
                            .lower = -7,
                            .upper = 7,
                            .velocity = 1,
                            .acceleration = 10,
                            .jerk = 100,
                            .home = 0});
    machine.tools = {{.number = 1, .length = 100, .radius = 5, .name = "MILL_10"},
                     {.number = 2, .length = 80, .radius = 3, .name = "DRILL_6"},
                     {.number = 3, .length = 80, .radius = 4, .name = "DRILL_8"}};
    machine.work_offsets = {{}, {-300, 20, 5}, {10, 0, 0}};
    return machine;
}

/// The common core with these rules and alarms: `<rule …/>`. Loaded once.
inline const nc::Dialect& control(std::string_view rules = {}) {
    static std::map<std::string, nc::Dialect, std::less<>> loaded;
    if (const auto known = loaded.find(rules); known != loaded.end()) return known->second;

    // Tests run side by side, each in its own process.
    const std::string file =
        ::testing::TempDir() + "kadr_control_" + std::to_string(getpid()) + ".xml";
    std::ofstream(file) << "<dialect name=\"control\" extends=\"iso\" title=\"under test\" "
                        << "suffix=\"nc\">" << rules << "</dialect>";
    Sources sources;
    DiagnosticList messages;
    std::optional<nc::Dialect> dialect =
        nc::load_dialect(file, {KADR_ROOT "/dialects"}, sources, messages);
    std::filesystem::remove(file);
    EXPECT_FALSE(messages.has_errors())
        << (messages.all().empty() ? "" : messages.all()[0].message());
    return loaded.emplace(rules, std::move(*dialect)).first->second;
}

struct Ran {
    std::vector<path::Command> commands;
    std::vector<Diagnostic> messages;
    bool alarmed = false;
    std::uint64_t blocks = 0;

    /// The commands as the listing shows them, without spindle and end if those are all the same.
    std::string listing() const {
        std::string out;
        const Listing lines(mill());
        for (const path::Command& command : commands) {
            path::Command shown = command;
            shown.line = 0;
            lines.append(shown, {}, out);
        }
        return out;
    }
    /// Codes of the messages: "K5213 K5260".
    std::string codes() const {
        std::string out;
        for (const Diagnostic& message : messages) {
            if (!out.empty()) out += ' ';
            out += message.row->code;
        }
        return out;
    }
};

struct Setup {
    std::string_view rules = {};
    machine::Machine machine = mill();
    InterpreterOptions options = {};
    CycleExpander* cycles = nullptr;
    bool ended = true;         // an end of program is appended
    bool spindle_runs = true;  // and the spindle turns at the start, unheard
    std::size_t batch = 5;     // commands of a pull
};

inline Ran run(std::vector<Block> blocks, const Setup& setup = {}) {
    std::vector<Block> all;
    if (setup.spindle_runs) all.push_back(fn(Function::SpindleCw).s(1000));
    all.insert(all.end(), blocks.begin(), blocks.end());
    if (setup.ended) all.push_back(fn(Function::EndRewind));
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].line = static_cast<std::uint32_t>(i + (setup.spindle_runs ? 0 : 1));
    }
    const nc::Dialect& dialect = control(setup.rules);
    BlockList stream(all);
    DiagnosticList messages;
    Interpreter interpreter(dialect, setup.machine, stream, nullptr, setup.cycles, setup.options,
                            messages);
    Ran ran;
    std::vector<path::Command> batch(setup.batch);
    while (const std::size_t count = interpreter.pull(batch)) {
        ran.commands.insert(ran.commands.end(), batch.begin(),
                            batch.begin() + static_cast<std::ptrdiff_t>(count));
    }
    EXPECT_EQ(interpreter.pull(batch), 0u) << "after the end there is nothing";
    if (setup.spindle_runs && !ran.commands.empty()) ran.commands.erase(ran.commands.begin());
    if (setup.ended && !ran.commands.empty() && ran.commands.back().op() == path::Op::End) {
        ran.commands.pop_back();
    }
    ran.messages = messages.all();
    ran.alarmed = interpreter.alarmed();
    ran.blocks = interpreter.blocks();
    return ran;
}

/// End of the last motion: "48.660254 30 0".
inline std::string end_of(const Ran& ran) {
    char text[80] = "no motion";
    for (const path::Command& command : ran.commands) {
        if (command.op() != path::Op::Rapid && command.op() != path::Op::Line &&
            command.op() != path::Op::Arc) {
            continue;
        }
        std::snprintf(text, sizeof text, "%.4f %.4f %.4f", round_to(command.motion().to[0], 4),
                      round_to(command.motion().to[1], 4), round_to(command.motion().to[2], 4));
    }
    return text;
}

}  // namespace kadr::interp
