#include "program/solve_program.h"

#include "base/deadline.h"
#include "base/infinity.h"
#include "program/coin.h"

#include <coin/CbcCompareObjective.hpp>
#include <coin/CbcEventHandler.hpp>
#include <coin/CbcModel.hpp>
#include <coin/CbcSolver.hpp>
#include <coin/CoinPackedMatrix.hpp>
#include <coin/OsiClpSolverInterface.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>

namespace qm {
namespace {

/// Seconds; the solver does not accept infinity.
constexpr double noLimit = 1e9;

class StopHandler : public CbcEventHandler {
public:
    explicit StopHandler(const Control& control) : control_(control) {}
    CbcAction event(CbcEvent) override { return control_.stopRequested() ? stop : noAction; }
    [[nodiscard]] CbcEventHandler* clone() const override { return new StopHandler(*this); }

private:
    const Control& control_;
};

void load(const IntegerProgram& program, OsiClpSolverInterface& solver) {
    std::vector<int> rowOf, columnOf;
    std::vector<double> weights, lower, upper;
    for (const IntegerProgram::Row& row : program.rows) {
        for (std::size_t k = 0; k < row.columns.size(); ++k) {
            rowOf.push_back(static_cast<int>(lower.size()));
            columnOf.push_back(row.columns[k].value());
            weights.push_back(row.weights[k]);
        }
        lower.push_back(coinBound(row.lower));
        upper.push_back(coinBound(row.upper));
    }
    CoinPackedMatrix matrix(true, rowOf.data(), columnOf.data(), weights.data(),
                            static_cast<CoinBigIndex>(weights.size()));
    matrix.setDimensions(static_cast<int>(lower.size()), static_cast<int>(program.costs.size()));
    const std::vector<double> zeros(program.costs.size(), 0), ones(program.costs.size(), 1);
    solver.messageHandler()->setLogLevel(0);
    solver.loadProblem(matrix, zeros.data(), ones.data(), program.costs.data(), lower.data(), upper.data());
    for (const ColumnId column : program.costs.ids())
        solver.setInteger(column.value());
}

/// A lower bound that ignores all rows.
double boundOfColumns(const IntegerProgram& program) {
    return std::accumulate(program.costs.begin(), program.costs.end(), 0.0,
                           [](double sum, double cost) { return sum + std::min(cost, 0.0); });
}

double maxCost(const IntegerProgram& program) {
    return std::accumulate(program.costs.begin(), program.costs.end(), 0.0,
                           [](double sum, double cost) { return sum + std::max(cost, 0.0); });
}

/// Solves the relaxation. CBC would not check the time before it is solved.
/// \return whether it was solved to optimality
bool relax(OsiClpSolverInterface& solver, double seconds, const Control& control) {
    ClpSimplex& simplex = *solver.getModelPtr();
    StopOnRequest handler(control);
    simplex.passInEventHandler(&handler); // copied, as it is to all copies of the solver
    simplex.setMaximumWallSeconds(seconds);
    solver.setHintParam(OsiDoDualInInitial, true);
    solver.resolve();
    simplex.setMaximumWallSeconds(-1);
    return solver.isProvenOptimal();
}

} // namespace

ProgramSolution solveProgram(const IntegerProgram& program, const ColumnValues& start,
                             const ProgramLimits& limits, const Control& control) {
    if (program.costs.empty()) return {ColumnValues{}, 0, true}; // CBC reports no proof for an empty program
    const Deadline end(control, limits.seconds);
    OsiClpSolverInterface solver;
    load(program, solver);
    if (!relax(solver, limits.seconds, control)) return {{}, boundOfColumns(program), false};
    const double relaxed = solver.getObjValue();
    CbcSolverUsefulData settings;
    settings.useSignalHandler_ = false; // what a signal does is decided by whoever made the control
    CbcModel model(solver);
    CbcMain0(model, settings);
    model.setLogLevel(0);
    StopHandler handler(control);
    model.passInEventHandler(&handler);
    if (!start.empty())
        model.setBestSolution(start.data(), static_cast<int>(start.size()), program.cost(start));
    const std::string seconds = std::to_string(std::min(end.secondsLeft(), noLimit));
    const std::string nodes = std::to_string(limits.nodes);
    // Interrupting CBC's own presolve makes it crash.
    const char* arguments[] = {"cbc",  "-log",          "0",         "-timeMode",   "elapsed",
                               "-sec", seconds.c_str(), "-maxNodes", nodes.c_str(), "-preprocess",
                               "off",  "-solve",        "-quit"};
    const auto goOn = [](CbcModel*, int) { return 0; };
    CbcMain1(static_cast<int>(std::size(arguments)), arguments, model, goOn, settings);
    // CBC takes a relaxation that was ended for infeasible, so its proofs and bounds count only without a
    // stop.
    const bool isWhole = !control.stopRequested();
    ProgramSolution solution;
    solution.proven = isWhole && model.isProvenOptimal();
    solution.lowerBound = isWhole ? model.getBestPossibleObjValue() : relaxed;
    if (const double* best = model.bestSolution()) {
        solution.values.emplace(best, best + program.costs.size());
        for (double& value : *solution.values)
            value = std::round(value);
        if (solution.proven) solution.lowerBound = model.getObjValue();
        if (!program.allows(*solution.values)) solution.values.reset();
    }
    return solution;
}

double boundProgram(const IntegerProgram& program, double seconds, const Control& control) {
    constexpr double nothing = -infinity;
    if (program.costs.empty()) return 0;
    const Deadline end(control, seconds);
    OsiClpSolverInterface solver;
    load(program, solver);
    // The time limit may end the first relaxation but no later one: CBC takes a node whose relaxation was not
    // finished for infeasible, and would report a false proof.
    if (!relax(solver, seconds, control)) return nothing;
    // CbcMain1 is not used because it keeps a state in globals; its cuts and heuristics would only cost time
    // in programs this small.
    CbcModel model(solver);
    model.setLogLevel(0);
    model.solver()->setHintParam(OsiDoReducePrint, true);
    StopHandler handler(control);
    model.passInEventHandler(&handler);
    CbcCompareObjective minBoundFirst;
    model.setNodeComparison(minBoundFirst);
    model.setUseElapsedTime(true);
    model.setMaximumSeconds(std::min(end.secondsLeft(), noLimit));
    model.initialSolve();
    if (!model.isInitialSolveProvenOptimal()) return nothing;
    model.branchAndBound();
    if (control.stopRequested()) return nothing;
    const double bound = model.isProvenOptimal() ? model.getObjValue() : model.getBestPossibleObjValue();
    return model.isProvenInfeasible() || bound > maxCost(program) ? nothing : bound;
}

} // namespace qm
