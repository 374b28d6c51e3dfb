#pragma once

/// Small netCDF files of grids for the tests, by the netCDF library; compiled into the tests only.

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace aeolic::test {

enum class NetcdfForm { classic, offsets64, netcdf4 };

/// Writes a file; it is whole when the writer ends. Throws std::runtime_error.
class NetcdfWriter {
public:
    using Texts = std::map<std::string, std::string>;
    using Numbers = std::map<std::string, double>;

    explicit NetcdfWriter(const std::string& path, NetcdfForm form = NetcdfForm::classic);
    ~NetcdfWriter();
    NetcdfWriter(const NetcdfWriter&) = delete;
    NetcdfWriter& operator=(const NetcdfWriter&) = delete;

    void dimension(const std::string& name, std::size_t length);

    /// `value` gets the last three indices, of fewer dimensions zeros first. Numbers are floats, or `shorts`.
    void variable(const std::string& name, const std::vector<std::string>& dimensions,
                  const std::function<double(int, int, int)>& value, const Texts& texts = {},
                  const Numbers& numbers = {}, bool shorts = false);

    /// The coordinates along a dimension.
    void line(const std::string& name, const std::function<double(int)>& place, const Texts& texts);

private:
    int file_ = 0;
};

/// Three steps of time: uo and vo flow around the middle of a sea of 9 x 8 points in 3 layers, with thetao; an island
/// is missing. The maps "u10" and "v10", packed in shorts, stand on the same places.
void writeSampleNetcdf(const std::string& path, NetcdfForm form);

}  // namespace aeolic::test
