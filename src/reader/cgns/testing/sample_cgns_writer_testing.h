#pragma once

/// What the sample files of CGNS are written with; compiled into the tests only.

#include <vtk_cgns.h>

#include VTK_CGNS(cgnslib.h)

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "reader/cgns/testing/sample_cgns.h"

namespace aeolic::test {

constexpr int kCells = 4, kPoints = kCells + 1;

inline void sound(int status)
{
    if (status != CG_OK) throw std::runtime_error(cg_get_error());
}

inline cgsize_t pointNumber(int i, int j, int k)
{
    return 1 + i + kPoints * (j + kPoints * cgsize_t(k));
}

inline std::vector<glm::dvec3> boxPoints(double shift, int layer = 0)
{
    std::vector<glm::dvec3> points;
    for (int k = -layer; k < kPoints + layer; ++k)
        for (int j = -layer; j < kPoints + layer; ++j)
            for (int i = -layer; i < kPoints + layer; ++i) points.emplace_back(shift + i, j, k);
    return points;
}

class CgnsFile {
public:
    explicit CgnsFile(const std::string& path)
    {
        sound(cg_set_file_type(CG_FILE_HDF5));
        sound(cg_open(path.c_str(), CG_MODE_WRITE, &file_));
    }
    ~CgnsFile() { cg_close(file_); }
    CgnsFile(const CgnsFile&) = delete;
    CgnsFile& operator=(const CgnsFile&) = delete;

    int base(const char* name, int cells, int space)
    {
        sound(cg_base_write(file_, name, cells, space, &base_));
        return base_;
    }

    void zone(const char* name, std::vector<cgsize_t> size, bool structured)
    {
        sound(cg_zone_write(file_, base_, name, size.data(),
                            structured ? CGNS_ENUMV(Structured) : CGNS_ENUMV(Unstructured), &zone_));
    }

    void go(std::vector<std::pair<const char*, int>> labels) const
    {
        std::vector<char*> names;
        std::vector<int> numbers;
        for (auto& [label, number] : labels) {
            names.push_back(const_cast<char*>(label));
            numbers.push_back(number);
        }
        sound(cg_golist(file_, base_, int(labels.size()), names.data(), numbers.data()));
    }
    void goZone() const { go({{"Zone_t", zone_}}); }

    /// An array beneath the node that was gone to.
    void array(const char* name, const std::vector<double>& values, std::vector<cgsize_t> shape, bool doubles) const
    {
        const std::vector<float> floats(values.begin(), values.end());
        sound(cg_array_write(name, doubles ? CGNS_ENUMV(RealDouble) : CGNS_ENUMV(RealSingle), int(shape.size()),
                             shape.data(), doubles ? static_cast<const void*>(values.data()) : floats.data()));
    }

    int file_ = 0, base_ = 0, zone_ = 0;
};

inline std::vector<double> component(const std::vector<glm::dvec3>& values, int c)
{
    std::vector<double> numbers;
    for (const glm::dvec3& value : values) numbers.push_back(value[c]);
    return numbers;
}

/// Writes the elements of a box that is not structured. Gets where the faces of floor, lid and inlet begin.
std::array<cgsize_t, 3> writeBoxElements(const CgnsFile& file, const SampleCgns& sample);

}  // namespace aeolic::test
