// print.cpp — `--print`: the lines that a program of the control prints.
#include "driver/outputs.h"

namespace kadr::driver {

namespace {

class PrintOutput final : public RunOutput, public macro::PrintTarget {
  public:
    explicit PrintOutput(const OutputParts& parts) : file_(parts.file) {}
    Wants wants() const override { return {.in_step = true}; }

    Done follow(Execution& execution) override {
        execution.print_to(*this);
        return kDone;
    }
    void line(std::string_view text) override {
        file_.write(text);
        file_.write("\n");
    }

  private:
    Output& file_;
};

}  // namespace

std::unique_ptr<RunOutput> make_print(const OutputParts& parts) {
    return std::make_unique<PrintOutput>(parts);
}

}  // namespace kadr::driver
