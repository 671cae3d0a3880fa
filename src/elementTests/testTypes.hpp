/// The types of element tests and what every section of system/elementTestDict that describes a test has: the start, the legs, tables of numbers.
#pragma once
#include "case/Case.hpp"
#include "dictionary/EntryList.hpp"
#include "elementTests/ElementTest.hpp"

namespace sph
{

namespace entry
{
inline const Scalar pressure{"pressure", units::pressure, byScene("needed without stress"), positive, "at the start, vertical (along z)"},
    K{"K", units::none, 1, nonNegative, "horizontal over vertical stress at the start"};
inline const ListOf<double> stress{"stress", units::pressure, byScene("of pressure and K"),
                                   "at the start, xx xy xz yy yz zz, tension positive"};
inline const ListOf<double> strain{"strain", byScene("needed without a stress"),
                                   "what is reached one after another, of the sign that the test is named by"},
    verticalStress{"verticalStress", units::pressure, byScene("strain"), "compression positive, what is reached one after another"},
    meanPressure{"meanPressure", units::pressure, byScene("strain"), "what is reached one after another"},
    deviatorStress{"deviatorStress", units::pressure, byScene("strain"),
                   "axial less lateral stress, compression positive, what is reached one after another"};
inline const Choice drainage{"drainage",
                             {{"drained", "lateral stresses are held"},
                              {"undrained",
                               "the volume is held, and the total lateral stress: porePressure is what the effective one gives up"}},
                             "drained",
                             "of the water in the pores"};
inline const ListOf<double> gamma{"gamma", required, "dv_x/dz t: what is reached one after another"},
    angle{"angle", required, "[degrees], what is reached one after another"};
inline const Direction axis{"axis", Vector<3>{0, 1, 0}, "that the soil turns about"};
}

/// Compression or shear for a path of 1, and which stresses are held.
struct TestType
{
    const char *name, *meaning;
    Tensor<3> unit;
    std::array<bool, 6> held; ///< xx xy xz yy yz zz
    const ListOf<double>* drivenBy;
    const char* axis = "strain [-]"; ///< of what drives it
    /// Stress that may drive it in place of the strain, and measure:sigma of that.
    const ListOf<double>* orBy = nullptr;
    SymmTensor<3> measure = {};
    std::optional<Tensor<3>> undrained = {}; ///< for a path of 1 at constant volume
};

const std::vector<TestType>& testTypes();

/// Rows of numbers with the columns that are asked for by name, in that order; `#` begins a comment. `optional` columns may be missing: 0; `found`:
/// those that are there.
std::vector<std::vector<double>> readTable(const Case&, const std::string& file, const std::vector<std::string>& columns, bool optional,
                                           std::vector<std::string>* found = nullptr);

/// Legs to these strains or stresses.
void addLegs(const Dictionary&, const TestType&, const ListOf<double>& driver, const std::vector<double>& targets, int cycles,
             ElementTest& test, const std::string& stage);

/// The state at the start, where the law does not hold for it an error at the entry that is wrong.
void readState(const Dictionary&, const SoilLaw&, ElementTest&);
/// The entries that it reads.
EntryList startEntries();

}
