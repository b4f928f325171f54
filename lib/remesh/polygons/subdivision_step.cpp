#include "remesh/polygons/subdivision_step.h"

#include "base/at.h"
#include "mesh/angle_between.h"

namespace qm {
namespace {

/// A curve of sharp edges goes on where it turns by at most this, radians, as in the reference of the fit.
constexpr double maxTurn = 1.2;

/// A mesh of which one step ends in the given vertices is approached by so many corrections, each this much
/// larger than what is missing. All but the fastest waves, which the step itself smooths away, then differ by
/// less than a millionth.
constexpr int correctionCount = 40;
constexpr double correctionFactor = 1.5;

std::vector<Point> faceMiddles(const Soup& soup, const std::vector<Point>& vertices) {
    std::vector<Point> middles(soup.faceCount(), Point(0, 0, 0));
    for (std::size_t face = 0; face < middles.size(); ++face) {
        const auto corners = soup.face(face);
        for (const std::int64_t corner : corners)
            middles[face] += vertices[at(corner)] / static_cast<double>(corners.size());
    }
    return middles;
}

std::vector<Point> edgeMiddles(const PolygonEdges& edges, const std::vector<Point>& vertices) {
    std::vector<Point> middles;
    middles.reserve(edges.ends.size());
    for (const auto& [a, b] : edges.ends)
        middles.push_back((vertices[at(a)] + vertices[at(b)]) / 2);
    return middles;
}

} // namespace

void SubdivisionStep::VertexRule::addEdge(std::int64_t other, bool isSharp) {
    ++edges;
    if (isSharp && ++sharpEdges <= 2) along[sharpEdges - 1] = other;
}

SubdivisionStep::SubdivisionStep(const Soup& soup, const PolygonEdges& edges)
    : soup_(soup), edges_(edges), rules_(soup.points.size()) {
    for (std::size_t k = 0; k < edges.ends.size(); ++k) {
        const auto [a, b] = edges.ends[k];
        rules_[at(a)].addEdge(b, edges.isSharp[k]);
        rules_[at(b)].addEdge(a, edges.isSharp[k]);
    }
    for (std::size_t k = 0; k < rules_.size(); ++k) {
        VertexRule& rule = rules_[k];
        if (rule.sharpEdges < 2) {
            rule.stays = rule.edges < 3;
        } else if (rule.sharpEdges == 2) {
            const Point before = soup.points[k] - soup.points[at(rule.along[0])];
            const Point after = soup.points[at(rule.along[1])] - soup.points[k];
            rule.stays = angleBetween(before, after) > maxTurn;
        }
    }
}

StepPoints SubdivisionStep::straight(const std::vector<Point>& vertices) const {
    return {vertices, edgeMiddles(edges_, vertices), faceMiddles(soup_, vertices)};
}

StepPoints SubdivisionStep::from(const std::vector<Point>& control) const {
    StepPoints points = straight(control);
    points.vertices = vertexPoints(control, points);
    smoothEdges(points);
    return points;
}

StepPoints SubdivisionStep::through(const std::vector<Point>& vertices) const {
    std::vector<Point> control = vertices;
    StepPoints points = from(control);
    for (int correction = 0; correction < correctionCount; ++correction) {
        for (std::size_t k = 0; k < control.size(); ++k)
            control[k] += correctionFactor * (vertices[k] - points.vertices[k]);
        points = from(control);
    }
    points.vertices = vertices;
    return points;
}

/// \param middles  of edges and faces
std::vector<Point> SubdivisionStep::vertexPoints(const std::vector<Point>& control,
                                                 const StepPoints& middles) const {
    // As many faces as edges meet at a vertex inside a surface.
    std::vector<Point> sums(control.size(), Point(0, 0, 0));
    for (std::size_t face = 0; face < soup_.faceCount(); ++face)
        for (const std::int64_t corner : soup_.face(face))
            sums[at(corner)] += middles.faces[face];
    for (std::size_t k = 0; k < edges_.ends.size(); ++k)
        for (const std::int64_t end : edges_.ends[k])
            sums[at(end)] += 2 * middles.edges[k];
    std::vector<Point> points = control;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const VertexRule& rule = rules_[k];
        if (rule.stays) continue;
        const auto count = static_cast<double>(rule.edges);
        if (rule.sharpEdges == 2)
            points[k] = 0.75 * control[k] + (control[at(rule.along[0])] + control[at(rule.along[1])]) / 8;
        else
            points[k] = (sums[k] / count + (count - 3) * control[k]) / count;
    }
    return points;
}

/// From the middles of edges to the points that the step makes of them.
void SubdivisionStep::smoothEdges(StepPoints& points) const {
    for (std::size_t k = 0; k < points.edges.size(); ++k)
        if (!edges_.isSharp[k]) points.edges[k] /= 2;
    for (std::size_t face = 0; face < soup_.faceCount(); ++face)
        for (std::size_t corner = soup_.faceBegins[face]; corner < soup_.faceBegins[face + 1]; ++corner)
            if (const std::size_t edge = edges_.edgeOf[corner]; !edges_.isSharp[edge])
                points.edges[edge] += points.faces[face] / 4;
}

} // namespace qm
