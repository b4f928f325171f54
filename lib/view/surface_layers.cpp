#include "bspline/reference/fit_reference.h"
#include "view/layers.h"
#include "view/surface_samples.h"

namespace qm {
namespace {

void addDeviationFigures(Items& items, const Deviation& deviation, const std::string& unit) {
    addFigure(items, "largest deviation, " + unit, deviation.max);
    addFigure(items, "deviation, root mean square, " + unit, deviation.rms);
    addFigure(items, "largest gap, " + unit, deviation.largestGap);
    addFigure(items, "largest angle between normals, degrees", deviation.largestNormalAngle);
}

FittedPatches fittedPatches(const Viewed& viewed, const Point& centre) {
    FittedPatches fitted;
    fitted.steps = latticeSteps(viewed.mesh.n_faces(), viewed.maxPoints);
    for (const Patch& patch : viewed.surfaces->patches) {
        fitted.degrees.push_back(patch.degree);
        fitted.counts.push_back(patch.count);
        fitted.knots.push_back(patch.knots);
        for (const Point& point : patch.controlPoints)
            appendPosition(fitted.controlPoints, point, centre);
    }
    for (const Segment& segment : viewed.layout->segments)
        for (const FaceId face : segment.faces)
            fitted.faces.push_back(static_cast<std::uint32_t>(face.idx()));
    return fitted;
}

FaceLayer surfaceLayer(const std::string& name, const std::string& title, Paint paint, Mapped mapped = {}) {
    auto layer = newLayer<FaceLayer>(name, title);
    layer.base = Base::surfaces;
    layer.paint = paint;
    layer.mapped = std::move(mapped);
    layer.itemsOf = "surfaces";
    return layer;
}

/// The layer whose items are the patches, coloured like the segments.
FaceLayer patchLayer(const Scene& scene, const Viewed& viewed) {
    auto layer = newLayer<FaceLayer>("surfaces", "patches", "patch", "/surfaces/patches/");
    layer.base = Base::surfaces;
    layer.paint = Paint::items;
    const std::vector<Patch>& patches = viewed.surfaces->patches;
    layer.items.count = patches.size();
    for (std::size_t k = 0; k < patches.size(); ++k) {
        addFigure(layer.items, "control points along u", patches[k].count[0]);
        addFigure(layer.items, "control points along v", patches[k].count[1]);
        if (k < viewed.surfaces->ofPatch.size())
            addDeviationFigures(layer.items, viewed.surfaces->ofPatch[k], viewed.unit);
    }
    for (const FaceLayer& faces : scene.faces)
        if (faces.name == "segments") layer.colours = faces.colours;
    return layer;
}

/// How far the surfaces are from what the tolerance refers to.
/// \param target  null if it is a scan that is not at hand: then what the document says of every patch
Mapped deviationOf(const Viewed& viewed, const FitTarget* target, std::size_t steps, unsigned jobs) {
    Mapped mapped{Scale::rising, {}, {}, {}, viewed.unit, viewed.tolerance};
    std::vector<double> distances;
    if (target != nullptr) {
        mapped.quantity = viewed.scan != nullptr ? "distance from the scan without its noise"
                                                 : "distance from the mesh's smooth surface";
        distances = distancesFromReference(
            {viewed.mesh, *viewed.layout, viewed.surfaces->patches, target->grids}, steps, jobs);
    } else {
        mapped.quantity = "largest distance of the patch from the scan without its noise";
        for (const Deviation& deviation : viewed.surfaces->ofPatch)
            distances.push_back(deviation.max);
        distances.resize(viewed.surfaces->patches.size(), viewed.surfaces->deviation.max);
        distances = onLattice(distances, *viewed.layout, steps);
    }
    mapped.values.assign(distances.begin(), distances.end());
    return mapped;
}

/// The scan's noise counts here, so the tolerance is no limit.
Mapped distanceFromScan(const Viewed& viewed, double cutOff, std::size_t steps, unsigned jobs) {
    const auto distances = distancesFromScan(viewed.surfaces->patches, *viewed.scan, cutOff, steps, jobs);
    return {Scale::rising,
            {distances.begin(), distances.end()},
            {},
            "distance from the scan's triangles",
            viewed.unit};
}

} // namespace

void addSurfaces(Scene& scene, const Viewed& viewed, const Point& centre, unsigned jobs) {
    scene.patches = fittedPatches(viewed, centre);
    // What was to keep to a tolerance was fitted smoothly, over bridged and evened quads.
    const FitReference reference =
        fitReference(viewed.mesh, *viewed.layout, viewed.dihedralAngles,
                     {.rho = viewed.rho, .improves = viewed.tolerance.has_value()}, viewed.scan, jobs);
    const bool isKnown = !viewed.surfaces->scan || viewed.scan != nullptr;
    const auto add = [&scene](FaceLayer layer) { scene.faces.push_back(std::move(layer)); };
    add(patchLayer(scene, viewed));
    add(surfaceLayer("shaded", "shaded", Paint::plain));
    add(surfaceLayer("zebra", "zebra stripes", Paint::stripes));
    add(surfaceLayer("mean", "mean curvature", Paint::mapped,
                     {Scale::centred, {}, "mean curvature", "mean curvature", "1/" + viewed.unit}));
    add(surfaceLayer(
        "gauss", "Gauss curvature", Paint::mapped,
        {Scale::centred, {}, "Gauss curvature", "Gauss curvature", "1/" + viewed.unit + "\u00b2"}));
    Mapped deviation = deviationOf(viewed, isKnown ? &reference.target : nullptr, scene.patches.steps, jobs);
    Mapped verdict{Scale::verdict, {}, "deviation", deviation.quantity, viewed.unit, viewed.tolerance};
    add(surfaceLayer("deviation", "deviation", Paint::mapped, std::move(deviation)));
    if (viewed.tolerance)
        add(surfaceLayer("tolerance", "within the tolerance or not", Paint::mapped, std::move(verdict)));
    if (viewed.scan != nullptr)
        add(surfaceLayer("scan", "distance from the scan itself", Paint::mapped,
                         distanceFromScan(viewed, reference.target.maxDistance, scene.patches.steps, jobs)));
    addSurfaceLines(scene, viewed, reference.network.marks);
}

} // namespace qm
