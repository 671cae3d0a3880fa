/// A loop whose rounds do not cost the same, on all threads: each takes pieces of a stretch of its own first, the same in every loop over as many rounds, so that it
/// finds in its cache what it has touched before; who is through helps others.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <omp.h>
#include <vector>

namespace sph
{

class Stretches
{
    struct alignas(64) Stretch
    {
        std::atomic<std::size_t> next{0};
        std::size_t end = 0;
    };
    static constexpr std::size_t piecesEach = 32; ///< of a thread at least: what one waits for in the end is a piece
    std::size_t piece_;
    std::vector<Stretch> stretches_;

public:
    /// Divides the rounds 0 .. n - 1, in pieces of `most` at most; made outside of the parallel region, anew for each loop.
    Stretches(std::size_t n, std::size_t most) : stretches_(std::size_t(omp_get_max_threads()))
    {
        const std::size_t threads = stretches_.size();
        piece_ = std::clamp<std::size_t>(n / (piecesEach * threads), 1, most);
        const std::size_t pieces = (n + piece_ - 1) / piece_;
        for (std::size_t t = 0; t < threads; ++t)
        {
            stretches_[t].next = t * pieces / threads * piece_;
            stretches_[t].end = std::min(n, (t + 1) * pieces / threads * piece_);
        }
    }

    /// f(begin, end) of each piece, by the threads of the parallel region around it.
    template<class F> void forEach(const F& f)
    {
        for (std::size_t k = 0; k < stretches_.size(); ++k)
        {
            auto& [next, end] = stretches_[(std::size_t(omp_get_thread_num()) + k) % stretches_.size()];
            for (std::size_t begin; (begin = next.fetch_add(piece_, std::memory_order_relaxed)) < end;)
                f(begin, std::min(end, begin + piece_));
        }
    }
};

}
