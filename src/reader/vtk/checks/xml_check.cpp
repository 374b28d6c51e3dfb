#include "reader/vtk/checks/xml_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "aeolic/error.h"
#include "reader/vtk/checks/grid_cover.h"
#include "reader/vtk/checks/xml_cells.h"
#include "reader/vtk/checks/xml_values.h"

namespace aeolic {
namespace {

constexpr int deepestBlocks = 3;  // Files that name files that name files.

std::string textOf(vtkXMLDataElement& element, const char* attribute)
{
    const char* value = element.GetAttribute(attribute);
    return value ? value : "";
}

GridExtent extentIn(vtkXMLDataElement& element, const char* attribute, const std::string& path)
{
    constexpr std::int64_t most = std::int64_t{1} << 30;  // VTK keeps them in 32 bits, and differences of them.
    const std::string text = textOf(element, attribute);
    GridExtent extent{};
    const char *at = text.data(), *const end = text.data() + text.size();
    for (std::int64_t& bound : extent) {
        while (at != end && (*at == ' ' || *at == '\n' || *at == '\t' || *at == '\r')) ++at;
        const auto [stop, error] = std::from_chars(at, end, bound);
        if (error != std::errc{} || bound < -most || bound > most)
            throw InputError(path, fmt::format("its {} is '{:.80}'", attribute, text), "six whole numbers");
        at = stop;
    }
    for (std::size_t c = 0; c < 3; ++c)
        if (extent[2 * c + 1] < extent[2 * c])
            throw InputError(path, fmt::format("its {} is '{:.80}'", attribute, text),
                             "no upper bound below the lower");
    return extent;
}

struct Counts {
    std::uint64_t points = 0, cells = 0;
};

constexpr std::uint64_t kMostBlocks = 1 << 20;

Counts countsOf(const GridExtent& extent)
{
    Counts counts{1, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto cells = std::uint64_t(extent[2 * c + 1] - extent[2 * c]);
        counts.points *= cells + 1;  // At most 2^31 each: the product may wrap, so it is compared as a double, too.
        counts.cells *= std::max<std::uint64_t>(cells, 1);
    }
    double points = 1;
    for (std::size_t c = 0; c < 3; ++c) points *= double(extent[2 * c + 1] - extent[2 * c]) + 1;
    if (points > 1e18) counts.points = counts.cells = std::uint64_t{1} << 60;
    return counts;
}

bool contains(const GridExtent& whole, const GridExtent& part)
{
    for (std::size_t c = 0; c < 3; ++c)
        if (part[2 * c] < whole[2 * c] || part[2 * c + 1] > whole[2 * c + 1]) return false;
    return true;
}

class XmlCheck {
public:
    XmlCheck(const std::string& path, int depth) : values_(path), depth_(depth) {}

    std::uint64_t run()
    {
        const std::string type = textOf(values_.root(), "type");
        const auto primaries = childrenOf(values_.root(), type);
        if (primaries.size() != 1)
            throw InputError(path(), fmt::format("it has {} elements '{:.40}'", primaries.size(), type), "one");
        vtkXMLDataElement& primary = *primaries.front();
        steps_ = countSteps(primary);
        checkFieldData(values_.root());
        checkFieldData(primary);
        if (type == "vtkMultiBlockDataSet")
            checkBlocks(primary);
        else if (type.starts_with("P") && type != "PolyData")
            checkParallel(primary, type.substr(1));
        else if (type == "PolyData" || type == "UnstructuredGrid")
            checkUnstructured(primary, type);
        else if (type == "ImageData" || type == "RectilinearGrid" || type == "StructuredGrid")
            checkStructured(primary, type);
        else
            throw InputError(path(), fmt::format("it holds {:.40}", type), "a surface or a grid");
        return bytes_ + values_.bytesInMemory();
    }

private:
    const std::string& path() const { return values_.path(); }

    void checkFieldData(vtkXMLDataElement& parent)
    {
        for (vtkXMLDataElement* data : childrenOf(parent, "FieldData"))
            for (int i = 0; i < data->GetNumberOfNestedElements(); ++i) {
                vtkXMLDataElement& array = *data->GetNestedElement(i);
                values_.requireTuples(array, countIn(array, "NumberOfTuples", path()));
            }
    }

    static std::size_t countSteps(vtkXMLDataElement& primary)
    {
        std::istringstream text(textOf(primary, "TimeValues"));
        std::size_t steps = 0;
        for (double value; text >> value;) ++steps;
        return steps;
    }

    /// VTK leaves the memory of an array as it is at a step for which the file has none of its name.
    void requireSteps(vtkXMLDataElement& piece, const std::string& group)
    {
        if (steps_ == 0) return;
        std::map<std::string, std::pair<vtkXMLDataElement*, std::vector<bool>>> known;
        for (vtkXMLDataElement* data : childrenOf(piece, group))
            for (int i = 0; i < data->GetNumberOfNestedElements(); ++i) {
                vtkXMLDataElement& array = *data->GetNestedElement(i);
                std::vector<int> own(steps_);
                own.resize(std::size_t(array.GetVectorAttribute("TimeStep", int(steps_), own.data())));
                auto& [first, has] = known[textOf(array, "Name")];
                if (!first) first = &array;
                has.resize(steps_, false);
                if (own.empty()) has.assign(steps_, true);
                for (const int step : own)
                    if (step >= 0 && std::size_t(step) < steps_) has[std::size_t(step)] = true;
            }
        for (const auto& [name, array] : known)
            if (const auto gap = std::find(array.second.begin(), array.second.end(), false); gap != array.second.end())
                values_.fail(*array.first, fmt::format("has no TimeStep {}", gap - array.second.begin()),
                             fmt::format("one for each of the {} TimeValues", steps_));
    }

    void checkArrays(vtkXMLDataElement& piece, const char* group, std::uint64_t tuples)
    {
        requireSteps(piece, group);
        std::vector<std::string> names;
        std::set<std::pair<std::string, std::string>> known;  // A file with several steps has an array for each.
        for (vtkXMLDataElement* data : childrenOf(piece, group))
            for (int i = 0; i < data->GetNumberOfNestedElements(); ++i) {
                vtkXMLDataElement& array = *data->GetNestedElement(i);
                if (textOf(array, "Name").empty()) values_.fail(array, "has no Name", "a name for each array");
                if (!known.emplace(textOf(array, "Name"), textOf(array, "TimeStep")).second)
                    values_.fail(array, "is there twice", "each name once");
                values_.requireTuples(array, tuples);
                names.push_back(
                    fmt::format("{} {} {}", textOf(array, "Name"), textOf(array, "type"), componentsOf(array, path())));
            }
        // VTK makes the arrays as the first piece has them, and then fills in all pieces.
        const auto [first, isNew] = arrays_.try_emplace(group, names);
        if (!isNew && first->second != names && tuples > 0)
            throw InputError(path(), fmt::format("the {} of its pieces differ", group),
                             "the same arrays, in the same order, in every piece");
    }

    void checkPoints(vtkXMLDataElement& piece, std::uint64_t points)
    {
        requireSteps(piece, "Points");
        std::size_t arrays = 0;
        for (vtkXMLDataElement* element : childrenOf(piece, "Points"))
            for (int i = 0; i < element->GetNumberOfNestedElements(); ++i, ++arrays) {
                vtkXMLDataElement& array = *element->GetNestedElement(i);
                if (componentsOf(array, path()) != 3 || typeOf(array) == VTK_STRING)
                    values_.fail(array, "is not an array of 3 numbers", "x, y and z of each point");
                values_.requireTuples(array, points);
            }
        if (arrays == 0 && points > 0)
            throw InputError(path(), fmt::format("it has no Points for {} points", points), "Points");
    }

    void checkUnstructured(vtkXMLDataElement& primary, const std::string& type)
    {
        const auto pieces = childrenOf(primary, "Piece");
        if (pieces.empty()) throw InputError(path(), "it has no Piece", "at least one");
        std::uint64_t all = 0;
        for (vtkXMLDataElement* piece : pieces) {
            const std::uint64_t points = countIn(*piece, "NumberOfPoints", path());
            all += points;
            checkPoints(*piece, points);
            std::uint64_t cells = 0;
            for (const char* group : {"Cells", "Verts", "Lines", "Strips", "Polys"}) requireSteps(*piece, group);
            if (type == "UnstructuredGrid") {
                cells = countIn(*piece, "NumberOfCells", path());
                checkXmlCells(values_, *piece, "Cells", cells, points);
                checkXmlPolyhedra(values_, *piece, cells, points);
            } else {
                for (const std::string kind : {"Verts", "Lines", "Strips", "Polys"}) {
                    const std::uint64_t some = countIn(*piece, ("NumberOf" + kind).c_str(), path());
                    checkXmlCells(values_, *piece, kind, some, points);
                    cells += some;
                }
            }
            checkArrays(*piece, "PointData", points);
            checkArrays(*piece, "CellData", cells);
        }
        // VTK makes the points as the first piece has them.
        if (all > 0 && childrenOf(*pieces.front(), "Points").empty())
            throw InputError(path(), fmt::format("its first piece has no Points, and all have {} points", all),
                             "Points in every piece");
    }

    void checkStructured(vtkXMLDataElement& primary, const std::string& type)
    {
        const GridExtent whole = extentIn(primary, "WholeExtent", path());
        checkPlace(primary);
        std::vector<GridExtent> extents;
        for (vtkXMLDataElement* piece : childrenOf(primary, "Piece")) {
            const GridExtent extent = extents.emplace_back(pieceExtent(*piece, whole));
            const Counts counts = countsOf(extent);
            if (type == "StructuredGrid") checkPoints(*piece, counts.points);
            if (type == "RectilinearGrid") checkCoordinates(*piece, extent);
            checkArrays(*piece, "PointData", counts.points);
            checkArrays(*piece, "CellData", counts.cells);
        }
        requireCovered(extents, whole);
    }

    /// VTK takes what it cannot read for 1 or 0.
    void checkPlace(vtkXMLDataElement& primary)
    {
        const std::pair<const char*, std::size_t> attributes[] = {{"Origin", 3}, {"Spacing", 3}, {"Direction", 9}};
        for (const auto& [name, count] : attributes) {
            if (!primary.GetAttribute(name)) continue;
            std::istringstream text(textOf(primary, name));
            std::size_t found = 0;
            for (double value; text >> value; ++found) {
            }
            if (found != count || !text.eof())
                throw InputError(path(), fmt::format("its {} is '{:.80}'", name, textOf(primary, name)),
                                 fmt::format("{} finite numbers", count));
        }
    }

    GridExtent pieceExtent(vtkXMLDataElement& piece, const GridExtent& whole)
    {
        const GridExtent extent = extentIn(piece, "Extent", path());
        if (!contains(whole, extent))
            throw InputError(path(), fmt::format("a piece has the Extent '{}'", textOf(piece, "Extent")),
                             "one within the WholeExtent");
        return extent;
    }

    void requireCovered(const std::vector<GridExtent>& pieces, const GridExtent& whole)
    {
        if (const auto cell = firstUncovered(pieces, whole))
            throw InputError(
                path(), fmt::format("none of its pieces has cell ({}, {}, {})", (*cell)[0], (*cell)[1], (*cell)[2]),
                "pieces that cover its WholeExtent");
    }

    void checkCoordinates(vtkXMLDataElement& piece, const GridExtent& extent)
    {
        const auto all = childrenOf(piece, "Coordinates");
        if (all.size() != 1 || all.front()->GetNumberOfNestedElements() != 3)
            throw InputError(path(), "a piece has no Coordinates of three arrays", "x, y and z");
        for (std::size_t c = 0; c < 3; ++c) {
            vtkXMLDataElement& array = *all.front()->GetNestedElement(int(c));
            if (componentsOf(array, path()) != 1 || typeOf(array) == VTK_STRING)
                values_.fail(array, "has several components", "one number for each layer");
            values_.requireTuples(array, std::uint64_t(extent[2 * c + 1] - extent[2 * c]) + 1);
        }
    }

    void checkParallel(vtkXMLDataElement& primary, const std::string& type)
    {
        const bool structured = type != "PolyData" && type != "UnstructuredGrid";
        const GridExtent whole = structured ? extentIn(primary, "WholeExtent", path()) : GridExtent{};
        const auto pieces = childrenOf(primary, "Piece");
        if (pieces.empty()) throw InputError(path(), "it has no Piece", "at least one");
        checkPlace(primary);
        std::vector<GridExtent> extents;
        for (vtkXMLDataElement* piece : pieces) {
            if (structured) extents.push_back(pieceExtent(*piece, whole));
            checkPiece(*piece, primary, type, structured);
        }
        if (structured) requireCovered(extents, whole);
    }

    /// A piece must have what the file says of it, because VTK makes room for that.
    void checkPiece(vtkXMLDataElement& piece, vtkXMLDataElement& primary, const std::string& type, bool structured)
    {
        const std::string file = fileNamed(textOf(piece, "Source"));
        checkNamed(file);
        const XmlValues inside(file);
        const auto primaries = childrenOf(inside.root(), type);
        if (textOf(inside.root(), "type") != type || primaries.size() != 1)
            throw InputError(path(), fmt::format("its piece {} holds '{:.40}'", file, textOf(inside.root(), "type")),
                             type);
        vtkXMLDataElement& held = *primaries.front();
        if (structured && extentIn(held, "WholeExtent", file) != extentIn(piece, "Extent", path()))
            throw InputError(path(),
                             fmt::format("its piece {} has the WholeExtent '{}'", file, textOf(held, "WholeExtent")),
                             "that of the Piece, '" + textOf(piece, "Extent") + "'");
        for (const char* group : {"PointData", "CellData", "Points", "Coordinates"})
            for (vtkXMLDataElement* data : childrenOf(primary, std::string("P") + group))
                checkSame(*data, held, group, file);
    }

    void checkSame(vtkXMLDataElement& declared, vtkXMLDataElement& held, const char* group, const std::string& file)
    {
        const bool named = std::string(group).ends_with("Data");
        if (group == std::string("Points") && declared.GetNumberOfNestedElements() != 1)
            throw InputError(path(), fmt::format("its PPoints has {} arrays", declared.GetNumberOfNestedElements()),
                             "one");
        for (int i = 0; i < declared.GetNumberOfNestedElements(); ++i) {
            vtkXMLDataElement& array = *declared.GetNestedElement(i);
            if (typeOf(array) < 0 || (group == std::string("Points") && componentsOf(array, path()) != 3))
                values_.fail(array, fmt::format("has the type '{:.40}'", textOf(array, "type")), "a type of VTK");
            for (vtkXMLDataElement* piece : childrenOf(held, "Piece"))
                for (vtkXMLDataElement* data : childrenOf(*piece, group))
                    for (int k = 0; k < data->GetNumberOfNestedElements(); ++k) {
                        vtkXMLDataElement& other = *data->GetNestedElement(k);
                        if (named ? textOf(other, "Name") != textOf(array, "Name") : k != i) continue;
                        if (componentsOf(other, file) != componentsOf(array, path()) || typeOf(other) != typeOf(array))
                            throw InputError(path(), fmt::format("{} is another in its piece {}", labelOf(array), file),
                                             "the same type and number of components");
                    }
        }
    }

    std::string fileNamed(const std::string& name) const
    {
        if (name.empty()) throw InputError(path(), "a piece has no file", "the name of a file");
        return (std::filesystem::path(path()).parent_path() / name).string();
    }

    void checkNamed(const std::string& file)
    {
        std::error_code error;
        if (!std::filesystem::is_regular_file(file, error))
            throw InputError(path(), "its piece " + file + " is not there", "a file for each piece");
        if (depth_ >= deepestBlocks)
            throw InputError(path(), "files name files too deeply", fmt::format("{} levels", depth_));
        bytes_ += XmlCheck(file, depth_ + 1).run();
    }

    void checkBlocks(vtkXMLDataElement& parent)
    {
        for (int i = 0; i < parent.GetNumberOfNestedElements(); ++i) {
            vtkXMLDataElement& child = *parent.GetNestedElement(i);
            // VTK makes as many blocks as the largest index says.
            const std::uint64_t index = countIn(child, "index", path());
            if (index >= kMostBlocks)
                throw InputError(path(), fmt::format("a block of index {}", index),
                                 fmt::format("indices below {}", kMostBlocks));
            if (child.GetAttribute("file")) checkNamed(fileNamed(textOf(child, "file")));
            checkBlocks(child);
        }
    }

    XmlValues values_;
    int depth_;
    std::size_t steps_ = 0;    // Of time; 0: the file tells of none.
    std::uint64_t bytes_ = 0;  // Of pieces and blocks.
    std::map<std::string, std::vector<std::string>> arrays_;
};

}  // namespace

std::uint64_t checkXmlFile(const std::string& path)
{
    return XmlCheck(path, 1).run();
}

}  // namespace aeolic
