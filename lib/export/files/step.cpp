#include "export/files/boundary_files.h"
#include "export/files/step_geometry.h"

#include <array>
#include <gp_Ax3.hxx>
#include <optional>

namespace qm {
namespace {

/// Largest length of the names of solids and faces, in bytes: Netgen copies a name into fifty bytes, however
/// long it is, and crashes.
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
    constexpr double inchInMillimetres = 25.4;
    const StepToken prefix{namesOf(unit).stepPrefix};
    const StepId metric =
        file.addComplex("LENGTH_UNIT()NAMED_UNIT(*)" + stepRecord("SI_UNIT", prefix, StepToken{".METRE."}));
    if (unit != LengthUnit::inch) return metric;
    const StepId exponents = file.add("DIMENSIONAL_EXPONENTS", 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    const StepId measure = file.add("LENGTH_MEASURE_WITH_UNIT",
                                    StepToken{stepRecord("LENGTH_MEASURE", inchInMillimetres)}, metric);
    return file.addComplex(stepRecord("CONVERSION_BASED_UNIT", "INCH", measure) + "LENGTH_UNIT()" +
                           stepRecord("NAMED_UNIT", exponents));
}

/// Units, and how exact coordinates are.
StepId addContext(StepFile& file, LengthUnit unit, double accuracy) {
    const StepId length = addLengthUnit(file, unit);
    const StepId angle = file.addComplex("NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.)");
    const StepId solidAngle = file.addComplex("NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT()");
    const StepId uncertainty =
        file.add("UNCERTAINTY_MEASURE_WITH_UNIT", StepToken{stepRecord("LENGTH_MEASURE", accuracy)}, length,
                 "distance_accuracy_value", "largest gap");
    return file.addComplex(stepRecord("GEOMETRIC_REPRESENTATION_CONTEXT", 3) +
                           stepRecord("GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT", std::array{uncertainty}) +
                           stepRecord("GLOBAL_UNIT_ASSIGNED_CONTEXT", std::array{length, angle, solidAngle}) +
                           stepRecord("REPRESENTATION_CONTEXT", "", "3D"));
}

class Writer {
public:
    Writer(const Boundary& boundary, const FaceOrigins& origins, const ExportOptions& options)
        : boundary_(boundary), origins_(origins), options_(options), edges_(boundary.edges.size()) {
        application_ =
            file_.add("APPLICATION_CONTEXT", "core data for automotive mechanical design processes");
        file_.add("APPLICATION_PROTOCOL_DEFINITION", "international standard", "automotive_design", 2000,
                  application_);
        context_ = addContext(file_, options.unit, largestTolerance(boundary));
        planeContext_ =
            file_.addComplex("GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()"
                             "REPRESENTATION_CONTEXT('','2D')");
        origin_ = addPlacement(file_, gp_Ax3());
    }

    std::string write() {
        for (const BoundaryVertex& vertex : boundary_.vertices)
            vertices_.push_back(file_.add("VERTEX_POINT", "", addPoint(file_, vertex.point)));
        for (const BoundaryFace& face : boundary_.faces)
            surfaces_.push_back(addSurface(file_, face.surface));
        addEdges();
        const std::vector<BoundaryBody> bodies = bodiesOf(boundary_.parts);
        int number = 0;
        for (const BoundaryBody& body : bodies)
            addBody(body, bodies.size() == 1 ? "" : " " + std::to_string(++number));
        return file_.text(stepText(options_.name), options_.date,
                          "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }");
    }

private:
    void addEdges() {
        std::vector<std::array<std::optional<StepId>, 2>> onFaces(edges_.size());
        forEachUse(boundary_, [&](std::size_t face, const EdgeUse& use) {
            if (const auto& curve = boundary_.edges[use.edge].onFaces.at(use.side()); !curve.IsNull())
                onFaces[use.edge].at(use.side()) = addOnSurface(curve, face);
        });
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            const BoundaryEdge& edge = boundary_.edges[e];
            StepId curve = addCurve(file_, edge.curve.curve);
            std::vector<StepId> known;
            for (const auto& onFace : onFaces[e])
                if (onFace) known.push_back(*onFace);
            if (!known.empty()) curve = file_.add("SURFACE_CURVE", "", curve, known, StepToken{".CURVE_3D."});
            edges_[e] =
                file_.add("EDGE_CURVE", "", vertices_[edge.ends[0]], vertices_[edge.ends[1]], curve, true);
        }
    }

    StepId addOnSurface(const Handle(Geom2d_BSplineCurve) & curve, std::size_t face) {
        const StepId plane = addPlaneCurve(file_, curve, boundary_.faces[face].surface);
        return file_.add("PCURVE", "", surfaces_[face],
                         file_.add("DEFINITIONAL_REPRESENTATION", "", std::array{plane}, planeContext_));
    }

    /// \param turned  seen from the other side
    StepId addFace(std::size_t f, bool turned) {
        const BoundaryFace& face = boundary_.faces[f];
        std::vector<StepId> bounds;
        for (const auto& outline : face.loops) {
            std::vector<StepId> uses;
            uses.reserve(outline.size());
            for (const EdgeUse& use : outline)
                uses.push_back(file_.add("ORIENTED_EDGE", "", derivedValue, derivedValue, edges_[use.edge],
                                         use.forwards));
            const StepId loop = file_.add("EDGE_LOOP", "", uses);
            bounds.push_back(
                file_.add(bounds.empty() ? "FACE_OUTER_BOUND" : "FACE_BOUND", "", loop, !turned));
        }
        return file_.add("ADVANCED_FACE", faceName(origins_[f]), bounds, surfaces_[f],
                         face.reversed == turned);
    }

    StepId addShell(const BoundaryPart& part) {
        std::vector<StepId> faces;
        for (const std::size_t face : part.faces)
            faces.push_back(addFace(face, part.inward));
        return file_.add(part.closed ? "CLOSED_SHELL" : "OPEN_SHELL", "", faces);
    }

    StepId addSolid(const BoundaryBody& body, const std::string& name) {
        const StepId outer = addShell(*body.outer);
        std::vector<StepId> cavities;
        for (const BoundaryPart* cavity : body.cavities)
            cavities.push_back(file_.add("ORIENTED_CLOSED_SHELL", "", derivedValue, addShell(*cavity), true));
        return cavities.empty() ? file_.add("MANIFOLD_SOLID_BREP", name, outer)
                                : file_.add("BREP_WITH_VOIDS", name, outer, cavities);
    }

    /// \param number  the end of its name
    void addBody(const BoundaryBody& body, const std::string& number) {
        const std::string name = stepText(options_.name, maxName - number.size()) + number;
        const bool isSolid = body.outer->closed;
        const StepId made =
            isSolid ? addSolid(body, name)
                    : file_.add("SHELL_BASED_SURFACE_MODEL", name, std::array{addShell(*body.outer)});
        addProduct(stepText(options_.name) + number,
                   file_.add(isSolid ? "ADVANCED_BREP_SHAPE_REPRESENTATION"
                                     : "MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
                             "", std::array{origin_, made}, context_));
    }

    void addProduct(const std::string& name, StepId shape) {
        const StepId context = file_.add("PRODUCT_CONTEXT", "", application_, "mechanical");
        const StepId product = file_.add("PRODUCT", name, name, "", std::array{context});
        file_.add("PRODUCT_RELATED_PRODUCT_CATEGORY", "part", noValue, std::array{product});
        const StepId formation = file_.add("PRODUCT_DEFINITION_FORMATION", "", "", product);
        const StepId stage =
            file_.add("PRODUCT_DEFINITION_CONTEXT", "part definition", application_, "design");
        const StepId definition = file_.add("PRODUCT_DEFINITION", "design", "", formation, stage);
        const StepId definitionShape = file_.add("PRODUCT_DEFINITION_SHAPE", "", "", definition);
        file_.add("SHAPE_DEFINITION_REPRESENTATION", definitionShape, shape);
    }

    const Boundary& boundary_;
    const FaceOrigins& origins_;
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

std::string boundaryAsStep(const Boundary& boundary, const FaceOrigins& origins,
                           const ExportOptions& options) {
    return Writer(boundary, origins, options).write();
}

} // namespace qm
