#pragma once

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "data/array_choice.h"

namespace aeolic {

/// What is known of an array before it is read.
struct ArrayInfo {
    std::string name;
    bool onPoints = true;  ///< Else on cells.
    int components = 1;
    int vtkType = 0;  ///< VTK_FLOAT, …
    bool activeVectors = false;
    bool activeNormals = false;
};

std::vector<ArrayInfo> arraysOf(vtkDataSet& data);

/// "U (points, 3 components), p (cells, 1 component)", or "none".
std::string listArrays(const std::vector<ArrayInfo>& arrays);

/// The same arrays, each name once.
ArrayChoices offeredArrays(const std::vector<ArrayInfo>& arrays);

/// The vectors to draw: `name`, on the points rather than on the cells; where it is empty the active vectors, else the
/// only float array of three components that is not the normals. Throws InputError naming `where` and what there is.
const ArrayInfo& chooseVectors(const std::vector<ArrayInfo>& arrays, const std::string& name, const std::string& where);

/// A scalar as the user names it: an array of one component, or NAME:mag for the length of one with more.
struct ScalarChoice {
    ArrayInfo array;
    bool magnitude = false;
    std::string label() const { return magnitude ? "|" + array.name + "|" : array.name; }
};

/// Nothing where no array has that name. Throws InputError if it has several components and no ":mag".
std::optional<ScalarChoice> findScalar(const std::vector<ArrayInfo>& arrays, const std::string& spec,
                                       const std::string& where);

/// Arrays that say which points or cells do not count, in the same data set: they are read along with what they mask.
bool isMaskName(const std::string& name);

vtkDataArray* findArray(vtkDataSet& data, const std::string& name, bool onPoints);
vtkSmartPointer<vtkFloatArray> toFloats(vtkDataArray* array);       ///< The array itself where it holds floats already.
vtkSmartPointer<vtkFloatArray> magnitudes(vtkFloatArray& vectors);  ///< One value per tuple, parallel.

struct MaskResult {
    std::int64_t masked = 0, nonFinite = 0;  ///< Tuples.
    double maxMagnitude = 0;                 ///< Of the tuples left.
    /// "a.vti: array 'U': 12 of 100 points are masked"; nothing if all count.
    std::optional<std::string> warning(const std::string& where, const ArrayInfo& array, std::int64_t tuples) const;
};

/// Sets to NaN every tuple with a value that is not finite, or that the data's mask arrays or ghost flags hide. One
/// parallel pass in place; pages without a masked value are only read.
MaskResult maskInvalid(vtkFloatArray& values, vtkDataSet& data, bool onPoints);

}  // namespace aeolic
