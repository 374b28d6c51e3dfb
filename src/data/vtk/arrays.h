#pragma once

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "data/array_choice.h"
#include "data/bricks.h"
#include "data/tally.h"

namespace aeolic {

/// What is known of an array before it is read.
struct ArrayInfo {
    std::string name;
    bool onPoints = true;  ///< False: on cells.
    int components = 1;
    int vtkType = 0;  ///< VTK_FLOAT, …
    bool activeVectors = false;
    bool activeNormals = false;
};

std::vector<ArrayInfo> arraysOf(vtkDataSet& data);

/// "U (points, 3 components), p (cells, 1 component)", or "none".
std::string listArrays(const std::vector<ArrayInfo>& arrays);

/// What is expected in the place of an array `typed` that is not there: "one of: U (points, 3 components); did you mean
/// U?".
std::string oneOf(const std::vector<ArrayInfo>& arrays, const std::string& typed);

/// "a.vti: array 'U'": how messages begin.
std::string nameOf(const std::string& where, const ArrayInfo& array);

/// These arrays, each name once.
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
    std::int64_t masked = 0, nonFinite = 0;  ///< Counted tuples that were left out.
    std::int64_t all = 0;                    ///< Tuples counted.
    double maxMagnitude = 0;                 ///< The longest of the tuples left, counted or not.
    Tally tally(const std::string& where, const ArrayInfo& array) const;
    void add(const MaskResult& other);
};

/// Sets to NaN every tuple with a value that is not finite, or that the data's mask arrays or ghost flags hide. One
/// parallel pass in place; pages without a masked value are only read. `counted`: where the values are samples that
/// other ranks hold too, which of them count; null: all.
MaskResult maskInvalid(vtkFloatArray& values, vtkDataSet& data, bool onPoints, const CountedSamples* counted = nullptr);

/// What maskInvalid() would find in floats of these values, which stay as they are. Floats are not copied.
MaskResult countInvalid(vtkDataArray& values, vtkDataSet& data, bool onPoints);

/// How many of the finite values are too large for half precision, each component by itself. `counted`: which samples
/// count; null: all.
std::int64_t countBeyondHalves(vtkFloatArray& values, const CountedSamples* counted = nullptr);

}  // namespace aeolic
