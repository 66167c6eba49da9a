// The frame that the expander follows in its normal form is the one that the interpreter
// multiplies: the same points, whatever was said in which order and deleted again.
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/degrees.h"
#include "control/frame_steps.h"
#include "control/frames.h"

namespace kadr::control::frames_law_test {
namespace {

using nc::Function;
using Three = std::array<double, 3>;

struct Plane {
    Function function;
    path::Plane plane;
};

/// One function, said to both.
class Both {
  public:
    void say_any() {
        switch (*rc::gen::inRange(0, 10)) {
            case 0: return shift(true);
            case 1: return shift(false);
            case 2:
            case 3: return rotate();
            case 4: return scale();
            case 5: return mirror();
            case 6:
                said_ += "rotate_off ";
                steps_.rotate_off();
                frames_.rotate_off();
                return;
            case 7:
                said_ += "scale_off ";
                steps_.scale_off();
                frames_.scale_off();
                return;
            case 8: return mirror_off();
            // As a control has it whose text says the normal form.
            default:
                said_ += "say ";
                steps_.say(steps_.frame().frame);
                set_frames();
                return;
        }
    }
    bool has_fault() const { return steps_.frame().fault != FrameFormFault::None; }
    const std::string& said() const { return said_; }

    /// How far a point is from where the other has it.
    double apart(const Three& point) const {
        const ProgramFrame frame = steps_.frame().frame;
        Three p = point;
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = p[i] * (frame.is_mirrored[i] ? -1 : 1) * frame.scale[i] - frame.center[i];
        const std::size_t a =
            frame.plane == Function::PlaneZx ? 2 : frame.plane == Function::PlaneYz;
        const std::size_t b = (a + 1) % 3;
        const double c = cos_deg(frame.angle_deg), s = sin_deg(frame.angle_deg);
        const double x = c * p[a] - s * p[b], y = s * p[a] + c * p[b];
        p[a] = x;
        p[b] = y;
        AxisValues programmed{};
        for (std::size_t i = 0; i < 3; ++i) programmed[i] = point[i];
        const AxisValues base = frames_.to_base(programmed);
        double most = 0;
        for (std::size_t i = 0; i < 3; ++i)
            most = std::max(most, std::fabs(p[i] + frame.center[i] + frame.shift[i] - base[i]));
        return most;
    }

  private:
    static double any(int reach) { return *rc::gen::inRange(-reach, reach + 1) * 0.5; }
    static Three any_point() { return {any(20), any(20), any(20)}; }
    static FrameWords words(const Three& values, unsigned given = 7) {
        FrameWords words;
        for (std::size_t i = 0; i < 3; ++i) words.values[i] = values[i];
        words.given = given;
        return words;
    }

    void shift(bool adds) {
        const Three by = any_point();
        said_ += adds ? "shift_add " : "shift ";
        if (adds) steps_.shift_add(by, {true, true, true});
        else steps_.shift(by, {true, true, true});
        if (adds) frames_.shift_add(words(by));
        else frames_.shift(words(by));
    }
    void rotate() {
        constexpr std::array<Plane, 3> kPlanes = {{{Function::PlaneXy, path::Plane::Xy},
                                                   {Function::PlaneZx, path::Plane::Zx},
                                                   {Function::PlaneYz, path::Plane::Yz}}};
        const Plane plane = kPlanes[static_cast<std::size_t>(*rc::gen::element(0, 0, 0, 0, 1, 2))];
        const double angle = *rc::gen::element(30, 90, -45, 180, 17);
        const Three about = any_point();
        said_ += "rotate ";
        steps_.rotate(angle, plane.function, about);
        frames_.rotate(plane.plane, angle * kRadPerDeg, words(about));
    }
    void scale() {
        const auto factor = [] { return *rc::gen::element(0.5, 1.0, 2.0); };
        const double all = factor();
        const bool is_even = *rc::gen::inRange(0, 3) > 0;
        const Three by = is_even ? Three{all, all, all} : Three{factor(), factor(), factor()};
        const Three about = any_point();
        said_ += "scale ";
        steps_.scale(by, about);
        frames_.scale({by[0], by[1], by[2]}, words(about));
    }
    void mirror() {
        const auto axes = static_cast<unsigned>(*rc::gen::inRange(1, 8));
        said_ += "mirror ";
        steps_.mirror({(axes & 1u) != 0, (axes & 2u) != 0, (axes & 4u) != 0});
        frames_.mirror(words({}, axes));
    }
    void mirror_off() {
        const auto axes = static_cast<unsigned>(*rc::gen::inRange(0, 8));
        said_ += "mirror_off ";
        steps_.mirror_off(axes);
        frames_.mirror_off(static_cast<AxisMask>(axes));
    }
    /// The same in the order in which blocks say it.
    void set_frames() {
        const ProgramFrame frame = steps_.frame().frame;
        const path::Plane plane = frame.plane == Function::PlaneZx   ? path::Plane::Zx
                                  : frame.plane == Function::PlaneYz ? path::Plane::Yz
                                                                     : path::Plane::Xy;
        frames_.shift(words(frame.shift));
        unsigned mirrored = 0;
        for (unsigned i = 0; i < 3; ++i) mirrored |= frame.is_mirrored[i] ? 1u << i : 0;
        if (mirrored != 0) frames_.mirror(words({}, mirrored));
        const auto turn = [&] {
            if (frame.angle_deg != 0)
                frames_.rotate(plane, frame.inner_angle_deg() * kRadPerDeg,
                               words(frame.inner_center()));
        };
        if (frame.is_stretched(frame.plane)) turn();
        if (frame.has_scale())
            frames_.scale({frame.scale[0], frame.scale[1], frame.scale[2]}, words({}));
        if (!frame.is_stretched(frame.plane)) turn();
    }

    nc::Rules rules_ = nc::Rules::of_language();
    FrameSteps steps_;
    Frames frames_{rules_};
    std::string said_;
};

RC_GTEST_PROP(FramesLaw, NormalFormAndProductAreTheSame, ()) {
    Both both;
    // Now and then more than are kept apart (kMaxSteps).
    const int count = *rc::gen::weightedElement<int>({{6, 3}, {6, 9}, {1, 300}});
    for (int i = 0; i < count; ++i) {
        both.say_any();
        // Rotations in two planes, or inside of an unequal scale, have no normal form.
        if (both.has_fault()) return;
        for (const Three& point : {Three{0, 0, 0}, Three{10, -4, 3}, Three{-7, 1, 12}})
            if (both.apart(point) > 1e-9) RC_FAIL(both.said());
    }
}

}  // namespace
}  // namespace kadr::control::frames_law_test
