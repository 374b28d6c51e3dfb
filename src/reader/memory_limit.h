#pragma once

namespace aeolic {

/// This process may take no more memory than the machine has left now, besides what it has. With sanitizers, which take
/// address space for themselves, nothing is limited.
void limitMemory();

}  // namespace aeolic
