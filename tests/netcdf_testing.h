#pragma once

#include <gtest/gtest.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/vtk/file_reader.h"
#include "data/vtk/testing/sample_files.h"
#include "reader/netcdf/testing/sample_netcdf.h"

namespace aeolic::testkit {

inline constexpr const char *kEast = "degrees_east", *kNorth = "degrees_north";

/// The dimensions "lat" and "lon" with their coordinates, from 0 on, a degree apart.
inline void addMap(test::NetcdfWriter& file, std::size_t rows, std::size_t columns)
{
    file.dimension("lat", rows);
    file.dimension("lon", columns);
    file.line("lat", [](int i) { return i; }, {{"units", kNorth}});
    file.line("lon", [](int i) { return i; }, {{"units", kEast}});
}

/// A file, and what the reader's process tells of it.
class NetcdfGrids : public testing::Test {
protected:
    const test::TempFolder folder_;
    const std::string path_ = folder_.file("a.nc");

    /// All that is in the grid of these arrays.
    vtkSmartPointer<vtkDataSet> read(const std::vector<std::string>& names, std::optional<double> time = {}) const
    {
        FileReader reader(path_, FileUse::field, time);
        std::vector<ArrayInfo> kept;
        for (const ArrayInfo& array : reader.announcedArrays())
            if (std::find(names.begin(), names.end(), array.name) != names.end()) kept.push_back(array);
        EXPECT_EQ(kept.size(), names.size()) << listArrays(reader.announcedArrays());
        reader.keepOnly(kept);
        return vtkDataSet::SafeDownCast(reader.read({}, "reading"));
    }

    static glm::dvec3 vectorAt(vtkDataSet& data, const char* name, vtkIdType point)
    {
        double v[3];
        data.GetPointData()->GetArray(name)->GetTuple(point, v);
        return {v[0], v[1], v[2]};
    }

    static glm::dvec3 placeOf(vtkDataSet& data, vtkIdType point)
    {
        double p[3];
        data.GetPoint(point, p);
        return {p[0], p[1], p[2]};
    }

    /// What is wrong with the file, or with these arrays of it; empty where nothing is.
    std::string failure(const std::vector<std::string>& names = {}) const
    {
        try {
            if (names.empty())
                FileReader(path_, FileUse::field).announcedArrays();
            else
                read(names);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
};

}  // namespace aeolic::testkit
