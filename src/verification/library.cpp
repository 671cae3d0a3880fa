/// The library libsphVerification.so: it has the tag by which a program knows it, and adds what it has while it is loaded.
#include "sampling/functionLibrary.hpp"
#include "verification/verification.hpp"

namespace
{
const struct OnLoading
{
    OnLoading() { sph::addVerification(); }
} onLoading;
}
