// Writes a built-in flow as raw image data (.vti), layer by layer: fields larger than the memory, for bench/large.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "data/builtin/flows.h"

namespace aeolic {
namespace {

constexpr double kHalfSide = 3.5;  // The box that the field fills, around the built-in teapot.

void writeField(const std::string& flow, int samples, const std::string& path)
{
    const double spacing = 2 * kHalfSide / (samples - 1);
    Bounds bounds;
    bounds.add(glm::dvec3(-kHalfSide));
    bounds.add(glm::dvec3(kHalfSide));
    const auto layer = std::size_t(samples) * std::size_t(samples);
    const std::uint64_t bytes = layer * std::size_t(samples) * sizeof(glm::vec3);

    std::ofstream file(path, std::ios::binary);
    const std::string extent = "0 " + std::to_string(samples - 1);
    file << "<?xml version=\"1.0\"?>\n"
         << "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
         << "<ImageData WholeExtent=\"" << extent << " " << extent << " " << extent << "\" Origin=\"" << -kHalfSide
         << " " << -kHalfSide << " " << -kHalfSide << "\" Spacing=\"";
    file.precision(17);
    file << spacing << " " << spacing << " " << spacing << "\">\n<Piece Extent=\"" << extent << " " << extent << " "
         << extent << "\">\n<PointData Vectors=\"U\"><DataArray type=\"Float32\" Name=\"U\" NumberOfComponents=\"3\" "
         << "format=\"appended\" offset=\"0\"/></PointData>\n</Piece>\n</ImageData>\n"
         << "<AppendedData encoding=\"raw\">_";
    file.write(reinterpret_cast<const char*>(&bytes), sizeof bytes);

    std::vector<glm::vec3> values(layer);
    for (int z = 0; z < samples && file; ++z) {
        parallelFor(std::size_t(samples), [&](std::size_t y) {
            for (std::size_t x = 0; x < std::size_t(samples); ++x)
                values[y * std::size_t(samples) + x] =
                    builtinFlow(flow, glm::dvec3(double(x), double(y), double(z)) * spacing - kHalfSide, bounds);
        });
        file.write(reinterpret_cast<const char*>(values.data()), std::streamsize(layer * sizeof(glm::vec3)));
    }
    file << "\n</AppendedData>\n</VTKFile>\n";
    file.close();
    if (!file) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace
}  // namespace aeolic

int main(int argc, char** argv)
{
    if (argc != 4) {
        std::fprintf(stderr, "usage: aeolic_large_field FLOW SAMPLES OUT.vti\n");
        return 2;
    }
    try {
        aeolic::writeField(argv[1], std::atoi(argv[2]), argv[3]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "aeolic_large_field: %s\n", error.what());
        return 1;
    }
}
