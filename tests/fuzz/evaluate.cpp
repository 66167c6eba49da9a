// Random expressions that are right by construction, evaluated twice: by the checker, which folds
// what is constant, and by the evaluator, from variables. Promise: both come to the same number.
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/fuzz/world.h"

namespace {

using namespace kadr;

constexpr int kDepth = 6;

/// Turns the input into one expression; `folded` is its text with numbers in place, `variables` and
/// `declarations` have a variable for every number.
class Expression {
  public:
    explicit Expression(std::span<const std::uint8_t> bytes) : bytes_(bytes) { real(kDepth); }

    std::string folded;
    std::string variables;
    std::string declarations;

  private:
    unsigned take(unsigned below) {
        if (bytes_.empty()) return 0;
        const unsigned byte = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return byte % below;
    }
    void put(std::string_view text) {
        folded += text;
        variables += text;
    }
    void leaf(const char* type, const std::string& value) {
        const std::string name = "v" + std::to_string(count_++);
        folded += value;
        variables += name;
        declarations += std::string("    ") + type + ' ' + name + " = " + value + ";\n";
    }
    /// `(a op b)` with operands of one type.
    void binary(void (Expression::*operand)(int), std::string_view op, int depth) {
        put("(");
        (this->*operand)(depth - 1);
        put(" " + std::string(op) + " ");
        (this->*operand)(depth - 1);
        put(")");
    }
    void call(void (Expression::*argument)(int), std::string_view name, int arguments, int depth) {
        put(std::string(name) + '(');
        for (int i = 0; i < arguments; ++i) {
            if (i > 0) put(", ");
            (this->*argument)(depth - 1);
        }
        put(")");
    }
    void choice(void (Expression::*value)(int), int depth) {
        put("(");
        boolean(depth - 1);
        put(" ? ");
        (this->*value)(depth - 1);
        put(" : ");
        (this->*value)(depth - 1);
        put(")");
    }

    void integer(int depth);
    void real(int depth);
    void boolean(int depth);

    std::span<const std::uint8_t> bytes_;
    unsigned count_ = 0;
};

void Expression::integer(int depth) {
    static constexpr const char* kNumbers[] = {
        "0", "1", "2", "3", "7", "10", "62", "63", "255", "4294967296", "9223372036854775807"};
    static constexpr const char* kOperators[] = {"+", "-", "*", "%", "<<", ">>", "&", "|", "^"};
    static constexpr const char* kRoundings[] = {"round", "floor", "ceil", "trunc"};
    switch (depth <= 0 ? 0 : take(8)) {
        case 0:
        case 1: return leaf("int", kNumbers[take(std::size(kNumbers))]);
        case 2:
        case 3: return binary(&Expression::integer, kOperators[take(std::size(kOperators))], depth);
        case 4: put(take(2) == 0 ? "(- " : "(~ "), integer(depth - 1), put(")"); return;
        case 5: return call(&Expression::real, kRoundings[take(std::size(kRoundings))], 1, depth);
        case 6: return call(&Expression::integer, take(2) == 0 ? "min" : "max", 2, depth);
        default: return choice(&Expression::integer, depth);
    }
}

void Expression::real(int depth) {
    static constexpr const char* kNumbers[] = {"0.0",  "1.0",  "0.5", "2.25",  "0.1",  "1e-9",
                                               "90.0", "1e15", "3e7", "1e300", "45.0", "1e-300"};
    static constexpr const char* kOperators[] = {"+", "-", "*", "/"};
    static constexpr const char* kUnary[] = {"abs", "sqrt", "sin",   "cos",  "tan",  "asin",
                                             "exp", "ln",   "log10", "cbrt", "round"};
    static constexpr const char* kBinary[] = {"min", "max", "pow", "hypot", "mod"};
    switch (depth <= 0 ? 0 : take(9)) {
        case 0:
        case 1: return leaf("real", kNumbers[take(std::size(kNumbers))]);
        case 2:
        case 3: return binary(&Expression::real, kOperators[take(std::size(kOperators))], depth);
        case 4: put("(- "), real(depth - 1), put(")"); return;
        case 5: {
            const std::string_view name = kUnary[take(std::size(kUnary))];
            const bool is_angle = name == "asin";  // a number again when it is divided by a degree
            if (is_angle) put("(");
            call(&Expression::real, name, 1, depth);
            if (is_angle) put("/1deg)");
            return;
        }
        case 6: return call(&Expression::real, kBinary[take(std::size(kBinary))], 2, depth);
        case 7: return call(&Expression::integer, "real", 1, depth);
        default: return choice(&Expression::real, depth);
    }
}

void Expression::boolean(int depth) {
    static constexpr const char* kOrders[] = {"<", "<=", ">", ">=", "==", "!="};
    switch (depth <= 0 ? 0 : take(6)) {
        case 0: return leaf("bool", take(2) == 0 ? "true" : "false");
        case 1:
        case 2: return binary(&Expression::real, kOrders[take(std::size(kOrders))], depth);
        case 3: return binary(&Expression::integer, kOrders[take(std::size(kOrders))], depth);
        case 4: return binary(&Expression::boolean, take(2) == 0 ? "&&" : "||", depth);
        default: put("(! "), boolean(depth - 1), put(")"); return;
    }
}

struct Answer {
    std::optional<double> value;  // nothing: it is refused
    std::string refusal;          // of the checker; empty: it let the expression pass
};

Answer evaluate(const std::string& declarations, const std::string& expression) {
    // The answer leaves the program as the X of a block; real() is the way from any number.
    const std::string source = "program p() {\n" + declarations + "    X=" + expression + ";\n}\n";
    const auto checked = fuzz::check(source);
    fuzz::show(checked->messages, checked->sources);
    if (!checked->code) return {std::nullopt, checked->messages.all().front().message()};
    expand::ExpandOptions options;
    options.limits = fuzz::small_limits();
    expand::Expander expander(*checked->code, fuzz::world().dialects.at("iso"), options,
                              checked->messages);
    if (!expander.start("", {})) fuzz::broken("the program starts", source);
    std::vector<nc::Block> blocks(4);
    const std::size_t count = expander.pull(blocks);
    fuzz::show(checked->messages, checked->sources);
    if (expander.failed()) return {};
    if (count != 1) fuzz::broken("there is one block", source);
    return {blocks[0].at(nc::Slot::X), ""};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Expression expression({data, size});
    const Answer folded = evaluate("", expression.folded);
    const Answer run = evaluate(expression.declarations, expression.variables);
    const std::string both = expression.folded + '\n' + expression.variables;
    if (!run.refusal.empty()) fuzz::broken("an expression of variables passes", run.refusal + both);
    if (run.value && !std::isfinite(*run.value)) {
        fuzz::broken("only numbers reach a block", both);
    }
    // The checker looks at both sides of `?:` and `&&`, the evaluator only at the one that is
    // taken: only the checker may refuse what the other one answers.
    if (folded.value && (!run.value || std::bit_cast<std::uint64_t>(*folded.value) !=
                                           std::bit_cast<std::uint64_t>(*run.value))) {
        fuzz::broken("folded is what is evaluated",
                     both + '\n' + std::to_string(*folded.value) + " and " +
                         (run.value ? std::to_string(*run.value) : "a fault"));
    }
    return 0;
}
