// types.h — types of the language: how they are told apart, how many registers they take.
//
// A Type is an index into a TypeTable that holds each type once, so equality is a comparison of
// two numbers. Structs lie flat in consecutive registers; texts and arrays are handles.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/source.h"
#include "sema/code.h"
#include "sema/quantity.h"

namespace kadr::sema {

struct Type {
    std::uint32_t index = 0;
    friend bool operator==(Type, Type) = default;
};

/// A declared name, index into Checked::symbols.
struct SymbolId {
    std::uint32_t index = 0xffffffffu;
    bool is_valid() const { return index != 0xffffffffu; }
    friend bool operator==(SymbolId, SymbolId) = default;
};

enum class TypeKind : std::uint8_t {
    Error,  // a mistake was reported; fits everything, so that one mistake is one message
    Void,
    Bool,
    Int,
    Real,   // with a quantity; the plain number too
    Feed,   // per time or per revolution: which one is known while the program runs
    Speed,  // of the spindle or of cutting, likewise
    String,
    Enum,
    Struct,     // points and vectors are built-in structs
    Array,      // growing or fixed
    Range,      // `1..6`, only in `for`
    Execution,  // what a test executed: a number that the test bench gave
};

struct TypeInfo {
    TypeKind kind = TypeKind::Error;
    Quantity quantity;             // of Real
    bool is_diameter = false;      // a length that goes across: X of it is a diameter everywhere
    bool is_optional = false;      // may be not given
    Type element;                  // of Array
    std::int64_t count = -1;       // of a fixed Array; -1 growing
    bool is_contour = false;       // an Array of elements that only contours can make
    std::uint32_t definition = 0;  // of Struct and Enum: index in TypeTable::structs, enums
    std::uint16_t slots = 1;       // registers that a value takes

    friend bool operator==(const TypeInfo&, const TypeInfo&) = default;
};

struct Member {
    std::string name;
    Type type;
    std::uint16_t offset = 0;
    std::uint32_t module = 0;   // of the default value
    syntax::ExprId initial;     // default value, may be invalid
    bool may_be_unset = false;  // a struct with `?`
    SymbolId symbol;            // not valid: of a built-in struct
};

/// How deep structs may hold structs. Deeper than any real data, and far from where a walk through
/// the members of members would use up the stack.
inline constexpr std::uint32_t kMostLevels = 100;

struct StructInfo {
    std::string name;
    std::vector<Member> members;
    std::uint16_t slots = 0;
    SourceRange range;
    std::uint32_t levels = 1;  // of structs inside of each other, itself among them
    bool holds_array = false;  // it, or a struct that it holds
    SymbolId symbol;           // not valid: built in
};

struct EnumInfo {
    std::string name;
    std::vector<std::pair<std::string, std::int64_t>> members;
    SourceRange range;
    SymbolId symbol;
    std::vector<SymbolId> symbols;  // of the members
};

namespace types {
// The order in which TypeTable makes them.
inline constexpr Type kError{0};
inline constexpr Type kVoid{1};
inline constexpr Type kBool{2};
inline constexpr Type kInt{3};
inline constexpr Type kReal{4};
inline constexpr Type kLengthType{5};
inline constexpr Type kAngleType{6};
inline constexpr Type kTimeType{7};
inline constexpr Type kFeed{8};
inline constexpr Type kSpeed{9};
inline constexpr Type kString{10};
inline constexpr Type kOptionalLength{11};
inline constexpr Type kOptionalReal{12};
inline constexpr Type kPoint{13};
inline constexpr Type kVector{14};
inline constexpr Type kRange{15};
inline constexpr Type kExecution{16};
inline constexpr Type kElement{17};  // of a contour; its registers: ElementSlot in code.h
inline constexpr Type kContour{18};
inline constexpr Type kDiameter{19};
}  // namespace types

/// The form of a feed or speed (0 or 1) that measures this; nothing if none does.
std::optional<int> form_of(Quantity quantity, TypeKind family);

class TypeTable {
  public:
    TypeTable();

    const TypeInfo& operator[](Type type) const { return types_[type.index]; }
    Type real(Quantity quantity);
    Type optional(Type type);
    /// The type without `?`.
    Type given(Type type);
    Type array(Type element, std::int64_t count);
    Type add_struct(StructInfo info);
    Type add_enum(EnumInfo info);
    /// What a struct can be too large for.
    enum class Completed : std::uint8_t { Good, TooManyRegisters, TooManyLevels };
    /// Fixes the members of a struct that was added empty. Members of one that is too large become
    /// errors, so that the mistake is reported once and not for everything that holds the struct.
    Completed complete_struct(Type type, std::vector<Member> members);

    const StructInfo& struct_of(Type type) const { return structs_[(*this)[type].definition]; }
    const EnumInfo& enum_of(Type type) const { return enums_[(*this)[type].definition]; }
    /// The names of a struct or enum, and of an enum's members, once they are declared.
    void set_symbol(Type type, SymbolId symbol);
    void set_member_symbols(Type enumeration, std::vector<SymbolId> symbols);
    void set_enum_values(Type type, const std::vector<std::int64_t>& values);
    std::size_t enum_count() const { return enums_.size(); }
    const EnumInfo& enum_at(std::size_t index) const { return enums_[index]; }
    /// A feed or speed times something else: `f*length`, on its way to another feed.
    Type family(TypeKind kind, Quantity extra);

    /// As a person writes it: `length`, `hole[]`, `length?`.
    std::string name(Type type) const;
    /// What each register of a value holds.
    std::vector<SlotKind> layout(Type type) const;
    bool holds_array(Type type) const;
    /// Whether a value can be left out in part: an optional, a point.
    bool is_numeric(Type type) const;

  private:
    struct Hash {
        std::size_t operator()(const TypeInfo& info) const;
    };
    Type intern(const TypeInfo& info);

    std::vector<TypeInfo> types_;
    std::unordered_map<TypeInfo, std::uint32_t, Hash> interned_;  // of equal ones the first
    std::vector<StructInfo> structs_;
    std::vector<EnumInfo> enums_;
};

}  // namespace kadr::sema
