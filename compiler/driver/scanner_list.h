// scanner_list.h — what a scanner is given in a run, as a text.
//
// One command a line. Positions are millimetres in the field, as the mirrors get them, times are
// microseconds, speeds mm/s on the workpiece:
//
//     set_jump_speed V                   once, in front of the lists
//     set_delays JUMP MARK POLYGON K     K `fixed`, or `turning`: with the angle at the corner
//     set_laser_delays ON OFF
//     set_pulse F                        Hz; left out if the beam is continuous
//     list_begin N T X Y Z               number, start from the start of the program, the stage
//     set_mark_speed V
//     jump_abs X Y T                     beam off, in T
//     mark_abs X Y T                     beam on
//     micro_abs X Y T                    a mark without a delay behind it: a bent path goes on
//     wait T                             in place, beam off
//     expose T                           in place, beam on
//     list_end T                         how long the list takes, the delays included
//
// The controller puts the delays in by itself; no line stands for them.
#pragma once

#include <cstdint>
#include <string>

#include "driver/output.h"
#include "machine/scanner_data.h"
#include "process/scanner.h"

namespace kadr::driver {

class ScannerText {
  public:
    /// Begins the text. The output outlives this.
    ScannerText(const machine::Scanner& scanner, Output& out);

    void write(const process::StartedList& list);
    /// Behind the last list.
    ///
    /// alarm  what ended the run before its end; empty: nothing did
    void finish(const std::string& alarm);

  private:
    void put_command(const process::ScanCommand& command);

    Output& out_;
    std::uint64_t lists_ = 0;
    std::string text_;
};

}  // namespace kadr::driver
