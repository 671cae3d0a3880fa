/// The cross-section of a duct at an inlet: the lines, parallel to its normal, along which particles come in.
///
/// The lines stand on a lattice that fills the fluid of the section; from wall to wall it is a little closer or wider than the spacing dx,
/// and the distance of the particles on a line makes up for it and for a round section's rim: dx^d particles per volume on the whole. The
/// velocity has a profile u over the section, of mean 1: 1 everywhere, or that of developed flow of a uniform viscosity,
///
///   -laplacian(u) = const,    u = 0 at the walls,
///
/// by central differences on the lattice with the walls half a cell beyond its last lines: of second order between plane walls.
#pragma once
#include "Opening.hpp"
#include <vector>

namespace sph
{

class Section
{
public:
    /// A line: where it meets the plane [m], and u there.
    struct Line
    {
        Vector<3> foot;
        double profile;
    };

    Section(const Opening&, const Geometry&, double spacing);

    const std::vector<Line>& lines() const { return lines_; }
    /// Between particles of one line [m].
    double rowSpacing() const { return rowSpacing_; }
    /// Of the fluid [m^2]; a length [m] in 2-D.
    double area() const { return area_; }
    /// The least of its two extents [m].
    double width() const;
    /// Index of the line nearest to a point; -1 where the lattice has none.
    int lineAt(const Vector<3>& x) const;

private:
    Vector<3> point_, across_[2]; ///< unit vectors along the plane
    int dimension_;
    double low_[2] = {0, 0}, step_[2] = {1, 1}, extent_[2] = {0, 0}; ///< of the lattice along them [m]
    int n_[2] = {0, 1};
    bool repeats_[2] = {false, false};
    std::vector<int> index_; ///< of the lattice's sites into lines_; -1: solid
    std::vector<Line> lines_;
    double rowSpacing_ = 0, area_ = 0;

    Vector<3> at(double a, double b) const { return point_ + a * across_[0] + b * across_[1]; }
    int site(int i, int k) const;
    void findExtents(const Opening&, const Geometry&, double spacing);
    void developProfile(const Location& where);
};

}
