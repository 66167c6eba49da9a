#include "macro/control_functions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <Eigen/Geometry>

#include "base/text.h"
#include "macro/control_value.h"
#include "nc/letters.h"

namespace kadr::macro {

using nc::is_digit;

namespace {

/// What stands behind a `%`.
struct Specifier {
    int width = 0;
    int decimals = 6;
    char kind = '\0';
};

/// `at` is behind the `%`; afterwards behind the letter.
Specifier specifier_at(std::string_view format, std::size_t& at) {
    constexpr int kMost = 200;  // no text is longer
    const auto number = [&](int otherwise) {
        if (at >= format.size() || !is_digit(format[at])) return otherwise;
        int value = 0;
        for (; at < format.size() && is_digit(format[at]); ++at)
            value = std::min(kMost, value * 10 + (format[at] - '0'));
        return value;
    };
    Specifier specifier;
    specifier.width = number(0);
    if (at < format.size() && format[at] == '.') {
        ++at;
        specifier.decimals = number(0);
    }
    if (at < format.size()) specifier.kind = format[at++];
    return specifier;
}

std::string printed(const char* format, int decimals, double value) {
    std::string out(512, '\0');
    const int length = std::snprintf(out.data(), out.size(), format, decimals, value);
    out.resize(static_cast<std::size_t>(std::clamp(length, 0, 511)));
    return out;
}

/// Nothing: the value is not of the kind that the letter takes.
std::optional<std::string> shown(const Specifier& specifier, const FormatValue& value) {
    const double whole = std::floor(value.number + 0.5);
    const bool is_whole = !value.is_text && std::fabs(whole) <= 2147483648.0;
    switch (specifier.kind) {
        case 'D':
            if (!is_whole) return std::nullopt;
            return printed("%.*f", 0, whole);
        case 'F':
            if (value.is_text) return std::nullopt;
            return printed("%.*f", specifier.decimals, value.number);
        case 'E':
            if (value.is_text) return std::nullopt;
            return printed("%.*E", specifier.decimals, value.number);
        case 'S':
            if (!value.is_text) return std::nullopt;
            return std::string(value.text);
        case 'C':
            if (value.is_text && count_code_points(value.text) == 1) return std::string(value.text);
            if (!is_whole || whole < 0 || whole > 255) return std::nullopt;
            return ControlValue::of(whole, nc::ValueType::Char).character();
        case 'B':
            if (value.is_text) return std::nullopt;
            return value.number != 0 ? "TRUE" : "FALSE";
        case 'X': {
            if (!is_whole) return std::nullopt;
            std::array<char, 16> digits{};
            const auto bits = static_cast<unsigned>(static_cast<std::int64_t>(whole));
            std::snprintf(digits.data(), digits.size(), "%X", bits);
            return std::string(digits.data());
        }
        default: return std::nullopt;
    }
}

/// Through three points: the two chords' bisectors meet in the centre.
std::optional<PlaneCircle> circle_through(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                          const Eigen::Vector2d& c) {
    const Eigen::Vector2d p = b - a;
    const Eigen::Vector2d q = c - a;
    const double area = p.x() * q.y() - p.y() * q.x();
    // Flatter than this the centre is farther away than any machine is long.
    constexpr double kFlat = 1e-9;
    if (std::fabs(area) <= kFlat * p.norm() * q.norm()) return std::nullopt;
    const Eigen::Vector2d to_center =
        Eigen::Vector2d{q.y() * p.squaredNorm() - p.y() * q.squaredNorm(),
                        p.x() * q.squaredNorm() - q.x() * p.squaredNorm()} /
        (2 * area);
    const Eigen::Vector2d center = a + to_center;
    return PlaneCircle{center.x(), center.y(), to_center.norm()};
}

Eigen::Matrix3d columns(std::span<const double, 9> points) {
    Eigen::Matrix3d out;
    for (Eigen::Index i = 0; i < 9; ++i) out(i % 3, i / 3) = points[static_cast<std::size_t>(i)];
    return out;
}

bool are_on_a_line(const Eigen::Matrix3d& points) {
    const Eigen::Vector3d p = points.col(1) - points.col(0);
    const Eigen::Vector3d q = points.col(2) - points.col(0);
    constexpr double kFlat = 1e-6;  // sine of the angle between two sides
    return p.cross(q).norm() <= kFlat * p.norm() * q.norm();
}

}  // namespace

Formatted format_text(std::string_view format, std::span<const FormatValue> values) {
    Formatted out;
    std::size_t next = 0;
    for (std::size_t at = 0; at < format.size();) {
        const std::size_t sign = at;
        if (format[at++] != '%') {
            out.text += format[sign];
            continue;
        }
        if (at < format.size() && format[at] == '%') {
            out.text += '%';
            ++at;
            continue;
        }
        const Specifier specifier = specifier_at(format, at);
        const auto text = next < values.size() ? shown(specifier, values[next]) : std::nullopt;
        ++next;
        if (!text) {
            out.wrong = format.substr(sign, at - sign);
            return out;
        }
        const auto width = static_cast<std::size_t>(specifier.width);
        const std::size_t length = count_code_points(*text);
        out.text.append(width > length ? width - length : 0, ' ').append(*text);
    }
    return out;
}

std::optional<PlaneCircle> circle_through(std::span<const double> points) {
    const std::size_t count = points.size() / 2;
    const auto at = [&](std::size_t i) {
        return Eigen::Vector2d{points[2 * i], points[2 * i + 1]};
    };
    PlaneCircle sum;
    double circles = 0;
    for (std::size_t left_out = 3; left_out < 4; --left_out) {
        // Of three points the fourth is left out alone.
        if (count == 3 && left_out != 3) break;
        std::array<Eigen::Vector2d, 3> of;
        std::size_t taken = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (i != left_out) of[taken++] = at(i);
        const auto circle = circle_through(of[0], of[1], of[2]);
        if (!circle) return std::nullopt;
        sum.x += circle->x;
        sum.y += circle->y;
        sum.radius += circle->radius;
        ++circles;
    }
    return PlaneCircle{sum.x / circles, sum.y / circles, sum.radius / circles};
}

MeasuredFrame measured_frame(std::span<const double, 9> ideal, std::span<const double, 9> real) {
    const Eigen::Matrix3d from = columns(ideal);
    const Eigen::Matrix3d to = columns(real);
    MeasuredFrame out;
    if (are_on_a_line(from) || are_on_a_line(to)) {
        out.error = are_on_a_line(from) ? -1 : -2;
        return out;
    }
    const Eigen::Matrix4d fit = Eigen::umeyama(from, to, false);
    out.frame.linear = fit.topLeftCorner<3, 3>();
    const Eigen::Vector3d shift = fit.topRightCorner<3, 1>();
    for (Eigen::Index i = 0; i < 3; ++i) out.frame.shift[static_cast<std::size_t>(i)] = shift[i];
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Eigen::Vector3d point = out.frame.linear * from.col(i) + shift;
        out.error += (point - to.col(i)).norm() / 3;
    }
    return out;
}

}  // namespace kadr::macro
