#pragma once

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>

#include <istream>
#include <string>
#include <vector>

namespace aeolic {

/// The elements of an XML file of VTK's family, without values of arrays. Throws InputError, which begins with `path`
/// and ends with `expected`, where it is not well-formed.
vtkSmartPointer<vtkXMLDataElement> parseXml(const std::string& path, const std::string& expected);
vtkSmartPointer<vtkXMLDataElement> parseXml(std::istream& text, const std::string& path, const std::string& expected);

/// The children of that name.
std::vector<vtkXMLDataElement*> childrenOf(vtkXMLDataElement& element, const std::string& name);

/// The attribute's text, empty where it is missing. Control characters are '?': messages and names are one line.
std::string attributeOf(vtkXMLDataElement& element, const char* name);

/// The finite numbers of a text, which blanks separate; none where there is anything else.
std::vector<double> numbersIn(const std::string& text);

/// The files that a parallel file names as its pieces, in order. Throws InputError where one is not there.
std::vector<std::string> pieceFilesOf(const std::string& path);

}  // namespace aeolic
