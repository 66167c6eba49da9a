#include "cli/progress.h"

#include <cstdio>

#include <fmt/format.h>

#include "driver/summary.h"

namespace kadr::cli {

void ProgressLine::show(const driver::Progress& progress) {
    if (!is_terminal_ || Clock::now() < next_) return;
    next_ = Clock::now() + std::chrono::milliseconds(100);
    std::string text = fmt::format("\r{} blocks", progress.blocks);
    if (progress.setpoints > 0) text += fmt::format(", {} setpoints", progress.setpoints);
    if (progress.time > 0) text += ", " + driver::duration_text(progress.time) + " of machine time";
    text += "\033[K";
    std::fwrite(text.data(), 1, text.size(), stderr);
    is_shown_ = true;
}

void ProgressLine::clear() {
    if (!is_shown_) return;
    std::fputs("\r\033[K", stderr);
    is_shown_ = false;
}

}  // namespace kadr::cli
