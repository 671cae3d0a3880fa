/// Particles in memory, a view of them, and a case folder that is gone with the test.
#pragma once
#include "sampling/FunctionContext.hpp"
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <unistd.h>

namespace sph
{

struct Particles
{
    Geometry geometry;
    std::vector<std::string> phases{"water"};
    std::vector<double> x, y, z, mass, volume, phase, ux, uy, uz, p;
    std::vector<double> heldBy; ///< none where nothing is held
    double spacing = 0, supportInSpacings = 3, time = 0;
    std::string kernel = "wendlandC2";
    double surfaceTension = 0;
    std::vector<double> surfaceTensions;
    Vector<3> g;

    /// A square or cubic lattice of cell centres that fills the domain, at rest, of density 1000.
    Particles(int dimension, Vector<3> low, Vector<3> high, double dx) : spacing(dx)
    {
        geometry.dimension = dimension;
        geometry.low = low;
        geometry.high = high;
        const auto count = [dx](double a, double b) { return long(std::round((b - a) / dx)); };
        for (long k = 0; k < (dimension == 3 ? count(low.z, high.z) : 1); ++k)
            for (long j = 0; j < count(low.y, high.y); ++j)
                for (long i = 0; i < count(low.x, high.x); ++i)
                    add({low.x + (double(i) + 0.5) * dx, low.y + (double(j) + 0.5) * dx,
                         dimension == 3 ? low.z + (double(k) + 0.5) * dx : 0});
    }

    void add(const Vector<3>& at)
    {
        x.push_back(at.x);
        y.push_back(at.y);
        z.push_back(at.z);
        volume.push_back(std::pow(spacing, geometry.dimension));
        mass.push_back(1000 * volume.back());
        for (auto* values : {&phase, &ux, &uy, &uz, &p}) values->push_back(0);
    }
    std::size_t size() const { return x.size(); }
    Vector<3> position(std::size_t i) const { return {x[i], y[i], z[i]}; }

    void setU(const std::function<Vector<3>(Vector<3>)>& u)
    {
        for (std::size_t i = 0; i < size(); ++i)
        {
            const auto v = u(position(i));
            ux[i] = v.x;
            uy[i] = v.y;
            uz[i] = v.z;
        }
    }
    void setP(const std::function<double(Vector<3>)>& f)
    {
        for (std::size_t i = 0; i < size(); ++i) p[i] = f(position(i));
    }
    void setPhase(const std::function<int(Vector<3>)>& f)
    {
        for (std::size_t i = 0; i < size(); ++i) phase[i] = f(position(i));
    }

    ParticleView view() const
    {
        ParticleView v;
        const bool flat = geometry.dimension == 2;
        v.dimension = geometry.dimension;
        v.n = size();
        v.x = x.data();
        v.y = y.data();
        v.z = flat ? nullptr : z.data();
        v.fields = {{"U", FieldClass::vector, {ux.data(), uy.data(), flat ? nullptr : uz.data()}}, {"p", FieldClass::scalar, {p.data()}}};
        v.mass = mass.data();
        v.volume = volume.data();
        v.phase = phase.data();
        v.heldBy = heldBy.empty() ? nullptr : heldBy.data();
        v.phases = phases;
        v.restDensity = {1000, 1};
        v.viscosity = {1e-3, 2e-5};
        v.soundSpeed = {10, 10};
        v.constants["sigma"] = surfaceTensions.empty() ? std::vector<double>{0, surfaceTension, surfaceTension, 0} : surfaceTensions;
        v.g = v.gravity = g;
        v.spacing = spacing;
        v.support = supportInSpacings * spacing;
        v.kernel = kernel;
        v.geometry = &geometry;
        v.time = time;
        v.executionTime = 1.5;
        return v;
    }
};

/// A case with controlDict and time 0.
class TemporaryCase
{
    std::filesystem::path folder_;

public:
    TemporaryCase()
    {
        static int number = 0;
        folder_ = std::filesystem::temp_directory_path() / ("sphSampling" + std::to_string(::getpid()) + "_" + std::to_string(number++));
        write("system/controlDict", "application sphFoamLike;\nstartFrom startTime;\nstartTime 0;\nstopAt endTime;\nendTime 1;\n"
                                    "deltaT 0.1;\nadjustTimeStep no;\nwriteControl timeStep;\nwriteInterval 1;\n");
        std::filesystem::create_directories(folder_ / "0");
    }
    ~TemporaryCase() { std::filesystem::remove_all(folder_); }
    const std::filesystem::path& folder() const { return folder_; }

    void write(const std::string& file, const std::string& text) const
    {
        std::filesystem::create_directories((folder_ / file).parent_path());
        std::ofstream(folder_ / file) << text;
    }
    std::string read(const std::string& file) const
    {
        std::ostringstream text;
        text << std::ifstream(folder_ / file).rdbuf();
        return text.str();
    }
    /// The lines that are no header, each cut at tabs.
    std::vector<std::vector<std::string>> rows(const std::string& file) const
    {
        std::vector<std::vector<std::string>> result;
        std::istringstream lines(read(file));
        for (std::string line; std::getline(lines, line);)
        {
            if (line.starts_with("#")) continue;
            result.emplace_back();
            std::istringstream cells(line);
            for (std::string text; std::getline(cells, text, '\t');) result.back().push_back(text);
        }
        return result;
    }
};

/// What Diagnostics holds, as one text; empty where all is well.
inline std::string errorsOf(const Diagnostics& diagnostics)
{
    try
    {
        diagnostics.throwIfAny();
    }
    catch (const CaseError& error)
    {
        return error.what();
    }
    return "";
}

}
