#include "bench/search_problem.h"

#include "basecomplex/arc_graph.h"
#include "mesh/dihedral.h"

namespace qm::bench {

Problem searchProblem(const QuadMesh& mesh, const BaseComplex& complex, GraphClass graphClass) {
    const ArcGraph graph = buildArcGraph(mesh, complex);
    const auto costs = sumOverArcs(mesh, graph, complex, edgeCosts(dihedralAngles(mesh), {}));
    Problem problem = makeProblem({graph, costs, {}, {}, {}, {}});
    problem.gaps = graphClass == GraphClass::motorcycle;
    return problem;
}

Problem searchProblem(const QuadMesh& mesh, GraphClass graphClass) {
    return searchProblem(mesh, buildBaseComplex(mesh), graphClass);
}

} // namespace qm::bench
