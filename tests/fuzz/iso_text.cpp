// Any bytes as ISO-7bit text; the first byte chooses the control. Read, interpreted, planned and
// sampled a little; what was read is written again.
#include <cstdint>
#include <string>

#include "interp/interpreter.h"
#include "motion/pipeline.h"
#include "nc/writer.h"

namespace {

using namespace kadr;

struct World {
    Sources sources;
    DiagnosticList messages;
    std::vector<nc::Dialect> dialects;
    machine::Machine mill;
    World()
        : mill(*machine::load_machine("mill", {KADR_ROOT "/runtime/machines"}, sources, messages)) {
        for (const char* name : {"iso", "sinumerik", "fanuc", "axioma"}) {
            dialects.push_back(*nc::load_dialect(name, {KADR_ROOT "/dialects"}, sources, messages));
        }
    }
};

class Pieces final : public nc::TextSource {
  public:
    explicit Pieces(std::string_view text) : rest_(text) {}
    std::string_view next() override {
        const std::string_view piece = rest_.substr(0, 7);  // lines are cut anywhere
        rest_.remove_prefix(piece.size());
        return piece;
    }

  private:
    std::string_view rest_;
};

void execute(const World& world, const nc::Dialect& dialect, std::string_view text) {
    DiagnosticList messages;
    Pieces pieces(text);
    nc::Reader reader(dialect, pieces, "fuzz", messages);
    interp::InterpreterOptions options;
    options.max_blocks = 200;
    interp::Interpreter interpreter(dialect, world.mill, reader, &reader, nullptr, options,
                                    messages);
    motion::Planner planner(interpreter, world.mill, {}, messages);
    motion::Sampler sampler(planner, world.mill, 0.01);
    std::vector<motion::Setpoint> setpoints(256);
    for (int i = 0; i < 8 && sampler.pull(setpoints) != 0; ++i) {
    }
}

void rewrite(const nc::Dialect& dialect, std::string_view text) {
    DiagnosticList messages;
    Pieces pieces(text);
    nc::Reader reader(dialect, pieces, "fuzz", messages);
    nc::Writer writer(dialect, {}, messages);
    std::string out;
    std::vector<nc::Block> blocks(64);
    for (std::size_t count; (count = reader.pull(blocks)) != 0;) {
        for (std::size_t i = 0; i < count; ++i) writer.write(blocks[i], out);
        out.clear();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const World world;
    if (size == 0) return 0;
    const nc::Dialect& dialect = world.dialects[data[0] % world.dialects.size()];
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    execute(world, dialect, text);
    rewrite(dialect, text);
    return 0;
}
