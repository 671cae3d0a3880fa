/// Ranks: the processes that share the particles of one run (MPI's word). Most runs have one process: then `ranks()` is null, nothing communicates, and no
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

    /// A message: bytes for or from a rank.
    struct Message
    {
        int rank;
        std::span<std::byte> bytes;
    };
    /// Gathers the same number of bytes from each rank, in the order of ranks, on all of them.
    virtual void gatherAll(std::span<const std::byte> part, std::span<std::byte> all) const = 0;
    /// Sends one number to each rank, and returns the numbers that each had for this one.
    virtual std::vector<std::size_t> exchangeCounts(std::span<const std::size_t> toEach) const = 0;
    /// Messages under way. Their bytes must stay in place until all are sent and received, which the destructor waits for.
    class Exchange
    {
    public:
        virtual ~Exchange() = default;
        /// Advances the messages while there is something else to do; called by the thread that has started them.
        virtual void progress() = 0;
    };
    /// Starts messages whose lengths both sides know.
    virtual std::unique_ptr<Exchange> start(std::span<const Message> send, std::span<const Message> receive) const = 0;
    /// Sends and receives, and waits until all messages are through.
    void exchange(std::span<const Message> send, std::span<const Message> receive) const { start(send, receive); }
    /// Cuts space so that each rank has about the same sum of weights. `x`: positions of this rank's particles, three numbers each.
    virtual std::vector<RankBox> cut(int dimension, std::span<const double> x, std::span<const float> weights) const = 0;
    virtual void barrier() const = 0;
    /// A file in which each rank writes at offsets of its own; all close it. Throws std::runtime_error with the reason.
    class SharedFile
    {
    public:
        virtual ~SharedFile() = default;
        virtual void write(std::size_t at, std::string_view bytes) = 0;
        virtual void close() = 0;
    };
    /// Creates a file that is not there yet, on all ranks, or throws on all.
    virtual std::unique_ptr<SharedFile> create(const std::filesystem::path&) const = 0;
    /// Time spent in communication so far, waiting included [s]: wall time, and processor time of this process.
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

/// Joins the processes that mpirun has started. Throws std::runtime_error where a library is missing.
void startRanks();
/// Whether this process reads, writes and speaks for all; also where it is alone.
bool isFirstRank();
bool isLastRank();
/// Processor time of this process, all threads together, without what it spent in waiting for others [s].
double busyTime();
/// Reading of the case in turns: the first rank prepares the case, and ends the run by what it throws, before the others read.
void waitForFirst();
void firstIsThrough();

/// All ranks act. An exception of one, or of the first of several, is thrown on all, as a CaseError of the same words: they go on or end together.
/// The act must not wait for other ranks.
void allOrNone(const std::function<void()>& act);
/// The first rank acts for all, who wait until it is through, or throw what it throws.
void byFirst(const std::function<void()>& act);

/// While this object lives, reductions are local to the process.
class Alone
{
    const Ranks* before_;

public:
    Alone();
    ~Alone();
    Alone(const Alone&) = delete;
    Alone& operator=(const Alone&) = delete;
};

/// Gathers the parts of all ranks, of any lengths, behind one another on the first; the others return nothing.
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

/// Sends each rank its part, and returns the parts that each had for this one, in the order of ranks.
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
