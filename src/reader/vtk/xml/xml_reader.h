#pragma once

#include <vtkDataArray.h>
#include <vtkObjectFactory.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtkXMLDataReader.h>
#include <vtkXMLPUnstructuredDataReader.h>

#include <string>
#include <type_traits>

#include "base/large_memory.h"
#include "data/vtk/messages.h"
#include "reader/vtk/text_numbers.h"
#include "reader/vtk/xml/xml_header.h"
#include "reader/vtk/xml/xml_tree.h"

namespace aeolic {

/// One of VTK's XML readers for a single file. It refuses what VTK would read as something else (xml_header.h), and
/// reads any number in text. Large arrays lie on huge pages where the system has them: most of its time VTK waits for
/// the pages that it reads into.
template <class Reader>
class XmlReader : public Reader {
public:
    static XmlReader* New() { VTK_STANDARD_NEW_BODY(XmlReader); }

protected:
    XmlReader() = default;

    int ReadPrimaryElement(vtkXMLDataElement* primary) override
    {
        const std::string fault = faultOf(*primary);
        if (fault.empty()) return Reader::ReadPrimaryElement(primary);
        vtkErrorWithObjectMacro(this, << fault);
        return 0;
    }

    int ReadXMLInformation() override
    {
        const VtkMessages::About about(nameOfFile());
        return Reader::ReadXMLInformation();
    }

    void ReadXMLData() override
    {
        const VtkMessages::About about(nameOfFile());
        this->Stream->imbue(textNumbers());
        whole_ = nullptr;
        Reader::ReadXMLData();
    }

    /// VTK has allocated the array, but not written into it yet. Texts are left out: nobody needs them, and VTK writes
    /// all that it finds, beyond the array's end, too.
    int ReadArrayValues(vtkXMLDataElement* element, vtkIdType index, vtkAbstractArray* array, vtkIdType start,
                        vtkIdType count, typename Reader::FieldType type) override
    {
        auto* numbers = vtkDataArray::SafeDownCast(array);
        if (!numbers) return 1;
        if (element != whole_ && !isWhole(*element, lastByte(*element, *numbers, start + count))) return 0;
        whole_ = element;
        if (numbers->HasStandardMemoryLayout() && numbers->GetDataType() != VTK_BIT)
            wishForHugePages(numbers->GetVoidPointer(0),
                             std::size_t(numbers->GetNumberOfValues()) * std::size_t(numbers->GetDataTypeSize()));
        if (!Reader::ReadArrayValues(element, index, array, start, count, type)) return 0;
        if (areCellTypes(*element, *numbers)) return 1;
        vtkErrorWithObjectMacro(this, << "the types of its cells have a number that is none from 0 to 255");
        return 0;
    }

private:
    std::string nameOfFile() { return this->FileName ? this->FileName : ""; }

    /// VTK passes over it where an array that is not compressed ends early. So the last byte is looked for, before the
    /// values are read.
    bool isWhole(vtkXMLDataElement& element, vtkTypeInt64 last)
    {
        if (last < 0 || this->XMLParser->GetCompressor()) return true;
        if (!element.GetAttribute("offset"))
            return attributeOf(element, "format") != "binary" || bytesWithin(element, *this->Stream) > last;
        char byte = 0;
        vtkTypeInt64 offset = -1;
        return element.GetScalarAttribute("offset", offset) && offset >= 0 &&
               this->XMLParser->ReadAppendedData(offset, &byte, vtkTypeUInt64(last), 1) == 1;
    }

    vtkXMLDataElement* whole_ = nullptr;  // The array that was looked at.
};

/// One of VTK's readers of files in pieces. VTK copies the bytes of a piece's array, whatever their type is.
template <class Reader, class PieceReader>
class XmlPiecesReader : public Reader {
public:
    static XmlPiecesReader* New() { VTK_STANDARD_NEW_BODY(XmlPiecesReader); }

protected:
    XmlPiecesReader() = default;

    vtkXMLDataReader* CreatePieceReader() override { return XmlReader<PieceReader>::New(); }

    int ReadPrimaryElement(vtkXMLDataElement* primary) override
    {
        const std::string fault = faultOfPlace(*primary);
        if (fault.empty()) return Reader::ReadPrimaryElement(primary);
        vtkErrorWithObjectMacro(this, << fault);
        return 0;
    }

    /// A piece without points and cells adds nothing. VTK would miss its arrays, which writers leave out there.
    int ReadPieceData() override
    {
        if constexpr (std::is_base_of_v<vtkXMLPUnstructuredDataReader, Reader>)
            if (this->GetNumberOfPointsInPiece(this->Piece) == 0 && this->GetNumberOfCellsInPiece(this->Piece) == 0)
                return 1;
        return Reader::ReadPieceData();
    }

    void CopyArrayForPoints(vtkAbstractArray* piece, vtkAbstractArray* whole) override
    {
        if (areAlike(piece, whole)) Reader::CopyArrayForPoints(piece, whole);
    }

    void CopyArrayForCells(vtkAbstractArray* piece, vtkAbstractArray* whole) override
    {
        if (areAlike(piece, whole)) Reader::CopyArrayForCells(piece, whole);
    }

private:
    bool areAlike(vtkAbstractArray* piece, vtkAbstractArray* whole)
    {
        if (!piece || !whole) return true;  // VTK passes over it.
        if (piece->GetDataType() == whole->GetDataType() &&
            piece->GetNumberOfComponents() == whole->GetNumberOfComponents())
            return true;
        vtkErrorWithObjectMacro(this, << "array '" << (whole->GetName() ? whole->GetName() : "")
                                      << "' has another type or number of components in piece " << this->Piece);
        return false;
    }
};

}  // namespace aeolic
