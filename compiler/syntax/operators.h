// operators.h — C's precedence of Kadr's binary operators.
#pragma once

#include "syntax/ast.h"
#include "syntax/token.h"

namespace kadr::syntax {

struct BinaryOperator {
    Token token;
    Operator op;
    int precedence;  // higher binds tighter
    bool is_right = false;
    const char* text;
};

/// Tightest first. `contains` compares, `??` stands between `||` and `?:` and groups to the right.
inline constexpr BinaryOperator kBinaryOperators[] = {
    {Token::Star, Operator::Multiply, 11, false, "*"},
    {Token::Slash, Operator::Divide, 11, false, "/"},
    {Token::Percent, Operator::Modulo, 11, false, "%"},
    {Token::Plus, Operator::Add, 10, false, "+"},
    {Token::Minus, Operator::Subtract, 10, false, "-"},
    {Token::ShiftLeft, Operator::ShiftLeft, 9, false, "<<"},
    {Token::ShiftRight, Operator::ShiftRight, 9, false, ">>"},
    {Token::Less, Operator::Less, 8, false, "<"},
    {Token::LessEqual, Operator::LessEqual, 8, false, "<="},
    {Token::Greater, Operator::Greater, 8, false, ">"},
    {Token::GreaterEqual, Operator::GreaterEqual, 8, false, ">="},
    {Token::Contains, Operator::Contains, 8, false, "contains"},
    {Token::Equal, Operator::Equal, 7, false, "=="},
    {Token::NotEqual, Operator::NotEqual, 7, false, "!="},
    {Token::And, Operator::BitAnd, 6, false, "&"},
    {Token::Xor, Operator::BitXor, 5, false, "^"},
    {Token::Or, Operator::BitOr, 4, false, "|"},
    {Token::AndAnd, Operator::And, 3, false, "&&"},
    {Token::OrOr, Operator::Or, 2, false, "||"},
    {Token::Coalesce, Operator::Coalesce, 1, true, "??"},
};

constexpr const BinaryOperator* find_binary_operator(Token token) {
    for (const BinaryOperator& row : kBinaryOperators) {
        if (row.token == token) return &row;
    }
    return nullptr;
}

constexpr const BinaryOperator* find_binary_operator(Operator op) {
    for (const BinaryOperator& row : kBinaryOperators) {
        if (row.op == op) return &row;
    }
    return nullptr;
}

}  // namespace kadr::syntax
