#pragma once

#include <string>
#include <vector>

namespace aeolic {

/// Round values along an axis, with labels of equal precision.
struct Ticks {
    std::vector<double> values;       ///< Ascending, within [lo, hi].
    std::vector<std::string> labels;  ///< UTF-8, with a real minus sign; to be multiplied by `factor`.
    std::string factor;               ///< "×10⁻⁷", or empty.
};

/// At most `most` (>= 2) ticks at multiples of 1, 2 or 5 times a power of ten. Very large and very small values share a
/// power of ten. A range too narrow for its numbers (lo == hi above all) gives one tick, at `lo`. lo <= hi, both
/// finite.
Ticks niceTicks(double lo, double hi, int most);

/// At most `most` (>= 2) ticks of a logarithmic axis: powers of ten, or every second, third … of them; where only one
/// or none is in the range, 1, 2 and 5 times them; where these are too few too, round values. 0 < lo < hi, both finite.
Ticks logTicks(double lo, double hi, int most);

/// The edges of so many equal bands, or every second, third … of them: at most `most` + 1 ticks, the first at `lo`, the
/// last at `hi`. Where no such step divides the bands, only the gap below the last is wider. lo < hi, both finite.
/// Labels have at most four digits, or as many as tell narrow bands apart.
Ticks bandTicks(double lo, double hi, int bands, int most);

}  // namespace aeolic
