#include "cli/tools/remesh_input.h"

#include "base/number_text.h"
#include "cli/system/exit_status.h"
#include "cli/tools/repair_text.h"
#include "mesh/bounding_box.h"
#include "mesh/files/read_triangles.h"
#include "mesh/files/write_soup.h"
#include "summary/figure_text.h"

#include <algorithm>
#include <string>

namespace qm {
namespace {

constexpr const char* remedy = ". Another number of quads or --seed may help, or a scan without small parts";

int judge(const Tool& tool, const Remeshed& remeshed) {
    if (remeshed.loops != remeshed.scanLoops)
        tool.warnOfInput("the quad mesh has " + countText(remeshed.loops, "boundary loop") +
                         ", the scan has " + std::to_string(remeshed.scanLoops) +
                         ". Another number of quads may help");
    const Mismatch& found = remeshed.mismatch;
    const double extent = boundingBox(remeshed.mesh).diagonal();
    if (found.missing > 0)
        tool.warnOfInput("the quads leave out " + figureText(std::max(100 * found.missing, 0.01)) +
                         "% of the scan, up to " + figureText(found.missingDistance) + " away, at " +
                         pointText(found.missingAt, extent) + remedy);
    if (found.strayed > 0)
        tool.warnOfInput("a vertex of the quads is " + figureText(found.strayed) +
                         " away from the scan, at " + pointText(found.strayedAt, extent) + remedy);
    return found.missing > 0 || found.strayed > 0 ? exitUnmet : exitDone;
}

} // namespace

int remeshInput(const Tool& tool, const RemeshOptions& options) {
    Triangles scan = readTriangles(tool.readInput(), tool.inputPath());
    tool.protect(tool.inputPath());
    tool.count("triangles", scan.faces.size());
    if (const std::string done = repairText(repairTriangles(scan)); !done.empty()) tool.warnOfInput(done);
    const Remeshed remeshed = remeshWithBlender(scan, options, tool.jobs());
    if (remeshed.used.seed != options.seed)
        tool.note("made with --seed " + std::to_string(remeshed.used.seed));
    if (remeshed.used.preserveSharp != options.preserveSharp)
        tool.warn("QuadriFlow did not end: made with --no-preserve-sharp");
    tool.count("quads", remeshed.mesh.n_faces());
    tool.count("weldedVertices", remeshed.repair.weldedVertices);
    tool.write(writeObj(remeshed.mesh));
    return judge(tool, remeshed);
}

} // namespace qm
