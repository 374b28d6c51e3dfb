#pragma once

#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/byte_message.h"
#include "data/array_choice.h"
#include "data/bricks.h"
#include "data/tally.h"
#include "description/color_by.h"

namespace aeolic {

/// What is known of an array before it is read.
struct ArrayInfo {
    std::string name;
    bool onPoints = true;  ///< False: on cells.
    int components = 1;
    int vtkType = 0;  ///< VTK_FLOAT, …
    bool activeVectors = false;
    bool activeNormals = false;
    std::vector<std::string> of = {};  ///< The file has its components only, as arrays of these names.
};

/// The members that a reader tells of an array: all but `of`.
template <PerhapsConst<ArrayInfo> Array, class Visit>
void withMembers(Array& array, const Visit& visit)
{
    visit(array.name, array.onPoints, array.components, array.vtkType, array.activeVectors, array.activeNormals);
}

/// The one of this name on points, or where `onPoints` is false on cells; null where there is none.
const ArrayInfo* findInfo(const std::vector<ArrayInfo>& arrays, const std::string& name, bool onPoints);

/// The arrays on the points, or where `onPoints` is false on the cells.
vtkDataSetAttributes* attributesOf(vtkDataSet& data, bool onPoints);

/// Gives `some` arrays like those of `all`, with the values of what `ids` lists, in that order.
void takeTuples(vtkDataSetAttributes& all, vtkIdList& ids, vtkDataSetAttributes& some);

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

/// The vectors to draw: `name` (also point:NAME or cell:NAME), on the points rather than on the cells. Where it is
/// empty the active vectors, else the only ones of the best kind that there is: floats of three components that are not
/// the normals, whole numbers, such as are put together of scalars, and two components, which are enough in flat data.
/// Throws InputError naming `where` and what there is.
const ArrayInfo& chooseVectors(const std::vector<ArrayInfo>& arrays, const std::string& name, const std::string& where);

/// A scalar as the user names it: an array of one component, or of one with more its length or a component.
struct ScalarChoice {
    ArrayInfo array;
    ArrayPart part = ArrayPart::whole;
    std::string label() const { return labelOf(array.name, part); }
};

/// Nothing where no array has that name. Throws InputError if it has several components and no part of it is named.
std::optional<ScalarChoice> findScalar(const std::vector<ArrayInfo>& arrays, const std::string& spec,
                                       const std::string& where);

bool sameArray(const ArrayInfo& a, const ArrayInfo& b);

/// Throws InputError where a part that needs the surface's normal is asked of an array that is not the vectors that
/// streaks follow. `vectors`: those; null: there are none here.
void requireOfVectors(const ScalarChoice& scalar, const ArrayInfo* vectors, const std::string& where);

/// Arrays that say which points or cells do not count, in the same data set: they are read along with what they mask.
bool isMaskName(const std::string& name);

vtkDataArray* findArray(vtkDataSet& data, const std::string& name, bool onPoints);
vtkSmartPointer<vtkFloatArray> toFloats(vtkDataArray* array);  ///< The array itself where it holds floats already.
/// One value for each tuple: the length, or a component. Parallel. `part`: one of these.
vtkSmartPointer<vtkFloatArray> partOf(vtkFloatArray& vectors, ArrayPart part);

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
