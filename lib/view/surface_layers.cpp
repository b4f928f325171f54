#include "base/parallel.h"
#include "bspline/measure/mesh_distance.h"
#include "bspline/splines/evaluate.h"
#include "view/items.h"
#include "view/layers.h"
#include "view/sampled_patch.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// What the figures of patches are called, and where they stand.
void addPatchFigures(Items& items, const Patch& patch) {
    addFigure(items, "control points along u", patch.count[0]);
    addFigure(items, "control points along v", patch.count[1]);
}

void addDeviationFigures(Items& items, const Deviation& deviation) {
    addFigure(items, "largest deviation", deviation.max);
    addFigure(items, "deviation, root mean square", deviation.rms);
    addFigure(items, "largest gap", deviation.largestGap);
    addFigure(items, "largest angle between normals, degrees", deviation.largestNormalAngle);
}

/// Appends a patch's samples to the shell.
void appendSamples(Shell& shell, const SampledPatch& patch, const Segment& segment, const Point& centre) {
    const auto first = static_cast<std::uint32_t>(shell.positions.size() / 3);
    for (const SurfacePoint& point : patch.points) {
        appendPosition(shell.positions, point.position, centre);
        appendPosition(shell.normals, unitNormal(point.du, point.dv), {0, 0, 0});
    }
    const auto width = static_cast<std::uint32_t>(patch.width);
    const auto steps = static_cast<std::uint32_t>(patch.steps);
    const auto columns = static_cast<std::uint32_t>(segment.size[0]);
    for (std::uint32_t j = 0; j + 1 < patch.height; ++j)
        for (std::uint32_t i = 0; i + 1 < width; ++i) {
            const std::uint32_t corner = first + j * width + i;
            shell.quads.insert(shell.quads.end(), {corner, corner + 1, corner + width + 1, corner + width});
            shell.faces.push_back(
                static_cast<std::uint32_t>(segment.faces[j / steps * columns + i / steps].idx()));
        }
}

/// Adds the four sides of a patch, walking round it.
void addCurves(LineLayer& curves, const SampledPatch& patch, std::uint32_t first, std::size_t number) {
    const std::size_t across = patch.width - 1;
    const std::size_t up = patch.height - 1;
    const auto add = [&](std::size_t side, std::size_t length, auto&& place) {
        for (std::size_t k = 0; k <= length; ++k)
            curves.points.push_back(first + static_cast<std::uint32_t>(place(k)));
        endItem(curves);
        addFigure(curves.items, "of patch", static_cast<double>(number));
        addFigure(curves.items, "side", static_cast<double>(side));
    };
    add(0, across, [&](std::size_t k) { return k; });
    add(1, up, [&](std::size_t k) { return k * patch.width + across; });
    add(2, across, [&](std::size_t k) { return up * patch.width + across - k; });
    add(3, up, [&](std::size_t k) { return (up - k) * patch.width; });
}

void addNet(Scene& scene, const std::vector<Patch>& patches, const Point& centre) {
    Shell& shell = scene.shells[static_cast<std::size_t>(Base::net)];
    LineLayer net = newLines("net", "control nets", "control net of patch", "/surfaces/patches/");
    net.base = Base::net;
    for (const Patch& patch : patches) {
        const auto first = static_cast<std::uint32_t>(shell.positions.size() / 3);
        for (const Point& point : patch.controlPoints)
            appendPosition(shell.positions, point, centre);
        // One line that runs along every row and comes back along every column.
        const int columns = patch.count[0], rows = patch.count[1];
        const auto visit = [&](int i, int j) {
            net.points.push_back(first + static_cast<std::uint32_t>(j * columns + i));
        };
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i)
                visit(j % 2 == 0 ? i : columns - 1 - i, j);
        const bool right = rows % 2 == 1;
        for (int i = 0; i < columns; ++i)
            for (int j = 0; j < rows; ++j)
                visit(right ? columns - 1 - i : i, i % 2 == 0 ? rows - 1 - j : j);
        endItem(net);
        addPatchFigures(net.items, patch);
    }
    scene.lines.push_back(std::move(net));
}

FaceLayer surfaceLayer(const char* name, const char* title, const Scene& scene) {
    const auto segments = std::find_if(scene.faces.begin(), scene.faces.end(),
                                       [](const FaceLayer& layer) { return layer.name == "segments"; });
    FaceLayer layer;
    layer.name = name;
    layer.title = title;
    layer.base = Base::surfaces;
    for (const std::uint32_t face : scene.shells[static_cast<std::size_t>(Base::surfaces)].faces)
        layer.groups.push_back(segments->groups[face]);
    layer.colours = segments->colours;
    layer.items.noun = "patch";
    layer.items.pointer = "/surfaces/patches/";
    return layer;
}

} // namespace

void addSurfaces(Scene& scene, const Viewed& viewed, const Point& centre, unsigned jobs) {
    const std::vector<Patch>& patches = viewed.surfaces->patches;
    const std::vector<Segment>& segments = viewed.layout->segments;
    const auto samples = samplePatches(viewed.mesh, *viewed.layout, patches, jobs);

    Shell& shell = scene.shells[static_cast<std::size_t>(Base::surfaces)];
    LineLayer curves = newLines("curves", "borders of patches", "border", "");
    curves.base = Base::surfaces;
    Items items;
    std::vector<float> distances;
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const auto first = static_cast<std::uint32_t>(shell.positions.size() / 3);
        appendSamples(shell, samples[k], segments[k], centre);
        addCurves(curves, samples[k], first, k);
        for (const double distance : samples[k].distances)
            distances.push_back(static_cast<float>(distance));
        addPatchFigures(items, patches[k]);
        if (k < viewed.surfaces->ofPatch.size()) addDeviationFigures(items, viewed.surfaces->ofPatch[k]);
    }
    FaceLayer faces = surfaceLayer("surfaces", "fitted surfaces", scene);
    faces.items.columns = items.columns;
    faces.items.count = patches.size();
    FaceLayer deviation = surfaceLayer("deviation", "deviation of the surfaces", scene);
    deviation.items = faces.items;
    deviation.unit = "distance from the mesh";
    deviation.scale = distances.empty() ? 0 : *std::max_element(distances.begin(), distances.end());
    deviation.values = std::move(distances);
    scene.faces.push_back(std::move(faces));
    scene.faces.push_back(std::move(deviation));
    scene.lines.push_back(std::move(curves));
    addNet(scene, patches, centre);
}

} // namespace qm
