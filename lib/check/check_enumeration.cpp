#include "base/at.h"
#include "base/infinity.h"
#include "base/number_text.h"
#include "check/check_sections.h"
#include "check/tracks/check_graph.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace qm::check {

namespace {

using BigInteger = boost::multiprecision::cpp_int;

class EnumerationCheck {
public:
    EnumerationCheck(const Context& context, const std::vector<LineNetwork>& networks,
                     const BaseComplexPart* complex, const EnumerationPart& part, Report& report)
        : context_(context), around_(context.around), networks_(networks), complex_(complex), part_(part),
          report_(report), present_(at(around_.edges()), 0) {}

    void run() {
        if (part_.tmesh && networks_.size() != 1)
            report_.violate("/enumeration/class", "class", "a T-mesh is that of a whole mesh");
        if (part_.subMeshes.size() != networks_.size()) {
            report_.violate("/enumeration/subMeshes", "sub-meshes",
                            "the mesh is cut into " + std::to_string(networks_.size()));
            return;
        }
        if (context_.segmentCost != 0) countBareCorners();
        for (std::size_t k = 0; k < networks_.size(); ++k)
            subMesh(k);
        totalCount();
    }

private:
    void subMesh(std::size_t k) {
        const auto& subMesh = part_.subMeshes[k];
        const std::string here = below("/enumeration/subMeshes", k);
        checkNumber(subMesh.id, k, here, "sub-meshes", report_);
        known_.clear();
        double before = -infinity;
        for (std::size_t g = 0; g < subMesh.graphs.size(); ++g) {
            const std::string place = below(here, "graphs", g);
            auto [edges, cost] = graph(k, subMesh.graphs[g], place);
            const auto [same, isNew] = known_.emplace(std::move(edges), place);
            if (!isNew) report_.violate(place, "distinct", "it has the same edges as " + same->second);
            if (cost.value() < before && !cost.equals(before))
                report_.violate(place, "sorted", "the graph before it costs more");
            before = cost.value();
            if (g == 0) best(subMesh, cost, here);
        }
        for (std::size_t s = 0; s < subMesh.samples.size(); ++s)
            (void)graph(k, subMesh.samples[s], below(here, "samples", s));
        count(subMesh, here);
    }

    /// Corners of faces around a vertex that have the graph or the mesh boundary on both sides.
    [[nodiscard]] int cornersAt(int vertex) const {
        const auto bounds = [&](int step) {
            return around_.boundary(step) || present_[at(around_.edge(step))] != 0;
        };
        int corners = 0;
        const int valence = around_.valence(vertex);
        for (int i = 0; i < valence; ++i) {
            const int step = around_.firstStep(vertex) + i;
            const int next = around_.firstStep(vertex) + (i + 1) % valence;
            if (around_.leftFace(step) >= 0 && bounds(step) && bounds(next)) ++corners;
        }
        return corners;
    }

    [[nodiscard]] std::size_t labelOf(int vertex) const {
        return context_.labels.empty() ? 0 : at(context_.labels[at(vertex)]);
    }

    /// What the mesh boundary alone makes.
    void countBareCorners() {
        bareCorners_.assign(networks_.size(), 0);
        for (int vertex = 0; vertex < around_.vertices(); ++vertex) {
            bareCornersAt_.push_back(cornersAt(vertex));
            bareCorners_[labelOf(vertex)] += bareCornersAt_.back();
        }
    }

    /// At the sub-mesh's vertices, and where its tracks end on the mesh boundary past the cut.
    [[nodiscard]] int corners(std::size_t subMesh, const std::vector<ReadTrack>& tracks) {
        std::set<int> touched;
        for (const ReadTrack& track : tracks)
            for (const int step : track.steps)
                touched.insert({around_.from(step), around_.to(step)});
        int sum = bareCorners_[subMesh];
        for (const int vertex : touched)
            if (labelOf(vertex) == subMesh)
                sum += cornersAt(vertex) - bareCornersAt_[at(vertex)];
            else if (!around_.interior(vertex) && around_.regular(vertex))
                sum += cornersAt(vertex);
        return sum;
    }

    struct PricedGraph {
        std::vector<int> edges; ///< ascending
        CostSum cost;
    };

    PricedGraph graph(std::size_t subMesh, const EnumerationPart::Graph& graph, const std::string& here) {
        const LineNetwork& network = networks_[subMesh];
        const std::string list = below(here, "tracks");
        const auto tracks = readTracks(around_, graph.tracks, list, report_);
        for (const ReadTrack& track : tracks)
            references(graph.tracks[track.rank], below(list, track.rank));
        auto edges = edgesOf(around_, tracks, list, report_);
        for (const int edge : edges)
            present_[at(edge)] = 1;
        checkGraph(around_, network, {list, tracks, present_, edges.size()}, part_.tmesh, report_);
        checkConstraints(context_, present_, networks_.size() == 1 ? GraphOf::mesh : GraphOf::subMesh, list,
                         report_);
        CostSum cost(context_.costs);
        if (context_.segmentCost != 0) cost.addCost(context_.segmentCost * corners(subMesh, tracks) / 4);
        for (const int edge : edges)
            present_[at(edge)] = 0;

        for (const int edge : edges)
            cost.add(edge);
        if (graph.cost && !cost.equals(*graph.cost))
            report_.violate(below(here, "cost"), "cost",
                            "the edges of its tracks cost " + numberText(cost.value()));
        return {std::move(edges), cost};
    }

    void references(const TrackPart& track, const std::string& here) {
        if (track.source && *track.source != track.vertices.front())
            report_.violate(below(here, "source"), "track source", "the track starts at another vertex");
        if (!track.separatrix || !complex_) return;
        const int id = *track.separatrix;
        const auto& separatrices = complex_->separatrices;
        if (id < 0 || id >= static_cast<int>(separatrices.size())) {
            report_.violate(below(here, "separatrix"), "track separatrix",
                            "there is no separatrix of this number");
            return;
        }
        const auto& path = separatrices[at(id)].vertices;
        const auto leaves =
            std::mismatch(track.vertices.begin(), track.vertices.end(), path.begin(), path.end());
        if (leaves.first != track.vertices.end())
            report_.violate(below(here, "separatrix"), "track separatrix",
                            "the track does not run on this separatrix");
    }

    void best(const EnumerationPart::SubMesh& subMesh, const CostSum& cost, const std::string& here) {
        if (subMesh.cost && !cost.equals(*subMesh.cost))
            report_.violate(below(here, "cost"), "best cost",
                            "the first graph costs " + numberText(cost.value()));
        if (subMesh.lowerBound && !(*subMesh.lowerBound <= cost.value()) && !cost.equals(*subMesh.lowerBound))
            report_.violate(below(here, "lowerBound"), "bound", "it is above the cost of the first graph");
    }

    void count(const EnumerationPart::SubMesh& subMesh, const std::string& here) {
        counts_.push_back(bigInteger(subMesh.count, below(here, "count")));
        if (counts_.back() && *counts_.back() < subMesh.graphs.size())
            report_.violate(below(here, "count"), "count",
                            std::to_string(subMesh.graphs.size()) + " graphs are listed");
    }

    /// Nothing if there is none; at most 2^edges graphs exist, so a longer number is wrong.
    std::optional<BigInteger> bigInteger(const std::optional<std::string>& text, const std::string& pointer) {
        if (!text) return std::nullopt;
        const bool digits = text->find_first_not_of("0123456789") == std::string::npos;
        const bool plain = digits && !text->empty() && (text->size() == 1 || text->front() != '0');
        if (plain && text->size() <= at(around_.edges()) + 1) return BigInteger(*text);
        report_.violate(pointer, "count",
                        plain ? "the mesh has not that many sets of edges" : "it is no decimal number");
        return std::nullopt;
    }

    void totalCount() {
        const auto total = bigInteger(part_.count, "/enumeration/count");
        if (!total) return;
        BigInteger product = 1;
        for (std::size_t k = 0; k < part_.subMeshes.size(); ++k) {
            if (!counts_[k]) {
                report_.violate("/enumeration/count", "count",
                                "sub-mesh " + std::to_string(k) + " has no count to go with it");
                return;
            }
            product *= *counts_[k];
        }
        if (product != *total)
            report_.violate("/enumeration/count", "count",
                            "the sub-meshes' counts multiply to " + product.str());
    }

    const Context& context_;
    const Neighbourhoods& around_;
    const std::vector<LineNetwork>& networks_;
    const BaseComplexPart* complex_;
    const EnumerationPart& part_;
    Report& report_;
    std::vector<char> present_;                     ///< by edge; all 0 between two graphs
    std::vector<int> bareCornersAt_;                ///< by vertex
    std::vector<int> bareCorners_;                  ///< by sub-mesh
    std::vector<std::optional<BigInteger>> counts_; ///< of the sub-meshes
    std::map<std::vector<int>, std::string> known_; ///< the sub-mesh's graphs so far
};

} // namespace

void checkEnumeration(const Context& context, const std::vector<LineNetwork>& networks,
                      const BaseComplexPart* complex, const EnumerationPart& part, Report& report) {
    EnumerationCheck(context, networks, complex, part, report).run();
}

} // namespace qm::check
