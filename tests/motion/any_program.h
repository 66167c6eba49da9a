// any_program.h — random machines and programs for the properties of the motion.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <rapidcheck/gtest.h>

#include "tests/motion/support.h"

namespace kadr::motion::test {

inline double any_number(int low, int high) {
    return *rc::gen::inRange(low * 1000, high * 1000 + 1) / 1000.0;
}

inline Vec3 any_point(int reach) {
    const double x = any_number(-reach, reach), y = any_number(-reach, reach);
    return {x, y, any_number(-reach, reach)};
}

inline machine::Machine any_machine() {
    Dynamics dynamics;
    for (int i = 0; i < 3; ++i) {
        dynamics.velocity[i] = any_number(20, 1500);
        dynamics.acceleration[i] = any_number(100, 20000);
    }
    if (*rc::gen::inRange(0, 3) > 0) {
        // From an axis that takes half a second to its acceleration to one that takes 4 ms.
        for (int i = 0; i < 3; ++i)
            dynamics.jerk[i] = dynamics.acceleration[i] * any_number(2, 250);
    }
    auto machine = machine_of(dynamics);
    machine.tick = *rc::gen::element(0.0005, 0.001, 0.002, 0.008);
    return machine;
}

/// A turn about a random centre in the plane, with height, from where the tip stands.
inline Command any_arc(const Vec3& from) {
    const Vec3 center = from + Vec3(any_number(-30, 30), any_number(1, 30), 0);
    const double sweep = any_number(-7, 7);
    if (std::abs(sweep) < 1e-3) return line_to(from, 1000);
    const Vec3 out = from - center;
    const double c = std::cos(sweep), s = std::sin(sweep);
    const Vec3 to =
        center + Vec3(c * out[0] - s * out[1], s * out[0] + c * out[1], any_number(-5, 5));
    return arc_to(to, {center[0], center[1], 0}, sweep, any_number(500, 60000));
}

/// A span that goes on in about one direction, bent and weighted at random.
inline Command any_spline(const Vec3& from) {
    const Vec3 delta(any_number(5, 60), 0, 0);
    const auto pole = [&](double share) { return Vec3(from + delta * share + any_point(4)); };
    const double w1 = any_number(1, 3), w2 = any_number(1, 3);
    return spline_to(from + delta, pole(1.0 / 3), pole(2.0 / 3), any_number(500, 60000),
                     {1, w1, w2, 1});
}

inline path::Blending any_blending() {
    const double size = any_number(0, 2) * *rc::gen::element(1.0, 0.1, 0.01);
    return *rc::gen::arbitrary<bool>() ? by_distance(size)
                                       : within(size, *rc::gen::arbitrary<bool>());
}

/// Lines of all lengths, arcs, splines, rapids, exact stops and dwells, mixed.
inline std::vector<Command> any_program() {
    std::vector<Command> program;
    Vec3 at = Vec3::Zero();
    const int count = *rc::gen::inRange(1, 40);
    for (int i = 0; i < count; ++i) {
        const int kind = *rc::gen::inRange(0, 11);
        Command command;
        if (kind < 5) {
            const int reach = *rc::gen::element(1, 5, 100);
            command = line_to(at + any_point(reach) * *rc::gen::element(1.0, 0.01),
                              any_number(500, 60000));
        } else if (kind < 7) {
            command = any_arc(at);
        } else if (kind < 9) {
            command = rapid_to(any_point(200));
        } else if (kind < 10) {
            command = any_spline(at);
        } else {
            command = simple(Op::Dwell);
            command.dwell().time = any_number(0, 1);
            program.push_back(command);
            continue;
        }
        command.motion().exact_stop = *rc::gen::inRange(0, 5) == 0;
        if (*rc::gen::inRange(0, 3) == 0) command.motion().blending = any_blending();
        at = Vec3(command.motion().to[0], command.motion().to[1], command.motion().to[2]);
        program.push_back(command);
    }
    return program;
}

}  // namespace kadr::motion::test
