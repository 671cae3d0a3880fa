/// Dictionaries damaged at random: reading ends, throws nothing, and gives a dictionary or errors; what is printed of one without errors reads
/// back as the same; what an edit leaves can be read.
#include "Mutator.hpp"
#include "case/TimeControls.hpp"
#include "dictionary/DictionaryText.hpp"
#include "messages.hpp"
#include "smallCases.hpp"

namespace sph::test
{
namespace
{

const std::string everything = R"(FoamFile { version 2.0; class dictionary; }
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

std::vector<std::string> seeds()
{
    std::vector<std::string> all{everything, everything};
    for (const auto& files : {channelCase(), dropCase(), suspensionCase(), openCase(), bedCase()})
        for (const auto& [name, text] : files) all.push_back(text);
    return all;
}

/// Asks each entry for everything.
void lookUpAll(const Dictionary& d)
{
    for (const auto& key : d.keys())
    {
        d.get<double>(key);
        d.get<std::vector<Vector<3>>>(key);
        d.get<std::vector<std::string>>(key);
        d.get(key, units::kinematicViscosity);
        d.pairs(key);
        for (const auto& inner : d.dictionaries(key)) inner.reportUnused();
        d.subDict(key).reportUnused();
    }
    TimeControls::read(d);
    d.reportUnused();
}

}

TEST(Fuzz, Dictionaries)
{
    const auto texts = seeds();
    fuzz(4000,
         [&](Mutator& mutator)
         {
             const auto text = mutator.of(mutator.oneOf(texts), texts);
             const auto diagnostics = std::make_shared<Diagnostics>();
             const auto d = Dictionary::parse(text, "constant/d", diagnostics);
             if (diagnostics->ok())
             {
                 const auto printed = entryText(d, "");
                 const auto again = std::make_shared<Diagnostics>();
                 EXPECT_EQ(entryText(Dictionary::parse(printed, "constant/d", again), ""), printed) << text;
                 EXPECT_EQ(messages(*again), "") << text << "\nprinted:\n" << printed;
             }
             lookUpAll(d);
         });
}

TEST(Fuzz, Edits)
{
    const auto texts = seeds();
    const TestCase c(Files{});
    fuzz(500,
         [&](Mutator& mutator)
         {
             const auto& text = mutator.oneOf(texts);
             std::filesystem::remove(c.folder() / "d"); // emptied in its place it would wait for the disk on some systems
             c.write("d", text);
             const auto before = std::make_shared<Diagnostics>();
             const auto d = Dictionary::read(c.folder(), "d", before);
             if (!before->ok()) return;
             const auto keys = d.keys();
             const auto entry = mutator.below(4) == 0 ? mutator.of("sub.inner", texts) : mutator.oneOf(keys);
             const auto value = mutator.of(mutator.below(2) == 0 ? "(1 2 3)" : "{ a 1; }", texts);
             try
             {
                 setEntry(c.folder(), "d", entry, value);
             }
             catch (const CaseError&)
             {
                 EXPECT_EQ(c.read("d"), text) << entry << " " << value;
             }
             const auto after = std::make_shared<Diagnostics>();
             Dictionary::read(c.folder(), "d", after);
             EXPECT_EQ(messages(*after), "") << entry << " " << value << "\n" << c.read("d");
             EXPECT_EQ(c.files(".").size(), 1u) << "nothing is left beside it";
         });
}

}
