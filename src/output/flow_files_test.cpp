#include "output/flow_files.h"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <limits>

#include "data/vtk/testing/sample_files.h"
#include "output/output_check.h"

namespace aeolic {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A saddle between a node and a focus, with a line to each.
FlowTopology sample()
{
    FlowTopology topology;
    topology.scalar = "p, <static>";
    topology.points = {{{{0, 0, 0}, {0, 0, 1}, 5}, CriticalPointKind::saddle, false, -1, 2.5},
                       {{{1, 0, 0}, {0, 0, 0}, 6}, CriticalPointKind::node, true, 1, 1},
                       {{{-1, 0, 0.5}, {0, 0, 0}, kNaN}, CriticalPointKind::focus, false, 1, 3}};
    topology.lines = {
        {0, 1, true, 1, 2.5, {topology.points[0].at, {{0.5, 0, 0}, {1, 0, 0}, 5.5}, topology.points[1].at}},
        {0, std::nullopt, false, 2, 2.5, {topology.points[0].at, topology.points[2].at}}};
    return topology;
}

TEST(TopologyFiles, Csv)
{
    EXPECT_EQ(topologyCsv(sample()),
              "line,type,attracts,index,strength,length,x,y,z,vector x,vector y,vector z,"
              "\"p, <static>\"\n"
              ",saddle,0,-1,2.5,0,0,0,0,0,0,1,5\n"
              ",node,1,1,1,0,1,0,0,0,0,0,6\n"
              ",focus,-1,1,3,0,-1,0,0.5,0,0,0,nan\n"
              "0,separation,0,0,2.5,1,0,0,0,0,0,1,5\n"
              "0,separation,0,0,2.5,1,0.5,0,0,1,0,0,5.5\n"
              "0,separation,0,0,2.5,1,1,0,0,0,0,0,6\n"
              "1,attachment,0,0,2.5,2,0,0,0,0,0,1,5\n"
              "1,attachment,0,0,2.5,2,-1,0,0.5,0,0,0,nan\n");
}

TEST(TopologyFiles, CsvWithoutAScalarHasNoColumnForIt)
{
    FlowTopology topology = sample();
    topology.scalar = "";
    topology.lines.clear();
    topology.points.resize(1);
    EXPECT_EQ(topologyCsv(topology),
              "line,type,attracts,index,strength,length,x,y,z,vector x,vector y,vector z\n"
              ",saddle,0,-1,2.5,0,0,0,0,0,0,1\n");
}

TEST(TopologyFiles, VtkReadsTheVtp)
{
    const test::TempFolder folder;
    writeTextFile(folder.file("lines.vtp"), topologyVtp(sample()));
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(folder.file("lines.vtp").c_str());
    reader->Update();
    vtkPolyData& data = *reader->GetOutput();
    ASSERT_EQ(data.GetNumberOfPoints(), 3 + 3 + 2);
    ASSERT_EQ(data.GetNumberOfVerts(), 3);
    ASSERT_EQ(data.GetNumberOfLines(), 2);
    vtkDataArray* const scalar = data.GetPointData()->GetArray("p, <static>");
    ASSERT_TRUE(scalar);
    EXPECT_EQ(scalar->GetTuple1(1), 6);
    EXPECT_TRUE(std::isnan(scalar->GetTuple1(2)));
    EXPECT_EQ(data.GetPointData()->GetVectors()->GetComponent(4, 0), 1);
    EXPECT_EQ(data.GetPoint(2)[2], 0.5);
    const auto cells = [&](const char* name) {
        std::vector<double> values;
        vtkDataArray* const array = data.GetCellData()->GetArray(name);
        for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i) values.push_back(array->GetTuple1(i));
        return values;
    };
    EXPECT_EQ(cells("type"), (std::vector<double>{3, 0, 1, 5, 6}));
    EXPECT_EQ(cells("attracts"), (std::vector<double>{0, 1, -1, 0, 0}));
    EXPECT_EQ(cells("index"), (std::vector<double>{-1, 1, 1, 0, 0}));
    EXPECT_EQ(cells("strength"), (std::vector<double>{2.5, 1, 3, 2.5, 2.5}));
    EXPECT_EQ(cells("length"), (std::vector<double>{0, 0, 0, 1, 2}));
    EXPECT_EQ(data.GetCell(3)->GetNumberOfPoints(), 3);
    EXPECT_EQ(data.GetCell(4)->GetPointId(1), 7);
}

TEST(TopologyFiles, NamesOfAnyKindMakeAFile)
{
    const test::TempFolder folder;
    for (const std::string name : {"vectors", "p\x01q", "a&b<\"c\">"}) {
        FlowTopology topology = sample();
        topology.scalar = name;
        writeTextFile(folder.file("named.vtp"), topologyVtp(topology));
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(folder.file("named.vtp").c_str());
        reader->Update();
        EXPECT_EQ(reader->GetOutput()->GetPointData()->GetNumberOfArrays(), 2) << name;
        EXPECT_EQ(reader->GetOutput()->GetPointData()->GetVectors()->GetNumberOfComponents(), 3) << name;
    }
}

TEST(TopologyFiles, AFlowWithoutPointsIsAFileToo)
{
    const test::TempFolder folder;
    writeTextFile(folder.file("none.vtp"), topologyVtp({}));
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(folder.file("none.vtp").c_str());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(reader->GetErrorCode(), 0u);
}

}  // namespace
}  // namespace aeolic
