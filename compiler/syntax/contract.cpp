#include "syntax/contract.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "syntax/quotes.h"

namespace kadr::syntax {

namespace {

struct BoundSign {
    Operator op;
    Operator mirrored;  // seen from the other side
    std::string_view text;
};
constexpr std::array<BoundSign, 4> kComparisons = {{
    {Operator::Less, Operator::Greater, "<"},
    {Operator::LessEqual, Operator::GreaterEqual, "<="},
    {Operator::Greater, Operator::Less, ">"},
    {Operator::GreaterEqual, Operator::LessEqual, ">="},
}};

const BoundSign* find_comparison(Operator op) {
    const auto found = std::ranges::find(kComparisons, op, &BoundSign::op);
    return found == kComparisons.end() ? nullptr : &*found;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

/// With one blank where the source has several or a line end.
std::string on_one_line(std::string_view text) {
    std::string out;
    for (const char c : trimmed(text)) {
        const bool is_blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
        if (!is_blank) out += c;
        else if (out.back() != ' ') out += ' ';
    }
    return out;
}

class ContractReader {
  public:
    ContractReader(const Ast& ast, DeclId id, std::string_view text)
        : ast_(ast), decl_(ast[id]), text_(text) {}

    Contract read() {
        out_.name = ast_.text(decl_.name);
        for (const DeclId id : ast_.decls(decl_.parameters)) read_parameter(id);
        read_head();
        read_documentation();
        if (decl_.body.is_valid()) read_requirements();
        return std::move(out_);
    }

  private:
    std::string source(const SourceRange& range) const {
        return on_one_line(text_.substr(range.begin, range.end - range.begin));
    }
    /// The range of `(a - b)/c` begins behind its bracket, that of `c*(a - b)` ends before it.
    std::string expression(ExprId id) const {
        std::size_t begin = ast_[id].range.begin;
        std::size_t end = ast_[id].range.end;
        int open = 0;
        int lacking = 0;  // brackets that are closed and not opened
        for (std::size_t at = begin; at < end; ++at) {
            if (text_[at] == '"') {
                const auto past = end_of_text(text_, static_cast<std::uint32_t>(at),
                                              static_cast<std::uint32_t>(end));
                at = std::max<std::size_t>(past, at + 1) - 1;
                continue;
            }
            if (text_[at] == '(') ++open;
            if (text_[at] == ')' && --open < 0) {
                ++lacking;
                open = 0;
            }
        }
        for (; lacking > 0 && begin > 0; --lacking) begin = text_.rfind('(', begin - 1);
        for (; open > 0 && end < text_.size(); --open) end = text_.find(')', end) + 1;
        return on_one_line(text_.substr(begin, end - begin));
    }
    ParameterContract* find(std::string_view name) {
        const auto found = std::ranges::find(out_.parameters, name, &ParameterContract::name);
        return found == out_.parameters.end() ? nullptr : &*found;
    }

    void read_parameter(DeclId id) {
        const Decl& decl = ast_[id];
        ParameterContract parameter;
        parameter.name = ast_.text(decl.name);
        parameter.range = decl.name_range;
        parameter.type_id = decl.type;
        parameter.meaning = on_one_line(ast_.text(decl.documentation));
        if (decl.type.is_valid()) {
            parameter.type = source(ast_[decl.type].range);
            parameter.is_optional = ast_[decl.type].is_optional;
        }
        if (decl.value.is_valid()) parameter.initial = expression(decl.value);
        out_.parameters.push_back(std::move(parameter));
    }

    /// What stands in front of the parameters, and what between them and the body.
    void read_head() {
        out_.heading = source({decl_.range.file, decl_.range.begin, decl_.name_range.end});
        if (!decl_.body.is_valid()) return;
        const std::uint32_t body = ast_[decl_.body].range.begin;
        std::uint32_t from = decl_.name_range.end;
        const auto parameters = ast_.decls(decl_.parameters);
        if (!parameters.empty()) from = ast_[parameters.back()].range.end;
        const std::size_t close = text_.substr(0, body).find(')', from);
        if (close != std::string_view::npos)
            out_.ending = on_one_line(text_.substr(close + 1, body - close - 1));
    }

    /// The parameters that a line of the documentation is about: all its names are theirs.
    std::vector<ParameterContract*> owners_of(std::string_view line, std::size_t gap) {
        std::vector<ParameterContract*> owners;
        for (std::size_t begin = 0; begin < gap;) {
            const std::size_t end = std::min(line.find(',', begin), gap);
            ParameterContract* owner = find(trimmed(line.substr(begin, end - begin)));
            if (owner == nullptr) return {};
            owners.push_back(owner);
            begin = end + 1;
        }
        return owners;
    }

    void read_documentation() {
        const std::string_view all = ast_.text(decl_.documentation);
        std::vector<ParameterContract*> owners;
        for (std::size_t begin = 0; begin < all.size();) {
            const std::size_t end = std::min(all.find('\n', begin), all.size());
            const std::string_view line = all.substr(begin, end - begin);
            begin = end + 1;
            const std::size_t gap = line.find("  ");
            const bool goes_on = !owners.empty() && gap == 0;
            if (!goes_on) owners = gap == line.npos ? decltype(owners)() : owners_of(line, gap);
            if (owners.empty()) {
                out_.about += std::string(line) + '\n';
                continue;
            }
            for (ParameterContract* owner : owners) {
                if (!owner->meaning.empty()) owner->meaning += ' ';
                owner->meaning += trimmed(line.substr(gap));
            }
        }
        while (out_.about.ends_with('\n')) out_.about.pop_back();
    }

    void read_requirements() {
        const Stmt& body = ast_[decl_.body];
        for (const StmtId id : ast_.stmts(body.statements)) {
            const Stmt& stmt = ast_[id];
            if (stmt.kind == StmtKind::Require) read_condition(stmt.expression[0]);
        }
    }

    /// `a && b && c`, from left to right: a chain hangs to the left.
    void read_condition(ExprId condition) {
        std::vector<ExprId> parts;
        while (ast_[condition].kind == ExprKind::Binary && ast_[condition].op == Operator::And) {
            parts.push_back(ast_[condition].child[1]);
            condition = ast_[condition].child[0];
        }
        parts.push_back(condition);
        for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
            if (!is_of_the_call(*part)) continue;
            const bool is_bound = bounds_one(*part);
            if (!is_bound) out_.conditions.push_back(expression(*part));
        }
    }

    /// Whether the comparison bounds a parameter; `wall < corner` bounds two.
    bool bounds_one(ExprId id) {
        const Expr& expr = ast_[id];
        const BoundSign* comparison =
            expr.kind == ExprKind::Binary ? find_comparison(expr.op) : nullptr;
        if (comparison == nullptr) return false;
        const bool left = bound(expr.child[0], comparison->op, expr.child[1]);
        const bool right = bound(expr.child[1], comparison->mirrored, expr.child[0]);
        return left || right;
    }

    bool bound(ExprId of, Operator op, ExprId by) {
        if (ast_[of].kind != ExprKind::Name) return false;
        ParameterContract* parameter = find(ast_.text(ast_[of].text));
        if (parameter == nullptr) return false;
        parameter->bounds.push_back({op, expression(by)});
        return true;
    }

    /// Whether a condition is about nothing but what a caller gives and what all calls share: no
    /// variable of the body, no parameter that has changed.
    bool is_of_the_call(ExprId condition) {
        const SourceRange whole = ast_[condition].range;
        return std::ranges::none_of(ast_.expressions, [&](const Expr& expr) {
            const bool is_inside = expr.range.begin >= whole.begin && expr.range.end <= whole.end;
            if (!is_inside || expr.kind != ExprKind::Name) return false;
            return find(ast_.text(expr.text)) != nullptr ? is_changed(expr) : is_local(expr);
        });
    }

    bool is_local(const Expr& use) const {
        const SourceRange body = ast_[decl_.body].range;
        return std::ranges::any_of(ast_.declarations, [&](const Decl& decl) {
            return decl.kind == DeclKind::Variable && decl.name == use.text &&
                   decl.range.begin >= body.begin && decl.range.end <= body.end;
        });
    }

    /// Whether a statement in front of this use gives the parameter another value.
    bool is_changed(const Expr& use) const {
        const std::uint32_t begin = ast_[decl_.body].range.begin;
        return std::ranges::any_of(ast_.expressions, [&](const Expr& expr) {
            const bool is_step = expr.kind == ExprKind::Unary &&
                                 expr.op >= Operator::PreIncrement &&
                                 expr.op <= Operator::PostDecrement;
            if (expr.kind != ExprKind::Assign && !is_step) return false;
            const Expr& target = ast_[expr.child[0]];
            return expr.range.begin >= begin && expr.range.begin < use.range.begin &&
                   target.kind == ExprKind::Name && target.text == use.text;
        });
    }

    const Ast& ast_;
    const Decl& decl_;
    std::string_view text_;
    Contract out_;
};

}  // namespace

Contract contract_of(const Ast& ast, DeclId id, std::string_view text) {
    return ContractReader(ast, id, text).read();
}

std::string_view spelling(Operator comparison) {
    const BoundSign* found = find_comparison(comparison);
    return found == nullptr ? std::string_view() : found->text;
}

std::string bounds_text(const ParameterContract& parameter) {
    std::string out;
    for (const Bound& bound : parameter.bounds) {
        if (!out.empty()) out += ", ";
        out += std::string(spelling(bound.op)) + ' ' + bound.value;
    }
    return out;
}

std::string_view bare_unit(std::string_view type, bool is_inch) {
    struct Row {
        std::string_view type;
        std::string_view metric;
        std::string_view inch;
    };
    constexpr Row kRows[] = {
        {"length", "mm", "in"},  {"diameter", "mm", "in"}, {"point", "mm", "in"},
        {"angle", "deg", "deg"}, {"time", "s", "s"},       {"feed", "mm/min", "in/min"},
        {"speed", "rpm", "rpm"},
    };
    for (const Row& row : kRows) {
        if (row.type == type) return is_inch ? row.inch : row.metric;
    }
    return {};
}

bool is_inch(const Ast& ast) {
    return std::ranges::any_of(ast.top, [&](const DeclId id) {
        return ast[id].kind == DeclKind::Units && ast.text(ast[id].name) == "inch";
    });
}

}  // namespace kadr::syntax
