#include "reader/netcdf/testing/sample_netcdf.h"

#include <netcdf.h>

#include <numeric>
#include <stdexcept>

namespace aeolic::test {
namespace {

void need(int status, int also = NC_NOERR)
{
    if (status != NC_NOERR && status != also) throw std::runtime_error(nc_strerror(status));
}

}  // namespace

NetcdfWriter::NetcdfWriter(const std::string& path, NetcdfForm form)
{
    constexpr int modes[] = {NC_CLOBBER, NC_CLOBBER | NC_64BIT_OFFSET, NC_CLOBBER | NC_NETCDF4};
    need(nc_create(path.c_str(), modes[std::size_t(form)], &file_));
}

NetcdfWriter::~NetcdfWriter()
{
    nc_close(file_);
}

void NetcdfWriter::dimension(const std::string& name, std::size_t length)
{
    need(nc_redef(file_), NC_EINDEFINE);
    int id = 0;
    need(nc_def_dim(file_, name.c_str(), length, &id));
}

void NetcdfWriter::variable(const std::string& name, const std::vector<std::string>& dimensions,
                            const std::function<double(int, int, int)>& value, const Texts& texts,
                            const Numbers& numbers, bool shorts)
{
    std::vector<int> ids;
    std::vector<std::size_t> shape;
    for (const std::string& dimension : dimensions) {
        ids.push_back(0);
        need(nc_inq_dimid(file_, dimension.c_str(), &ids.back()));
        shape.push_back(0);
        need(nc_inq_dimlen(file_, ids.back(), &shape.back()));
    }
    need(nc_redef(file_), NC_EINDEFINE);
    int id = 0;
    const nc_type type = shorts ? NC_SHORT : NC_FLOAT;
    need(nc_def_var(file_, name.c_str(), type, int(ids.size()), ids.data(), &id));
    for (const auto& [key, text] : texts) need(nc_put_att_text(file_, id, key.c_str(), text.size(), text.c_str()));
    for (const auto& [key, number] : numbers)
        need(nc_put_att_double(file_, id, key.c_str(), key == "_FillValue" ? type : NC_DOUBLE, 1, &number));
    need(nc_enddef(file_));
    const std::size_t count = std::accumulate(shape.begin(), shape.end(), std::size_t(1), std::multiplies<>());
    std::vector<double> values;
    std::vector<std::size_t> at(shape.size(), 0);
    for (std::size_t i = 0; i < count; ++i) {
        const auto back = [&](std::size_t k) { return k < at.size() ? int(at[at.size() - 1 - k]) : 0; };
        values.push_back(value(back(2), back(1), back(0)));
        for (std::size_t k = at.size(); k-- > 0 && ++at[k] == shape[k];) at[k] = 0;
    }
    need(nc_put_var_double(file_, id, values.data()));
}

void NetcdfWriter::line(const std::string& name, const std::function<double(int)>& place, const Texts& texts)
{
    variable(
        name, {name}, [&](int, int, int x) { return place(x); }, texts);
}

void writeSampleNetcdf(const std::string& path, NetcdfForm form)
{
    constexpr int kColumns = 9, kRows = 8;
    NetcdfWriter file(path, form);
    file.dimension("time", 3);
    file.dimension("depth", 3);
    file.dimension("lat", kRows);
    file.dimension("lon", kColumns);
    file.line("time", [](int i) { return 6 * i; }, {{"units", "hours since 2000-01-01"}});
    file.line("depth", [](int i) { return 1 + 9 * i * i; }, {{"units", "m"}, {"positive", "down"}});
    file.line("lat", [](int i) { return 54.0 - i; }, {{"units", "degrees_north"}});
    file.line("lon", [](int i) { return 2.0 + i; }, {{"units", "degrees_east"}});
    const auto isLand = [](int y, int x) { return x == 6 && y > 2 && y < 5; };
    const NetcdfWriter::Numbers fill{{"_FillValue", 1e20}}, packed{{"_FillValue", -32767}, {"scale_factor", 0.01}};
    const std::vector<std::string> layers{"time", "depth", "lat", "lon"}, maps{"time", "lat", "lon"};
    const auto sea = [&](const char* name, const std::function<double(int, int, int)>& value) {
        file.variable(
            name, layers, [&](int z, int y, int x) { return isLand(y, x) ? 1e20 : value(z, y, x); }, {}, fill);
    };
    sea("uo", [&](int z, int y, int) { return (y - kRows / 2.0) / (z + 1); });
    sea("vo", [&](int z, int, int x) { return (x - kColumns / 2.0) / (z + 1); });
    sea("thetao", [](int z, int y, int) { return 20 - 5 * z - y; });
    file.variable(
        "u10", maps, [](int, int y, int) { return 500 - 10 * y; }, {}, packed, true);
    file.variable(
        "v10", maps, [](int, int, int x) { return 50 * x; }, {}, packed, true);
}

}  // namespace aeolic::test
