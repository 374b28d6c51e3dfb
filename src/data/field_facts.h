#pragma once

#include <string>
#include <vector>

#include "data/array_choice.h"
#include "data/tally.h"
#include "description/color_by.h"

namespace aeolic {

/// What is known of a field beside its values.
struct FieldFacts {
    bool hasScalar = false;                  ///< Something to colour by is in the field.
    ArrayPart ofVectors = ArrayPart::whole;  ///< Scene::ofVectors, of that something.
    std::string scalarName;
    std::string vectorsName;
    std::string arrays;             ///< What arrays there are, for messages.
    ArrayChoices offered;           ///< What arrays there are to choose from.
    std::vector<double> timeSteps;  ///< Those of a file that holds several.
    std::vector<Tally> tallies;
    std::string name;  ///< The file's, for messages.
};

template <PerhapsConst<FieldFacts> Facts, class Visit>
void withMembers(Facts& facts, const Visit& visit)
{
    visit(facts.hasScalar, facts.ofVectors, facts.scalarName, facts.vectorsName, facts.arrays, facts.name,
          facts.offered, facts.timeSteps, facts.tallies);
}

}  // namespace aeolic
