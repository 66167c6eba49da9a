// names.h — who is called what: files, their top-level names, functions, local variables.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "nc/dialect.h"
#include "sema/checked.h"
#include "sema/code.h"
#include "sema/types.h"
#include "syntax/ast.h"

namespace kadr::sema {

using Reg = std::uint16_t;
inline constexpr Reg kNoReg = 0xffff;

/// Where a number comes from, if that makes it a slip somewhere (origins.cpp).
enum class Origin : std::uint8_t {
    Any,
    Radians,    // made from pi, or a number that is a part of it
    PerRadian,  // what turns radians into degrees: 180/pi
    Ratio,      // of two values of one dimension
};

/// What an expression came to: a constant, or the registers that hold it.
struct Value {
    enum class Form : std::uint8_t { None, Constant, InRegister };
    Form form = Form::None;
    Type type;
    Slot constant{};  // of a String: index into Code::texts
    Reg reg = 0;
    bool is_variable = false;  // the registers belong to a variable: copy before changing
    bool is_fresh = false;     // an array that nobody else holds
    Origin origin = Origin::Any;

    bool is_constant() const { return form == Form::Constant; }
};

struct Symbol {
    static constexpr std::uint32_t kNotNamed = 0xffffffffu;

    enum class Storage : std::uint8_t { Local, Global, Reference, Constant };
    std::string_view name;
    Type type;
    Storage storage = Storage::Local;
    Reg reg = 0;  // of Local; of Reference: the register that refers
    std::uint32_t global = 0;
    Value constant;
    bool is_const = false;
    bool is_optional = false;     // its type is
    bool may_be_unset = false;    // declared without a value: reads are checked
    std::string_view unset_name;  // what is not given then, if it is not the variable itself
    Givenness givenness = Givenness::Given;
    bool is_parameter = false;
    bool is_read = false;
    bool is_row = false;          // of `for (… : list)`, or as a table gave it
    bool is_assigned = false;     // after its declaration
    Origin origin = Origin::Any;  // of the value that it was given last in the text
    SourceRange range;
    syntax::DeclId decl;  // not valid: a coordinate of a curve
    SymbolId checked;
    std::uint32_t named = kNotNamed;  // entry of CodeNames::variables
};

struct ParameterDecl {
    std::string_view name;
    Type type;
    bool is_reference = false;
    bool is_required = true;    // no default and not optional
    bool may_be_unset = false;  // an optional struct
    syntax::ExprId initial;
    Reg reg = 0;
    std::uint16_t slots = 1;
    SourceRange range;
    syntax::DeclId decl;
    SymbolId checked;
};

struct FunctionDecl {
    std::uint32_t module = 0;
    syntax::DeclId decl;
    std::string_view name;
    syntax::DeclKind kind = syntax::DeclKind::Function;
    bool is_limits = false;  // of a Curve: gives the range of its parameter, not a point
    Type result;
    std::vector<ParameterDecl> parameters;
    std::uint16_t parameter_slots = 0;
    bool is_wanted = false;  // its body is or will be checked
    SourceRange range;
    SymbolId checked;
};

/// A top-level name of a file.
struct Name {
    enum class What : std::uint8_t { Function, Variable, Type, EnumMember, Curve };
    What what = What::Function;
    std::uint32_t module = 0;
    // Function: functions; Variable: globals; Curve: functions, of its points; its limits are next
    std::uint32_t index = 0;
    Type type;  // Type, EnumMember
    std::int64_t member = 0;
    SourceRange range;
    SymbolId checked;
};

struct GlobalVariable {
    enum class State : std::uint8_t { Unchecked, Checking, Done };
    State state = State::Unchecked;
    std::uint32_t module = 0;
    syntax::DeclId decl;
    Symbol symbol;
};

struct ModuleScope {
    const syntax::Ast* ast = nullptr;
    const nc::Dialect* dialect = nullptr;
    Units units = Units::Metric;
    std::unordered_map<std::string_view, Name> names;
    std::vector<std::uint32_t> imports;  // direct ones, the prelude last
};

}  // namespace kadr::sema
