#include "check/check_document.h"

#include "base/number_text.h"
#include "base/or_null.h"
#include "check/check_sections.h"
#include "check/mesh/angles.h"
#include "check/tracks/lines.h"

namespace qm::check {

namespace {

class DocumentCheck {
public:
    DocumentCheck(const CheckedMesh& mesh, const CheckedDocument& document, Report report, unsigned jobs)
        : mesh_(mesh), document_(document), around_(mesh), report_(std::move(report)), jobs_(jobs) {}

    Report run() {
        baseComplex();
        TraceInput sources;
        if (!features(sources) || !labels(sources)) return std::move(report_);
        cut(sources);
        if (document_.weights) priced(sources);
        return std::move(report_);
    }

private:
    /// Notes what the check found true unless it found a violation.
    /// \return whether it found none
    template <class Check> bool section(const Check& check, const std::string& summary) {
        const std::size_t before = report_.total();
        check();
        if (report_.total() != before) return false;
        report_.verify(summary);
        return true;
    }

    void baseComplex() {
        if (!document_.baseComplex) return;
        const auto& part = *document_.baseComplex;
        section([&] { checkBaseComplex(around_, traceLines(around_, {}).front(), part, report_); },
                "base complex: " +
                    countText(part.extraordinaryVertices.size(), "extraordinary vertex",
                              "extraordinary vertices") +
                    ", " + countText(part.separatrices.size(), "separatrix", "separatrices") + ", " +
                    countText(static_cast<std::size_t>(part.ordinaryJunctions), "ordinary junction"));
    }

    bool features(TraceInput& sources) {
        if (!document_.features) return true;
        return section([&] { sources.seedSteps = checkFeatures(around_, *document_.features, report_); },
                       "features: " + countText(document_.features->curves.size(), "curve"));
    }

    bool labels(TraceInput& sources) {
        if (!document_.cut) return true;
        if (!checkLabels(around_, *document_.cut, report_)) return false;
        sources.labels = document_.cut->labels;
        sources.subMeshes = static_cast<int>(document_.cut->subMeshes.size());
        return true;
    }

    void cut(const TraceInput& sources) {
        networks_ = traceLines(around_, sources);
        if (document_.cut)
            section([&] { checkSubMeshes(around_, networks_, *document_.cut, report_); },
                    "cut: " + countText(document_.cut->subMeshes.size(), "sub-mesh", "sub-meshes"));
    }

    void priced(const TraceInput& sources) {
        const Angles angles = dihedralAngles(mesh_, around_);
        const ConstraintsPart constraints = document_.constraints.value_or(ConstraintsPart{});
        if (!checkConstraintPaths(around_, constraints, report_)) return;
        const EdgeCosts costs = edgeCosts(mesh_, around_, angles, *document_.weights, constraints);
        const Context context{mesh_,         around_, angles, costs, constraints, document_.weights->segments,
                              sources.labels};
        if (document_.enumeration) enumeration(context);
        if (!document_.layout) return;
        if (document_.cut) networks_ = traceLines(around_, {sources.seedSteps, {}, 1});
        if (layout(context) && document_.layout->divided) surfaces(context);
    }

    void enumeration(const Context& context) {
        const auto& part = *document_.enumeration;
        std::size_t graphs = 0;
        for (const auto& subMesh : part.subMeshes)
            graphs += subMesh.graphs.size();
        section([&] { checkEnumeration(context, networks_, orNull(document_.baseComplex), part, report_); },
                "enumeration: " + countText(graphs, "graph") + " of " +
                    countText(part.subMeshes.size(), "sub-mesh", "sub-meshes"));
    }

    bool layout(const Context& context) {
        const auto& part = *document_.layout;
        return section([&] { checkLayout(context, networks_.front(), part, report_); },
                       "layout: " + countText(part.tracks.size(), "track") + ", " +
                           countText(part.segments.size(), "segment"));
    }

    void surfaces(const Context& context) {
        if (!document_.surfaces) return;
        const auto& part = *document_.surfaces;
        const bool sound = section([&] { checkSurfaces(mesh_, around_, *document_.layout, part, report_); },
                                   "surfaces: " + countText(part.patches.size(), "patch", "patches"));
        if (sound && part.figures["maxFromFacets"])
            section([&] { checkFigures(context, *document_.layout, part, jobs_, report_); },
                    "deviation: no figure is less than what is measured");
    }

    const CheckedMesh& mesh_;
    const CheckedDocument& document_;
    Neighbourhoods around_;
    Report report_;
    unsigned jobs_;
    std::vector<LineNetwork> networks_;
};

} // namespace

Report checkDocument(const CheckedMesh& mesh, const CheckedDocument& document, Report report, unsigned jobs) {
    return DocumentCheck(mesh, document, std::move(report), jobs).run();
}

} // namespace qm::check
