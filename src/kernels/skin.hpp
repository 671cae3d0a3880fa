/// Skin of the neighbour lists, beyond the kernel's support.
#pragma once

namespace sph
{

/// Lists reach this much beyond the kernel's support [spacings]. Measured (test/benchmark/README.md): 0.2 and 0.3 cost the same, 0.12 and
/// 0.45 more.
inline constexpr double skinInSpacings = 0.3;

}
