#include "Parsed.hpp"
#include <random>

using namespace sph;

// Whatever is done to a file, reading it ends, throws nothing and leaves either a dictionary or errors that name lines of the
// file. 4000 files with characters changed, dropped, doubled or cut off at random, the same ones in each run.
TEST(DictionaryDamage, readingAlwaysEnds)
{
    const std::string whole = R"(FoamFile { version 2.0; class dictionary; }
L 1e-3; /* c */ nu [0 2 -1 0 0 0 0] 1e-6; // d
sub { a $L; list 3(1 2 3); u 5{0.5}; inner { b #eval{ 2*$L + sin(1) }; $..L; } }
copy { $sub; "(x|y).*" "text \" ; {"; }
walls ( { type a; } name { type b; points ((0 0 0) (1 1 1)); } );
#ifeq $L 1e-3
c yes;
#else
c no;
#endif
#if #eval "$L > 1"
#include "nothing"
#elif on
#remove (c "d.*")
#endif
#inputMode protect
verb #{ code #}; f nonuniform List<vector> 2((0 0 0) (1 2 3)); div(phi,U) Gauss x { k 1; };
sigma ( (water air) 0.07 );
)";
    const std::string special = "{}()[];\"$#/*\\\n :.,=<>";
    std::mt19937 random(1);
    for (int run = 0; run < 4000; ++run)
    {
        auto text = whole;
        for (int change = 0; change <= run % 4; ++change)
        {
            const auto at = random() % text.size();
            switch (random() % 5)
            {
            case 0:
                text.erase(at, 1);
                break;
            case 1:
                text[at] = special[random() % special.size()];
                break;
            case 2:
                text.insert(at, 1, special[random() % special.size()]);
                break;
            case 3:
                text.insert(at, text.substr(random() % text.size(), random() % 20));
                break;
            default:
                text.erase(at, random() % 30);
                break;
            }
            if (text.empty()) text = " ";
        }
        const Parsed p(text);
        for (const auto& key : p.dict.keys())
        {
            p.dict.get<double>(key);
            p.dict.get<std::vector<Vector<3>>>(key);
            p.dict.get(key, units::kinematicViscosity);
            p.dict.dictionaries(key);
            p.dict.subDict(key).reportUnused();
        }
        p.dict.reportUnused();
        ASSERT_NE(p.errors(), "") << text; // the look-ups above ask each entry for everything, so some must fail
    }
}
