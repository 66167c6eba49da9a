#include "driver/property_values.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace kadr::driver {

using sema::ParameterInfo;

namespace {

constexpr int kDigits = 5;  // of a number between the ends of its range
constexpr int kMostDecimals = 9;

/// As the compiler reads `200mm/min`: exact where the factor is one over a whole number.
double in_registers(double shown, double factor) {
    const double inverse = std::nearbyint(1 / factor);
    const bool divides = factor < 1 && std::fabs(1 / factor - inverse) < 1e-9;
    return divides ? shown / inverse : shown * factor;
}

}  // namespace

std::uint64_t Dice::next() {
    // Steele, Lea, Flood: Fast splittable pseudorandom number generators (2014).
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

std::uint64_t Dice::below(std::uint64_t sides) { return sides == 0 ? next() : next() % sides; }

double Dice::unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

PropertyValues::PropertyValues(const sema::Code& code, const sema::FunctionCode& property)
    : code_(code), property_(property) {
    for (std::size_t i = 0; i < property.parameters.size(); ++i) {
        const ParameterInfo& parameter = property.parameters[i];
        const sema::PropertyRange& range = property.ranges[i];
        Space space;
        switch (parameter.kind) {
            case ParameterInfo::Kind::Bool: space.most = 1; break;
            case ParameterInfo::Kind::Enum:
                space.most =
                    static_cast<std::int64_t>(code.enums[parameter.enumeration].members.size()) - 1;
                break;
            case ParameterInfo::Kind::Integer:
                space.least = range.from.integer;
                space.most = range.to.integer;
                break;
            default: {
                space.is_number = true;
                space.from = round_to(range.from.number / range.factor, kMostDecimals);
                space.to = round_to(range.to.number / range.factor, kMostDecimals);
                const double width = space.to - space.from;
                const int leading = width > 0 ? static_cast<int>(std::floor(std::log10(width))) : 0;
                space.decimals = std::clamp(kDigits - 1 - leading, 0, kMostDecimals);
                break;
            }
        }
        spaces_.push_back(space);
    }
}

PropertyValues::Choice PropertyValues::end(std::size_t parameter, bool is_upper) const {
    const Space& space = spaces_[parameter];
    Choice choice;
    if (space.is_number) choice.number = is_upper ? space.to : space.from;
    else choice.whole = is_upper ? space.most : space.least;
    return choice;
}

PropertyValues::Choice PropertyValues::any(std::size_t parameter, Dice& dice) const {
    const Space& space = spaces_[parameter];
    Choice choice;
    if (space.is_number) {
        const double value = space.from + dice.unit() * (space.to - space.from);
        choice.number = std::clamp(round_to(value, space.decimals), space.from, space.to);
    } else {
        const auto sides =
            static_cast<std::uint64_t>(space.most) - static_cast<std::uint64_t>(space.least) + 1;
        choice.whole =
            static_cast<std::int64_t>(static_cast<std::uint64_t>(space.least) + dice.below(sides));
    }
    return choice;
}

PropertyValues::Set PropertyValues::choose(std::uint64_t run, Dice& dice) const {
    const std::size_t count = spaces_.size();
    Set set(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t luck = dice.below(8);
        set[i] = run < 2 ? end(i, run == 1) : luck < 2 ? end(i, luck == 1) : any(i, dice);
    }
    if (run >= 2 && run - 2 < 2 * count) {
        const auto at = static_cast<std::size_t>((run - 2) / 2);
        set[at] = end(at, run % 2 == 1);
    }
    return set;
}

void PropertyValues::add_simpler(const Set& set, std::size_t parameter,
                                 std::vector<Set>& sets) const {
    const Space& space = spaces_[parameter];
    const auto add = [&](Choice choice) {
        Set other = set;
        other[parameter] = choice;
        if (choice == set[parameter]) return;
        if (std::find(sets.begin(), sets.end(), other) == sets.end())
            sets.push_back(std::move(other));
    };
    if (!space.is_number) {
        const std::int64_t now = set[parameter].whole;
        const std::int64_t zero = std::clamp<std::int64_t>(0, space.least, space.most);
        // The whole distance, half of it, a quarter … one step.
        for (std::int64_t way = now - zero; way != 0; way /= 2) add({now - way, 0});
        return;
    }
    const double now = set[parameter].number;
    const double zero = std::clamp(0.0, space.from, space.to);
    const double step = std::pow(10.0, -space.decimals);
    // With fewer digits, towards zero; then nearer by half of the distance and so on.
    for (int decimals = 0; decimals < space.decimals; ++decimals) {
        double rounded = round_to(now, decimals);
        if (std::fabs(rounded - zero) > std::fabs(now - zero)) {
            rounded =
                round_to(now - std::copysign(std::pow(10.0, -decimals), now - zero), decimals);
        }
        rounded = std::clamp(rounded, space.from, space.to);
        const bool is_nearer = std::fabs(rounded - zero) < std::fabs(now - zero);
        if (is_nearer) add({0, rounded});
    }
    for (double distance = now - zero; std::fabs(distance) >= step / 2; distance /= 2) {
        const double nearer = round_to(now - distance, space.decimals);
        if (std::fabs(nearer - zero) < std::fabs(now - zero)) add({0, nearer});
    }
    if (zero != now) {
        // The boldest of all.
        Set boldest = set;
        boldest[parameter].number = zero;
        sets.erase(std::remove(sets.begin(), sets.end(), boldest), sets.end());
        sets.insert(sets.begin(), std::move(boldest));
    }
}

std::vector<PropertyValues::Set> PropertyValues::simpler(const Set& set) const {
    std::vector<Set> sets;
    for (std::size_t i = 0; i < spaces_.size(); ++i) {
        std::vector<Set> own;
        add_simpler(set, i, own);
        sets.insert(sets.end(), own.begin(), own.end());
    }
    return sets;
}

std::vector<sema::Slot> PropertyValues::slots(const Set& set) const {
    std::vector<sema::Slot> slots;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const ParameterInfo& parameter = property_.parameters[i];
        sema::Slot slot{};
        if (!spaces_[i].is_number) {
            slot.integer = set[i].whole;
            if (parameter.kind == ParameterInfo::Kind::Enum) {
                slot.integer = code_.enums[parameter.enumeration]
                                   .members[static_cast<std::size_t>(set[i].whole)]
                                   .second;
            }
        } else if (const double factor = property_.ranges[i].factor; factor >= 0x1p300) {
            slot.number =
                in_registers(set[i].number, factor / sema::kSecondForm) * sema::kSecondForm;
        } else {
            slot.number = in_registers(set[i].number, factor);
        }
        slots.push_back(slot);
    }
    return slots;
}

std::vector<std::string> PropertyValues::words(const Set& set) const {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const ParameterInfo& parameter = property_.parameters[i];
        std::string value;
        if (spaces_[i].is_number) {
            value = format_shortest(round_to(set[i].number, kMostDecimals));
            value += property_.ranges[i].unit;
        } else if (parameter.kind == ParameterInfo::Kind::Bool) {
            value = set[i].whole != 0 ? "true" : "false";
        } else if (parameter.kind == ParameterInfo::Kind::Enum) {
            value = code_.enums[parameter.enumeration]
                        .members[static_cast<std::size_t>(set[i].whole)]
                        .first;
        } else {
            value = std::to_string(set[i].whole);
        }
        words.push_back(parameter.name + '=' + value);
    }
    return words;
}

}  // namespace kadr::driver
