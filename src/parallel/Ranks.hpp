/// The processes that share the particles of one run (MPI calls them ranks). The rule is one process: then `ranks()` is null, nothing communicates, and no
/// library for it is loaded.
#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sph
{

/// A box of space that one rank owns, low and high corner [m]; its outer faces are infinitely far.
struct RankBox
{
    std::array<double, 3> low, high;
};

class Ranks
{
public:
    virtual ~Ranks() = default;
    int rank() const { return rank_; }
    int count() const { return count_; }

    /// Bytes for or from a rank.
    struct Message
    {
        int rank;
        std::span<std::byte> bytes;
    };
    /// The same number of bytes from each rank, in their order, on all.
    virtual void gatherAll(std::span<const std::byte> part, std::span<std::byte> all) const = 0;
    /// One number to each rank, and what each had for this one.
    virtual std::vector<std::size_t> exchangeCounts(std::span<const std::size_t> toEach) const = 0;
    /// Messages under way. Their bytes stay where they are until all have come and gone, which the destructor too waits for.
    class Exchange
    {
    public:
        virtual ~Exchange() = default;
        /// Brings them on while there is something else to do; by the thread that has started them.
        virtual void progress() = 0;
    };
    /// Messages whose lengths both sides know.
    virtual std::unique_ptr<Exchange> start(std::span<const Message> send, std::span<const Message> receive) const = 0;
    /// Waits until all have come and gone.
    void exchange(std::span<const Message> send, std::span<const Message> receive) const { start(send, receive); }
    /// Cuts space so that each rank has about the same sum of weights. `x` three numbers a place, of this rank's particles.
    virtual std::vector<RankBox> cut(int dimension, std::span<const double> x, std::span<const float> weights) const = 0;
    virtual void barrier() const = 0;
    /// A file in which each rank writes where it likes; all close it. Throws std::runtime_error with the reason.
    class SharedFile
    {
    public:
        virtual ~SharedFile() = default;
        virtual void write(std::size_t at, std::string_view bytes) = 0;
        virtual void close() = 0;
    };
    /// Makes one that is not there yet, on all ranks, or throws on all.
    virtual std::unique_ptr<SharedFile> create(const std::filesystem::path&) const = 0;
    /// In all that has been exchanged, gathered and waited for so far [s]: wall time, and processor time of this process.
    struct Waited
    {
        double wall = 0, processor = 0;
    };
    const Waited& waited() const { return waited_; }
    /// Ends all ranks, with exit code 1.
    virtual void abort() const = 0;

protected:
    int rank_ = 0, count_ = 1;
    mutable Waited waited_;
};

/// Null where one process is alone, and within the scope of an Alone.
const Ranks* ranks();

/// Joins those that mpirun has started. Throws std::runtime_error where a library is missing.
void startRanks();
/// Whether this process reads, writes and speaks for all; also where it is alone.
bool isFirstRank();
bool isLastRank();
/// Processor time of this process, all threads together, without what it spent in waiting for others [s].
double busyTime();
/// Reading the case in turns: the first rank brings about what it needs, and ends the run by what it throws, before the others look.
void waitForFirst();
void firstIsThrough();

/// All ranks act. What one throws, the first of them where there are several, all throw, as a CaseError of the same words: they go on or end together.
/// The act must not wait for other ranks.
void allOrNone(const std::function<void()>& act);
/// The first rank acts for all, who wait until it is through, or throw what it throws.
void byFirst(const std::function<void()>& act);

/// What this process does within its scope it does for itself: sums are of what it is given.
class Alone
{
    const Ranks* before_;

public:
    Alone();
    ~Alone();
    Alone(const Alone&) = delete;
    Alone& operator=(const Alone&) = delete;
};

/// The parts of all ranks, of any lengths, behind one another on the first; elsewhere nothing.
template<class T> std::vector<T> gatherOnFirst(const Ranks& all, std::span<const T> part)
{
    std::vector<std::size_t> lengths(std::size_t(all.count()));
    const std::size_t length = part.size();
    all.gatherAll(std::as_bytes(std::span(&length, 1)), std::as_writable_bytes(std::span(lengths)));
    std::vector<T> whole(part.begin(), part.end());
    std::vector<Ranks::Message> send, receive;
    if (all.rank() > 0) send.push_back({0, std::as_writable_bytes(std::span(whole))});
    else
    {
        whole.resize(std::accumulate(lengths.begin(), lengths.end(), std::size_t(0)));
        std::size_t begin = length;
        for (std::size_t r = 1; r < lengths.size(); begin += lengths[r++])
            receive.push_back({int(r), std::as_writable_bytes(std::span(whole).subspan(begin, lengths[r]))});
    }
    all.exchange(send, receive);
    if (all.rank() > 0) whole.clear();
    return whole;
}

/// To each rank its part; what each had for this one, in their order.
template<class T> std::vector<std::vector<T>> exchangeParts(const Ranks& all, std::span<std::vector<T>> parts)
{
    std::vector<std::size_t> lengths;
    for (const auto& part : parts) lengths.push_back(part.size());
    const auto comes = all.exchangeCounts(lengths);
    std::vector<std::vector<T>> from(parts.size());
    std::vector<Ranks::Message> send, receive;
    for (std::size_t r = 0; r < parts.size(); ++r)
    {
        if (int(r) == all.rank())
        {
            from[r] = std::move(parts[r]);
            continue;
        }
        from[r].resize(comes[r]);
        if (!parts[r].empty()) send.push_back({int(r), std::as_writable_bytes(std::span(parts[r]))});
        if (!from[r].empty()) receive.push_back({int(r), std::as_writable_bytes(std::span(from[r]))});
    }
    all.exchange(send, receive);
    return from;
}

}
