#include "motion/stretch_window.h"

namespace kadr::motion {

void StretchWindow::append(const Stretch& piece, double exit_limit) {
    if (kind_.gathers) {
        gathered_.add(piece, exit_limit);
        append_complete();
        return;
    }
    lookahead_.append(piece);
    if (kind_.keeps_limits) stretches_.push_back(piece);
}

void StretchWindow::append_complete() {
    for (const Stretch& stretch : gathered_.complete()) {
        lookahead_.append(stretch);
        stretches_.push_back(stretch);
    }
    gathered_.clear();
}

void StretchWindow::finish() {
    gathered_.finish();
    append_complete();
    lookahead_.finish();
}

}  // namespace kadr::motion
