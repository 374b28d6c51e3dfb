#include "data/array_choice.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "base/nearest_name.h"

namespace aeolic {

ArrayChoices arraysListed(const std::string& listing)
{
    ArrayChoices arrays;
    for (std::size_t start = 0; start < listing.size();) {
        const std::size_t open = std::min(listing.find(" (points, ", start), listing.find(" (cells, ", start));
        const std::size_t close = listing.find(')', open);
        if (close == std::string::npos) break;
        const int components = std::atoi(listing.c_str() + listing.find(',', open) + 1);
        arrays.push_back({listing.substr(start, open - start), components});
        start = close + 1;
        for (const std::string_view between : {", ", "; on the surface: "})
            if (listing.compare(start, between.size(), between) == 0) start += between.size();
    }
    return arrays;
}

std::vector<std::string> colorableNames(const ArrayChoices& arrays)
{
    std::vector<std::string> names;
    for (const ArrayChoice& array : arrays) {
        names.push_back(array.name);
        if (array.components > 1) names.push_back(array.name + ":mag");
        if (array.components != 3) continue;
        for (const char* part : {":x", ":y", ":z", ":normal", ":tangential"}) names.push_back(array.name + part);
    }
    return names;
}

std::string nearestArray(const std::string& typed, const ArrayChoices& arrays)
{
    return didYouMean(typed, colorableNames(arrays));
}

}  // namespace aeolic
