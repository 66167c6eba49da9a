// out_of_memory.h — how the program ends when there is no memory left: one message, status 1.
#pragma once

#include "driver/messages.h"

namespace kadr::cli {

/// From here on a thread that finds no memory ends the program with the message, too: nobody
/// catches what it throws. Outputs that were begun have no name yet and vanish.
void end_without_memory();

/// Whether the message is for a person or for a program.
void say_out_of_memory_as(driver::MessageFormat format);

/// Writes the message to standard error, without asking for memory. Returns the exit status.
int report_out_of_memory();

}  // namespace kadr::cli
