/// The cross-section of a duct at an inlet: the lines, parallel to its normal, along which particles come in.
///
/// The lines stand on a lattice that fills the fluid of the section; from wall to wall it is a little closer or wider than the spacing dx,
/// and the distance of the particles on a line makes up for it: dx^-d particles per volume on the whole. Where no lattice fits the walls they are
/// moved until the density is even (evenLines.hpp). A part that is cut out of a plane has those lines of the plane that lie within it, so that
/// what stands beside it continues its arrangement. Its particles fill `carried()`, which is more or less than its area by a part of a line's share, and a given rate takes a
/// velocity of rate/carried. The velocity has a profile u over the section, of mean 1: 1 everywhere, or that of developed flow of a uniform viscosity,
///
///   -laplacian(u) = const,    u = 0 at the walls,
///
/// by central differences on the lattice with the walls half a cell beyond its last lines: of second order between plane walls. Lines that were moved
/// have the values of a lattice four times as fine, interpolated.
#pragma once
#include "models/openings/Opening.hpp"
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

    /// `plane`: what the opening is a part of, whose lattice it takes; null where it stands alone.
    Section(const Opening&, const Geometry&, double spacing, const OpenPlane* plane = nullptr);

    const std::vector<Line>& lines() const { return lines_; }
    /// Distance between particles of one line [m].
    double rowSpacing() const { return rowSpacing_; }
    /// The area of the fluid, between its edges, which are found to 1e-12 of a spacing [m^2]; a length [m] in 2-D.
    double area() const { return area_; }
    /// The area that the particles of all lines fill: volume per length along the normal [m^2].
    double carried() const { return carried_; }
    /// The least of its two extents [m].
    double width() const;
    /// Index of the line nearest to a point; -1 where that is another opening's, and beside the section.
    int lineAt(const Vector<3>& x) const;

private:
    Vector<3> point_, across_[2]; ///< unit vectors along the plane
    int dimension_;
    double low_[2] = {0, 0}, step_[2] = {1, 1}; ///< of the lattice along them [m]
    double width_[2] = {0, 0};                  ///< of the fluid [m]
    int n_[2] = {0, 1};
    bool repeats_[2] = {false, false};
    std::vector<Line> lines_;
    /// A line of the plane: an index into lines_, or -1 where it is another opening's.
    struct OfPlane
    {
        Vector<3> foot;
        int line;
    };
    std::vector<std::vector<OfPlane>> cells_; ///< of the lattice, the lines that meet the plane there
    double rowSpacing_ = 0, area_ = 0, carried_ = 0;

    Vector<3> at(double a, double b) const { return point_ + a * across_[0] + b * across_[1]; }
    /// The number of a site of a lattice `finer` times as fine; -1 outside of it.
    int site(int i, int k, int finer = 1) const;
    int nearestSite(const Vector<3>& x) const;
    Vector<3> centre(int i, int k, int finer = 1) const;
    /// Open part of a plane: its area, its ends along `across_`, and whether all of its edges are walls or periodic faces.
    struct Extents
    {
        double area = 0, low[2] = {Box::infinity, Box::infinity}, high[2] = {-Box::infinity, -Box::infinity};
        bool walled = true;
    };
    Extents extentsOf(const auto& open, const Geometry&, double spacing) const;
    std::vector<Vector<3>> oneToASquare(const Extents& whole, double spacing, const auto& open) const;
    void developProfile(const auto& isFluid, int finer, const Location& where);
};

}
