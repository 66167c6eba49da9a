// random_program.h — random programs as small trees: what they do, and how each language says it.
//
// A tree has what FANUC's Custom Macro B, SINUMERIK's language and Kadr have in common: assignments
// to numbered variables, expressions, branches, loops, jumps forward, moves with computed words.
// `settle` takes out what the languages round or compare differently, or what goes out of bounds,
// so that one evaluation in C++ says what all of them must do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kadr::control_testing {

struct Expression {
    enum class Kind : std::uint8_t {
        Number,
        Variable,
        Add,
        Subtract,
        Multiply,
        Divide,
        Remainder,  // of whole numbers: FANUC rounds both sides
        Negate,
        Sine,
        Cosine,
        Tangent,
        Arctangent,  // of two; the first is above 0: FANUC counts from 0 to 360 degrees
        Root,        // of the amount of its operand
        Amount,
        Round,
        Cut,
    };
    Kind kind = Kind::Number;
    double number = 0;
    std::size_t variable = 0;
    std::vector<Expression> operands = {};
};

struct Condition {
    enum class Kind : std::uint8_t { Compare, And, Or, Not };
    enum class Comparison : std::uint8_t {
        Equal,
        NotEqual,
        Less,
        LessEqual,
        Greater,
        GreaterEqual
    };
    Kind kind = Kind::Compare;
    Comparison comparison = Comparison::Less;
    std::vector<Expression> sides = {};  // of a comparison
    std::vector<Condition> parts = {};
};

struct Statement {
    enum class Kind : std::uint8_t {
        Assign,     // variable = values[0]
        If,         // condition: body, else: otherwise
        SkipIf,     // condition: a jump forward behind the body
        LeaveIf,    // condition: a jump out of the loop
        While,      // a loop whose variable counts from `first` to `last`
        For,        // the same, in the words that count
        Repeat,     // the same, asked at its end
        Rapid,      // to values on the axes of `axes`
        Line,       // the same; the feed behind them if `has_feed`
        Quarter,    // to values[0], values[1], then an arc about a point values[2] along X
        Full,       // the same, a whole circle
        BowRadius,  // the same, a sixth of a circle by its radius
    };
    Kind kind = Kind::Assign;
    std::size_t variable = 0;
    int first = 0;
    int last = 0;
    unsigned axes = 0;
    bool has_feed = false;
    bool is_clockwise = false;
    Condition condition = {};
    std::vector<Expression> values = {};
    std::vector<Statement> body = {};
    std::vector<Statement> otherwise = {};
};

using RandomProgram = std::vector<Statement>;

/// A motion as it is meant, in mm.
struct Step {
    enum class Kind : std::uint8_t { Rapid, Line, Arc };
    Kind kind = Kind::Rapid;
    double to[3] = {};
    double center[2] = {};  // of an arc
    double sweep = 0;       // rad
    bool is_clockwise = false;
    double feed = 0;  // mm/min, of all but a rapid
};

inline constexpr std::size_t kVariables = 13;  // numbered from 1

struct Outcome {
    std::vector<Step> steps;
    double variables[kVariables] = {};
};

enum class Language : std::uint8_t { Fanuc, Sinumerik, Kadr };

/// Drawn with RapidCheck, settled already.
RandomProgram any_program();
Outcome outcome_of(const RandomProgram& program);
std::string text_of(const RandomProgram& program, Language language);

}  // namespace kadr::control_testing
