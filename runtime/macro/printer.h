// printer.h — where the lines go that a program prints.
#pragma once

#include <string_view>

namespace kadr::macro {

class PrintTarget {
  public:
    virtual ~PrintTarget() = default;
    /// One whole line, without its end.
    virtual void line(std::string_view text) = 0;
};

}  // namespace kadr::macro
