/// What the tests of this folder read is known, as it is once a case has loaded the library.
#include "verification/verification.hpp"

namespace
{
const struct Known
{
    Known() { sph::addVerification(); }
} known;
}
