/// A cloud without a run, written by ranks together: what they write, and how fast.
///
///   collatedWriting write <folder> ascii|binary <i> <particles of each rank>...    time folder `1`; the phase of particle i (-1: of none) is no label
///   mpirun -np N collatedWriting speed <folder> <particles>                        a name, a number and a unit a line
#include "base/Clock.hpp"
#include "base/OutputFile.hpp"
#include "case/Cloud.hpp"
#include "case/TimeFolder.hpp"
#include "parallel/Ranks.hpp"
#include <algorithm>
#include <cmath>
#include <fcntl.h>
#include <fmt/format.h>
#include <iostream>
#include <numeric>
#include <unistd.h>

using namespace sph;
namespace fs = std::filesystem;

namespace
{
/// Each value is one of its particle's number in the whole cloud, so that the bytes do not depend on the ranks.
struct Particles
{
    std::vector<double> x, y, phase, rho;

    Particles(std::size_t before, std::size_t n, std::size_t withoutLabel)
    {
        for (std::size_t i = before; i < before + n; ++i)
        {
            x.push_back(double(i) / 7);
            y.push_back(1e-3 * double(i * i % 1001));
            phase.push_back(i == withoutLabel ? 1e10 : double(i % 3));
            rho.push_back(1000);
        }
    }
    FieldView positions() const { return {"positions", FieldClass::vector, {x.data(), y.data(), nullptr}}; }
    std::vector<FieldView> fields() const
    {
        return {{"U", FieldClass::vector, {y.data(), x.data(), nullptr}},
                {"rho", FieldClass::scalar, {rho.data()}},
                {"p", FieldClass::scalar, {y.data()}},
                {"phase", FieldClass::label, {phase.data()}}};
    }
};

std::size_t number(const char* text) { return std::size_t(std::stoll(text)); }

void write(const fs::path& folder, WriteFormat format, std::size_t withoutLabel, const std::vector<std::size_t>& counts)
{
    const std::size_t rank = ranks() ? std::size_t(ranks()->rank()) : 0;
    const Particles particles(std::accumulate(counts.begin(), counts.begin() + long(rank), std::size_t(0)), counts.at(rank), withoutLabel);
    writeFolder(folder, "1",
                [&](const fs::path& time) {
                    writeCloud(time, "sph", counts[rank], particles.positions(), particles.fields(), {format, 0});
                });
}

void toDisk(const fs::path& path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY);
    if (descriptor < 0 || ::fsync(descriptor) != 0) throw std::runtime_error(path.string() + " does not go to the disk");
    ::close(descriptor);
}

/// [s]
double timeOf(const auto& act)
{
    const Clock clock;
    act();
    return clock.clockTime();
}

void speed(const fs::path& folder, std::size_t all)
{
    const auto& those = *ranks();
    const std::size_t rank = std::size_t(those.rank()), count = std::size_t(those.count());
    const Slice slice{rank, count};
    const std::size_t before = slice.begin(all), n = slice.end(all) - before;
    const Particles particles(before, n, all);
    const auto filesOfTime = [&]
    {
        std::vector<fs::path> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder / "1"))
            if (entry.is_regular_file()) files.push_back(entry.path());
        std::ranges::sort(files);
        return files;
    };
    const auto collated = [&]
    {
        writeCloud(folder / "1", "sph", n, particles.positions(), particles.fields(), {});
        allOrNone(
            [&]
            {
                const auto files = filesOfTime();
                for (std::size_t k = rank; k < files.size(); k += count) toDisk(files[k]);
            });
    };
    std::uintmax_t bytes = 0;
    const auto plain = [&]
    {
        const std::string piece(2 << 20, 'x'); // more than an OutputFile copies
        OutputFile file(folder / "plain");
        for (auto left = bytes; left > 0; left -= std::min<std::uintmax_t>(left, piece.size()))
            file.write(std::string_view(piece).substr(0, left));
        file.close();
        toDisk(folder / "plain");
    };
    double bestCollated = INFINITY, bestPlain = INFINITY;
    for (int turn = 0; turn < 5; ++turn)
    {
        byFirst(
            [&]
            {
                fs::remove_all(folder / "1");
                ::sync();
            });
        bestCollated = std::min(bestCollated, timeOf(collated));
        byFirst(
            [&]
            {
                bytes = 0;
                for (const auto& file : filesOfTime()) bytes += fs::file_size(file);
                fs::remove(folder / "plain");
                ::sync();
                bestPlain = std::min(bestPlain, timeOf(plain));
            });
    }
    if (isFirstRank())
        std::cout << fmt::format("collatedWrite {:.0f} MB/s\nplainWrite {:.0f} MB/s\ncollatedOfPlain {:.2f} -\n",
                                 1e-6 * double(bytes) / bestCollated, 1e-6 * double(bytes) / bestPlain, bestPlain / bestCollated);
}
}

int main(int argc, char** argv)
try
{
    const std::vector<std::string> words(argv, argv + argc);
    if (words.at(1) == "speed")
    {
        startRanks();
        speed(words.at(2), number(argv[3]));
        return 0;
    }
    std::vector<std::size_t> counts;
    for (int k = 5; k < argc; ++k) counts.push_back(number(argv[k]));
    if (counts.size() > 1) startRanks();
    write(words.at(2), words.at(3) == "ascii" ? WriteFormat::ascii : WriteFormat::binary, number(argv[4]), counts);
}
catch (const std::exception& e)
{
    std::cerr << fmt::format("{}\n", e.what());
    return 1;
}
