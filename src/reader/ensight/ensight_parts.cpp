#include "reader/ensight/ensight_parts.h"

#include <map>
#include <optional>

#include "reader/ensight/ensight_case.h"
#include "reader/ensight/ensight_values.h"

namespace aeolic {
namespace {

CellShape shapeOf(EnSightShape shape)
{
    return CellShape(int(shape) - int(EnSightShape::triangle));
}
static_assert(int(EnSightShape::polyhedron) - int(EnSightShape::triangle) == int(CellShape::polyhedron));

PartPoints pointsOf(const EnSightPart& part)
{
    auto points = std::make_shared<std::vector<glm::dvec3>>(part.pointCount());
    for (std::size_t i = 0; i < points->size(); ++i)
        (*points)[i] = {part.points[0][i], part.points[1][i], part.points[2][i]};
    return points;
}

std::vector<std::int64_t> wide(const std::vector<std::int32_t>& numbers)
{
    return {numbers.begin(), numbers.end()};
}

class EnSightParts : public PartSource {
public:
    EnSightParts(const std::string& path, std::optional<double> time) : case_(readEnSightCase(path)), time_(time)
    {
        for (const EnSightVariable& variable : case_.variables)
            arrays_.push_back({variable.name, variable.onPoints, variable.components, NumberType::float32});
    }

    const std::vector<PartArray>& arrays() const override { return arrays_; }
    std::vector<double> times() const override { return case_.times(); }

    const std::vector<PartInfo>& parts() override
    {
        if (geometry_) return parts_;
        geometry_ = readEnSightGeometry(case_.placeAt(case_.geometry, time_));
        for (const EnSightPart& part : geometry_->parts)
            parts_.push_back(
                {part.name, part.fillsSpace() ? "volume" : "faces", {}, part.fillsSpace() ? 3 : 2, part.cells() > 0});
        return parts_;
    }

    PartMesh read(std::size_t number, const std::vector<std::size_t>& wanted) override
    {
        parts();
        const EnSightPart& part = geometry_->parts[number];
        PartMesh mesh;
        mesh.points = pointsOf(part);
        for (const EnSightSection& section : part.sections)
            if (section.kept)
                mesh.cells.push_back({shapeOf(section.element->shape), section.count, wide(section.corners),
                                      wide(section.sizes), wide(section.ofFaces)});
        for (const std::size_t array : wanted) {
            const EnSightVariable& variable = case_.variables[array];
            auto& all = values_[array];
            if (all.empty()) all = readEnSightValues(case_.placeAt(variable.file, time_), variable, *geometry_);
            mesh.values.push_back(std::make_shared<const std::vector<float>>(std::move(all[number])));
        }
        return mesh;
    }

private:
    EnSightCase case_;
    std::optional<double> time_;
    std::vector<PartArray> arrays_;
    std::optional<EnSightGeometry> geometry_;  // Once it was asked for.
    std::vector<PartInfo> parts_;
    std::map<std::size_t, std::vector<std::vector<float>>> values_;  // Of an array: of each part that was not yet read.
};

}  // namespace

std::unique_ptr<PartSource> openEnSightCase(const std::string& path, std::optional<double> time)
{
    return std::make_unique<EnSightParts>(path, time);
}

}  // namespace aeolic
