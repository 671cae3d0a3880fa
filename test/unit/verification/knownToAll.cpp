/// What the tests of this folder read is known, as it is once a case has loaded the library.
#include "verification/verification.hpp"

namespace
{
const struct AddedToAll
{
    AddedToAll() { sph::addVerification(); }
} addedToAll;
}
