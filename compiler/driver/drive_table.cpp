#include "driver/drive_table.h"

#include <cmath>

#include "base/units.h"
#include "driver/columns.h"

namespace kadr::driver {

namespace {

/// m/min
double cutting_speed_of(const process::DriveSample& sample) {
    return sample.speed * std::abs(sample.tip[0]) * 60 / 1000;
}

}  // namespace

DriveTable::DriveTable(Output& out) : out_(out) {
    out_.write("t,tip_x,tip_y,tip_z,speed_set,speed,current,load,power,feed,cutting_speed,iso\n");
}

void DriveTable::add(const process::DriveSample& sample) {
    constexpr int kDecimals = 6;
    append_trimmed(text_, sample.time, kDecimals);
    for (int i = 0; i < 3; ++i) append_column(text_, sample.tip[i], kDecimals);
    append_column(text_, rpm_from_angular_speed(sample.wanted_speed), kDecimals);
    append_column(text_, rpm_from_angular_speed(sample.speed), kDecimals);
    append_column(text_, sample.current, kDecimals);
    append_column(text_, sample.load, kDecimals);
    append_column(text_, sample.load * sample.speed, kDecimals);
    append_column(text_, mm_min_from_feed(sample.feed), kDecimals);
    append_column(text_, cutting_speed_of(sample), kDecimals);
    append_column(text_, sample.line);
    text_ += '\n';
    if (text_.size() > 60000) flush();
}

void DriveTable::finish() { flush(); }

void DriveTable::flush() {
    out_.write(text_);
    text_.clear();
}

}  // namespace kadr::driver
