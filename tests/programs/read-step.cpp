/// \file Reads a STEP file back with OpenCASCADE, and prints one line of JSON about the result.
/// usage: read-step FILE
///
/// {"faces", "shells", "solids", "valid", "closed"}: `valid` is BRepCheck's verdict, `closed` is true if
/// every edge has a face on both sides. Shares no code with qm-export.
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdio>

namespace {

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(shape, kind, all);
    return all.Extent();
}

bool isClosed(const TopoDS_Shape& shape) {
    TopTools_IndexedDataMapOfShapeListOfShape facesOfEdge;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdge);
    for (int k = 1; k <= facesOfEdge.Extent(); ++k)
        if (!BRep_Tool::Degenerated(TopoDS::Edge(facesOfEdge.FindKey(k))) && facesOfEdge(k).Extent() != 2)
            return false;
    return facesOfEdge.Extent() > 0;
}

const char* truth(bool value) {
    return value ? "true" : "false";
}

} // namespace

int main(int argc, char** argv) {
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    STEPControl_Reader reader;
    if (argc != 2 || reader.ReadFile(argv[1]) != IFSelect_RetDone || reader.TransferRoots() == 0) {
        std::fprintf(stderr, "read-step: cannot read the file\n");
        return 1;
    }
    const TopoDS_Shape shape = reader.OneShape();
    std::printf(R"({"faces": %d, "shells": %d, "solids": %d, "valid": %s, "closed": %s})"
                "\n",
                count(shape, TopAbs_FACE), count(shape, TopAbs_SHELL), count(shape, TopAbs_SOLID),
                truth(BRepCheck_Analyzer(shape).IsValid()), truth(isClosed(shape)));
    return 0;
}
