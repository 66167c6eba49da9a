// words.h — numbers get their units, addresses their numbers.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "nc/dialect.h"
#include "syntax/lexeme.h"

namespace kadr::syntax {

using WordKindOf = std::function<nc::WordKind(std::string_view)>;

/// Merges `10` `mm` to a Number with a unit, `X10` `.5` to a LiteralWord, and retypes identifiers
/// that the input dialect knows to BareWord and Address. `G0X10Y20` becomes three words.
std::vector<Lexeme> merge_words(const SourceFile& file, const std::vector<Lexeme>& lexemes,
                                const WordKindOf& kind_of);

/// The unit that an identifier behind a number means; None if it is none. `per` is what stands
/// behind a `/`, or empty.
Unit find_unit(std::string_view name, std::string_view per);

/// The unit that is meant by a name that is none: `mm` by `MM`, `s` by `sec`; empty: none is.
std::string_view unit_meant(std::string_view name);

}  // namespace kadr::syntax
