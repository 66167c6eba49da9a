// evaluator.h — expressions of the control's own language → values.
//
// Works on the compiled code of a line and changes nothing; what a control would alarm on comes
// back as a fault. Numbers never touch the heap.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/done.h"
#include "macro/contour_table.h"
#include "macro/control_value.h"
#include "nc/lexer.h"

namespace kadr::macro {

/// What expressions read: variables, and the state of the control.
class Variables {
  public:
    virtual ~Variables() = default;
    enum class Answer : std::uint8_t {
        Value,
        Missing,
        NotReadable,
        Unsupported,
        Compensated,
        Later
    };
    /// A variable of a family by its number.
    virtual Answer family(std::uint32_t form, std::int64_t number, ControlValue& out) = 0;
    /// How a program writes such a variable, and what it is: "`#1004` (inputs)".
    virtual std::string named(std::uint32_t form, std::int64_t number) const = 0;
    /// A value of the machine: of an open form by the number of its name and its indices. A text
    /// goes to `text`.
    virtual Answer input(std::uint32_t form, std::span<const std::int64_t> indices,
                         ControlValue& out, std::string& text) = 0;
    /// `Later`: the blocks before have to be executed first.
    virtual Answer system(nc::SystemQuantity quantity, std::int64_t first, std::int64_t second,
                          double& out) = 0;
    /// Sets a system variable that is a whole number; false: there is no such variable.
    virtual bool set_system(nc::SystemQuantity quantity, std::int64_t first, std::int64_t second,
                            double value) = 0;
    /// The same of a system variable that is a frame.
    virtual Answer frame(nc::SystemQuantity quantity, std::int64_t index,
                         control::ControlFrame& out) = 0;
    /// The same of a system variable that is a text.
    virtual Answer text(nc::SystemQuantity quantity, std::int64_t index, std::string& out) = 0;
    /// mm, or degrees, that 1 in a word of the axis is.
    virtual double axis_unit(Axis axis) const = 0;
    /// Which of the machine's axes it is, counted from 1; nothing: the machine has none such.
    virtual std::optional<std::int64_t> axis_number(Axis axis) const = 0;
    /// Whether a variable has this name, behind which indices may stand.
    virtual bool has_name(std::string_view name) const = 0;
    /// What such a variable holds; nothing: there is none.
    virtual std::optional<nc::ValueType> type_of(std::string_view name) const = 0;
    /// How the control writes an operation.
    virtual std::string word_of(nc::Operation operation) const = 0;
    /// Whether the machine has a spindle with this number; 0 is the master.
    virtual bool has_spindle(std::int64_t number) const = 0;
    /// Whether a program has it; texts may be read for that.
    virtual bool find_program(std::string_view name) = 0;
    /// Sets one element of a variable that the program has declared; false: its type takes no real.
    virtual bool set_element(const nc::ControlSymbol& symbol, std::uint32_t element,
                             double value) = 0;
};

class Evaluator {
  public:
    static constexpr std::size_t kLongestText = 400;  // that is put together; S 8.4, alarm 14099

    Evaluator(const nc::LanguageRules& rules, const Store& globals, const Level& level,
              Variables& variables)
        : rules_(rules), globals_(globals), level_(&level), variables_(variables) {}

    enum class Outcome : std::uint8_t { Done, Fault, Later };

    /// decimals  to which the function round goes; -1: to whole numbers
    Outcome run(const nc::ControlLine& line, const nc::Expression& expression, ControlValue& out,
                int decimals = -1);
    /// Where the latest run has taken radians for degrees, and the word of the function that did.
    struct Radians {
        nc::Span place;
        nc::Operation operation{};
        double angle = 0;
    };
    /// What it has found since it was asked last.
    std::optional<Radians> take_radians() { return std::exchange(radians_, std::nullopt); }
    bool has_radians() const { return radians_.has_value(); }
    /// Why it came to no value.
    const nc::LineFault& fault() const { return fault_; }
    /// What is being worked out, or was last.
    const nc::Span& place() const { return place_; }
    /// Whether two values are equal, as `==` has it; none: they cannot be compared, `fault` tells
    /// why.
    std::optional<bool> is_same(ControlValue a, const ControlValue& b);
    /// A text that a value holds; valid until the next `forget`.
    std::string_view text(const ControlValue& value) const {
        return value.is_text() ? std::string_view(texts_[value.text]) : std::string_view();
    }
    ControlValue keep_text(std::string text) {
        texts_.push_back(std::move(text));
        return {0, static_cast<std::uint32_t>(texts_.size() - 1), ControlValue::Kind::Text};
    }
    const control::ControlFrame* frame(const ControlValue& value) const {
        return value.is_frame() ? &frames_[value.text] : nullptr;
    }
    Content content(const ControlValue& value) const { return {text(value), frame(value)}; }
    ControlValue keep_frame(const control::ControlFrame& frame) {
        frames_.push_back(frame);
        return {0, static_cast<std::uint32_t>(frames_.size() - 1), ControlValue::Kind::Frame};
    }
    /// A value that stands elsewhere, for what is worked out next.
    ControlValue keep(const ControlValue& value, const Content& content) {
        if (value.is_text()) return keep_text(std::string(content.text));
        return value.is_frame() ? keep_frame(*content.frame) : value;
    }
    void forget() {
        if (!texts_.empty()) texts_.clear();
        if (!frames_.empty()) frames_.clear();
    }
    void enter(const Level& level) { level_ = &level; }

    /// The indices that the code of a reference has put on the stack.
    Outcome indices(const nc::ControlLine& line, const nc::Reference& reference,
                    std::span<std::int64_t> out);

    /// As `<<` writes it.
    std::string written(const ControlValue& value) const;
    /// The slot of an element of a declared variable; nothing: an index does not fit.
    static std::optional<std::uint32_t> element(const nc::ControlSymbol& symbol,
                                                std::span<const std::int64_t> indices);
    /// Which index does not fit, for a message: "`MAT`", and of a further one "`MAT` in place 2".
    static std::string wrong_index(const nc::ControlSymbol& symbol,
                                   std::span<const std::int64_t> indices);
    /// A row of a table of contours that the program has.
    ContourRow contour_row(const nc::ControlSymbol& table, std::int64_t row) const;

  private:
    Outcome execute(const nc::ControlLine& line, const nc::Expression& expression, int decimals);
    Done load(const nc::ControlLine& line, std::size_t at);
    Done load_family(const nc::ControlInstruction& instruction);
    Done load_system(const nc::ControlInstruction& instruction);
    Done load_input(const nc::ControlInstruction& instruction);
    Done load_element(const nc::ControlInstruction& instruction);
    Done load_frame_part(const nc::ControlInstruction& instruction);
    Done answer(Variables::Answer answer);
    Done operate(const nc::ControlInstruction& instruction, int decimals);
    Done arithmetic(nc::Operation operation, ControlValue& a, const ControlValue& b);
    void make_character(ControlValue& value, const ControlValue& other) const;
    Done compare(nc::Operation operation, ControlValue& a, ControlValue b);
    Done bits(nc::Operation operation, ControlValue& a, const ControlValue& b);
    Done function(nc::Operation operation, ControlValue* a, int decimals);
    Done text_function(nc::Operation operation, ControlValue* a, int count);
    void look_for_radians(nc::Operation operation, double angle);
    Done arc_function(nc::Operation operation, ControlValue* a);
    Done axis_function(nc::Operation operation, ControlValue* a);
    Done plane_rotation(ControlValue* a);
    Done question(nc::Operation operation, ControlValue* a);
    Done format_text(ControlValue* a, int count);
    const nc::ControlSymbol* variable_itself(const ControlValue& place, std::uint32_t least,
                                             const std::string& what);
    double element_of(const nc::ControlSymbol& symbol, std::uint32_t element) const;
    Done set_element(const nc::ControlSymbol& symbol, std::uint32_t element, double value);
    Done circle_through(ControlValue* a);
    Done measured_frame(ControlValue* a);
    Done common_point(ControlValue* a);
    // Cutting edges by their numbers.
    Done ask(nc::SystemQuantity quantity, double first, double second, double& out);
    Done edge_question(nc::Operation operation, ControlValue* a, int count);
    Done tool_of_edge(ControlValue* a);
    Done edges_unique(ControlValue* a, int count);
    Done frame_function(nc::Operation operation, ControlValue* a, int count);
    Done pairs(nc::Operation operation, const ControlValue* a, int count,
               std::vector<control::AxisAndValue>& out);
    void note_fault(const DiagnosticRow& row, std::vector<std::string> arguments);
    Done fail(const DiagnosticRow& row, std::vector<std::string> arguments = {});
    Done real(ControlValue& out, double number);
    void push(const ControlValue& value) { stack_[size_++] = value; }

    const nc::LanguageRules& rules_;
    const Store& globals_;
    const Level* level_;
    Variables& variables_;
    std::vector<ControlValue> stack_;
    std::size_t size_ = 0;
    std::deque<std::string> texts_;  // views of them stay valid
    std::deque<control::ControlFrame> frames_;
    nc::LineFault fault_;
    nc::Span place_;
    std::optional<Radians> radians_;
    nc::Operation operation_{};  // that runs, for messages
    bool is_later_ = false;
};

}  // namespace kadr::macro
