#pragma once

#include <vtkDataSetAttributes.h>

#include "reader/vtk/legacy/legacy_text.h"

namespace aeolic {

/// Reads one attribute behind its keyword ("SCALARS", "VECTORS", "FIELD" …) for `tuples` points or cells. The first of
/// a kind becomes the active one. Returns false where the keyword is no attribute's.
bool readLegacyAttribute(LegacyText& text, const std::string& keyword, vtkDataSetAttributes& data, std::int64_t tuples);

/// Reads the arrays behind "FIELD".
void readLegacyField(LegacyText& text, vtkFieldData& data);

}  // namespace aeolic
