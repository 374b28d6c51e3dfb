#pragma once

#include <locale>

namespace aeolic {

/// A locale for streams that VTK reads numbers from: the classic one, but with every number that readReal() reads. VTK
/// 9.1 ends an array where the text says "nan", as its own writers do.
const std::locale& textNumbers();

}  // namespace aeolic
