/// Rates and memory of the core on one thread, one line a figure: `name value unit`.
///
///     sphBenchmark <folder of the cases> [part...]        parts: force block bed bedStress bccBed band mixed meshes, all unless named; threads, by name alone
#include "base/CaseError.hpp"
#include "forcePass.hpp"
#include "readMeshes.hpp"
#include "wholeStep.hpp"
#include <fmt/format.h>
#include <iostream>
#include <omp.h>
#include <set>

int main(int argc, char** argv)
{
    using namespace sph;
    if (argc < 2)
    {
        std::cerr << "sphBenchmark <folder of the cases> [part...]\n";
        return 1;
    }
    const std::filesystem::path cases = argv[1];
    const std::set<std::string> parts(argv + 2, argv + argc);
    const auto wanted = [&](const std::string& part) { return parts.empty() || parts.contains(part); };
    const auto print = [](const Figures& figures)
    {
        for (const auto& f : figures) std::cout << fmt::format("{} {:.4g} {}\n", f.name, f.value, f.unit);
        std::cout.flush();
    };
    try
    {
        omp_set_num_threads(1);
        PairLimit limit = jitteredBlock(60);
        if (wanted("force")) print(forcePass(limit, 0.3));
        if (wanted("block"))
        {
            const auto figures = wholeStep(cases / "block", "whole", limit, 12, 4);
            print(figures);
            print({{"bytesPerParticle", figures.back().value, figures.back().unit}});
        }
        if (wanted("bed")) print(wholeStep(cases / "bed", "bed", limit, 20, 4));
        if (wanted("bedStress")) print(wholeStep(cases / "bedStress", "bedStress", limit, 20, 4));
        if (wanted("meshes")) print(readMeshes());
        const auto bccBed = cases / "../../../tutorials/heapLeaching/bccBed";
        if (wanted("bccBed")) print(wholeStep(bccBed, "bccBed", limit, 10, 4));
        if (wanted("band")) print(wholeStep(cases / "band", "band", limit, 10, 4));
        if (wanted("mixed"))
        {
            constexpr bool mixed = true;
            print(wholeStep(cases / "block", "mixedWhole", limit, 12, 4, mixed));
            print(wholeStep(cases / "bed", "mixedBed", limit, 20, 4, mixed));
            print(wholeStep(bccBed, "mixedBccBed", limit, 10, 4, mixed));
            print(wholeStep(cases / "band", "mixedBand", limit, 10, 4, mixed));
        }
        if (parts.contains("threads"))
        {
            print(twoThreads(cases / "block", "whole", 12, 4));
            print(twoThreads(cases / "bed", "bed", 20, 4));
            print(twoThreads(cases / "bedStress", "bedStress", 20, 4));
            print(twoThreads(bccBed, "bccBed", 10, 4));
            print(twoThreads(cases / "band", "band", 10, 4));
        }
    }
    catch (const CaseError& e)
    {
        std::cerr << e.what() << '\n';
        return 1;
    }
}
