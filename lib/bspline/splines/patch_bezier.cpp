#include "bspline/splines/patch_bezier.h"

#include "base/at.h"
#include "bspline/splines/basis.h"
#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace qm {
namespace {

using Row = std::array<double, 2 * maxDegree + 1>;

/// "degree over k" for k from 0 to degree.
Row binomials(int degree) {
    Row row{};
    row[0] = 1;
    for (int k = 1; k <= degree; ++k)
        row[at(k)] = row[at(k - 1)] * (degree - k + 1) / k;
    return row;
}

/// Every point times the binomials of its place: products of polynomials are then sums of products.
std::vector<Eigen::Vector3d> scaled(const BezierPiece& piece) {
    const Row u = binomials(piece.degree[0]);
    const Row v = binomials(piece.degree[1]);
    std::vector<Eigen::Vector3d> points = piece.points;
    std::size_t k = 0;
    for (int j = 0; j <= piece.degree[1]; ++j)
        for (int i = 0; i <= piece.degree[0]; ++i)
            points[k++] *= u[at(i)] * v[at(j)];
    return points;
}

/// Bernstein's polynomials of a degree and their derivatives.
void bernstein(int degree, double t, Row& value, Row& derivative) {
    value[0] = 1;
    derivative[0] = 0;
    for (int d = 1; d <= degree; ++d) {
        if (d == degree) {
            derivative[0] = -degree * value[0];
            for (int i = 1; i < degree; ++i)
                derivative[at(i)] = degree * (value[at(i - 1)] - value[at(i)]);
            derivative[at(degree)] = degree * value[at(degree - 1)];
        }
        value[at(d)] = t * value[at(d - 1)];
        for (int i = d - 1; i > 0; --i)
            value[at(i)] = t * value[at(i - 1)] + (1 - t) * value[at(i)];
        value[0] *= 1 - t;
    }
}

/// Restricts a row of points, `stride` apart, to [from, to].
void restrictRow(Eigen::Vector3d* points, std::size_t stride, int degree, double from, double to) {
    if (to < 1)
        for (int level = 1; level <= degree; ++level)
            for (int i = degree; i >= level; --i)
                points[at(i) * stride] = (1 - to) * points[at(i - 1) * stride] + to * points[at(i) * stride];
    const double begin = to > 0 ? from / to : 0;
    if (begin > 0)
        for (int level = 1; level <= degree; ++level)
            for (int i = 0; i + level <= degree; ++i)
                points[at(i) * stride] =
                    (1 - begin) * points[at(i) * stride] + begin * points[at(i + 1) * stride];
}

std::vector<double> knotsOf(const Patch& patch, std::size_t direction) {
    return differentKnots(patch.knots[direction], patch.degree[direction]);
}

} // namespace

void BezierPieces::get(std::size_t i, std::size_t j, BezierPiece& piece) const {
    const BezierExtraction& u = along[0];
    const BezierExtraction& v = along[1];
    const std::span<const double> weightsU = u.of(i);
    const std::span<const double> weightsV = v.of(j);
    const std::size_t columns = at(u.degree) + 1;
    const std::size_t rows = at(v.degree) + 1;
    piece.degree = {u.degree, v.degree};
    piece.points.assign(columns * rows, Eigen::Vector3d::Zero());
    std::array<Eigen::Vector3d, maxDegree + 1> onRow;
    const double* weightU = nullptr;
    for (std::size_t r = 0; r < at(v.controls); ++r) {
        const Point* control = controls.data() + (v.first[j] + r) * width + u.first[i];
        weightU = weightsU.data();
        for (std::size_t column = 0; column < columns; ++column) {
            onRow[column] = *weightU++ * vector(control[0]);
            for (std::size_t c = 1; c < at(u.controls); ++c)
                onRow[column] += *weightU++ * vector(control[c]);
        }
        for (std::size_t row = 0; row < rows; ++row) {
            const double weight = weightsV[row * at(v.controls) + r];
            for (std::size_t column = 0; column < columns; ++column)
                piece.points[row * columns + column] += weight * onRow[column];
        }
    }
}

BezierPieces bezierPieces(const Patch& patch) {
    return bezierPieces(patch, {knotsOf(patch, 0), knotsOf(patch, 1)}, patch.degree);
}

BezierPieces bezierPieces(const Patch& patch, const std::array<std::vector<double>, 2>& breaks,
                          const std::array<int, 2>& elevatedTo) {
    BezierPieces pieces;
    for (std::size_t k = 0; k < 2; ++k)
        pieces.along[k] = splineExtraction(patch.knots[k], patch.degree[k], breaks[k], elevatedTo[k]);
    pieces.controls = patch.controlPoints;
    pieces.width = at(patch.count[0]);
    return pieces;
}

std::array<std::vector<double>, 2> knotsAndGridLines(const Patch& patch) {
    constexpr double apart = 1e-9;
    const auto areNear = [](double x, double y) { return y - x < apart; };
    std::array<std::vector<double>, 2> result;
    for (std::size_t k = 0; k < 2; ++k) {
        const std::vector<double> knots = knotsOf(patch, k);
        const std::vector<double> lines = gridLines(static_cast<int>(std::lround(knots.back())));
        std::ranges::merge(knots, lines, std::back_inserter(result[k]));
        result[k].erase(std::unique(result[k].begin(), result[k].end(), areNear), result[k].end());
    }
    return result;
}

std::array<PatchPiece, 4> quarters(const PatchPiece& whole) {
    constexpr std::array begins{0.0, 0.5};
    const Parameters middle = middleOf(whole.box);
    std::array<PatchPiece, 4> parts;
    for (const std::size_t u : {0U, 1U})
        for (const std::size_t v : {0U, 1U}) {
            PatchPiece& part = parts[2 * u + v];
            restrict(whole.piece, {begins[u], begins[v]}, {begins[u] + 0.5, begins[v] + 0.5}, part.piece);
            part.box = whole.box;
            part.box[0][1 - u] = middle[0];
            part.box[1][1 - v] = middle[1];
        }
    return parts;
}

double farthestFrom(const Eigen::Vector3d& place, const BezierPiece& piece) {
    double square = 0;
    for (const Eigen::Vector3d& point : piece.points)
        square = std::max(square, (point - place).squaredNorm());
    return std::sqrt(square);
}

void restrict(const BezierPiece& piece, const std::array<double, 2>& from, const std::array<double, 2>& to,
              BezierPiece& result) {
    result = piece;
    const std::size_t columns = at(piece.degree[0]) + 1;
    for (std::size_t row = 0; row <= at(piece.degree[1]); ++row)
        restrictRow(&result.points[row * columns], 1, piece.degree[0], from[0], to[0]);
    for (std::size_t column = 0; column < columns; ++column)
        restrictRow(&result.points[column], columns, piece.degree[1], from[1], to[1]);
}

PiecePoint evaluate(const BezierPiece& piece, double u, double v) {
    Row valueU;
    Row valueV;
    Row slopeU;
    Row slopeV;
    bernstein(piece.degree[0], u, valueU, slopeU);
    bernstein(piece.degree[1], v, valueV, slopeV);
    PiecePoint result{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    const Eigen::Vector3d* point = piece.points.data();
    for (int j = 0; j <= piece.degree[1]; ++j) {
        Eigen::Vector3d onRow = Eigen::Vector3d::Zero();
        Eigen::Vector3d slope = Eigen::Vector3d::Zero();
        for (int i = 0; i <= piece.degree[0]; ++i, ++point) {
            onRow += valueU[at(i)] * *point;
            slope += slopeU[at(i)] * *point;
        }
        result.position += valueV[at(j)] * onRow;
        result.du += valueV[at(j)] * slope;
        result.dv += slopeV[at(j)] * onRow;
    }
    return result;
}

BezierPiece derivative(const BezierPiece& piece, std::size_t direction) {
    BezierPiece result;
    result.degree = piece.degree;
    --result.degree[direction];
    const int stepI = direction == 0 ? 1 : 0;
    result.points.reserve(piece.points.size());
    for (int j = 0; j <= result.degree[1]; ++j)
        for (int i = 0; i <= result.degree[0]; ++i)
            result.points.emplace_back(piece.degree[direction] *
                                       (piece.at(i + stepI, j + 1 - stepI) - piece.at(i, j)));
    return result;
}

BezierPiece normalPiece(const BezierPiece& piece) {
    const BezierPiece du = derivative(piece, 0);
    const BezierPiece dv = derivative(piece, 1);
    const auto left = scaled(du);
    const auto right = scaled(dv);
    BezierPiece normal;
    normal.degree = {2 * piece.degree[0] - 1, 2 * piece.degree[1] - 1};
    const std::size_t columns = at(normal.degree[0]) + 1;
    const std::size_t rows = at(normal.degree[1]) + 1;
    const std::size_t leftColumns = at(du.degree[0]) + 1;
    const std::size_t rightColumns = at(dv.degree[0]) + 1;
    normal.points.assign(columns * rows, Eigen::Vector3d::Zero());
    for (std::size_t a = 0; a < left.size(); ++a)
        for (std::size_t b = 0; b < right.size(); ++b) {
            const std::size_t row = a / leftColumns + b / rightColumns;
            const std::size_t column = a % leftColumns + b % rightColumns;
            normal.points[row * columns + column] += left[a].cross(right[b]);
        }
    const Row u = binomials(normal.degree[0]);
    const Row v = binomials(normal.degree[1]);
    for (std::size_t k = 0; k < normal.points.size(); ++k)
        normal.points[k] /= u[k % columns] * v[k / columns];
    return normal;
}

} // namespace qm
