// Any bytes as a Kadr source: lexer and parser alone. Whatever stands there, it gets a tree or
// messages; the tree prints.
#include <cstdint>

#include "syntax/print.h"
#include "tests/fuzz/world.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto parsed = kadr::fuzz::parse({reinterpret_cast<const char*>(data), size});
    kadr::fuzz::show(parsed->messages, parsed->sources);
    (void)kadr::syntax::dump(parsed->ast);
    return 0;
}
