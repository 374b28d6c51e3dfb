#include "pieces_testing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

namespace aeolic::testkit {
namespace {

constexpr const char* kHead =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"%\" version=\"0.1\" byte_order=\"LittleEndian\">\n";

std::string head(const std::string& kind)
{
    std::string text = kHead;
    return text.replace(text.find('%'), 1, kind);
}

struct Wedge {
    std::vector<std::array<double, 3>> points, normals;
    std::vector<std::vector<int>> polygons, strips;
};

Wedge makeWedge(const TorusPieces& torus, int piece)
{
    Wedge wedge;
    const int us = torus.aroundWedge, vs = torus.aroundTube;
    for (int i = 0; i <= us; ++i)
        for (int j = 0; j < vs; ++j) {
            const double u = 2 * std::numbers::pi * (piece + double(i) / us) / torus.pieces,
                         v = 2 * std::numbers::pi * j / vs, r = torus.size * (1 + 0.4 * std::cos(v));
            wedge.points.push_back(
                {1000.3 + r * std::cos(u), -20 + r * std::sin(u), 5 + 0.4 * torus.size * std::sin(v)});
            wedge.normals.push_back({std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)});
        }
    const auto at = [&](int i, int j) { return i * vs + j % vs; };
    for (int i = 0; i < us; ++i) {
        std::vector<int> strip;
        for (int j = 0; j <= vs; ++j) {
            if (piece == torus.strips && i >= 2) {
                strip.push_back(at(i, j));
                strip.push_back(at(i + 1, j));
            } else if (j < vs) {
                wedge.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        }
        if (!strip.empty()) wedge.strips.push_back(strip);
    }
    if (piece == torus.noArea) wedge.polygons.push_back({0, 1, 0});
    if (piece == torus.notFinite) {
        wedge.polygons.push_back({0, 1, int(wedge.points.size())});
        wedge.points.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
        wedge.normals.push_back({0, 0, 1});
    }
    if (piece == torus.brokenNormal) wedge.normals[3] = {0, 0, 0};
    return wedge;
}

template <class Values>
void writeArray(std::ofstream& file, const std::string& attributes, const Values& values)
{
    file << "<DataArray " << attributes << " format=\"ascii\">\n";
    for (const auto& value : values) file << value << ' ';
    file << "</DataArray>\n";
}

void writeCells(std::ofstream& file, const std::string& kind, const std::vector<std::vector<int>>& cells)
{
    std::vector<int> ids, ends;
    for (const auto& cell : cells) {
        ids.insert(ids.end(), cell.begin(), cell.end());
        ends.push_back(int(ids.size()));
    }
    file << '<' << kind << '>';
    writeArray(file, "type=\"Int64\" Name=\"connectivity\"", ids);
    writeArray(file, "type=\"Int64\" Name=\"offsets\"", ends);
    file << "</" << kind << ">\n";
}

std::vector<double> flat(const std::vector<std::array<double, 3>>& values)
{
    std::vector<double> all;
    for (const auto& value : values) all.insert(all.end(), value.begin(), value.end());
    return all;
}

void writeData(std::ofstream& file, const Wedge& wedge, const TorusPieces& torus, int piece)
{
    const std::size_t count = torus.onCells ? wedge.polygons.size() + wedge.strips.size() : wedge.points.size();
    std::vector<double> tau, q;
    for (std::size_t i = 0; i < count; ++i) {
        const double a = 0.7 * double(i) + piece;
        tau.insert(tau.end(), {std::sin(0.1 * a) + 0.2, std::cos(0.13 * a), 0.3});
        q.push_back(std::sin(0.05 * a) + 0.1 * piece);
    }
    const std::string other = piece == torus.otherArrays ? "2" : "";
    const auto arrays = [&] {
        writeArray(file, "type=\"Float32\" Name=\"tau" + other + "\" NumberOfComponents=\"3\"", tau);
        writeArray(file, "type=\"Float32\" Name=\"q" + other + "\"", q);
    };
    file << "<PointData" << (torus.normals ? " Normals=\"Normals\"" : "") << ">\n";
    if (!torus.onCells) arrays();
    if (torus.normals)
        writeArray(file, "type=\"Float32\" Name=\"Normals\" NumberOfComponents=\"3\"", flat(wedge.normals));
    file << "</PointData><CellData>\n";
    if (torus.onCells) arrays();
    file << "</CellData>\n";
}

void writeWedge(const std::string& path, const TorusPieces& torus, int piece)
{
    const bool empty = std::find(torus.empty.begin(), torus.empty.end(), piece) != torus.empty.end();
    const Wedge wedge = empty ? Wedge() : makeWedge(torus, piece);
    std::ofstream file(path);
    file.precision(17);
    file << head("PolyData") << "<PolyData><Piece NumberOfPoints=\"" << wedge.points.size()
         << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"" << wedge.strips.size()
         << "\" NumberOfPolys=\"" << wedge.polygons.size() << "\">\n";
    writeData(file, wedge, torus, piece);
    file << "<Points>\n";
    writeArray(file, "type=\"Float64\" NumberOfComponents=\"3\"", flat(wedge.points));
    file << "</Points>\n";
    writeCells(file, "Strips", wedge.strips);
    writeCells(file, "Polys", wedge.polygons);
    file << "</Piece></PolyData></VTKFile>\n";
}

}  // namespace

std::string writeTorusPieces(const std::string& folder, const std::string& name, const TorusPieces& torus)
{
    const std::string arrays =
        "<PDataArray type=\"Float32\" Name=\"tau\" NumberOfComponents=\"3\"/><PDataArray type=\"Float32\" Name=\"q\"/>";
    const std::string path = folder + "/" + name + ".pvtp";
    std::ofstream file(path);
    file << head("PPolyData") << "<PPolyData GhostLevel=\"0\">\n<PPointData"
         << (torus.normals ? " Normals=\"Normals\"" : "") << ">" << (torus.onCells ? "" : arrays);
    if (torus.normals) file << "<PDataArray type=\"Float32\" Name=\"Normals\" NumberOfComponents=\"3\"/>";
    file << "</PPointData>\n<PCellData>" << (torus.onCells ? arrays : "")
         << "</PCellData>\n<PPoints><PDataArray type=\"Float64\" NumberOfComponents=\"3\"/></PPoints>\n";
    for (int i = 0; i < torus.pieces; ++i) {
        const std::string piece = name + "_" + std::to_string(i) + ".vtp";
        writeWedge(folder + "/" + piece, torus, i);
        file << "<Piece Source=\"" << piece << "\"/>\n";
    }
    file << "</PPolyData></VTKFile>\n";
    return path;
}

void writeWindingField(const std::string& path, bool masked, double phase)
{
    constexpr int kNx = 19, kNy = 17, kNz = 15;
    std::vector<double> vectors, scalars;
    for (int k = 0; k < kNz; ++k)
        for (int j = 0; j < kNy; ++j)
            for (int i = 0; i < kNx; ++i) {
                const double x = 0.5 * i + phase, y = 0.45 * j, z = 0.55 * k;
                const bool hidden = masked && std::abs(i - 9) < 3 && std::abs(j - 8) < 3 && std::abs(k - 7) < 2;
                vectors.insert(vectors.end(),
                               {std::sin(z) + std::cos(y), std::sin(x) + std::cos(z), std::sin(y) + 0.2});
                scalars.push_back(hidden ? std::numeric_limits<double>::quiet_NaN()
                                         : std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) +
                                               std::sin(z) * std::cos(x));
            }
    std::ofstream file(path);
    file.precision(9);
    file << head("ImageData")
         << "<ImageData WholeExtent=\"0 18 0 16 0 14\" Origin=\"9 -7 3\" Spacing=\"0.1 0.11 0.09\">"
         << "<Piece Extent=\"0 18 0 16 0 14\"><PointData>\n";
    writeArray(file, "type=\"Float32\" Name=\"U\" NumberOfComponents=\"3\"", vectors);
    writeArray(file, "type=\"Float32\" Name=\"p\"", scalars);
    file << "</PointData></Piece></ImageData></VTKFile>\n";
}

}  // namespace aeolic::testkit
