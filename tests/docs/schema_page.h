// schema_page.h — the reference of a dialect file's elements, as dialects/dialect.xsd has them.
#pragma once

#include <string>

namespace docs {

/// A heading for each element of a dialect file, what it holds, and a table of its attributes.
/// Empty, with a failure of the test, if the schema cannot be read.
std::string elements_of_dialects();

}  // namespace docs
