// property_values.h — random values for the parameters of a property, and simpler ones that may
// fail as well.
//
// Values are chosen as a person writes them, 21.5 mm or 230 mm/min, so that a set of values that
// fails can be given again on the command line and is the same to the last bit.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sema/code.h"

namespace kadr::driver {

/// Numbers that look random and are the same everywhere (splitmix64).
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next();
    /// 0 to `sides` - 1.
    std::uint64_t below(std::uint64_t sides);
    double unit();  // 0 ≤ … < 1

  private:
    std::uint64_t state_;
};

class PropertyValues {
  public:
    /// The value of one parameter: `whole` of whole numbers, truth values and members of an enum
    /// (their index); `number` of others, in the unit that it is shown in.
    struct Choice {
        std::int64_t whole = 0;
        double number = 0;
        friend bool operator==(const Choice&, const Choice&) = default;
    };
    using Set = std::vector<Choice>;

    /// References outlive the object.
    PropertyValues(const sema::Code& code, const sema::FunctionCode& property);

    /// The set for one run of many: first all least and all greatest values, then each parameter
    /// at its ends with the others at random, then anything.
    Set choose(std::uint64_t run, Dice& dice) const;
    /// Sets that differ in one parameter, which is simpler: nearer to zero or to the first member,
    /// or with fewer digits. The boldest first.
    std::vector<Set> simpler(const Set& set) const;

    /// As registers of the property.
    std::vector<sema::Slot> slots(const Set& set) const;
    /// `w=21.5mm`, for each parameter.
    std::vector<std::string> words(const Set& set) const;

  private:
    struct Space {
        bool is_number = false;
        std::int64_t least = 0;
        std::int64_t most = 0;
        double from = 0;  // in the shown unit
        double to = 0;
        int decimals = 0;  // of values between
    };
    Choice end(std::size_t parameter, bool is_upper) const;
    Choice any(std::size_t parameter, Dice& dice) const;
    void add_simpler(const Set& set, std::size_t parameter, std::vector<Set>& sets) const;

    const sema::Code& code_;
    const sema::FunctionCode& property_;
    std::vector<Space> spaces_;
};

}  // namespace kadr::driver
