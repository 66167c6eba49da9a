// profile.h — a turned part as its height over the way of the tool, cut by a turning tool: what a
// turning cycle leaves behind.
//
// Every case is looked at in one view: the cuts run down the way t and follow each other down the
// height h. Along the axis t is Z and h the radius (in a bore: the radius with its sign changed);
// across it t is the radius and h is Z. Slow and simple on purpose, as stock.h.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace stdlib_test {

struct ProfilePoint {
    double h = 0, t = 0;
};

/// A line or an arc of less than half a turn, to `to`.
struct ProfileElement {
    ProfilePoint to;
    double radius = 0;     // of an arc
    bool is_left = false;  // it turns left, seen with t to the right and h up
};

/// A contour that runs down the way.
struct ProfileShape {
    ProfilePoint start;
    std::vector<ProfileElement> elements;

    double lowest() const;
    double highest() const;
    ProfilePoint end() const { return elements.back().to; }
    /// Close points on it …
    std::vector<ProfilePoint> path() const;
    /// … and on the face below its start and the wall above its end.
    std::vector<ProfilePoint> points() const;
};

struct ProfileView {
    bool is_facing = false;
    double side = 1;  // -1 in a bore
};

/// A tool of which the tip is programmed that both axes touch; of a grooving tool the left corner.
struct TurningTool {
    double nose = 0;              // radius
    double back_deg = 0;          // how steeply its back rises
    double width = 0;             // of a grooving tool
    bool rapids_in_both = false;  // the cycle moves both axes at once at rapid
};

class Profile {
  public:
    Profile(double t_low, double t_high, double cell);
    /// Material up to a height between two places.
    void fill(double t_low, double t_high, double h);
    void cut(const std::vector<nlohmann::json>& commands, const ProfileView& view,
             const TurningTool& tool);

    double cell() const { return cell_; }
    double place(std::size_t i) const { return t_low_ + (static_cast<double>(i) + 0.5) * cell_; }
    const std::vector<double>& heights() const { return height_; }
    /// Deepest cut of one command at feed.
    double deepest_cut() const { return deepest_; }
    /// Rapid into material, the back of the tool in material, rapid in two axes.
    const std::vector<std::string>& faults() const { return faults_; }
    /// Where the tool stands, as radius and Z.
    double x() const { return x_; }
    double z() const { return z_; }

    /// What must stay, in the same cells: the shape, `allowance` beside it, moved by more_h and
    /// more_t; with what a nose cannot reach.
    std::vector<double> kept(const ProfileShape& shape, double allowance, double more_h,
                             double more_t, double nose) const;

  private:
    void travel(const std::vector<ProfilePoint>& points, const TurningTool& tool);
    void press(const ProfilePoint& tip, const TurningTool& tool);
    void check_back(const ProfilePoint& tip, const TurningTool& tool, const std::string& command);
    std::size_t index(double t) const;

    double t_low_, cell_;
    std::vector<double> height_;
    double deepest_ = 0;
    std::vector<std::string> faults_;
    bool has_position_ = false;
    double x_ = 0, z_ = 0;
};

}  // namespace stdlib_test
