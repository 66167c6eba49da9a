// readable.h — numbers in messages.
#pragma once

#include <string>

namespace kadr {

/// A number for a person to read: rounded to a millionth, a small one to six digits, and to no more
/// than twelve, so that neither the noise of the last binary digit nor that of a calculation is
/// shown: `10` for 10.000000001, `0.3`, `0.000012`. No exponent for what people write without one.
std::string readable(double value);

}  // namespace kadr
