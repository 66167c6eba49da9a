#include <algorithm>
#include <charconv>

#include "base/diagnostics/syntax.h"
#include "syntax/operators.h"
#include "syntax/tree.h"

namespace kadr::syntax {

namespace {

Operator assignment_operator(Token token) {
    switch (token) {
        case Token::PlusAssign: return Operator::AddAssign;
        case Token::MinusAssign: return Operator::SubtractAssign;
        case Token::StarAssign: return Operator::MultiplyAssign;
        case Token::SlashAssign: return Operator::DivideAssign;
        case Token::PercentAssign: return Operator::ModuloAssign;
        case Token::ShiftLeftAssign: return Operator::ShiftLeftAssign;
        case Token::ShiftRightAssign: return Operator::ShiftRightAssign;
        case Token::AndAssign: return Operator::BitAndAssign;
        case Token::XorAssign: return Operator::BitXorAssign;
        case Token::OrAssign: return Operator::BitOrAssign;
        default: return Operator::Assign;
    }
}

Operator prefix_operator(Token token) {
    switch (token) {
        case Token::Minus: return Operator::Minus;
        case Token::Plus: return Operator::Plus;
        case Token::Not: return Operator::Not;
        case Token::Tilde: return Operator::BitNot;
        case Token::PlusPlus: return Operator::PreIncrement;
        default: return Operator::PreDecrement;
    }
}

SourceRange join(const SourceRange& first, const SourceRange& last) {
    return {first.file, first.begin, last.end};
}

}  // namespace

ExprId TreeBuilder::add(const Expr& expr) {
    std::size_t depth = 0;
    for (const ExprId child : expr.child) {
        if (child.is_valid()) depth = std::max<std::size_t>(depth, depths_[child.index] + 1u);
    }
    for (const ExprId item : ast_.exprs(expr.list)) {
        depth = std::max<std::size_t>(depth, depths_[item.index] + 1u);
    }
    if (expr.is_chain_link() && ast_[expr.child[0]].is_chain_link()) {
        depth =
            std::max<std::size_t>(depths_[expr.child[0].index], depths_[expr.child[1].index] + 1u);
    }
    const ExprId id{static_cast<std::uint32_t>(ast_.expressions.size())};
    ast_.expressions.push_back(expr);
    if (depth >= kMaxNesting) {
        if (!has_complained_of_depth_) {
            file_.sink.report(diag::NestingTooDeep, expr.range).arg(kMaxNesting);
        }
        has_complained_of_depth_ = true;
        ast_.expressions.back() = Expr{};
        ast_.expressions.back().range = expr.range;
        depth = 0;
    }
    depths_.push_back(static_cast<std::uint16_t>(depth));
    return id;
}

ExprId TreeBuilder::binary(Operator op, ExprId left, ExprId right) {
    Expr expr;
    expr.kind = ExprKind::Binary;
    expr.op = op;
    expr.range = join(ast_[left].range, ast_[right].range);
    expr.child = {left, right, ExprId{}};
    return add(expr);
}

ExprId TreeBuilder::unary(Operator op, ExprId value, const SourceRange& range) {
    Expr expr;
    expr.kind = ExprKind::Unary;
    expr.op = op;
    expr.range = range;
    expr.child[0] = value;
    return add(expr);
}

/// Operands and operators in a row become a tree by precedence (Dijkstra's two stacks).
ExprId TreeBuilder::by_precedence(ExprId first, std::span<Node* const> rest) {
    std::vector<ExprId> values = {first};
    std::vector<const BinaryOperator*> pending;
    const auto reduce = [&] {
        const ExprId right = values.back();
        values.pop_back();
        values.back() = binary(pending.back()->op, values.back(), right);
        pending.pop_back();
    };
    for (std::size_t i = 0; i + 1 < rest.size(); i += 2) {
        const BinaryOperator* row = find_binary_operator(lexeme(rest[i]).token);
        if (row == nullptr) break;  // `?`
        while (!pending.empty() &&
               (pending.back()->precedence > row->precedence ||
                (pending.back()->precedence == row->precedence && !row->is_right))) {
            reduce();
        }
        pending.push_back(row);
        values.push_back(operand(*static_cast<KadrParser::OperandContext*>(rest[i + 1])));
    }
    while (!pending.empty()) reduce();
    return values.front();
}

ExprId TreeBuilder::expression(KadrParser::ExpressionContext& context) {
    const std::span<Node* const> children(context.children);
    const ExprId value = by_precedence(
        operand(*static_cast<KadrParser::OperandContext*>(children[0])), children.subspan(1));
    if (context.expression().empty()) return value;
    Expr expr;
    expr.kind = ExprKind::Conditional;
    expr.range = range_of(context);
    expr.child = {value, expression(*context.expression(0)), expression(*context.expression(1))};
    return add(expr);
}

ExprId TreeBuilder::assignment(KadrParser::AssignmentContext& context) {
    const ExprId target = expression(*context.expression(0));
    if (context.children.size() == 1) return target;
    Expr expr;
    expr.kind = ExprKind::Assign;
    expr.op = assignment_operator(lexeme(context.children[1]).token);
    expr.range = range_of(context);
    expr.child = {target, expression(*context.expression(1)), ExprId{}};
    return add(expr);
}

ExprId TreeBuilder::condition(KadrParser::ConditionContext& context) {
    const ExprId first = expression(*context.expression(0));
    if (context.children.size() == 1) return first;
    const SourceRange location = file_.range(lexeme(context.children[1]));
    file_.sink.report(diag::AssignmentInCondition, location)
        .fix(location, "==", "compare with `==`");
    return binary(Operator::Equal, first, expression(*context.expression(1)));
}

ExprId TreeBuilder::range(KadrParser::RangeContext& context) {
    const ExprId from = expression(*context.expression(0));
    if (context.children.size() == 1) return from;
    Expr expr;
    expr.kind = ExprKind::Range;
    expr.range = range_of(context);
    expr.child = {from, expression(*context.expression(1)), ExprId{}};
    return add(expr);
}

ExprId TreeBuilder::operand(KadrParser::OperandContext& context) {
    const std::vector<Node*>& children = context.children;
    std::size_t i = 0;
    while (dynamic_cast<antlr4::tree::TerminalNode*>(children[i]) != nullptr) ++i;
    const std::size_t prefixes = i;
    ExprId value = primary(*static_cast<KadrParser::PrimaryContext*>(children[i++]));
    // `given a[i]` asks for the element, `given h.d` for the member.
    const bool is_given = ast_[value].kind == ExprKind::Given && i < children.size();
    const SourceRange whole = ast_[value].range;
    if (is_given) value = ast_[value].child[0];
    for (; i < children.size(); ++i) {
        value = suffix(value, *static_cast<KadrParser::SuffixContext*>(children[i]));
    }
    if (is_given) {
        Expr expr;
        expr.kind = ExprKind::Given;
        expr.range = join(whole, ast_[value].range);
        expr.child[0] = value;
        value = add(expr);
    }
    for (i = prefixes; i-- > 0;) {
        const Lexeme& sign = lexeme(children[i]);
        value =
            unary(prefix_operator(sign.token), value, join(file_.range(sign), ast_[value].range));
    }
    return value;
}

ExprId TreeBuilder::primary(KadrParser::PrimaryContext& context) {
    const Lexeme& first = lexeme(context.start);
    Expr expr;
    expr.range = range_of(context);
    switch (first.token) {
        case Token::Number: return number(first);
        case Token::Identifier: return name(first);
        case Token::True:
        case Token::False:
            expr.kind = ExprKind::Bool;
            expr.integer = first.token == Token::True ? 1 : 0;
            return add(expr);
        case Token::Text:
        case Token::TextOpen:
            return text(*static_cast<KadrParser::TextValueContext&>(context).text());
        case Token::Given:
            expr.kind = ExprKind::Given;
            expr.child[0] = name(lexeme(context.children[1]));
            return add(expr);
        case Token::OpenParen:
            return expression(*static_cast<KadrParser::ParenthesesContext&>(context).expression());
        case Token::GenericName: {
            auto& call = static_cast<KadrParser::GenericCallContext&>(context);
            expr.kind = ExprKind::TypedCall;
            expr.text = first.text;
            expr.type = type(*call.type());
            expr.list = arguments(call.arguments());
            return add(expr);
        }
        default:
            return braces(context, static_cast<KadrParser::BracesContext&>(context).argument());
    }
}

ExprId TreeBuilder::suffix(ExprId base, KadrParser::SuffixContext& context) {
    Expr expr;
    expr.range = join(ast_[base].range, range_of(context));
    expr.child[0] = base;
    switch (token_at(context)) {
        case Token::OpenParen:
            expr.kind = ExprKind::Call;
            expr.list = arguments(static_cast<KadrParser::CallContext&>(context).arguments());
            return add(expr);
        case Token::OpenBracket:
            expr.kind = ExprKind::Index;
            expr.child[1] =
                expression(*static_cast<KadrParser::IndexContext&>(context).expression());
            return add(expr);
        case Token::Dot:
            expr.kind = ExprKind::Member;
            expr.text = lexeme(context.children[1]).text;
            return add(expr);
        case Token::PlusPlus: return unary(Operator::PostIncrement, base, expr.range);
        default: return unary(Operator::PostDecrement, base, expr.range);
    }
}

ExprId TreeBuilder::point(KadrParser::PointContext& context) {
    auto* start = static_cast<KadrParser::PointStartContext*>(context.children[0]);
    ExprId value;
    if (token_at(*start) == Token::Identifier) {
        value = name(lexeme(start->children[0]));
        for (std::size_t i = 1; i < start->children.size(); ++i) {
            value = suffix(value, *static_cast<KadrParser::SuffixContext*>(start->children[i]));
        }
    } else {
        value = braces(*start, static_cast<KadrParser::ValuePointContext*>(start)->argument());
    }
    return by_precedence(value, std::span<Node* const>(context.children).subspan(1));
}

ExprId TreeBuilder::number(const Lexeme& lexeme) {
    const std::string_view spelled = file_.spelling(lexeme);
    Expr expr;
    expr.range = file_.range(lexeme);
    expr.number = lexeme.number;
    expr.unit = lexeme.unit;
    const bool is_whole = spelled.find_first_not_of("0123456789") == std::string_view::npos;
    expr.kind = is_whole ? ExprKind::Int : ExprKind::Real;
    if (is_whole) {
        std::from_chars(spelled.data(), spelled.data() + spelled.size(), expr.integer);
    }
    return add(expr);
}

ExprId TreeBuilder::name(const Lexeme& lexeme) {
    Expr expr;
    expr.kind = ExprKind::Name;
    expr.range = file_.range(lexeme);
    expr.text = lexeme.text;
    return add(expr);
}

ExprId TreeBuilder::text(KadrParser::TextContext& context) {
    Expr whole;
    whole.kind = ExprKind::String;
    whole.range = range_of(context);
    if (context.children.size() == 1) {
        whole.text = lexeme(context.children[0]).text;
        return add(whole);
    }
    std::vector<ExprId> pieces;
    for (Node* child : context.children) {
        Expr piece;
        if (auto* formatted = dynamic_cast<KadrParser::FormattedContext*>(child)) {
            piece.kind = ExprKind::Format;
            piece.range = range_of(*formatted);
            piece.child[0] = expression(*formatted->expression());
            if (auto* format = formatted->Format()) piece.text = lexeme(format).text;
        } else {
            const Lexeme& spelled = lexeme(child);
            if (spelled.text.is_empty()) continue;
            piece.kind = ExprKind::String;
            piece.range = file_.range(spelled);
            piece.text = spelled.text;
        }
        pieces.push_back(add(piece));
    }
    whole.list = list(pieces);
    return add(whole);
}

ExprId TreeBuilder::braces(Rule& context, std::span<KadrParser::ArgumentContext* const> values) {
    std::vector<ExprId> ids;
    for (KadrParser::ArgumentContext* value : values) {
        auto* given_name = value->ArgumentName();
        if (value->expression() == nullptr) continue;  // only a call leaves something out
        if (given_name == nullptr) {
            ids.push_back(expression(*value->expression()));
            continue;
        }
        Expr named;
        named.kind = ExprKind::Argument;
        named.range = range_of(*value);
        named.text = lexeme(given_name).text;
        named.child[0] = expression(*value->expression());
        ids.push_back(add(named));
    }
    Expr expr;
    expr.kind = ExprKind::Braces;
    expr.range = range_of(context);
    expr.list = list(ids);
    return add(expr);
}

List TreeBuilder::arguments(KadrParser::ArgumentsContext* context) {
    if (context == nullptr) return {};
    std::vector<ExprId> ids;
    for (KadrParser::ArgumentContext* argument : context->argument()) {
        Expr expr;
        expr.kind = ExprKind::Argument;
        expr.range = range_of(*argument);
        if (auto* given_name = argument->ArgumentName()) expr.text = lexeme(given_name).text;
        // A call of the control may leave arguments out.
        if (argument->expression() != nullptr) expr.child[0] = expression(*argument->expression());
        ids.push_back(add(expr));
    }
    return list(ids);
}

}  // namespace kadr::syntax
