#pragma once

#include <vtkDataSet.h>

#include <cstddef>
#include <functional>

#include "base/bounds.h"

namespace aeolic {

/// The boxes around a data set's cells. Any thread may ask, as long as the data set stays as it is.
std::function<Bounds(std::size_t cell)> cellBoxesOf(vtkDataSet& data);

/// The boxes of all cells where they are finite. Cost: one parallel pass.
Bounds boundsOfCells(vtkDataSet& data);

/// A box with an inside, none of whose sides is infinitely far.
bool isFinite(const Bounds& box);

}  // namespace aeolic
