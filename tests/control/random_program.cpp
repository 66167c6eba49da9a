#include "tests/control/random_program.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <rapidcheck.h>

#include "base/numbers.h"

namespace kadr::control_testing {
namespace {

using Kind = Expression::Kind;

constexpr std::size_t kFree = 6;          // variables 1 to 6 are assigned to at will
constexpr std::size_t kFirstCounter = 7;  // 7 to 9 count the loops, by their depth
constexpr std::size_t kArc = 10;          // 10 to 12: start and radius of an arc
constexpr int kMostLevels = 3;

/// From the whole range in every case: small programs come by themselves.
int whole(int low, int high) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}
bool maybe() { return whole(0, 1) == 1; }

Expression number(double value) { return {.number = value}; }
Expression variable(std::size_t index) { return {.kind = Kind::Variable, .variable = index}; }
Expression of(Kind kind, std::vector<Expression> operands) {
    return {.kind = kind, .operands = std::move(operands)};
}

// ---------------------------------------------------------------- drawing

Expression any_leaf() {
    const int choice = whole(0, 3);
    if (choice == 0) return number(whole(0, 12));
    if (choice == 1) return number(whole(1, 4000) / 100.0);
    return variable(static_cast<std::size_t>(whole(1, kFirstCounter)));
}

/// What may stand behind a division sign without being 0 wherever it is looked at.
Expression any_divisor(int levels);

Expression any_expression(int levels) {
    if (levels == 0) return any_leaf();
    const auto below = [&] { return any_expression(levels - 1); };
    const auto whole_below = [&] { return of(maybe() ? Kind::Round : Kind::Cut, {below()}); };
    switch (whole(0, 15)) {
        case 0: return any_leaf();
        case 1:
        case 2: return of(Kind::Add, {below(), below()});
        case 3:
        case 4: return of(Kind::Subtract, {below(), below()});
        case 5:
        case 6: return of(Kind::Multiply, {below(), below()});
        case 7: return of(Kind::Divide, {below(), any_divisor(levels - 1)});
        case 8: return of(Kind::Remainder, {whole_below(), number(whole(1, 9))});
        case 9: return of(Kind::Negate, {below()});
        case 10: return of(maybe() ? Kind::Sine : Kind::Cosine, {below()});
        // Kadr works a constant out where nobody goes, too, and a right angle has no tangent.
        case 11: return of(Kind::Tangent, {of(Kind::Add, {below(), variable(1)})});
        case 12:
            return of(Kind::Arctangent,
                      {of(Kind::Add, {of(Kind::Amount, {any_leaf()}), number(1)}), below()});
        case 13: return of(Kind::Root, {of(Kind::Amount, {below()})});
        case 14: return of(Kind::Amount, {below()});
        default: return whole_below();
    }
}

Expression any_divisor(int levels) {
    const int choice = whole(0, 2);
    if (choice == 0) return number(whole(1, 500) / 10.0);
    if (choice == 1) return variable(static_cast<std::size_t>(whole(1, kFree)));
    return of(Kind::Add, {of(Kind::Amount, {any_expression(levels)}), number(whole(1, 9))});
}

/// Stays within bounds however often it is assigned: a loop must not run away.
Expression any_bounded() {
    if (maybe())
        return of(Kind::Remainder, {of(Kind::Round, {any_expression(2)}), number(whole(2, 99))});
    return of(Kind::Multiply, {number(whole(1, 30)), of(Kind::Sine, {any_expression(2)})});
}

Condition any_comparison() {
    return {.comparison = static_cast<Condition::Comparison>(whole(0, 5)),
            .sides = {any_expression(2), any_expression(1)}};
}

Condition any_condition() {
    const int choice = whole(0, 5);
    if (choice > 2) return any_comparison();
    Condition all{.kind = static_cast<Condition::Kind>(choice + 1)};
    all.parts.push_back(any_comparison());
    if (all.kind != Condition::Kind::Not) all.parts.push_back(any_comparison());
    return all;
}

void without_rounding(Expression& e) {
    if (e.kind == Kind::Round) e.kind = Kind::Cut;
    for (Expression& operand : e.operands) without_rounding(operand);
}

/// In a word FANUC's ROUND rounds to the increment of the address.
Expression any_of_word(int levels) {
    Expression e = any_expression(levels);
    without_rounding(e);
    return e;
}

Statement any_move() {
    Statement move{.kind = maybe() ? Statement::Kind::Line : Statement::Kind::Rapid};
    move.axes = static_cast<unsigned>(whole(1, 7));
    for (unsigned axis = 0; axis < 3; ++axis) {
        if ((move.axes >> axis & 1u) != 0) move.values.push_back(any_of_word(2));
    }
    if (move.kind == Statement::Kind::Rapid || whole(0, 2) != 0) return move;
    move.has_feed = true;
    move.values.push_back(maybe() ? number(whole(1, 4000))
                                  : of(Kind::Add, {number(500), any_of_word(1)}));
    return move;
}

Statement any_arc() {
    Statement arc{.kind = static_cast<Statement::Kind>(static_cast<int>(Statement::Kind::Quarter) +
                                                       whole(0, 2))};
    arc.is_clockwise = maybe();
    for (int i = 0; i < 3; ++i) arc.values.push_back(any_expression(1));
    return arc;
}

std::vector<Statement> any_statements(int levels, int loops, int most);

Statement any_loop(int levels, int loops) {
    Statement loop{.kind = static_cast<Statement::Kind>(static_cast<int>(Statement::Kind::While) +
                                                        whole(0, 2))};
    loop.variable = kFirstCounter + static_cast<std::size_t>(loops);
    loop.first = whole(-1, 3);
    loop.last = loop.first + whole(-1, 3);
    loop.body = any_statements(levels - 1, loops + 1, 3);
    return loop;
}

Statement any_statement(int levels, int loops) {
    const int choice = whole(0, levels > 0 ? 11 : 7);
    if (choice < 3) {
        return {.kind = Statement::Kind::Assign,
                .variable = static_cast<std::size_t>(whole(1, kFree)),
                .values = {loops > 0 ? any_bounded() : any_expression(3)}};
    }
    if (choice < 6) return any_move();
    if (choice == 6) return any_arc();
    if (choice == 7) {
        if (loops == 0) return any_move();
        return {.kind = Statement::Kind::LeaveIf, .condition = any_condition()};
    }
    if (choice < 10 && loops < kMostLevels) return any_loop(levels, loops);
    Statement branch{.kind = maybe() ? Statement::Kind::If : Statement::Kind::SkipIf,
                     .condition = any_condition()};
    branch.body = any_statements(levels - 1, loops, 3);
    if (branch.kind == Statement::Kind::If && maybe())
        branch.otherwise = any_statements(levels - 1, loops, 2);
    return branch;
}

std::vector<Statement> any_statements(int levels, int loops, int most) {
    std::vector<Statement> statements;
    for (int i = whole(1, most); i > 0; --i) statements.push_back(any_statement(levels, loops));
    return statements;
}

// ---------------------------------------------------------------- evaluating

/// A value, and how far a language may be from it that calculates in another order or rounds in
/// between. 0: it is a whole number or a literal, and all have the very same.
struct Known {
    double value = 0;
    double error = 0;
};

constexpr double kRelative = 2e-12;  // SINUMERIK takes numbers for equal within 5·10^-13 of them
constexpr double kMostError = 1e-7;  // of what is assigned or moved to
constexpr double kMostValue = 1e5;
constexpr double kMostPosition = 5e3;  // mm
constexpr double kShortMove = 0.01;    // mm: shorter ones are left out of the comparison

bool is_whole(double value) { return std::abs(value) < 1e9 && value == std::floor(value); }

/// The result of + - * /: exact if everything is whole.
Known calculated(double value, double error, const Known& a, const Known& b) {
    const bool is_exact =
        a.error == 0 && b.error == 0 && is_whole(a.value) && is_whole(b.value) && is_whole(value);
    if (is_exact) return {value, 0};
    const double size = std::max({std::abs(value), std::abs(a.value), std::abs(b.value)});
    return {value, error + 1e-15 * size};
}

class Evaluation {
  public:
    explicit Evaluation(RandomProgram& program) : program_(program) {}

    /// Runs the program. The first expression that the languages need not agree on, or that goes
    /// out of bounds; null: there is none.
    Expression* run() {
        execute(program_);
        return fault_;
    }
    const Outcome& outcome() {
        for (std::size_t i = 1; i < kVariables; ++i) outcome_.variables[i] = variables_[i].value;
        return outcome_;
    }

  private:
    enum class Next : std::uint8_t { GoOn, Leave };

    Known of(Expression& e) {
        std::vector<Known> in;
        for (Expression& operand : e.operands) in.push_back(of(operand));
        if (fault_ != nullptr) return {};
        switch (e.kind) {
            case Kind::Number: return {e.number, 0};
            case Kind::Variable: return variables_[e.variable];
            case Kind::Add:
                return calculated(in[0].value + in[1].value, in[0].error + in[1].error, in[0],
                                  in[1]);
            case Kind::Subtract:
                return calculated(in[0].value - in[1].value, in[0].error + in[1].error, in[0],
                                  in[1]);
            case Kind::Multiply:
                return calculated(
                    in[0].value * in[1].value,
                    std::abs(in[0].value) * in[1].error + std::abs(in[1].value) * in[0].error,
                    in[0], in[1]);
            case Kind::Divide: return quotient(e, in[0], in[1]);
            case Kind::Remainder: return {std::fmod(in[0].value, in[1].value), 0};
            case Kind::Negate: return {-in[0].value, in[0].error};
            case Kind::Amount: return {std::abs(in[0].value), in[0].error};
            case Kind::Root: return root(e, in[0]);
            case Kind::Round:
            case Kind::Cut: return whole_number(e, in[0]);
            case Kind::Sine:
            case Kind::Cosine:
            case Kind::Tangent: return of_angle(e, in[0]);
            case Kind::Arctangent: {
                const double size = std::hypot(in[0].value, in[1].value);  // 1 at least
                return {std::atan2(in[0].value, in[1].value) * 180 / std::numbers::pi,
                        60 * (in[0].error + in[1].error) / size + 1e-12};
            }
        }
        return {};
    }

    Known quotient(Expression& e, const Known& a, const Known& b) {
        if (std::abs(b.value) < 1e-3 + b.error) return blame(e);
        const double value = a.value / b.value;
        return calculated(value, (a.error + std::abs(value) * b.error) / std::abs(b.value), a, b);
    }
    Known root(Expression& e, const Known& a) {
        if (a.error == 0 && a.value == 0) return {0, 0};
        if (a.value < 1e-3 + a.error) return blame(e);
        return {std::sqrt(a.value), a.error / std::sqrt(a.value) + 1e-12};
    }
    /// Where a whole number ends and the next begins the languages may be on either side.
    Known whole_number(Expression& e, const Known& a) {
        const double size = std::abs(a.value);
        const bool is_round = e.kind == Kind::Round;
        const double edge = is_round ? std::floor(size) + 0.5 : std::round(size);
        const bool is_at_edge = std::abs(size - edge) <= a.error + kRelative * size + 1e-9;
        const bool is_zero = !is_round && edge == 0;  // cut to 0 from both sides
        if (is_at_edge && !is_zero && a.error != 0) return blame(e);
        return {is_round ? std::round(a.value) : std::trunc(a.value), 0};
    }
    Known of_angle(Expression& e, const Known& a) {
        if (std::abs(a.value) > 1e4) return blame(e);
        const double angle = a.value * std::numbers::pi / 180;
        const double error = a.error / 57 + 1e-12;
        if (e.kind == Kind::Sine) return {std::sin(angle), error};
        if (e.kind == Kind::Cosine) return {std::cos(angle), error};
        if (std::abs(std::cos(angle)) < 0.02) return blame(e);  // a pole
        return {std::tan(angle), error / (std::cos(angle) * std::cos(angle))};
    }
    Known blame(Expression& e) {
        if (fault_ == nullptr) fault_ = &e;
        return {};
    }

    bool holds(Condition& condition) {
        using C = Condition::Comparison;
        switch (condition.kind) {
            case Condition::Kind::Not: return !holds(condition.parts[0]);
            case Condition::Kind::And: {
                const bool left = holds(condition.parts[0]);
                return holds(condition.parts[1]) && left;  // controls work out both
            }
            case Condition::Kind::Or: {
                const bool left = holds(condition.parts[0]);
                return holds(condition.parts[1]) || left;
            }
            case Condition::Kind::Compare: break;
        }
        const Known a = of(condition.sides[0]);
        const Known b = of(condition.sides[1]);
        const bool is_exact = a.error == 0 && b.error == 0;
        const double near = a.error + b.error + kRelative * (std::abs(a.value) + std::abs(b.value));
        if (std::abs(a.value - b.value) <= near && !(is_exact && a.value == b.value))
            blame(condition.sides[0]);
        switch (condition.comparison) {
            case C::Equal: return a.value == b.value;
            case C::NotEqual: return a.value != b.value;
            case C::Less: return a.value < b.value;
            case C::LessEqual: return a.value <= b.value;
            case C::Greater: return a.value > b.value;
            case C::GreaterEqual: return a.value >= b.value;
        }
        return false;
    }

    /// A value that is assigned or programmed, between two bounds.
    Known bounded(Expression& e, double least, double most) {
        const Known known = of(e);
        if (!(known.value >= least && known.value <= most) || known.error > kMostError) blame(e);
        return known;
    }

    Next execute(std::vector<Statement>& statements) {
        for (Statement& statement : statements) {
            if (fault_ != nullptr || execute(statement) == Next::Leave) return Next::Leave;
        }
        return Next::GoOn;
    }

    Next execute(Statement& statement) {
        using K = Statement::Kind;
        switch (statement.kind) {
            case K::Assign:
                variables_[statement.variable] =
                    bounded(statement.values[0], -kMostValue, kMostValue);
                break;
            case K::If:
                return execute(holds(statement.condition) ? statement.body : statement.otherwise);
            case K::SkipIf:
                if (!holds(statement.condition)) return execute(statement.body);
                break;
            case K::LeaveIf: return holds(statement.condition) ? Next::Leave : Next::GoOn;
            case K::While:
            case K::For:
            case K::Repeat: loop(statement); break;
            case K::Rapid:
            case K::Line: move(statement); break;
            case K::Quarter:
            case K::Full:
            case K::BowRadius: arc(statement); break;
        }
        return Next::GoOn;
    }

    void loop(Statement& statement) {
        Known& counter = variables_[statement.variable];
        counter = {static_cast<double>(statement.first), 0};
        bool is_asked = statement.kind != Statement::Kind::Repeat;
        while (fault_ == nullptr && (!is_asked || counter.value <= statement.last)) {
            if (execute(statement.body) == Next::Leave) return;
            ++counter.value;
            is_asked = true;
        }
    }

    void move(Statement& statement) {
        Step step{.kind = statement.kind == Statement::Kind::Rapid ? Step::Kind::Rapid
                                                                   : Step::Kind::Line};
        std::copy(std::begin(at_), std::end(at_), step.to);
        std::size_t next = 0;
        Expression* causes[3] = {};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if ((statement.axes >> axis & 1u) == 0) continue;
            causes[axis] = &statement.values[next++];
            step.to[axis] = bounded(*causes[axis], -kMostPosition, kMostPosition).value;
        }
        if (statement.has_feed) feed_ = bounded(statement.values[next], 1, 9000).value;
        add(step, causes);
    }

    void arc(Statement& statement) {
        const Known a = bounded(statement.values[0], -kMostPosition, kMostPosition);
        const Known b = bounded(statement.values[1], -kMostPosition, kMostPosition);
        const Known r = bounded(statement.values[2], 1, 400);
        if (fault_ != nullptr) return;
        variables_[kArc] = a;
        variables_[kArc + 1] = b;
        variables_[kArc + 2] = r;
        Expression* const causes[3] = {&statement.values[0], &statement.values[1]};
        add({.kind = Step::Kind::Line, .to = {a.value, b.value, at_[2]}}, causes);
        Step step{.kind = Step::Kind::Arc,
                  .to = {a.value, b.value, at_[2]},
                  .center = {a.value + r.value, b.value},
                  .sweep = 2 * std::numbers::pi,
                  .is_clockwise = statement.is_clockwise};
        const double side = statement.is_clockwise ? 1 : -1;
        if (statement.kind == Statement::Kind::Quarter) {
            step.to[0] += r.value;
            step.to[1] += side * r.value;
            step.sweep = std::numbers::pi / 2;
        } else if (statement.kind == Statement::Kind::BowRadius) {
            step.to[0] += r.value;
            step.center[0] = a.value + r.value / 2;
            step.center[1] = b.value - side * r.value * std::sqrt(0.75);
            step.sweep = std::numbers::pi / 3;
        }
        add(step, causes);
    }

    /// `causes`: what the programmed axes go to.
    void add(Step step, Expression* const (&causes)[3]) {
        if (fault_ != nullptr) return;
        double distance = 0;
        std::size_t longest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::abs(step.to[i] - at_[i]) <= distance) continue;
            distance = std::abs(step.to[i] - at_[i]);
            longest = i;
        }
        const bool is_turn = step.kind == Step::Kind::Arc;
        if (!is_turn && distance > 0.5 * kShortMove && distance < 1.5 * kShortMove)
            blame(*causes[longest]);
        if (step.kind != Step::Kind::Rapid) step.feed = feed_;
        std::copy(std::begin(step.to), std::end(step.to), at_);
        if (is_turn || distance > kShortMove) outcome_.steps.push_back(step);
    }

    RandomProgram& program_;
    Known variables_[kVariables];
    double at_[3] = {};
    double feed_ = 0;
    Outcome outcome_;
    Expression* fault_ = nullptr;
};

// ---------------------------------------------------------------- writing

bool is_binary(Kind kind) { return kind >= Kind::Add && kind <= Kind::Remainder; }

/// 0 binds strongest; the same in all three languages.
int level_of(Kind kind) {
    if (kind == Kind::Negate) return 1;
    if (kind == Kind::Multiply || kind == Kind::Divide || kind == Kind::Remainder) return 2;
    return is_binary(kind) ? 3 : 0;
}

struct Spelling {
    Language language;
    char open;
    char close;
    const char* variable;
    const char* functions[8];  // from the sine on
    const char* remainder;
    const char* comparisons[6];
};

const Spelling& spelling_of(Language language) {
    static const Spelling kSpellings[] = {
        {Language::Fanuc,
         '[',
         ']',
         "#",
         {"SIN", "COS", "TAN", "ATAN", "SQRT", "ABS", "ROUND", "FIX"},
         "MOD",
         {"EQ", "NE", "LT", "LE", "GT", "GE"}},
        {Language::Sinumerik,
         '(',
         ')',
         "R",
         {"SIN", "COS", "TAN", "ATAN2", "SQRT", "ABS", "ROUND", "TRUNC"},
         " MOD ",
         {"==", "<>", "<", "<=", ">", ">="}},
        {Language::Kadr,
         '(',
         ')',
         "value",
         {"sin", "cos", "tan", "atan2", "sqrt", "abs", "round", "trunc"},
         " % ",
         {" == ", " != ", " < ", " <= ", " > ", " >= "}},
    };
    return kSpellings[static_cast<std::size_t>(language)];
}

class ExpressionText {
  public:
    explicit ExpressionText(Language language) : spelling_(spelling_of(language)) {}

    std::string of(const Expression& e) const {
        if (e.kind == Kind::Number) return format_shortest(e.number);
        if (e.kind == Kind::Variable) return spelling_.variable + std::to_string(e.variable);
        if (e.kind == Kind::Negate) return '-' + operand(e.operands[0], 0);
        if (is_binary(e.kind)) {
            const int level = level_of(e.kind);
            return operand(e.operands[0], level) + sign_of(e.kind) +
                   operand(e.operands[1], is_sign_first(e.operands[1]) ? -1 : level - 1);
        }
        const std::string name =
            spelling_
                .functions[static_cast<std::size_t>(e.kind) - static_cast<std::size_t>(Kind::Sine)];
        if (e.kind == Kind::Arctangent) return arctangent(name, e);
        return name + bracketed(of(e.operands[0]));
    }

    std::string bracketed(const std::string& text) const {
        return spelling_.open + text + spelling_.close;
    }

    std::string of(const Condition& condition, bool is_negated = false) const {
        if (condition.kind == Condition::Kind::Compare)
            return of(condition.sides[0]) + comparison(condition.comparison, is_negated) +
                   of(condition.sides[1]);
        if (condition.kind == Condition::Kind::Not) return negation(condition.parts[0], is_negated);
        if (is_negated && spelling_.language != Language::Fanuc) return negation(condition, false);
        // FANUC has no NOT: a negated AND is an OR of what is negated.
        const bool is_and = (condition.kind == Condition::Kind::And) != is_negated;
        const char* const sign = spelling_.language == Language::Fanuc ? (is_and ? "AND" : "OR")
                                 : spelling_.language == Language::Kadr
                                     ? (is_and ? " && " : " || ")
                                     : (is_and ? " AND " : " OR ");
        return bracketed(of(condition.parts[0], is_negated)) + sign +
               bracketed(of(condition.parts[1], is_negated));
    }

  private:
    const char* comparison(Condition::Comparison comparison, bool is_negated) const {
        // Beside each its opposite.
        static constexpr std::size_t kOpposite[] = {1, 0, 5, 4, 3, 2};
        const auto index = static_cast<std::size_t>(comparison);
        return spelling_.comparisons[is_negated ? kOpposite[index] : index];
    }

    std::string negation(const Condition& condition, bool is_negated) const {
        if (is_negated || spelling_.language == Language::Fanuc) return of(condition, !is_negated);
        return (spelling_.language == Language::Kadr ? "!" : "NOT ") + bracketed(of(condition));
    }

    static bool is_sign_first(const Expression& e) {
        return e.kind == Kind::Negate || (e.kind == Kind::Number && e.number < 0) ||
               (is_binary(e.kind) && is_sign_first(e.operands[0]));
    }

    std::string operand(const Expression& e, int loosest) const {
        const std::string text = of(e);
        const bool is_negative = e.kind == Kind::Number && e.number < 0;
        return level_of(e.kind) > loosest || is_negative ? bracketed(text) : text;
    }

    std::string sign_of(Kind kind) const {
        if (kind == Kind::Remainder) return spelling_.remainder;
        const char* const kSigns[] = {"+", "-", "*", "/"};
        return kSigns[static_cast<std::size_t>(kind) - static_cast<std::size_t>(Kind::Add)];
    }

    std::string arctangent(const std::string& name, const Expression& e) const {
        const std::string a = of(e.operands[0]);
        const std::string b = of(e.operands[1]);
        switch (spelling_.language) {
            case Language::Fanuc: return name + bracketed(a) + '/' + bracketed(b);
            case Language::Sinumerik: return name + bracketed(a + ',' + b);
            case Language::Kadr: return bracketed(name + bracketed(a + ", " + b) + "/1deg");
        }
        return {};
    }

    const Spelling& spelling_;
};

class ProgramText {
  public:
    explicit ProgramText(Language language)
        : language_(language), spelling_(spelling_of(language)), expressions_(language) {}

    std::string of(const RandomProgram& program) {
        head();
        for (const Statement& statement : program) add(statement);
        if (language_ == Language::Fanuc) return out_ + "M30\n%\n";
        return out_ + (language_ == Language::Kadr ? "M30;\n}\n" : "M30\n");
    }

  private:
    bool is_kadr() const { return language_ == Language::Kadr; }
    bool is_fanuc() const { return language_ == Language::Fanuc; }

    void head() {
        if (is_fanuc()) out_ += "%\nO0001\n";
        if (is_kadr()) out_ += "program random() {\nunits mm;\n";
        for (std::size_t i = 1; i < kVariables; ++i) {
            if (is_kadr()) out_ += "real ";
            assign(i, "0");
        }
        line("G17 G90 G94 G40");
        line("S1000 M3");
    }

    void line(const std::string& text) { out_ += text + (is_kadr() ? ";\n" : "\n"); }

    std::string name(std::size_t variable) const {
        return spelling_.variable + std::to_string(variable);
    }
    void assign(std::size_t variable, const std::string& value) {
        say(name(variable) + (is_kadr() ? " = " : "=") + value);
    }
    /// A block; SINUMERIK executes one of some as a text that the program makes.
    void say(const std::string& text) {
        constexpr int kOfSome = 5;
        constexpr std::size_t kLongest = 150;  // characters of a text: 200, and more are an alarm
        const bool is_made = language_ == Language::Sinumerik && ++said_ % kOfSome == 0;
        if (!is_made || text.size() > kLongest) return line(text);
        const std::size_t half = text.size() / 2;
        line("EXECSTRING(\"" + text.substr(0, half) + "\"<<\"" + text.substr(half) + "\")");
    }

    std::string new_label() {
        return is_fanuc() ? std::to_string(++labels_) : "MARK" + std::to_string(++labels_);
    }
    void mark(const std::string& label) { out_ += is_fanuc() ? 'N' + label + '\n' : label + ":\n"; }
    void jump(const std::string& label) { line((is_fanuc() ? "GOTO" : "GOTOF ") + label); }
    void jump_if(const Condition& condition, bool is_negated, const std::string& label) {
        const std::string asked = expressions_.of(condition, is_negated);
        if (is_fanuc()) line("IF" + expressions_.bracketed(asked) + "GOTO" + label);
        else line("IF " + asked + " GOTOF " + label);
    }

    void add_all(const std::vector<Statement>& statements) {
        for (const Statement& statement : statements) add(statement);
    }

    void add(const Statement& statement) {
        using K = Statement::Kind;
        switch (statement.kind) {
            case K::Assign: assign(statement.variable, expressions_.of(statement.values[0])); break;
            case K::If: branch(statement); break;
            case K::SkipIf: skip(statement); break;
            case K::LeaveIf:
                if (is_kadr()) out_ += "if (" + expressions_.of(statement.condition) + ") break;\n";
                else jump_if(statement.condition, false, leave_.back());
                break;
            case K::While:
            case K::For:
            case K::Repeat: loop(statement); break;
            case K::Rapid:
            case K::Line: move(statement); break;
            case K::Quarter:
            case K::Full:
            case K::BowRadius: arc(statement); break;
        }
    }

    void branch(const Statement& statement) {
        const std::string asked = expressions_.of(statement.condition);
        const std::vector<Statement>& body = statement.body;
        if (is_kadr()) {
            out_ += "if (" + asked + ") {\n";
            add_all(body);
            out_ += "} else {\n";
            add_all(statement.otherwise);
            out_ += "}\n";
        } else if (!is_fanuc()) {
            line("IF " + asked);
            add_all(body);
            if (!statement.otherwise.empty()) line("ELSE");
            add_all(statement.otherwise);
            line("ENDIF");
        } else if (statement.otherwise.empty() && body.size() == 1 &&
                   body[0].kind == Statement::Kind::Assign) {
            out_ += "IF" + expressions_.bracketed(asked) + "THEN";
            add(body[0]);
        } else {
            const std::string otherwise = new_label();
            const std::string end = new_label();
            jump_if(statement.condition, true, otherwise);
            add_all(body);
            jump(end);
            mark(otherwise);
            add_all(statement.otherwise);
            mark(end);
        }
    }

    void skip(const Statement& statement) {
        if (is_kadr()) {
            out_ += "if (!(" + expressions_.of(statement.condition) + ")) {\n";
            add_all(statement.body);
            out_ += "}\n";
            return;
        }
        const std::string label = new_label();
        jump_if(statement.condition, false, label);
        add_all(statement.body);
        mark(label);
    }

    void loop(const Statement& statement) {
        leave_.push_back(new_label());
        if (is_kadr()) kadr_loop(statement);
        else if (is_fanuc()) fanuc_loop(statement);
        else sinumerik_loop(statement);
        if (!is_kadr()) mark(leave_.back());
        leave_.pop_back();
    }

    void kadr_loop(const Statement& statement) {
        const std::string counter = name(statement.variable);
        const std::string first = counter + " = " + std::to_string(statement.first);
        const std::string asked = counter + " <= " + std::to_string(statement.last);
        const std::string next = counter + " += 1";
        if (statement.kind == Statement::Kind::For) {
            out_ += "for (" + first + "; " + asked + "; " + next + ") {\n";
            add_all(statement.body);
            out_ += "}\n";
            return;
        }
        const bool is_repeat = statement.kind == Statement::Kind::Repeat;
        line(first);
        out_ += is_repeat ? std::string("do {\n") : "while (" + asked + ") {\n";
        add_all(statement.body);
        line(next);
        out_ += is_repeat ? "} while (" + asked + ");\n" : "}\n";
    }

    void fanuc_loop(const Statement& statement) {
        const std::string counter = name(statement.variable);
        const std::string last = std::to_string(statement.last);
        const std::string number = std::to_string(leave_.size());
        const bool is_repeat = statement.kind == Statement::Kind::Repeat;
        assign(statement.variable, std::to_string(statement.first));
        line((is_repeat ? "" : "WHILE[" + counter + "LE" + last + "]") + "DO" + number);
        add_all(statement.body);
        assign(statement.variable, counter + "+1");
        if (is_repeat) line("IF[" + counter + "GT" + last + "]GOTO" + leave_.back());
        line("END" + number);
    }

    void sinumerik_loop(const Statement& statement) {
        const std::string counter = name(statement.variable);
        const std::string first = std::to_string(statement.first);
        const std::string last = std::to_string(statement.last);
        const bool is_for = statement.kind == Statement::Kind::For;
        const bool is_repeat = statement.kind == Statement::Kind::Repeat;
        if (is_for) line("FOR " + counter + '=' + first + " TO " + last);
        else assign(statement.variable, first);
        if (is_repeat) line("REPEAT");
        else if (!is_for) line("WHILE " + counter + "<=" + last);
        add_all(statement.body);
        if (!is_for) assign(statement.variable, counter + "+1");
        line(is_for ? "ENDFOR" : is_repeat ? "UNTIL " + counter + '>' + last : "ENDWHILE");
    }

    std::string word(const std::string& address, const Expression& value) const {
        const std::string text = expressions_.of(value);
        const bool is_number = value.kind == Kind::Number;
        if (!is_fanuc())
            return ' ' + address + (is_number && address.size() == 1 ? "" : "=") + text;
        // Without a point X10 is ten increments.
        if (is_number)
            return ' ' + address + text + (text.find('.') == std::string::npos ? "." : "");
        return ' ' + address + (value.kind == Kind::Variable ? text : expressions_.bracketed(text));
    }

    void move(const Statement& statement) {
        std::string text = statement.kind == Statement::Kind::Rapid ? "G0" : "G1";
        std::size_t next = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if ((statement.axes >> axis & 1u) != 0)
                text += word(std::string(1, "XYZ"[axis]), statement.values[next++]);
        }
        if (statement.has_feed) text += word("F", statement.values[next]);
        say(text);
    }

    void arc(const Statement& statement) {
        for (std::size_t i = 0; i < 3; ++i) assign(kArc + i, expressions_.of(statement.values[i]));
        const Expression x = variable(kArc);
        const Expression y = variable(kArc + 1);
        const Expression r = variable(kArc + 2);
        line("G1" + word("X", x) + word("Y", y));
        std::string text = statement.is_clockwise ? "G2" : "G3";
        const Kind side = statement.is_clockwise ? Kind::Add : Kind::Subtract;
        if (statement.kind != Statement::Kind::Full)
            text += word("X", control_testing::of(Kind::Add, {x, r}));
        if (statement.kind == Statement::Kind::Quarter)
            text += word("Y", control_testing::of(side, {y, r}));
        if (statement.kind == Statement::Kind::BowRadius)
            text += word("Y", y) + word(is_fanuc() ? "R" : "CR", r);
        else text += word("I", r) + word("J", number(0));
        line(text);
    }

    Language language_;
    const Spelling& spelling_;
    ExpressionText expressions_;
    std::string out_;
    int labels_ = 0;
    int said_ = 0;
    std::vector<std::string> leave_;  // labels behind the loops that are open
};

// ---------------------------------------------------------------- settling

/// FANUC nests five pairs of brackets.
void limit_brackets(Expression& e, int most) {
    const auto depth = [&] {
        int open = 0;
        int deepest = 0;
        for (const char c : ExpressionText(Language::Fanuc).of(e)) {
            open += c == '[' ? 1 : c == ']' ? -1 : 0;
            deepest = std::max(deepest, open);
        }
        return deepest;
    };
    while (depth() > most) e = Expression(e.operands[0]);
}

void limit_brackets(Condition& condition, int most) {
    for (Expression& side : condition.sides) limit_brackets(side, most);
    for (Condition& part : condition.parts) limit_brackets(part, most - 1);
}

void limit_brackets(std::vector<Statement>& statements) {
    for (Statement& statement : statements) {
        for (Expression& value : statement.values) limit_brackets(value, 4);
        limit_brackets(statement.condition, 4);
        limit_brackets(statement.body);
        limit_brackets(statement.otherwise);
    }
}

/// A literal in the place of every expression about which the languages need not agree.
void settle(RandomProgram& program) {
    limit_brackets(program);
    for (int i = 0;; ++i) {
        Expression* const fault = Evaluation(program).run();
        if (fault == nullptr) return;
        RC_ASSERT(i < 500);
        *fault = number(3 + i % 90);
    }
}

}  // namespace

RandomProgram any_program() {
    RandomProgram program;
    for (std::size_t i = 1; i <= kFree; ++i) {
        program.push_back({.kind = Statement::Kind::Assign,
                           .variable = i,
                           .values = {number(whole(-5000, 5000) / 100.0)}});
    }
    program.push_back({.kind = Statement::Kind::Line,
                       .axes = 7,
                       .has_feed = true,
                       .values = {number(11), number(7), number(100), number(500)}});
    for (Statement& statement : any_statements(2, 0, 8)) program.push_back(std::move(statement));
    settle(program);
    return program;
}

Outcome outcome_of(const RandomProgram& program) {
    RandomProgram copy = program;
    Evaluation evaluation(copy);
    evaluation.run();
    return evaluation.outcome();
}

std::string text_of(const RandomProgram& program, Language language) {
    return ProgramText(language).of(program);
}

}  // namespace kadr::control_testing
