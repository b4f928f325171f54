#include "cli/tools/quadriflow.h"

#include "base/embedded_text.h"
#include "base/error.h"
#include "cli/system/child_process.h"
#include "cli/system/output_file.h"
#include "document/files/files.h"
#include "mesh/boundary_loops.h"
#include "mesh/bounding_box.h"
#include "mesh/files/read_mesh.h"
#include "mesh/files/write_soup.h"
#include "mesh/triangles/triangle_edges.h"
#include "remesh/close_holes.h"
#include "remesh/draw_to_scan.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace qm {
namespace {

constexpr int maxSeeds = 3;

/// How long QuadriFlow may take, ten times as long as it usually does: with sharp edges, it does not always
/// end.
std::chrono::seconds patienceFor(std::size_t triangles, int quads) {
    return std::chrono::seconds(10 + quads / 100 + static_cast<int>(triangles / 1000));
}

/// Moves the centre of a box to the origin, and scales the box to a length at which Blender, which takes no
/// mesh with an edge shorter than 1e-4, takes every edge that single precision tells from none.
class WorkingBox {
public:
    explicit WorkingBox(const std::vector<Point>& points) {
        const BoundingBox box = boundingBoxOf(points);
        centre_ = box.low / 2 + box.high / 2;
        unit_ = box.size().max() / 1024;
    }
    [[nodiscard]] Point to(const Point& point) const { return (point - centre_) / unit_; }
    [[nodiscard]] Point from(const Point& point) const { return point * unit_ + centre_; }

private:
    Point centre_{0, 0, 0};
    double unit_ = 1;
};

/// A result of QuadriFlow, or the reason why it is no quad mesh.
struct Attempt {
    std::optional<Remeshed> result;
    std::string problem;
    bool isStuck = false; ///< QuadriFlow did not end
};

/// QuadriFlow with a scan to work on. Signals are held as long as this exists.
class QuadriFlow {
public:
    explicit QuadriFlow(const Triangles& scan)
        : folder_("qm-remesh"), box_(scan.points), triangles_(scan.faces.size()),
          loops_(boundaryLoopCount(scan)) {
        Triangles scaled = scan;
        std::ranges::transform(scan.points, scaled.points.begin(),
                               [&](const Point& point) { return box_.to(point); });
        writeFile(folder_.file("scan.obj"), writeSoup(soupOf(scaled), MeshFormat::obj));
        for (const EmbeddedText& script : embeddedBlenderScripts())
            writeFile(folder_.file(std::string(script.name)), script.text);
    }

    [[nodiscard]] bool isOpen() const { return loops_ > 0; }

    /// \param holdsBoundary  whether edges are held to the boundary of the scan
    [[nodiscard]] Attempt attempt(const RemeshOptions& options, bool holdsBoundary) const {
        const std::string quads = folder_.file("quads.obj");
        std::filesystem::remove(quads);
        if (!run(options, holdsBoundary)) return {{}, "QuadriFlow does not end", true};
        if (HeldSignals::oneWaits() || !std::filesystem::exists(quads))
            return {{}, "QuadriFlow gave up", false};
        try {
            ReadResult read = readMesh(readFile(quads), "", {.repair = true});
            for (const VertexId vertex : read.mesh.vertices())
                read.mesh.set_point(vertex, box_.from(read.mesh.point(vertex)));
            const std::size_t loops = boundaryLoops(read.mesh).size();
            return {Remeshed{std::move(read.mesh), read.repair, loops, loops_, options, {}}, {}, false};
        } catch (const Error& error) {
            return {{}, error.what(), false};
        }
    }

private:
    /// \return whether it has ended in time
    [[nodiscard]] bool run(const RemeshOptions& options, bool holdsBoundary) const {
        const auto flag = [](bool value) { return std::string(value ? "1" : "0"); };
        const std::vector<std::string> words = {"blender",
                                                "--background",
                                                "--factory-startup",
                                                "-noaudio", // it would leave a folder of the sound server's
                                                "--python-exit-code",
                                                "1",
                                                "--python",
                                                folder_.file("quadriflow.py"),
                                                "--",
                                                folder_.file("scan.obj"),
                                                folder_.file("quads.obj"),
                                                std::to_string(options.quads),
                                                flag(options.preserveSharp),
                                                flag(holdsBoundary),
                                                std::to_string(options.seed)};
        const std::chrono::seconds patience = patienceFor(triangles_, options.quads);
        const auto begin = std::chrono::steady_clock::now();
        if (!runProgram(words, signals_, folder_.file("messages"), patience))
            throw Error("", "Blender makes the quads, and is not there", "Install Debian's package blender");
        return std::chrono::steady_clock::now() - begin < patience;
    }

    HeldSignals signals_;
    TemporaryFolder folder_;
    WorkingBox box_;
    std::size_t triangles_; ///< of the scan, like the boundary loops
    std::size_t loops_;
};

std::size_t difference(const Remeshed& remeshed) {
    return std::max(remeshed.loops, remeshed.scanLoops) - std::min(remeshed.loops, remeshed.scanLoops);
}

} // namespace

Remeshed remeshWithBlender(const Triangles& scan, const RemeshOptions& options, unsigned jobs) {
    const QuadriFlow quadriFlow(scan);
    std::optional<Remeshed> best;
    std::string problem;
    RemeshOptions next = options;
    const auto tryWith = [&](int seed, bool holdsBoundary) {
        if (HeldSignals::oneWaits()) return;
        next.seed = seed;
        Attempt made = quadriFlow.attempt(next, holdsBoundary);
        if (made.isStuck) next.preserveSharp = false; // it would be stuck with other seeds, too
        if (made.result && (!best || difference(*made.result) < difference(*best)))
            best = std::move(made.result);
        if (problem.empty()) problem = made.problem;
    };
    for (int k = 0; k < maxSeeds && (!best || difference(*best) > 0); ++k)
        tryWith(options.seed + k, quadriFlow.isOpen());
    if (!best && quadriFlow.isOpen()) tryWith(options.seed, false);
    if (!best)
        throw Error("", "QuadriFlow makes no quad mesh of it: " + problem,
                    "Try another number of quads, or mend the scan");
    if (best->loops > 0) {
        best->mesh = closeHoles(std::move(best->mesh), scan);
        best->loops = boundaryLoops(best->mesh).size();
    }
    if (options.draw && !HeldSignals::oneWaits()) best->mesh = drawToScan(std::move(best->mesh), scan, jobs);
    best->mismatch = mismatchOf(best->mesh, scan, jobs);
    return std::move(*best);
}

} // namespace qm
