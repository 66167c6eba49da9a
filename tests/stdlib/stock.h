// stock.h — a block of material on a grid, cut by an end mill: what a milling cycle leaves behind.
//
// The height of the material is kept per cell; a move of the cutter lowers the cells that its flat
// end passes. It is slow and simple on purpose: nothing of the interpreter or of the planner is in
// it but the commands that came out.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace stdlib_test {

struct Place {
    double x = 0, y = 0, z = 0;
};

/// Signed distance of a place from the border of a shape: negative inside.
using Shape = std::function<double(double x, double y)>;

Shape disc(double d);
/// With rounded corners of radius r.
Shape rectangle(double w, double h, double r);
/// Round ends; from end to end along X.
Shape stadium(double l, double w);
/// A slot of the width w along a circle of the diameter d, with round ends, angles in degrees.
Shape bent_stadium(double d, double start_deg, double arc_deg, double w);

/// What must never happen to a cutter, in the order in which it happened.
struct Fault {
    std::string what;
    std::string command;
};

class Stock {
  public:
    /// half: half the side of the square grid; cell: size of a cell; top: height of the material
    /// where `blank` is negative, mm.
    Stock(double half, double cell, double top, const Shape& blank);

    /// Lowers the material where the shape is positive, before anything is cut.
    void lower_outside(const Shape& shape, double to);
    /// Cuts by all commands, in mm. A chamfering cutter has a flat tip of the diameter tool_d and
    /// above it a cone 6 mm wide all around; 180 degrees is an end mill.
    void cut(const std::vector<nlohmann::json>& commands, double tool_d, double tip_deg = 180);
    /// Height of the material in the cell at a place.
    double height_at(double x, double y) const;

    /// Rapid into material, straight down into material at feed.
    const std::vector<Fault>& faults() const { return faults_; }
    /// Deepest cut of one command.
    double deepest_cut() const { return deepest_; }
    /// Lowest place that the tool reached, and where it stood at the end.
    double lowest() const { return lowest_; }
    Place position() const { return position_; }

    /// The first cell that is not as it should be: `floor` where the shape is below -margin, `top`
    /// (untouched) where it is above +edge. Empty if all are right.
    std::string difference(const Shape& shape, double floor, double margin, double edge) const;
    /// As it should be of a spigot: untouched inside the shape, `floor` elsewhere in the blank.
    std::string spigot_difference(const Shape& shape, double floor, double margin,
                                  double edge) const;

  private:
    void move(const Place& to, const nlohmann::json& command);
    void press(const Place& at, bool is_rapid, bool is_plunge, const nlohmann::json& command);
    double center(int i) const { return -half_ + (i + 0.5) * cell_; }

    double half_, cell_, top_;
    int n_;
    Shape blank_;
    std::vector<double> height_;
    double radius_ = 0, tip_radius_ = 0;
    double rise_ = 0;  // of the cone per mm of its radius
    Place position_;
    bool has_position_ = false;
    double deepest_ = 0;
    double lowest_ = 1e9;
    std::vector<double> before_;
    std::vector<Fault> faults_;
};

}  // namespace stdlib_test
