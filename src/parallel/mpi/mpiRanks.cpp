/// Ranks by Open MPI, cut by Zoltan's recursive coordinate bisection: a library of its own, loaded where a run is parallel.
#include "parallel/Ranks.hpp"
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <mpi.h>
#include <stdexcept>
#include <system_error>
#include <zoltan.h>

namespace sph
{

namespace
{
/// Positions and weights that Zoltan asks for.
struct Places
{
    int dimension;
    std::span<const double> x;
    std::span<const float> weights;
};

class Stopwatch
{
    Ranks::Waited& total_;
    double wall_ = MPI_Wtime(), processor_ = processorTime();

public:
    explicit Stopwatch(Ranks::Waited& total) : total_(total) {}
    Stopwatch(const Stopwatch&) = delete;
    ~Stopwatch()
    {
        total_.wall += MPI_Wtime() - wall_;
        total_.processor += processorTime() - processor_;
    }
    static double processorTime()
    {
        timespec now;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
    }
};

std::string inWords(int code)
{
    char text[MPI_MAX_ERROR_STRING];
    int length = 0;
    MPI_Error_string(code, text, &length);
    return {text, std::size_t(length)};
}

/// Ranks on one machine talk through its memory. To look for networks as well takes Open MPI as long as all else of its start (0.10 s of processor
/// time in place of 0.06). What the user has asked for stays.
void leaveOutNetworks()
{
    const char *const all = std::getenv("OMPI_COMM_WORLD_SIZE"), *const here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
    if (!all || !here || std::string_view(all) != here) return;
    setenv("OMPI_MCA_pml", "ob1", 0);
    setenv("OMPI_MCA_btl", "self,vader", 0);
}

/// Each rank writes by itself: what it has is in one piece and long, and to collect it on fewer ranks first (MPI_File_write_at_all) brought nothing.
class MpiFile final : public Ranks::SharedFile
{
    MPI_File file_;
    Ranks::Waited& waited_;

public:
    MpiFile(MPI_File file, Ranks::Waited& waited) : file_(file), waited_(waited) {}
    ~MpiFile() override
    {
        if (file_ != MPI_FILE_NULL) MPI_File_close(&file_);
    }

    void write(std::size_t at, std::string_view bytes) override
    {
        while (!bytes.empty())
        {
            MPI_Status status;
            int written = 0;
            errno = 0;
            const int code = MPI_File_write_at(file_, MPI_Offset(at), bytes.data(), int(bytes.size()), MPI_BYTE, &status);
            const int reason = errno;
            if (code == MPI_SUCCESS) MPI_Get_count(&status, MPI_BYTE, &written);
            // A full disk is a success of no bytes to Open MPI's own input and output, and errno alone has the reason.
            if (written <= 0) throw std::runtime_error(reason != 0 ? std::generic_category().message(reason) : inWords(code));
            at += std::size_t(written);
            bytes.remove_prefix(std::size_t(written));
        }
    }

    void close() override
    {
        const Stopwatch stopwatch(waited_);
        if (const int code = MPI_File_close(&file_); code != MPI_SUCCESS) throw std::runtime_error(inWords(code));
    }
};

class MpiExchange final : public Ranks::Exchange
{
    Ranks::Waited& waited_;
    std::vector<MPI_Request> requests_;

public:
    MpiExchange(std::span<const Ranks::Message> send, std::span<const Ranks::Message> receive, Ranks::Waited& waited) : waited_(waited)
    {
        const Stopwatch stopwatch(waited_);
        // An int counts bytes of a message: long ones go in pieces.
        constexpr std::size_t most = std::size_t(1) << 30;
        const auto start = [&](const Ranks::Message& m, const auto& f)
        {
            for (std::size_t begin = 0; begin < m.bytes.size(); begin += most)
                f(m.bytes.data() + begin, int(std::min(most, m.bytes.size() - begin)), m.rank, &requests_.emplace_back());
        };
        for (const auto& m : receive)
            start(m, [](std::byte* at, int n, int from, MPI_Request* r) { MPI_Irecv(at, n, MPI_BYTE, from, 0, MPI_COMM_WORLD, r); });
        for (const auto& m : send)
            start(m, [](std::byte* at, int n, int to, MPI_Request* r) { MPI_Isend(at, n, MPI_BYTE, to, 0, MPI_COMM_WORLD, r); });
    }
    ~MpiExchange() override
    {
        const Stopwatch stopwatch(waited_);
        MPI_Waitall(int(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
    }
    void progress() override
    {
        int through;
        MPI_Testall(int(requests_.size()), requests_.data(), &through, MPI_STATUSES_IGNORE);
    }
};

class MpiRanks final : public Ranks
{
public:
    MpiRanks()
    {
        leaveOutNetworks();
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &count_);
    }
    ~MpiRanks() override { MPI_Finalize(); }

    void gatherAll(std::span<const std::byte> part, std::span<std::byte> all) const override
    {
        const Stopwatch stopwatch(waited_);
        MPI_Allgather(part.data(), int(part.size()), MPI_BYTE, all.data(), int(part.size()), MPI_BYTE, MPI_COMM_WORLD);
    }

    std::vector<std::size_t> exchangeCounts(std::span<const std::size_t> toEach) const override
    {
        const Stopwatch stopwatch(waited_);
        std::vector<std::size_t> from(toEach.size());
        MPI_Alltoall(toEach.data(), sizeof(std::size_t), MPI_BYTE, from.data(), sizeof(std::size_t), MPI_BYTE, MPI_COMM_WORLD);
        return from;
    }

    std::unique_ptr<Exchange> start(std::span<const Message> send, std::span<const Message> receive) const override
    {
        return std::make_unique<MpiExchange>(send, receive, waited_);
    }

    std::vector<RankBox> cut(int dimension, std::span<const double> x, std::span<const float> weights) const override
    {
        float version;
        if (Zoltan_Initialize(0, nullptr, &version) != ZOLTAN_OK) throw std::runtime_error("Zoltan cannot be initialised");
        Zoltan_Struct* zoltan = Zoltan_Create(MPI_COMM_WORLD);
        for (const auto& [name, value] : {std::pair{"DEBUG_LEVEL", "0"}, // first: a method is told to the log when it is chosen
                                          {"LB_METHOD", "RCB"},
                                          {"KEEP_CUTS", "1"},
                                          {"OBJ_WEIGHT_DIM", "1"},
                                          {"NUM_GID_ENTRIES", "1"},
                                          {"NUM_LID_ENTRIES", "1"},
                                          {"RETURN_LISTS", "NONE"},
                                          {"RCB_RECTILINEAR_BLOCKS", "1"},
                                          {"IMBALANCE_TOL", "1.005"}})
            Zoltan_Set_Param(zoltan, name, value);
        Places places{dimension, x, weights};
        Zoltan_Set_Num_Obj_Fn(
            zoltan, [](void* data, int*) { return int(static_cast<Places*>(data)->weights.size()); }, &places);
        Zoltan_Set_Obj_List_Fn(
            zoltan,
            [](void* data, int, int, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR local, int, float* weight, int*)
            {
                const auto& p = *static_cast<Places*>(data);
                for (std::size_t i = 0; i < p.weights.size(); ++i)
                {
                    global[i] = local[i] = ZOLTAN_ID_TYPE(i);
                    weight[i] = p.weights[i];
                }
            },
            &places);
        Zoltan_Set_Num_Geom_Fn(
            zoltan, [](void* data, int*) { return static_cast<Places*>(data)->dimension; }, &places);
        Zoltan_Set_Geom_Multi_Fn(
            zoltan,
            [](void* data, int, int, int n, ZOLTAN_ID_PTR, ZOLTAN_ID_PTR local, int components, double* to, int*)
            {
                const auto& p = *static_cast<Places*>(data);
                for (int k = 0; k < n; ++k)
                    for (int c = 0; c < components; ++c) to[k * components + c] = p.x[3 * local[k] + std::size_t(c)];
            },
            &places);
        int changes, globalSize, localSize, imported, exported;
        ZOLTAN_ID_PTR importGlobal, importLocal, exportGlobal, exportLocal;
        int *importRanks, *importParts, *exportRanks, *exportParts;
        const int code =
            Zoltan_LB_Partition(zoltan, &changes, &globalSize, &localSize, &imported, &importGlobal, &importLocal, &importRanks,
                                &importParts, &exported, &exportGlobal, &exportLocal, &exportRanks, &exportParts);
        std::vector<RankBox> boxes;
        const double infinity = std::numeric_limits<double>::infinity();
        for (int part = 0; code == ZOLTAN_OK && part < count_; ++part)
        {
            int n;
            RankBox box{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
            auto &l = box.low, &h = box.high;
            Zoltan_RCB_Box(zoltan, part, &n, &l[0], &l[1], &l[2], &h[0], &h[1], &h[2]);
            if (dimension == 2)
            {
                l[2] = -infinity;
                h[2] = infinity;
            }
            for (auto* corner : {&l, &h})
                for (double& q : *corner)
                    if (std::abs(q) >= 0.5 * std::numeric_limits<double>::max()) q = q > 0 ? infinity : -infinity;
            boxes.push_back(box);
        }
        Zoltan_Destroy(&zoltan);
        if (code != ZOLTAN_OK) throw std::runtime_error("Zoltan cannot cut the particles into parts");
        return boxes;
    }

    void barrier() const override
    {
        const Stopwatch stopwatch(waited_);
        MPI_Barrier(MPI_COMM_WORLD);
    }
    std::unique_ptr<SharedFile> create(const std::filesystem::path& path) const override
    {
        const Stopwatch stopwatch(waited_);
        MPI_File file;
        int code = MPI_File_open(MPI_COMM_WORLD, path.c_str(), MPI_MODE_CREATE | MPI_MODE_EXCL | MPI_MODE_WRONLY, MPI_INFO_NULL, &file);
        // A rank that has the file open cannot close it without those that have not.
        MPI_Allreduce(MPI_IN_PLACE, &code, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
        if (code != MPI_SUCCESS) throw std::runtime_error(inWords(code));
        return std::make_unique<MpiFile>(file, waited_);
    }
    void abort() const override { MPI_Abort(MPI_COMM_WORLD, 1); }
};
}

}

extern "C" sph::Ranks* makeRanks() { return new sph::MpiRanks; }
