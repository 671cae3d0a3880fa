/// An expression that is read once and computed for many particles at a time.
#pragma once
#include "dictionary/Expression.hpp"
#include <array>
#include <span>
#include <vector>

namespace sph
{

/// The text of an expression as steps on rows of numbers, each a loop without a branch.
///
/// All parts of the text are computed, also the side of a condition that is not chosen: a value without a meaning there (1/0, sqrt(-1)) does no harm.
class ExpressionProgram
{
public:
    enum class Kind
    {
        number,
        vector,
        unknown ///< while a text is looked through before it is known what its names are; it then goes with numbers and with vectors
    };
    /// Values of a name, of all particles or one for all.
    struct Values
    {
        std::array<const double*, 3> each{}; ///< components, of a number the first; null: `same`
        Vector<3> same;
    };

private:
    enum class Code
    {
        constant,
        variable,
        add,
        subtract,
        multiply,
        multiplyAdd,
        divide,
        remainder,
        equal,
        notEqual,
        lessEqual,
        greaterEqual,
        less,
        greater,
        both,
        either,
        isZero,
        negate,
        choose,
        function1,
        function2
    };
    struct Step
    {
        Code code;
        int a = 0, b = 0, c = 0; ///< rows that it reads; of a variable its number and component
        double value = 0;
        double (*one)(double) = nullptr;
        double (*two)(double, double) = nullptr;
    };
    class Reader;

    std::vector<Step> steps_; ///< step k writes row k
    std::vector<std::string> names_;
    Kind kind_ = Kind::number;
    std::array<int, 3> result_{};

    template<bool strict> void run(std::size_t begin, std::size_t end, std::span<const Values>, const std::array<double*, 3>& out) const;

public:
    /// `kindOf` says what a name is, or throws ExpressionError; so does this where the text is no expression: what is wrong, and where.
    ExpressionProgram(const std::string& text, const std::function<Kind(const std::string&)>& kindOf);

    Kind kind() const { return kind_; }
    /// The names that the text has, each once.
    const std::vector<std::string>& names() const { return names_; }
    /// Values of particles begin .. end - 1 to `out[.][0 .. end - begin - 1]`, of a vector three rows; `values` in the order of names(). IEEE arithmetic: nothing
    /// is thrown.
    void operator()(std::size_t begin, std::size_t end, std::span<const Values>, const std::array<double*, 3>& out) const;
    /// The one value of names that have one for all. Throws ExpressionError where a divisor is 0 or the result is not finite.
    ExpressionValue single(std::span<const Values>) const;
};

}
