#include "base/at.h"
#include "check/check_sections.h"
#include "check/tracks/paths.h"

#include <utility>

namespace qm::check {

namespace {

constexpr const char* place = "/baseComplex";

void checkExtraordinaryVertices(const Neighbourhoods& around, const BaseComplexPart& part, Report& report) {
    const std::string list = below(place, "extraordinaryVertices");
    std::vector<char> listed(at(around.vertices()), 0);
    for (std::size_t i = 0; i < part.extraordinaryVertices.size(); ++i) {
        const int vertex = part.extraordinaryVertices[i];
        if (!knownVertex(around, vertex, below(list, i), report)) continue;
        if (around.regular(vertex)) report.violate(below(list, i), "extraordinary", "this vertex is regular");
        if (i > 0 && part.extraordinaryVertices[i - 1] >= vertex)
            report.violate(below(list, i), "order", "extraordinary vertices are listed once, ascending");
        listed[at(vertex)] = 1;
    }
    for (int vertex = 0; vertex < around.vertices(); ++vertex)
        if (!around.regular(vertex) && !listed[at(vertex)])
            report.violate(list, "extraordinary",
                           "vertex " + std::to_string(vertex) + " is extraordinary and is not listed");
}

class SeparatrixCheck {
public:
    SeparatrixCheck(const Neighbourhoods& around, const LineNetwork& network, const BaseComplexPart& part,
                    Report& report)
        : around_(around), network_(network), part_(part), report_(report),
          rankOfWay_(network.ways.size(), -1), wayOfRank_(part.separatrices.size(), -1) {}

    void run() {
        for (std::size_t i = 0; i < part_.separatrices.size(); ++i)
            readOne(i);
        for (std::size_t i = 0; i < part_.separatrices.size(); ++i)
            if (wayOfRank_[i] >= 0) checkOpposite(i);
        for (std::size_t w = 0; w < network_.ways.size(); ++w)
            if (rankOfWay_[w] < 0) missing(network_.ways[w].steps.front());
    }

private:
    [[nodiscard]] std::string pointer(std::size_t rank) const { return below(place, "separatrices", rank); }

    void readOne(std::size_t rank) {
        const auto& separatrix = part_.separatrices[rank];
        const std::string here = pointer(rank);
        const std::string path = below(here, "vertices");
        checkNumber(separatrix.id, rank, here, "separatrices", report_);
        const auto steps = readPath(around_, separatrix.vertices, path, report_);
        if (!steps) return;
        const auto found = network_.wayByFirstStep.find(steps->front());
        if (found == network_.wayByFirstStep.end()) {
            report_.violate(below(path, 0), "separatrix start",
                            "no separatrix leaves vertex " + std::to_string(separatrix.vertices[0]) +
                                " this way");
            return;
        }
        const Way& way = network_.ways[at(found->second)];
        const std::size_t bend = firstBend(around_, *steps);
        if (bend < steps->size())
            report_.violate(below(path, bend + 1), "straight on",
                            "the path does not go straight on to this vertex");
        else if (*steps != way.steps)
            report_.violate(path, "separatrix end",
                            "it ends at vertex " + std::to_string(separatrix.vertices.back()) +
                                ", which is neither extraordinary nor on the boundary");
        int& known = rankOfWay_[at(found->second)];
        if (known >= 0)
            report_.violate(here, "separatrix twice", "the same as separatrix " + std::to_string(known));
        known = static_cast<int>(rank);
        wayOfRank_[rank] = found->second;
        if (separatrix.selfCrossing != way.selfCrossing())
            report_.violate(below(here, "selfCrossing"), "self-crossing",
                            way.selfCrossing() ? "it visits a vertex twice" : "it visits no vertex twice");
    }

    void checkOpposite(std::size_t rank) {
        const auto& opposite = part_.separatrices[rank].opposite;
        const int expected = network_.ways[at(wayOfRank_[rank])].opposite;
        const std::string here = below(pointer(rank), "opposite");
        if (expected < 0) {
            if (opposite) report_.violate(here, "opposite", "it ends on the boundary and has no opposite");
            return;
        }
        const bool known = opposite && *opposite >= 0 && *opposite < static_cast<int>(wayOfRank_.size());
        if (!known || wayOfRank_[at(*opposite)] != expected)
            report_.violate(here, "opposite",
                            "the same path backwards is separatrix " +
                                std::to_string(rankOfWay_[at(expected)]));
    }

    void missing(int step) {
        report_.violate(below(place, "separatrices"), "separatrix missing",
                        "the one from vertex " + std::to_string(around_.from(step)) + " over vertex " +
                            std::to_string(around_.to(step)) + " is not listed");
    }

    const Neighbourhoods& around_;
    const LineNetwork& network_;
    const BaseComplexPart& part_;
    Report& report_;
    std::vector<int> rankOfWay_; ///< in the document; -1 if it is not there
    std::vector<int> wayOfRank_;
};

} // namespace

void checkBaseComplex(const Neighbourhoods& around, const LineNetwork& network, const BaseComplexPart& part,
                      Report& report) {
    checkExtraordinaryVertices(around, part, report);
    SeparatrixCheck(around, network, part, report).run();
    if (std::cmp_not_equal(part.ordinaryJunctions, network.ordinaryJunctions))
        report.violate(below(place, "ordinaryJunctions"), "n_j",
                       "the mesh has " + std::to_string(network.ordinaryJunctions) + " ordinary junctions");
}

} // namespace qm::check
