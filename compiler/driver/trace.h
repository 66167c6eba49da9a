// trace.h — `--trace`: what each executed block has changed, as a table or as JSON Lines.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/json_writer.h"
#include "driver/session.h"
#include "expand/expander.h"
#include "interp/snapshot.h"
#include "macro/code_list.h"
#include "macro/program.h"

namespace kadr::driver {

/// A number, rounded to nine decimals, a count or a word of the modal state; or nothing.
using ModalValue = std::variant<std::monostate, double, std::int64_t, std::string>;

/// One entry of the modal state behind a block.
struct ModalEntry {
    std::string_view name;   // in JSON: `feed`
    std::string_view label;  // in the table: `F`
    ModalValue value;
};

/// Feed, speed, spindle, tools and offsets; always the same entries in the same order.
std::vector<ModalEntry> modal_entries(const interp::Snapshot& now);

/// The state of a control between two blocks.
struct TraceState {
    interp::Snapshot now;
    std::vector<macro::ActiveCode> codes;
    std::vector<ModalEntry> modal;
};

/// A block that was executed.
struct TraceStep {
    std::uint64_t block = 0;  // from 1; 0: what the program found when it began
    std::string file;
    std::uint64_t line = 0;
    std::int64_t number = -1;  // N; -1 none
    std::string program;       // that was called; empty: the main program
    std::size_t level = 0;     // how many calls led there
    std::string text;
    SourceRange statement;   // of the Kadr program; invalid: none
    bool has_calls = false;  // `calls` holds
    expand::BlockOrigin calls;
    std::vector<macro::VariableChange> variables;  // each once, and only if it has changed
};

/// For people: `200`, `cw`; `nothing` if there is none.
std::string modal_text(const ModalValue& value, std::string_view nothing);
/// A value of a variable as JSON has it: `2.5`, `"A"`; null for one that is vacant.
std::string json_text(const macro::ControlVariable& variable);

void put_value(JsonWriter& json, const ModalValue& value);
void put_value(JsonWriter& json, const macro::ControlVariable& variable);
/// `{"X":1.5,"Y":0}` of the axes that the machine has.
void put_axis_values(JsonWriter& json, AxisMask axes, const AxisValues& values);

enum class TraceFormat : std::uint8_t { Table, Json };

/// Writes steps one by one; keeps nothing but the state behind the last one.
class Trace {
  public:
    /// The session outlives the trace. `main`: the file whose lines need no name in the table.
    Trace(const Session& session, TraceFormat format, std::string main)
        : session_(session), format_(format), main_(std::move(main)) {}

    /// Appends a step and what the state became by it.
    void append(const TraceStep& step, TraceState state, std::string& out);
    /// Appends the last line of a run that came to an alarm.
    void append_alarm(std::string_view text, std::string& out) const;

  private:
    void put_step(JsonWriter& json, const TraceStep& step) const;
    void append_json(const TraceStep& step, const TraceState& state, std::string& out) const;
    void append_head(AxisMask axes, std::string& out) const;
    void append_row(const TraceStep& step, const TraceState& state, std::string& out) const;
    std::string entered(const TraceStep& step) const;
    std::string changes(const TraceStep& step, const TraceState& state) const;

    const Session& session_;
    TraceFormat format_;
    std::string main_;
    bool has_state_ = false;
    TraceState before_;
    std::string program_;    // of the last row of the table
    std::size_t level_ = 0;  // … and how many calls led there
};

}  // namespace kadr::driver
