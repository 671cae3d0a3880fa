/// The particles of all ranks, behind one another on the first of them, for function objects. One process alone shows its own.
#pragma once
#include "case/Cloud.hpp"
#include "parallel/Ranks.hpp"
#include <deque>

namespace sph
{

class WholeCloud
{
    std::size_t own_, size_;
    std::deque<std::vector<double>> arrays_; ///< that views show: they last as long as this

public:
    /// `own`: this rank's particles. All ranks ask for the same, in the same order.
    explicit WholeCloud(std::size_t own);
    /// 0 but on the first rank.
    std::size_t size() const { return size_; }
    const double* whole(const double* own);
    FieldView whole(FieldView own);
};

}
