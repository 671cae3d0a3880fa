/// cos(theta) of each wall, 0 of one without a contact angle.
#pragma once
#include <vector>

namespace sph
{

struct WettingAngles
{
    std::vector<double> cosine;
};

}
