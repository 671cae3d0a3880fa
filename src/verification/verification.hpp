/// The formulas and measures of verification cases: exact solutions, and numbers with a reference value of their own.
///
/// A case has them from libsphVerification.so, `libs ("libsphVerification.so");`. Programs that link this room add them by the function here.
#pragma once

namespace sph
{

/// Adds all of them to those that `errors` knows; once, however often it is called.
void addVerification();

}
