/// Positions of many points, one array per component; in 2-D z is 0.
#pragma once
#include "base/Vector.hpp"
#include <cstddef>
#include <vector>

namespace sph
{

struct Points
{
    std::vector<double> x, y, z;

    std::size_t size() const { return x.size(); }
    Vector<3> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, const Vector<3>& p)
    {
        x[i] = p.x;
        y[i] = p.y;
        z[i] = p.z;
    }
    void add(const Vector<3>& p)
    {
        x.push_back(p.x);
        y.push_back(p.y);
        z.push_back(p.z);
    }
    void resize(std::size_t n)
    {
        x.resize(n);
        y.resize(n);
        z.resize(n);
    }
};

}
