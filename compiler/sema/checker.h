// checker.h — the checker at work: one pass over each function that checks and emits code.
//
// The chapters: check.cpp (the road through a program), declarations.cpp (files, types, functions),
// scope.cpp (names), expressions.cpp, values.cpp, convert.cpp (units and dimensions),
// optionals.cpp, composites.cpp (points, structs, arrays), operators.cpp, conditions.cpp,
// lvalues.cpp (what can be assigned), calls.cpp, builtins.cpp, text.cpp (strings), statements.cpp,
// loops.cpp, blocks.cpp (NC blocks), contours.cpp, curves.cpp, with.cpp, tests.cpp, preserves.cpp,
// origins.cpp. For the room sema only.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/done.h"
#include "sema/check.h"
#include "sema/code.h"
#include "sema/emitter.h"
#include "sema/names.h"
#include "sema/recorder.h"
#include "sema/types.h"

namespace kadr::sema {

/// Something that can be read, assigned, referred to: a variable, a member, an element.
struct Lvalue {
    enum class Storage : std::uint8_t { Local, Global, Reference, Element };
    Storage storage = Storage::Local;
    Type type;
    Reg reg = 0;               // Local; Reference: the register that refers; Element: the array
    Reg index = 0;             // Element
    std::uint32_t offset = 0;  // Global: its register; Reference, Element: slots further
    std::uint16_t stride = 1;  // Element: slots of a whole element
    bool is_const = false;
    bool is_loop_variable = false;
    bool is_temporary = false;  // part of a value that nobody else sees
    bool is_contour_part = false;
    bool may_be_unset = false;
    std::int32_t symbol = -1;  // local symbol, if this is a whole local variable
    std::string_view root;     // name of the variable, for messages
    SourceRange root_range;    // where it was declared
};

struct LoopScope {
    Label* on_break = nullptr;
    Label* on_continue = nullptr;  // null: a switch
    std::size_t with_depth = 0;
};

class Checker {
  public:
    Checker(ModuleLoader& modules, const Sources& sources, DiagnosticSink& sink,
            const CheckOptions& options);
    CheckResult run(const syntax::Ast& main, const nc::Dialect& dialect);

  private:
    /// Whether there was no error, and so there is code.
    bool check_program(const syntax::Ast& main, const nc::Dialect& dialect);

    // declarations.cpp
    std::uint32_t load_module(const syntax::Ast& ast, const nc::Dialect& dialect);
    void import(std::uint32_t module, const syntax::Decl& decl);
    void declare_names(std::uint32_t module);
    SymbolId declare(std::uint32_t module, syntax::DeclId id, Name entry, SymbolId owner = {});
    void declare_enum(std::uint32_t module, syntax::DeclId id);
    DeclaredSymbol described(std::uint32_t module, syntax::DeclId id,
                             DeclaredSymbol::Kind kind) const;
    void declare_parameter(const FunctionDecl& function, ParameterDecl& parameter);
    void check_header(const syntax::Ast& ast);
    void declare_units(std::uint32_t module);
    void define_types(std::uint32_t module);
    void define_struct(std::uint32_t module, Type type, const syntax::Decl& decl);
    void define_enum_values(std::uint32_t module, const syntax::Decl& decl);
    void define_signature(std::uint32_t function);
    Type resolve_type(syntax::TypeId id);
    std::optional<Type> builtin_type(std::string_view name) const;
    void check_global(std::uint32_t global, bool on_demand);
    void check_function(std::uint32_t function);
    void check_defaults(const FunctionDecl& function);
    void bind_parameters(const FunctionDecl& function);
    ParameterInfo describe_parameter(const ParameterDecl& parameter);
    void report_unused_parameters();
    void look_at_clock();
    void report_missing_return(const FunctionDecl& function, const syntax::Decl& decl,
                               const SourceRange& end);
    bool take_proposal();
    void report_overflow(std::string_view name, const SourceRange& range);
    void export_enums();
    void finish();
    struct DiameterWords {
        bool in_program = false;  // DIAMON or DIAMOF
        bool in_contour = false;  // DIAMON
    };
    DiameterWords diameter_words(const FunctionCode& function) const;
    void mark_diameters();
    Units units_of(const FunctionDecl& function) const;
    /// The common cycle that this function is the body of.
    bool is_library(std::uint32_t module) const;
    std::optional<nc::CycleId> native_cycle(const FunctionDecl& function) const;
    void emit_native_cycle();
    bool is_check(syntax::StmtId id) const;
    bool only_checks(const FunctionDecl& function) const;
    const FunctionDecl* called_function(syntax::ExprId id) const;
    void emit_unset(Type type, Reg reg);
    bool has_defaults(Type type) const;
    void emit_member(const Member& member, Reg reg);
    void emit_initial(Type type, Reg reg);

    // scope.cpp
    struct Found {
        std::int32_t symbol = -1;    // local
        const Name* name = nullptr;  // top-level
    };
    Found find(std::string_view name) const;
    /// What a Name means; it is recorded as a use.
    Found look_up(syntax::ExprId id);
    const Name* find_global(std::uint32_t module, std::string_view name) const;
    void check_unambiguous(std::string_view name, const SourceRange& range);
    Symbol& add_symbol(Symbol symbol);
    void check_new_name(std::string_view name, const SourceRange& range);
    void report_unknown(std::string_view name, const SourceRange& range);
    Done require_no_unit(std::string_view name, const SourceRange& range);
    Done require_no_foreign_keyword(std::string_view name, const SourceRange& range);
    bool is_numbered_word(std::string_view word) const;
    std::size_t glued_letters(std::string_view name, const SourceRange& range);
    static void fix_glued(std::size_t letters, const SourceRange& range,
                          DiagnosticBuilder& builder);
    Done require_no_glued_point(const SourceRange& range);
    std::optional<nc::BlockPlan> plan_source(const nc::Dialect& dialect,
                                             std::span<const nc::SourceWord> source);
    std::string name_in_library(std::string_view name);
    std::string hint_of_cycle(std::string_view word);
    std::string hint_of_command(std::string_view word);
    std::string hint_of_call(std::span<const nc::SourceWord> source);
    Done require_no_control_index(std::string_view name, const SourceRange& range);
    bool fix_lookalike(std::string_view name, const SourceRange& range, DiagnosticBuilder& builder);
    Done require_no_foreign_word(std::string_view name, const SourceRange& range);
    Done require_no_letter_for_digit(std::string_view name, const SourceRange& range);
    bool is_statement_at(const SourceRange& range) const;
    bool fix_as_word(std::string_view name, const SourceRange& range, DiagnosticBuilder& builder);
    void report_unknown_type(std::string_view name, const SourceRange& range);
    bool fix_next_word(std::string_view name, const SourceRange& range, DiagnosticBuilder& builder);
    bool fix_loop_variable(const SourceRange& range, DiagnosticBuilder& builder);
    bool fix_statement(std::string_view name, const SourceRange& range, DiagnosticBuilder& builder);
    /// A name that a mistake has taken away, which is reported already.
    Done require_not_lost(std::string_view name);
    std::vector<std::string_view> known_names(bool functions) const;
    /// What `leave_scope` goes back to.
    struct OuterScope {
        std::size_t symbols = 0;
        std::size_t begin = 0;
        std::uint32_t end = 0;
    };
    OuterScope enter_scope(const SourceRange& range);
    void leave_scope(const OuterScope& outer);
    void forget_symbols(std::size_t first);
    void report_unused(const Symbol& symbol);
    std::vector<Givenness> remember_givenness() const;
    void merge_givenness(const std::vector<Givenness>& other);
    void set_givenness(const std::vector<Givenness>& other);
    void forget_givenness();

    // expressions.cpp
    Value expression(syntax::ExprId id, Type expected = {}, Reg hint = kNoReg);
    void note_value(syntax::ExprId id, const Value& value);
    Value expression_kind(syntax::ExprId id, Type expected, Reg hint);
    Value number_literal(const syntax::Expr& expr);
    Value name_value(syntax::ExprId id, Reg hint);
    Value symbol_value(std::int32_t index, const SourceRange& range, bool checked);
    Value conditional(syntax::ExprId id, Type expected, Reg hint);
    Value assign(syntax::ExprId id, bool is_value);
    Value step(syntax::ExprId id, bool is_value);
    Value braces(syntax::ExprId id, Type expected, Reg hint);
    Value brace_array(syntax::ExprId id, Type type);
    Value brace_struct(syntax::ExprId id, Type type, Reg hint);
    void fill_members(syntax::ExprId id, Type type, Reg reg);
    Value member(syntax::ExprId id);
    Value position_member(const syntax::Expr& expr, bool is_position);
    Value given(const syntax::Expr& expr);
    Value is_given(const Value& value);
    Value coalesce(syntax::ExprId id, Type expected);
    /// The value, converted to `target`; `what` names it in messages.
    Value convert(const Value& value, Type target, const SourceRange& range, std::string_view what);
    Value adapt_number(const Value& value, Type target);
    void check_places(Type from, Type to, const SourceRange& range, std::string_view what);
    /// An expression where a type is wanted: converted and in registers `reg` (taken if none).
    Reg expression_in(syntax::ExprId id, Type type, Reg reg, std::string_view what);
    Reg in_register(const Value& value, Reg hint = kNoReg);
    void copy_value(const Value& value, Reg target);
    /// Reads an optional as if it were given: reports or emits the check.
    Value require_given(const Value& value, const SourceRange& range, std::string_view name);
    bool is_plain_number(const Value& value) const;
    bool is_diameter(const Value& value) const;
    Done match_diameters(Value& left, Value& right, const syntax::Expr& expr);
    /// No length stands where a diameter is needed, and no diameter where a length is.
    Done require_same_measure(const Value& value, Type target, const SourceRange& range,
                              std::string_view what);
    std::string quantity_name(Type type) const;
    static Value retyped(Value value, Type type);
    Value whole_number(const Value& value, Type target, const SourceRange& range,
                       std::string_view what);
    std::optional<Value> same_quantity(const Value& value, Type target);
    Value family_value(const Value& value, Type target, bool second);
    bool settle(Value& value);
    void check_unset(const Value& value, std::string_view name, const SourceRange& range);
    /// The value of a name, member or element without the check that it is given; sets
    /// last_unset_ if the variable may be without a value.
    Value unchecked(syntax::ExprId id);
    Value unchecked_kind(syntax::ExprId id);
    Type type_of(syntax::ExprId id);
    /// What a condition tells about optionals: inside `if (given b)`, b is given.
    void assume_given(syntax::ExprId condition, bool sense);
    /// `list.count` and the like; nothing if it is a member of a struct.
    std::optional<Value> property_value(const Lvalue& whole, const syntax::Expr& expr);
    Value constant_number(double value, Type type) const;
    Value constant_integer(std::int64_t value, Type type) const;
    Value constant_text(std::string_view text);
    Value in_registers(Type type, Reg reg) const;
    Value error_value() const;
    std::optional<double> number_of(const Value& constant) const;
    bool writes(syntax::ExprId id);
    Done require_finite(double value, const SourceRange& range);

    // operators.cpp
    Value unary(syntax::ExprId id, Type expected, Reg hint);
    Value binary(syntax::ExprId id, Type expected, Reg hint);
    Type operand_type(const syntax::Expr& expr);
    Value with_literals(const Value& start, std::vector<syntax::ExprId>& links);
    Value chain_link(const syntax::Expr& expr, Value left, Reg mark, Reg hint);
    Value binary_values(syntax::Operator op, Value left, Value right, const syntax::Expr& expr,
                        Reg hint);
    Value arithmetic(syntax::Operator op, Value left, Value right, const syntax::Expr& expr,
                     Reg hint);
    Value families(syntax::Operator op, const Value& left, const Value& right,
                   const syntax::Expr& expr, Reg hint);
    /// Whether an instruction does nothing but set its first register.
    static bool is_pure(OpCode op);
    Value fold_integers(syntax::Operator op, std::int64_t a, std::int64_t b,
                        const SourceRange& range);
    Value emit_integers(syntax::Operator op, const Value& a, const Value& b, Reg hint);
    Value emit_reals(syntax::Operator op, const Value& a, const Value& b, Type type, Reg hint,
                     const SourceRange& range);
    Value vectors(syntax::Operator op, const Value& left, const Value& right,
                  const syntax::Expr& expr);
    void check_same_parts(Reg left, syntax::ExprId left_text, Reg right, syntax::ExprId right_text);
    void warn_of_power(const syntax::Expr& expr, const Value& left, const Value& right);
    void fix_power(const syntax::Expr& expr, const Value& left, const Value& right,
                   DiagnosticBuilder& builder);
    Value bits(syntax::Operator op, const Value& left, const Value& right, const syntax::Expr& expr,
               Reg hint);
    Value truth(syntax::ExprId id, Reg hint);
    Value contains(const syntax::Expr& expr, Reg hint);
    Value contains_struct(const Value& array, const Value& part);
    void emit_equality(Type type, Reg left, Reg right, Reg all);
    struct Sides {
        Value left;
        Value right;
    };
    struct ComparedSides {
        syntax::Operator op = syntax::Operator::Equal;
        bool is_real = false;
        Value left;
        Value right;
    };
    std::optional<ComparedSides> comparison(const syntax::Expr& expr);
    bool is_as_given(syntax::ExprId id) const;
    void warn_equality(const syntax::Expr& expr, const Value& left, const Value& right);
    std::optional<Sides> compared_sides(const syntax::Expr& expr);
    std::optional<ComparedSides> compare(const syntax::Expr& expr, Value left, Value right);
    /// Makes two numbers comparable and addable: the same quantity.
    Done match_quantities(Value& left, Value& right, const syntax::Expr& expr);
    Value to_real(const Value& value);
    Value plain_form(const Value& value, int form);
    /// Jumps to the label if the condition has this truth. `depth` ≥ 0: a loop's backward jump.
    void jump_if(syntax::ExprId id, bool sense, Label& label, int depth = -1);
    void jump_compare(const ComparedSides& comparison, bool sense, Label& label, int depth);
    void check_condition(const Value& value, const SourceRange& range);

    // origins.cpp
    static Origin origin_of_literal(double number, std::string_view literal);
    Origin origin_of_result(syntax::Operator op, const Value& left, const Value& right) const;
    void warn_of_origin(const Value& value, Type target, const SourceRange& range);
    // lvalues.cpp
    std::optional<Lvalue> lvalue(syntax::ExprId id);
    bool is_read(syntax::ExprId id) const;
    std::optional<Lvalue> name_lvalue(syntax::ExprId id);
    std::optional<Lvalue> member_lvalue(syntax::ExprId id);
    std::optional<Lvalue> element_lvalue(syntax::ExprId id);
    std::optional<Lvalue> character_lvalue(const Lvalue& whole, const syntax::Expr& expr);
    /// An lvalue, or the temporary that an expression leaves.
    std::optional<Lvalue> owner_lvalue(syntax::ExprId id);
    /// The member `expr.text` of a struct that stands somewhere.
    std::optional<Lvalue> part_lvalue(const Lvalue& whole, syntax::ExprId id);
    void note_assignment(const Lvalue& lvalue);
    Value load(const Lvalue& lvalue, const SourceRange& range, bool checked, Reg hint);
    void store(const Lvalue& lvalue, const Value& value, const SourceRange& range);
    Reg reference_to(const Lvalue& lvalue);
    Done require_assignable(const Lvalue& lvalue, const SourceRange& range);

    // calls.cpp
    Value call(syntax::ExprId id, Reg hint);
    Value call_function(std::uint32_t function, const syntax::Expr& expr);
    void note_arguments(const FunctionDecl& function, const syntax::Expr& expr);
    void pass_argument(const ParameterDecl& parameter, syntax::ExprId argument, Reg first);
    std::optional<Value> named_axis(const nc::FunctionInfo& info, const nc::Parameter& parameter,
                                    const Value& value, const SourceRange& range);
    Value call_vocabulary(const nc::FunctionInfo& info, const syntax::Expr& expr);
    Value call_method(syntax::ExprId id, const syntax::Expr& callee, Reg hint);
    Value array_method(const Lvalue& array, const syntax::Expr& callee, const syntax::Expr& expr);
    Value string_method(const Lvalue& string, const syntax::Expr& callee, const syntax::Expr& expr);
    Value table(const syntax::Expr& expr);
    Value image_call(const syntax::Expr& expr);
    bool is_picture(Type type, PictureSource& source) const;
    std::string folder_of_file() const;
    void add_columns(TableSchema& schema, Type type, const std::string& prefix, std::uint16_t slot);
    void add_default(TableColumn& column, const Member& member);
    std::optional<std::vector<syntax::ExprId>> bind_arguments(
        const syntax::Expr& expr, std::string_view name, std::span<const std::string_view> names,
        const SourceRange& declared, std::uint32_t required = 0);
    std::string parameter_list(const syntax::Expr& expr, std::span<const std::string_view> names,
                               std::uint32_t required) const;

    // builtins.cpp
    std::optional<Value> builtin(std::string_view name, const syntax::Expr& expr, Reg hint);
    Value math_call(Math function, const syntax::Expr& expr, std::string_view name, Reg hint);
    Value round_call(Rounding rounding, const syntax::Expr& expr, std::string_view name);
    Value extreme(Math function, const syntax::Expr& expr, std::string_view name);
    Value root_call(int degree, const syntax::Expr& expr, std::string_view name);
    Value power_call(const syntax::Expr& expr);
    Value trigonometric(OpCode op, const syntax::Expr& expr, std::string_view name, Reg hint);
    Value distance_call(const syntax::Expr& expr);
    Value mod_call(const syntax::Expr& expr);
    Value length_as(Type type, const syntax::Expr& expr, std::string_view name);
    Done require_argument_count(const syntax::Expr& expr, std::string_view name, std::size_t least,
                                std::size_t most);
    std::optional<Value> numeric_argument(syntax::ExprId argument, std::string_view name);
    Value math_value(Math function, const Value& a, Type type, const SourceRange& range, Reg hint);
    Value math_value(Math function, const Value& a, const Value& b, Type type,
                     const SourceRange& range, Reg hint);

    // contours.cpp
    void contour_body(const syntax::Decl& decl, Reg target);
    void contour_variable(syntax::DeclId id);
    std::optional<Value> contour_property(const Value& contour, const syntax::Expr& expr);
    std::optional<Value> contour_function(std::string_view name, const syntax::Expr& expr);
    Value contour_value(ContourFunction function, Type result, Reg arguments,
                        const SourceRange& range);
    bool takes_contour(const syntax::Expr& expr);
    Value follow_call(const syntax::Expr& expr, std::string_view name);

    // curves.cpp
    void curve_body(const FunctionDecl& function, const syntax::Decl& decl);
    /// The call of a curve that is the first argument of `follow`; nothing if it is none.
    std::optional<syntax::ExprId> curve_argument(const syntax::Expr& expr);
    Value follow_curve(const syntax::Expr& expr, std::string_view name, syntax::ExprId curve);
    bool is_contour(Type type) const { return type_info(type).is_contour; }

    // text.cpp
    Value string(syntax::ExprId id, Reg hint);
    Done read_format(const Value& value, std::string_view format, const SourceRange& range,
                     FormatPiece& piece);
    /// Lets the piece show the unit of its values behind them, with `between` before it.
    void set_factor(Quantity quantity, FormatPiece& piece) const;
    void add_unit(Type type, std::string_view between, FormatPiece& piece);
    void add_unit(Type type, std::string_view between, Units units, FormatPiece::Scale& scale);
    Value text_of(const Value& value, const SourceRange& range);
    /// Makes the value of an expression known at the prompt, given or not.
    void show(syntax::ExprId id);
    std::uint32_t shown_form(Type type, bool is_part);
    std::uint32_t text_constant(std::string_view text);
    std::uint32_t layout_constant(Type type);

    // statements.cpp
    /// How a statement ends: what stands behind it is reached, or not (`return`, `break`).
    enum class Completion : std::uint8_t { Normal, Abrupt };
    static Completion completion(bool is_normal) {
        return is_normal ? Completion::Normal : Completion::Abrupt;
    }
    Completion statement(syntax::StmtId id);
    Completion block(syntax::List statements, const SourceRange& range);
    void variable(syntax::DeclId id);
    bool is_optional_type(const syntax::Decl& decl) const {
        return decl.type.is_valid() && ast()[decl.type].is_optional;
    }
    void warn_of_empty_body(const syntax::Stmt& stmt);  // empty_body.cpp
    void warn_of_empty_range(const syntax::Expr& range);
    Completion if_statement(const syntax::Stmt& stmt);
    Completion switch_statement(const syntax::Stmt& stmt);
    bool is_own_local(syntax::ExprId id) const;
    void return_statement(const syntax::Stmt& stmt);
    void leave_function(const SourceRange& range);
    void check_statement(const syntax::Stmt& stmt, bool is_require);
    void text_statement(const syntax::Stmt& stmt, OpCode op, unsigned kind);
    void expression_statement(const syntax::Stmt& stmt);
    std::uint32_t statement_id(const SourceRange& range);

    // loops.cpp
    Completion while_statement(const syntax::Stmt& stmt);
    Completion do_statement(const syntax::Stmt& stmt);
    Completion for_statement(const syntax::Stmt& stmt);
    bool counting_loop(const syntax::Stmt& stmt, Label& top, int depth);
    Completion for_each(const syntax::Stmt& stmt);
    Value characters(const Value& string, bool is_reference, const syntax::Decl& decl,
                     const SourceRange& range);
    void for_range(const syntax::Stmt& stmt);
    void jump_if_quietly(syntax::ExprId condition, Label& top, int depth);
    void check_named_global(syntax::ExprId id);
    bool is_plain_constant(syntax::ExprId id) const;
    void jump_out(bool is_break, const SourceRange& range);

    // blocks.cpp
    void words_statement(const syntax::Stmt& stmt);
    Value target_value(syntax::ExprId point, std::span<const syntax::Word> words);
    /// What stands behind the words of a block: a point to which it goes, and how the tool stands.
    struct Behind {
        syntax::ExprId point;
        syntax::ExprId orient;
    };
    Behind behind_words(const syntax::Stmt& stmt);
    void emit_words(std::span<const syntax::Word> words, const Behind& behind,
                    const SourceRange& range, std::int8_t skip_level = -1,
                    std::uint32_t customs = 0);
    void check_passed_text(const Plan& plan, std::span<const syntax::Word> words);
    std::optional<nc::BlockPlan> plan_words(std::span<const syntax::Word> words);
    void check_units_function(nc::Function function, const SourceRange& range);
    /// Numbers without a point where the control of the input dialect counts increments.
    Done check_points(const nc::BlockPlan& plan, std::span<const syntax::Word> words);
    /// What the control of the input dialect does otherwise than the language (`custom`).
    std::uint32_t customs_of(const Plan& plan, std::span<const syntax::Word> words) const;
    bool has_point(const syntax::Word& word) const;
    Done check_cycle_words(const nc::BlockPlan& plan, std::span<const syntax::Word> words);
    void check_units_words(const nc::BlockPlan& plan, std::span<const syntax::Word> words);
    void check_counts(const nc::BlockPlan& plan, std::span<const syntax::Word> words);
    Filling fill_word(const syntax::Word& word, const nc::Hole& hole, Reg reg);
    Filling fill_literal(const syntax::Word& word, const nc::Hole& hole, Reg reg);
    Filling fill_computed(const Value& source, const syntax::Word& word, const nc::Hole& hole,
                          bool has_unit, Reg reg);
    Done require_no_diameter(const Value& value, const SourceRange& range, std::string_view what);
    Filling fill_feed(const Value& value, const syntax::Word& word, Reg reg);
    Filling fill_speed(const Value& value, const syntax::Word& word, Reg reg);
    Filling fill_value(const Value& value, nc::Dimension dimension, const SourceRange& range,
                       std::string_view what, Reg reg);
    std::uint32_t plan_constant(Plan plan);
    void emit_plan(Plan plan, Reg first, unsigned point, const SourceRange& range);
    Completion with_statement(const syntax::Stmt& stmt);
    ModalMask modal_mask(const nc::BlockPlan& plan, bool& is_modal) const;
    ModalMask words_mask(std::span<const syntax::Word> words, bool is_preserves);
    ModalMask named_state(const syntax::Word& word) const;
    ModalMask with_mask(const syntax::Stmt& stmt);
    Done require_least(const nc::FunctionInfo& info, std::span<const syntax::ExprId> bound,
                       const syntax::Expr& expr);
    void frame_call(syntax::ExprId id);
    std::string word_text(const syntax::Word& word) const;

    // orienting.cpp
    bool is_orient(syntax::ExprId id) const;
    Done take_direction(const syntax::Expr& expr, Reg first);
    Done take_parts(std::span<const syntax::ExprId> bound, Reg first);
    Done take_angles(std::span<const syntax::ExprId> bound, const SourceRange& range, Reg first);
    Done add_direction(Plan& plan, const SourceRange& range);
    Value orient_call(const syntax::Expr& expr);
    Value tcp_call(const syntax::Expr& expr);

    // cycle_blocks.cpp
    void load_cycles(std::uint32_t module);
    const Name* cycle_function(nc::CycleId cycle) const;
    const syntax::Word* repeats_of(std::span<const syntax::Word> words) const;
    void repeat_places(const syntax::Stmt& stmt, const syntax::Word& times);
    bool is_modal_call(std::span<const syntax::Word> words) const;
    void modal_call(const syntax::Stmt& stmt);
    Value cycle_call(const syntax::Expr& expr, SourceCycle::Kind kind);
    std::vector<nc::SourceArgument> source_arguments(std::span<const syntax::ExprId> items,
                                                     std::vector<Value>& values);
    void fill_cycle(const nc::BlockPlan& plan, std::span<const Value> values,
                    std::span<const syntax::ExprId> items, Reg first, SourceCycle& cycle);
    /// Takes the cycle out of a block; its fillings become those of the cycle.
    std::optional<SourceCycle> take_cycle(Plan& plan, const nc::BlockPlan& planned,
                                          std::span<const syntax::Word> words);
    Done begin_cycle(SourceCycle& cycle, nc::CycleId id, const SourceRange& range);
    void emit_cycle(SourceCycle cycle, Reg first, const SourceRange& range);
    void emit_run_cycle(const SourceRange& range);

    // tests.cpp
    void declare_test(std::uint32_t module, syntax::DeclId id);
    void property_ranges(std::uint32_t function);
    Done read_range_end(syntax::ExprId id, const ParameterDecl& parameter, Slot& end);
    bool is_in_test() const;
    void report_test_block(const SourceRange& range);
    std::optional<Value> test_builtin(std::string_view name, const syntax::Expr& expr);
    Value test_call(TestCall::Purpose purpose, std::string_view name, const syntax::Expr& expr);
    std::optional<std::uint32_t> test_subject(std::string_view name, syntax::ExprId id);
    /// A figure of an execution; `call` is null where it is not called.
    Value figure(const Lvalue& execution, const syntax::Expr& member, const syntax::Expr* call);
    Done take_figure_arguments(const FigureInfo& info, const syntax::Expr& call, Reg first);
    void expect_statement(const syntax::Stmt& stmt);
    void assume_statement(const syntax::Stmt& stmt);
    void expectation(syntax::ExprId id);
    void expect_comparison(const syntax::Expr& expr);
    void jump_if_near(Reg a, Reg b, Label& near);
    bool is_measured(Type type) const;
    Done emit_agreement(const syntax::Expr& expr, const Value& left, const Value& right,
                        Label& good);
    Reg shown(const Value& value);
    void append_shown(const Value& value, FormatPattern& pattern);

    // preserves.cpp
    /// The members of modal groups that the declaration promises to preserve, and so needs.
    std::vector<nc::Function> preserved_members(const syntax::Decl& decl);
    void check_preserves(const FunctionDecl& function, const syntax::Decl& decl);
    friend class PreservesCheck;

    const syntax::Ast& ast() const { return *modules_[module_].ast; }
    std::string_view text(syntax::TextId id) const { return ast().text(id); }
    Units units() const { return units_; }
    DiagnosticBuilder report(const DiagnosticRow& row, const SourceRange& range) {
        return sink_.report(row, range);
    }
    std::string type_name(Type type) const { return types_.name(type); }
    const TypeInfo& type_info(Type type) const { return types_[type]; }
    TypeKind kind(Type type) const { return types_[type].kind; }
    bool is_error(const Value& value) const { return kind(value.type) == TypeKind::Error; }

    /// Counts errors on their way to the caller's sink.
    class CountingSink final : public DiagnosticSink {
      public:
        explicit CountingSink(DiagnosticSink& next) : next_(next) {}
        void take(Diagnostic diagnostic) override {
            if (is_quiet) return;
            if (diagnostic.severity != Severity::Warning) ++errors;
            next_.take(std::move(diagnostic));
        }
        std::size_t errors = 0;
        bool is_quiet = false;

      private:
        DiagnosticSink& next_;
    };

    /// While it lives, what is checked is only tried: nothing is reported or recorded.
    class Trial {
      public:
        explicit Trial(Checker& checker)
            : sink_(checker.sink_),
              was_quiet_(std::exchange(sink_.is_quiet, true)),
              trial_(checker.record_) {}
        Trial(const Trial&) = delete;
        Trial& operator=(const Trial&) = delete;
        ~Trial() { sink_.is_quiet = was_quiet_; }

      private:
        CountingSink& sink_;
        bool was_quiet_;
        Recorder::Trial trial_;
    };

    /// While it lives, mistakes count, whoever tries something around it.
    class Finding {
      public:
        explicit Finding(Checker& checker)
            : sink_(checker.sink_),
              was_quiet_(std::exchange(sink_.is_quiet, checker.is_late_)),
              finding_(checker.record_) {}
        Finding(const Finding&) = delete;
        Finding& operator=(const Finding&) = delete;
        ~Finding() { sink_.is_quiet = was_quiet_; }

      private:
        CountingSink& sink_;
        bool was_quiet_;
        Recorder::Finding finding_;
    };

    ModuleLoader& loader_;
    const Sources& sources_;
    CountingSink sink_;
    CheckOptions options_;
    std::unique_ptr<Code> code_;
    Emitter emit_;
    Checked checked_;
    TypeTable& types_ = checked_.types;
    Recorder record_{checked_};
    std::vector<ModuleScope> modules_;
    std::vector<FunctionDecl> functions_;
    std::vector<GlobalVariable> globals_;
    std::vector<std::uint32_t> wanted_;  // functions whose bodies are to be checked
    std::uint32_t prelude_ = 0xffffffffu;
    std::map<nc::CycleId, std::uint32_t> cycle_modules_;  // of the cycles that are blocks somewhere

    // Where the checker is.
    std::uint32_t module_ = 0;
    Units units_ = Units::Metric;
    std::vector<Symbol> symbols_;         // visible local names, innermost last
    std::vector<std::uint32_t> varying_;  // of the symbols: may be without a value
    std::unordered_map<std::string_view, std::vector<std::int32_t>>
        visible_;                  // by name, innermost last
    std::size_t scope_begin_ = 0;  // first symbol of the innermost scope
    std::uint32_t scope_end_ = 0;  // of the innermost scope, a byte of its file
    std::vector<LoopScope> loops_;
    std::size_t with_depth_ = 0;
    int loop_depth_ = 0;
    syntax::StmtId block_;   // the statement whose blocks are being planned
    SourceRange target_;     // the point behind words that is being looked at
    int contour_depth_ = 0;  // bodies of contours around
    const FunctionDecl* function_ = nullptr;
    bool has_preserves_ = false;
    static constexpr std::size_t kNoDefault = ~std::size_t{0};
    std::size_t defaults_from_ = kNoDefault;  // the parameter whose default is being checked
    struct Unused {
        SourceRange range;
        std::string_view name;
    };
    std::vector<Unused> unused_;  // local variables
    bool is_startup_ = false;
    std::optional<nc::CycleId> current_native_;
    std::uint32_t proposals_ = 0;
    std::uint32_t looked_ = 0;  // at the clock, statements ago
    bool is_late_ = false;
    Reg for_limit_ = kNoReg;     // register of the constant that ends a `for`
    std::string_view declared_;  // name of the variable whose value is being calculated
    bool last_unset_ = false;
    bool native_pending_ = false;  // the body's checks are still being emitted
    SourceRange ambiguous_;        // name that was reported last
    SourceRange unit_;             // apart from its number, reported last
    std::vector<Type> open_structs_;
    std::uint32_t statement_ = 0;      // SourceId of the statement
    std::uint32_t asked_figures_ = 0;  // of those that are functions

    std::unordered_map<std::uint64_t, Type> known_types_;  // of expressions, by file and index
    std::unordered_map<std::string, std::uint32_t> text_index_;
    std::unordered_map<std::string, std::uint32_t> plan_index_;
    std::unordered_map<std::uint32_t, std::uint32_t> layout_index_;  // by type
    std::unordered_map<std::uint32_t, std::uint32_t> shown_index_;   // by type, parts apart
};

/// In backticks, as code stands in messages.
std::string quoted(std::string_view text);
/// An operator as it is written, without the `=` of a compound assignment.
std::string_view spelling(syntax::Operator op);

}  // namespace kadr::sema
