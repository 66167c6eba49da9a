// map.cpp — `--map`: which statement made which line of the text. It is written while the text is
// made.
#include "driver/outputs.h"

namespace kadr::driver {

namespace {

class MapOutput final : public RunOutput {
  public:
    explicit MapOutput(const OutputParts& parts) : file_(parts.file) {}
    Wants wants() const override { return {}; }
    Done look_on(Aside& aside) override {
        aside.map = &file_;
        return kDone;
    }

  private:
    Output& file_;
};

}  // namespace

std::unique_ptr<RunOutput> make_map(const OutputParts& parts) {
    return std::make_unique<MapOutput>(parts);
}

}  // namespace kadr::driver
