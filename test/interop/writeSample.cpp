/// Writes the case that the interoperability tests read: `writeSample <folder> ascii|binary`. The values of particle i at time t are
/// simple enough for sample.py to state them again, and all but those of `positions` have exact doubles.
#include "base/OutputFile.hpp"
#include "case/RunTime.hpp"
#include <cstdio>

namespace
{

constexpr std::size_t particles = 7;

void writeDictionary(const std::filesystem::path& folder, const std::string& object, const std::string& entries)
{
    sph::createFolders(folder / "system");
    sph::writeFile(folder / "system" / object, "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       dictionary;\n"
                                               "    object      " +
                                                   object + ";\n}\n\n" + entries);
}

void writeDictionaries(const std::filesystem::path& folder, const std::string& format)
{
    writeDictionary(folder, "controlDict",
                    "application sphFoamLike;\nstartFrom startTime;\nstartTime 0;\nstopAt endTime;\nendTime 1;\ndeltaT 0.25;\n"
                    "adjustTimeStep no;\nwriteControl runTime;\nwriteInterval 0.5;\nwriteFormat " +
                        format + ";\ntimeFormat general;\ntimePrecision 6;\n");
    writeDictionary(folder, "fvSchemes",
                    "ddtSchemes { default none; }\ngradSchemes { default none; }\ndivSchemes { default none; }\n"
                    "laplacianSchemes { default none; }\ninterpolationSchemes { default none; }\nsnGradSchemes { default none; }\n");
    writeDictionary(folder, "fvSolution", "solvers {}\n");
}

void writeParticles(const std::filesystem::path& folder, double t, const sph::WriteOptions& options)
{
    using sph::FieldClass;
    std::vector<double> x, y, Ux, Uy, rho, phase, xx, xy, xz, yy, yz, zz;
    const std::vector<double> uniform(particles, 0.375);
    for (std::size_t i = 0; i < particles; ++i)
    {
        const double k = double(i);
        x.push_back(0.1 * k + 0.01 * t);
        y.push_back(0.5);
        Ux.push_back(k + t);
        Uy.push_back(-0.25 * k);
        rho.push_back(1000 + 0.5 * k);
        phase.push_back(double(i % 3));
        for (auto [component, factor] : {std::pair{&xx, 1}, {&xy, 2}, {&xz, 3}, {&yy, 4}, {&yz, 5}, {&zz, 6}})
            component->push_back(factor + 0.5 * k);
    }
    sph::writeCloud(folder, "sph", particles, {"positions", FieldClass::vector, {x.data(), y.data(), nullptr}},
                    {{"U", FieldClass::vector, {Ux.data(), Uy.data(), nullptr}},
                     {"rho", FieldClass::scalar, {rho.data()}},
                     {"phase", FieldClass::label, {phase.data()}},
                     {"uniform", FieldClass::scalar, {uniform.data()}},
                     {"sigma", FieldClass::symmTensor, {xx.data(), xy.data(), xz.data(), yy.data(), yz.data(), zz.data()}},
                     sph::fieldView("planeStrain", sph::valueType<sph::PlaneStrainStress>, {xx.data(), xy.data(), yy.data(), zz.data()}),
                     sph::fieldView("gradU", sph::valueType<sph::Tensor<2>>, {xx.data(), xy.data(), yy.data(), zz.data()})},
                    options);
    sph::writeCloud(folder, "empty", 0, {"positions", FieldClass::vector, {nullptr, nullptr, nullptr}},
                    {{"rho", FieldClass::scalar, {nullptr}}}, options);
}

void writeSample(const std::filesystem::path& folder, const std::string& format)
{
    writeDictionaries(folder, format);
    sph::writeBoundingMesh(folder, {-1, -1, 0}, {2, 2, 0});
    sph::createFolders(folder / "0");
    const sph::Case theCase(folder);
    sph::RunTime time(theCase);
    theCase.diagnostics().throwIfAny();
    writeParticles(folder / "0", 0, time.writeOptions());
    while (time.running())
    {
        time.advance(time.nextDeltaT(1));
        if (time.writeTime())
            time.write([&](const auto& partial) { writeParticles(partial, time.value(), time.writeOptions()); },
                       {{"massOfInlet(water)", 0.1 + 0.2}});
    }
}

}

int main(int count, char** arguments)
{
    if (count != 3) return 2;
    try
    {
        writeSample(arguments[1], arguments[2]);
    }
    catch (const sph::CaseError& e)
    {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
}
