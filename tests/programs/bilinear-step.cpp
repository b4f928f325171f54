/// \file Writes a quad mesh as the plainest STEP file, with one bilinear face for every quad, for comparison.
/// usage: bilinear-step MESH.obj FILE.step
///
/// Reads OBJ as written by qm-export: only lines of vertices and of quads. Shares no code with qm-export.
#include <BRep_Builder.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Line.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr double tolerance = 1e-7;

class BilinearShell {
public:
    explicit BilinearShell(std::vector<gp_Pnt> points) : points_(std::move(points)) {
        for (const gp_Pnt& point : points_)
            builder_.MakeVertex(vertices_.emplace_back(), point, tolerance);
        builder_.MakeShell(shell_);
    }

    void addQuad(const std::array<std::size_t, 4>& corners) {
        TColgp_Array2OfPnt poles(1, 2, 1, 2);
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i)
                poles.SetValue(i + 1, j + 1,
                               points_.at(corners.at(static_cast<std::size_t>(j == 0 ? i : 3 - i))));
        TColStd_Array1OfReal knots(1, 2);
        knots.SetValue(1, 0);
        knots.SetValue(2, 1);
        TColStd_Array1OfInteger multiplicities(1, 2);
        multiplicities.Init(2);
        TopoDS_Face face;
        builder_.MakeFace(face,
                          new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 1, 1),
                          tolerance);
        TopoDS_Wire wire;
        builder_.MakeWire(wire);
        for (std::size_t side = 0; side < 4; ++side)
            builder_.Add(wire, use(corners[side], corners[(side + 1) % 4], side, face));
        wire.Closed(true);
        builder_.Add(face, wire);
        builder_.Add(shell_, face);
    }

    [[nodiscard]] TopoDS_Shape solid() {
        shell_.Closed(true);
        TopoDS_Solid result;
        builder_.MakeSolid(result);
        builder_.Add(result, shell_);
        return result;
    }

private:
    /// An edge as used by a face, on one side of the unit square, from its lower to its higher vertex.
    TopoDS_Shape use(std::size_t from, std::size_t to, std::size_t side, const TopoDS_Face& face) {
        static const std::array<gp_Pnt2d, 5> square{gp_Pnt2d(0, 0), gp_Pnt2d(1, 0), gp_Pnt2d(1, 1),
                                                    gp_Pnt2d(0, 1), gp_Pnt2d(0, 0)};
        const bool forwards = from < to;
        const std::pair ends = std::minmax(from, to);
        const double length = points_.at(from).Distance(points_.at(to));
        TopoDS_Edge& edge = edges_[ends];
        if (edge.IsNull()) {
            builder_.MakeEdge(edge, line(ends), tolerance);
            builder_.Add(edge, vertices_[ends.first].Oriented(TopAbs_FORWARD));
            builder_.Add(edge, vertices_[ends.second].Oriented(TopAbs_REVERSED));
            builder_.Range(edge, 0, length);
        }
        const gp_Pnt2d& a = square.at(forwards ? side : side + 1);
        const gp_Pnt2d& b = square.at(forwards ? side + 1 : side);
        builder_.UpdateEdge(edge, planeLine(a, b, length), face, tolerance);
        return edge.Oriented(forwards ? TopAbs_FORWARD : TopAbs_REVERSED);
    }

    [[nodiscard]] Handle(Geom_Curve) line(const std::pair<std::size_t, std::size_t>& ends) const {
        const gp_Pnt& from = points_[ends.first];
        return new Geom_Line(from, gp_Dir(gp_Vec(from, points_[ends.second])));
    }

    static Handle(Geom2d_Curve) planeLine(const gp_Pnt2d& a, const gp_Pnt2d& b, double length) {
        TColgp_Array1OfPnt2d poles(1, 2);
        poles.SetValue(1, a);
        poles.SetValue(2, b);
        TColStd_Array1OfReal knots(1, 2);
        knots.SetValue(1, 0);
        knots.SetValue(2, length);
        TColStd_Array1OfInteger multiplicities(1, 2);
        multiplicities.Init(2);
        return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
    }

    std::vector<gp_Pnt> points_;
    std::vector<TopoDS_Vertex> vertices_;
    std::map<std::pair<std::size_t, std::size_t>, TopoDS_Edge> edges_;
    TopoDS_Shell shell_;
    BRep_Builder builder_;
};

} // namespace

int main(int argc, char** argv) {
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    if (argc != 3) return 2;
    std::ifstream file(argv[1]);
    std::vector<gp_Pnt> points;
    std::vector<std::array<std::size_t, 4>> quads;
    for (std::string line, word; std::getline(file, line);) {
        std::istringstream words(line);
        words >> word;
        if (word == "v") {
            std::array<double, 3> p{};
            words >> p[0] >> p[1] >> p[2];
            points.emplace_back(p[0], p[1], p[2]);
        } else if (word == "f") {
            std::array<std::size_t, 4>& quad = quads.emplace_back();
            for (std::size_t& corner : quad) {
                words >> corner;
                --corner;
            }
        }
    }
    BilinearShell shell(std::move(points));
    for (const auto& quad : quads)
        shell.addQuad(quad);
    STEPControl_Writer writer;
    if (quads.empty() || writer.Transfer(shell.solid(), STEPControl_AsIs) != IFSelect_RetDone ||
        writer.Write(argv[2]) != IFSelect_RetDone) {
        std::fprintf(stderr, "bilinear-step: cannot write the file\n");
        return 1;
    }
    return 0;
}
