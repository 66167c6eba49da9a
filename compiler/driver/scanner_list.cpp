#include "driver/scanner_list.h"

#include "driver/columns.h"

namespace kadr::driver {

namespace {

constexpr int kPlaceDecimals = 6;
constexpr int kTimeDecimals = 3;   // of a microsecond
constexpr int kSpeedDecimals = 6;  // of mm/s and Hz

void put_number(std::string& out, double value, int decimals) {
    out += ' ';
    append_trimmed(out, value, decimals);
}

void put_time(std::string& out, double seconds) { put_number(out, seconds * 1e6, kTimeDecimals); }

}  // namespace

ScannerText::ScannerText(const machine::Scanner& scanner, Output& out) : out_(out) {
    const machine::ScannerDelays& delays = scanner.delays;
    text_ = "# scanner lists: mm, us, mm/s\nset_jump_speed";
    put_number(text_, scanner.jump_speed, kSpeedDecimals);
    text_ += "\nset_delays";
    for (const double delay : {delays.jump, delays.mark, delays.polygon}) put_time(text_, delay);
    text_ += delays.polygon_turning ? " turning" : " fixed";
    text_ += "\nset_laser_delays";
    for (const double delay : {delays.laser_on, delays.laser_off}) put_time(text_, delay);
    text_ += '\n';
    if (scanner.pulse > 0) {
        text_ += "set_pulse";
        put_number(text_, scanner.pulse, kSpeedDecimals);
        text_ += '\n';
    }
    out_.write(text_);
}

void ScannerText::write(const process::StartedList& started) {
    text_ = "list_begin " + std::to_string(++lists_);
    put_time(text_, started.start_time);
    for (const double place : started.stage) put_number(text_, place, kPlaceDecimals);
    text_ += '\n';
    for (const process::ScanCommand& command : started.list.commands) put_command(command);
    text_ += "list_end";
    put_time(text_, started.list.duration);
    text_ += '\n';
    out_.write(text_);
}

void ScannerText::put_command(const process::ScanCommand& command) {
    using Kind = process::ScanCommand::Kind;
    const auto put_vector = [&](const char* name) {
        text_ += name;
        put_number(text_, command.to.x(), kPlaceDecimals);
        put_number(text_, command.to.y(), kPlaceDecimals);
        put_time(text_, command.value);
    };
    switch (command.kind) {
        case Kind::MarkSpeed:
            text_ += "set_mark_speed";
            put_number(text_, command.value, kSpeedDecimals);
            break;
        case Kind::Jump: put_vector("jump_abs"); break;
        case Kind::Mark: put_vector("mark_abs"); break;
        case Kind::Micro: put_vector("micro_abs"); break;
        case Kind::Wait:
            text_ += "wait";
            put_time(text_, command.value);
            break;
        case Kind::Expose:
            text_ += "expose";
            put_time(text_, command.value);
            break;
    }
    text_ += '\n';
}

void ScannerText::finish(const std::string& alarm) {
    if (!alarm.empty()) out_.write("# not complete, ended by " + alarm + '\n');
}

}  // namespace kadr::driver
