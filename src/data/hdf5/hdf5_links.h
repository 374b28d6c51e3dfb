#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "data/hdf5/hdf5_header.h"

namespace aeolic {

/// What a group calls by a name: an object of the file, or another name, perhaps in another file.
struct Hdf5Link {
    std::string name;
    std::uint64_t address = 0;  ///< Of the object; without meaning where there is a target.
    std::string target, file;   ///< Of a soft link the path; of an external one the file, too.
    std::uint64_t order = 0;    ///< In which links were made, where the file says so.
};

/// The links of a group, in the order in which they were made or, where the file does not say it, by their names.
std::vector<Hdf5Link> readHdf5Links(const Hdf5Store& store, const std::vector<Hdf5Message>& header);

/// Attributes of an object, in any order.
std::vector<std::vector<std::uint8_t>> readHdf5Attributes(const Hdf5Store& store,
                                                          const std::vector<Hdf5Message>& header);

}  // namespace aeolic
