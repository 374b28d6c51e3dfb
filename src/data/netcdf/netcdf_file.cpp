#include "data/netcdf/netcdf_file.h"

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/binary/file_bytes.h"
#include "data/hdf5/hdf5_store.h"

namespace aeolic {

std::unique_ptr<const NetcdfFile> NetcdfFile::open(const std::string& path)
{
    const FileBytes file(path);
    const auto start = file.read(0, std::min<std::uint64_t>(file.size(), 3), "the start");
    if (std::string(start.begin(), start.end()) == "CDF") return openClassicNetcdf(path);
    if (isHdf5File(path)) return openNetcdf4(path);
    throw InputError(path, "it does not begin like a netCDF file", "netCDF");
}

std::vector<std::string> NetcdfFile::texts(const std::string& variable) const
{
    const std::vector<std::uint64_t> lengths = shape(variable);
    const std::vector<std::uint8_t> all = characters(variable);
    const std::uint64_t length = lengths.empty() ? all.size() : lengths.back();
    std::vector<std::string> texts;
    for (std::uint64_t at = 0; length > 0 && at + length <= all.size(); at += length) {
        std::string text(all.begin() + std::ptrdiff_t(at), all.begin() + std::ptrdiff_t(at + length));
        text.erase(std::min(text.find('\0'), text.size()));
        while (!text.empty() && text.back() == ' ') text.pop_back();
        texts.push_back(withoutControls(std::move(text), '?'));
    }
    return texts;
}

void NetcdfFile::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(path_, found, expected);
}

}  // namespace aeolic
