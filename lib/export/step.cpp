#include "export/boundary_files.h"
#include "export/step_geometry.h"

#include <array>
#include <gp_Ax3.hxx>
#include <optional>

namespace qm {
namespace {

/// Of solids and faces, in bytes: Netgen copies a name into fifty bytes, however long it is, and crashes.
constexpr std::size_t maxName = 49;

/// "segment 4", or "segments 4 7" of a face that was joined, or "segments 4 7 and 58 more" of very many.
std::string faceName(const std::vector<std::size_t>& segments) {
    std::string name = segments.size() == 1 ? "segment" : "segments";
    std::string shortName;
    for (std::size_t k = 0; k < segments.size(); ++k) {
        const std::string more = " and " + std::to_string(segments.size() - k) + " more";
        if (name.size() + more.size() <= maxName) shortName = name + more;
        name += " " + std::to_string(segments[k]);
    }
    return name.size() <= maxName ? name : shortName;
}

StepId addLengthUnit(StepFile& file, LengthUnit unit) {
    const auto si = [&](const char* prefix) {
        return file.add(std::string("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(") + prefix + ",.METRE.))");
    };
    switch (unit) {
    case LengthUnit::cm:
        return si(".CENTI.");
    case LengthUnit::m:
        return si("$");
    case LengthUnit::inch: {
        const StepId metric = si(".MILLI.");
        const StepId exponents = file.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
        const StepId measure = file.add(StepText("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(")
                                            .real(inMillimetres(unit))
                                            .raw("),")
                                            .id(metric)
                                            .raw(")"));
        return file.add(StepText("(CONVERSION_BASED_UNIT('INCH',")
                            .id(measure)
                            .raw(")LENGTH_UNIT()NAMED_UNIT(")
                            .id(exponents)
                            .raw("))"));
    }
    default:
        return si(".MILLI.");
    }
}

/// Units, and how exact coordinates are.
StepId addContext(StepFile& file, LengthUnit unit, double accuracy) {
    const StepId length = addLengthUnit(file, unit);
    const StepId angle = file.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const StepId solidAngle = file.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    const StepId uncertainty = file.add(StepText("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(")
                                            .real(accuracy)
                                            .raw("),")
                                            .id(length)
                                            .raw(",'distance_accuracy_value','largest gap')"));
    return file.add(StepText("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((")
                        .id(uncertainty)
                        .raw("))GLOBAL_UNIT_ASSIGNED_CONTEXT((")
                        .id(length)
                        .raw(",")
                        .id(angle)
                        .raw(",")
                        .id(solidAngle)
                        .raw("))REPRESENTATION_CONTEXT('','3D'))"));
}

class Writer {
public:
    Writer(const Boundary& boundary, const std::vector<std::vector<std::size_t>>& origins,
           const ExportOptions& options)
        : boundary_(boundary), origins_(origins), options_(options), edges_(boundary.edges.size()) {
        application_ =
            file_.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        file_.add(
            StepText("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,")
                .id(application_)
                .raw(")"));
        context_ = addContext(file_, options.unit, largestTolerance(boundary));
        planeContext_ = file_.add("(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()"
                                  "REPRESENTATION_CONTEXT('','2D'))");
        origin_ = addPlacement(file_, gp_Ax3());
    }

    std::string write() {
        for (const BoundaryVertex& vertex : boundary_.vertices)
            vertices_.push_back(
                file_.add(StepText("VERTEX_POINT('',").id(addPoint(file_, vertex.point)).raw(")")));
        for (const BoundaryFace& face : boundary_.faces)
            surfaces_.push_back(addSurface(file_, face.surface));
        addEdges();
        for (std::size_t k = 0; k < boundary_.parts.size(); ++k)
            addPart(boundary_.parts[k], boundary_.parts.size() == 1 ? "" : " " + std::to_string(k + 1));
        return file_.text({stepText(options_.name), options_.date},
                          "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }");
    }

private:
    void addEdges() {
        std::vector<std::array<std::optional<StepId>, 2>> onFaces(edges_.size());
        for (std::size_t f = 0; f < boundary_.faces.size(); ++f)
            for (const auto& loop : boundary_.faces[f].loops)
                for (const EdgeUse& use : loop) {
                    const std::size_t side = use.forwards ? 0 : 1;
                    if (const auto& curve = boundary_.edges[use.edge].onFaces.at(side); !curve.IsNull())
                        onFaces[use.edge].at(side) = addOnSurface(curve, surfaces_[f]);
                }
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            const BoundaryEdge& edge = boundary_.edges[e];
            StepId curve = addCurve(file_, edge.curve);
            std::vector<StepId> known;
            for (const auto& onFace : onFaces[e])
                if (onFace) known.push_back(*onFace);
            if (!known.empty())
                curve = file_.add(
                    StepText("SURFACE_CURVE('',").id(curve).raw(",").ids(known).raw(",.CURVE_3D.)"));
            edges_[e] = file_.add(StepText("EDGE_CURVE('',")
                                      .id(vertices_[edge.ends[0]])
                                      .raw(",")
                                      .id(vertices_[edge.ends[1]])
                                      .raw(",")
                                      .id(curve)
                                      .raw(",.T.)"));
        }
    }

    StepId addOnSurface(const Handle(Geom2d_BSplineCurve) & curve, StepId surface) {
        const StepId plane = addPlaneCurve(file_, curve);
        const StepId representation = file_.add(
            StepText("DEFINITIONAL_REPRESENTATION('',(").id(plane).raw("),").id(planeContext_).raw(")"));
        return file_.add(StepText("PCURVE('',").id(surface).raw(",").id(representation).raw(")"));
    }

    /// \param turned  seen from the other side
    StepId addFace(std::size_t f, bool turned) {
        const BoundaryFace& face = boundary_.faces[f];
        std::vector<StepId> bounds;
        for (const auto& outline : face.loops) {
            std::vector<StepId> uses;
            uses.reserve(outline.size());
            for (const EdgeUse& use : outline)
                uses.push_back(file_.add(StepText("ORIENTED_EDGE('',*,*,")
                                             .id(edges_[use.edge])
                                             .raw(",")
                                             .flag(use.forwards)
                                             .raw(")")));
            const StepId loop = file_.add(StepText("EDGE_LOOP('',").ids(uses).raw(")"));
            bounds.push_back(file_.add(StepText(bounds.empty() ? "FACE_OUTER_BOUND(''," : "FACE_BOUND('',")
                                           .id(loop)
                                           .raw(",")
                                           .flag(!turned)
                                           .raw(")")));
        }
        return file_.add(StepText("ADVANCED_FACE('" + faceName(origins_[f]) + "',")
                             .ids(bounds)
                             .raw(",")
                             .id(surfaces_[f])
                             .raw(",")
                             .flag(face.reversed == turned)
                             .raw(")"));
    }

    /// \param number  the end of its name
    void addPart(const BoundaryPart& part, const std::string& number) {
        const std::string name = stepText(options_.name, maxName - number.size()) + number;
        std::vector<StepId> faces;
        for (const std::size_t face : part.faces)
            faces.push_back(addFace(face, part.inward));
        const StepId shell = file_.add(
            StepText(part.closed ? "CLOSED_SHELL('" : "OPEN_SHELL('").raw("',").ids(faces).raw(")"));
        const StepId body =
            part.closed
                ? file_.add(StepText("MANIFOLD_SOLID_BREP('" + name + "',").id(shell).raw(")"))
                : file_.add(StepText("SHELL_BASED_SURFACE_MODEL('" + name + "',(").id(shell).raw("))"));
        const StepId shape = file_.add(StepText(part.closed ? "ADVANCED_BREP_SHAPE_REPRESENTATION('',"
                                                            : "MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',")
                                           .ids(std::array{origin_, body})
                                           .raw(",")
                                           .id(context_)
                                           .raw(")"));
        addProduct(stepText(options_.name) + number, shape);
    }

    void addProduct(const std::string& name, StepId shape) {
        const StepId context =
            file_.add(StepText("PRODUCT_CONTEXT('',").id(application_).raw(",'mechanical')"));
        const StepId product =
            file_.add(StepText("PRODUCT('" + name + "','" + name + "','',(").id(context).raw("))"));
        file_.add(StepText("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(").id(product).raw("))"));
        const StepId formation =
            file_.add(StepText("PRODUCT_DEFINITION_FORMATION('','',").id(product).raw(")"));
        const StepId stage = file_.add(
            StepText("PRODUCT_DEFINITION_CONTEXT('part definition',").id(application_).raw(",'design')"));
        const StepId definition =
            file_.add(StepText("PRODUCT_DEFINITION('design','',").id(formation).raw(",").id(stage).raw(")"));
        const StepId definitionShape =
            file_.add(StepText("PRODUCT_DEFINITION_SHAPE('','',").id(definition).raw(")"));
        file_.add(
            StepText("SHAPE_DEFINITION_REPRESENTATION(").id(definitionShape).raw(",").id(shape).raw(")"));
    }

    const Boundary& boundary_;
    const std::vector<std::vector<std::size_t>>& origins_;
    const ExportOptions& options_;
    StepFile file_;
    StepId application_;
    StepId context_;
    StepId planeContext_;
    StepId origin_;
    std::vector<StepId> vertices_;
    std::vector<StepId> surfaces_;
    std::vector<StepId> edges_;
};

} // namespace

std::string boundaryAsStep(const Boundary& boundary, const std::vector<std::vector<std::size_t>>& origins,
                           const ExportOptions& options) {
    return Writer(boundary, origins, options).write();
}

} // namespace qm
