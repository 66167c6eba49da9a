// scan_field.h — from points on the workpiece to points in the field of a scanner.
//
// position = stage + matrix · field; what the lens distorts is added to the position in the field,
// from a table, bilinear between its crossings. A path becomes short vectors where it is bent, by
// itself or by the table, beyond the scanner's chord tolerance.
//
// source: reference motion §4
#pragma once

#include <cstddef>
#include <vector>

#include "machine/scanner_data.h"
#include "path/curve.h"

namespace kadr::process {

using Vec2 = Eigen::Vector2d;

/// The end of a vector.
struct FieldStep {
    Vec2 to = Vec2::Zero();     // what the mirrors are given, mm
    Vec2 field = Vec2::Zero();  // before the correction
    double share = 1;           // of the path's length, from its start to here
};

class ScanField {
  public:
    explicit ScanField(const machine::Scanner& scanner);

    /// The position in the field, before the correction.
    Vec2 field_of(const path::Vec3& point, const path::Vec3& stage) const;
    /// By how much a point lies outside of the field, mm; 0 inside.
    double outside(const Vec2& field) const;
    /// What the mirrors are given, for a point within the table.
    Vec2 corrected(const Vec2& field) const;

    /// A path as vectors, its start excluded; one for a straight line that stays straight.
    std::vector<FieldStep> vectors(const path::Curve& curve, const path::Vec3& stage) const;
    /// The end alone, for a jump.
    FieldStep end_of(const path::Curve& curve, const path::Vec3& stage) const;

  private:
    /// A path that is being cut, with the stage below it.
    struct StagedCurve {
        const path::Curve& curve;
        const path::Vec3& stage;
        double length;
    };

    FieldStep at(const StagedCurve& staged, double share) const;
    bool is_straight(const StagedCurve& staged, double from, double to) const;
    void cut(const StagedCurve& staged, double from, double to, std::vector<FieldStep>& out) const;
    std::vector<double> kinks(const StagedCurve& staged, const FieldStep& from,
                              const FieldStep& to) const;
    std::size_t probes(const StagedCurve& staged, double from, double to) const;

    const machine::Scanner& scanner_;
    Eigen::Matrix2d inverse_;
    double cell_ = 0;  // mm, least side of a cell of the table; 0: there is no table
};

}  // namespace kadr::process
