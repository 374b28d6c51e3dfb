#include "reader/vtk/legacy/legacy_attributes.h"

#include <fmt/format.h>

#include "aeolic/error.h"

namespace aeolic {
namespace {

constexpr std::int64_t mostComponents = 1000;
constexpr std::int64_t mostArrays = 100000;

void addActive(vtkDataSetAttributes& data, vtkDataArray* array, int attribute)
{
    const int index = data.AddArray(array);
    if (!data.GetAttribute(attribute)) data.SetActiveAttribute(index, attribute);
}

void readScalars(LegacyText& text, vtkDataSetAttributes& data, std::int64_t tuples)
{
    const std::string name = text.name(), type = text.word("a type of values");
    std::int64_t components = 1;
    if (!text.takes("LOOKUP_TABLE")) {
        components = text.count("the number of components", mostComponents);
        if (!text.takes("LOOKUP_TABLE"))
            throw InputError(text.path(), "scalars '" + name + "' lack a LOOKUP_TABLE", "one");
    }
    text.name();
    const auto array = text.array(type, tuples, components, "'" + name + "'");
    if (!array) return;
    array->SetName(name.c_str());
    addActive(data, array, vtkDataSetAttributes::SCALARS);
}

void readTuples(LegacyText& text, vtkDataSetAttributes& data, std::int64_t tuples, std::int64_t components,
                int attribute)
{
    const std::string name = text.name();
    if (attribute == vtkDataSetAttributes::TCOORDS) components = text.count("the number of components", mostComponents);
    const auto array = text.array(text.word("a type of values"), tuples, components, "'" + name + "'");
    if (!array) return;
    array->SetName(name.c_str());
    addActive(data, array, attribute);
}

}  // namespace

void readLegacyField(LegacyText& text, vtkFieldData& data)
{
    text.name();
    const std::int64_t count = text.count("the number of arrays", mostArrays);
    for (std::int64_t i = 0; i < count; ++i) {
        std::string name = text.name();
        if (name == "METADATA") {  // Of the array before.
            text.skipToBlankLine();
            name = text.name();
        }
        if (name == "NULL_ARRAY") continue;
        const std::int64_t components = text.count("the number of components", mostComponents),
                           tuples = text.count("the number of tuples");
        const auto array = text.array(text.word("a type of values"), tuples, components, "'" + name + "'");
        if (!array) continue;
        array->SetName(name.c_str());
        data.AddArray(array);
    }
}

bool readLegacyAttribute(LegacyText& text, const std::string& keyword, vtkDataSetAttributes& data, std::int64_t tuples)
{
    using Attributes = vtkDataSetAttributes;
    struct Kind {
        const char* keyword;
        std::int64_t components;
        int attribute;
    };
    static const Kind kinds[] = {{"VECTORS", 3, Attributes::VECTORS},
                                 {"NORMALS", 3, Attributes::NORMALS},
                                 {"TENSORS", 9, Attributes::TENSORS},
                                 {"TENSORS6", 6, Attributes::TENSORS},
                                 {"TEXTURE_COORDINATES", 0, Attributes::TCOORDS},
                                 {"TANGENTS", 3, Attributes::TANGENTS},
                                 {"GLOBAL_IDS", 1, Attributes::GLOBALIDS},
                                 {"PEDIGREE_IDS", 1, Attributes::PEDIGREEIDS},
                                 {"EDGE_FLAGS", 1, Attributes::EDGEFLAG}};
    for (const Kind& kind : kinds)
        if (keyword == kind.keyword) {
            readTuples(text, data, tuples, kind.components, kind.attribute);
            return true;
        }
    if (keyword == "SCALARS") {
        readScalars(text, data, tuples);
    } else if (keyword == "COLOR_SCALARS") {
        const std::string name = text.name();
        const auto array =
            text.colors(tuples, text.count("the number of components", mostComponents), "'" + name + "'");
        array->SetName(name.c_str());
        addActive(data, array, Attributes::SCALARS);
    } else if (keyword == "LOOKUP_TABLE") {
        const std::string name = text.name();
        text.colors(text.count("the number of colours"), 4, "'" + name + "'");
    } else if (keyword == "FIELD") {
        readLegacyField(text, data);
    } else {
        return false;
    }
    return true;
}

}  // namespace aeolic
