#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace aeolic::testkit {

/// A .vti of three floats a sample, U, around [-1, 1]^3, whose data are a hole in the file: it takes no room on the
/// disk, and however large it is only its ends can be read.
inline void writeSparseGrid(const std::string& path, const std::array<std::int64_t, 3>& dims)
{
    std::string extent, spacing;
    for (const std::int64_t samples : dims) {
        extent += "0 " + std::to_string(samples - 1) + " ";
        spacing += std::to_string(2.0 / double(samples - 1)) + " ";
    }
    std::ofstream(path, std::ios::binary)
        << "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
           "<ImageData WholeExtent=\""
        << extent << "\" Origin=\"-1 -1 -1\" Spacing=\"" << spacing << "\">\n<Piece Extent=\"" << extent
        << "\"><PointData Vectors=\"U\"><DataArray type=\"Float32\" Name=\"U\" NumberOfComponents=\"3\" "
           "format=\"appended\" offset=\"0\"/></PointData></Piece></ImageData>\n<AppendedData encoding=\"raw\">_";
    const auto bytes = std::uint64_t(dims[0] * dims[1] * dims[2]) * 12;
    std::ofstream file(path, std::ios::binary | std::ios::app);
    for (int i = 0; i < 8; ++i) file.put(char(bytes >> (8 * i)));  // Little-endian.
    file.flush();
    std::filesystem::resize_file(path, std::filesystem::file_size(path) + bytes);
    file.seekp(0, std::ios::end);
    file << "\n</AppendedData></VTKFile>\n";
}

}  // namespace aeolic::testkit
