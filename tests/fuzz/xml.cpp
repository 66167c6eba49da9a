// Any bytes as a dialect, a machine or a keyword language.
#include <cstdint>
#include <cstdio>
#include <string>

#include <unistd.h>

#include "machine/machine.h"
#include "nc/dialect.h"
#include "syntax/parse.h"
#include "tests/fuzz/world.h"

namespace {

using namespace kadr;

/// The loaders take files; this one lives in memory where the system has such a place.
std::string scratch_file() { return "/dev/shm/kadr-fuzz-" + std::to_string(::getpid()) + ".xml"; }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string path = scratch_file();
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return 0;
    std::fwrite(data, 1, size, file);
    std::fclose(file);
    Sources sources;
    DiagnosticList messages;
    (void)nc::load_dialect(path, {KADR_ROOT "/dialects"}, sources, messages);
    (void)machine::load_machine(path, {KADR_ROOT "/runtime/machines"}, sources, messages);
    (void)syntax::load_keywords(path, {KADR_ROOT "/dialects/languages"}, sources, messages);
    ::unlink(path.c_str());
    fuzz::show(messages, sources);
    return 0;
}
