/// \file How closely and how long is fitted.
#pragma once

namespace qm {

struct SmoothFitOptions {
    double tolerance = 0;     ///< largest distance from the reference, in its unit; positive
    double flatness = 0;      ///< a reference no farther than this from a plane makes a plane patch
    int steps = 4;            ///< lattice points per mesh edge: 1, 2 or 4
    double minInterval = 0;   ///< shortest knot interval, in tolerances; see `MinInterval` as well
    int unfoldings = 6;       ///< how often folded patches begin anew with more knots
    double evenBorders = 1;   ///< first error of borders at even vertices, in tolerances; see `minError`
    int maxRounds = 30;       ///< largest number of rounds, each with a factorisation
    int maxIdle = 12;         ///< a search ends after so many rounds without a better result
    int roundsOfMending = 8;  ///< largest number of rounds for mending what a verification has found
    int slides = 6;           ///< solutions per round, between which the targets slide
    double slack = 0.25;      ///< in tolerances: surfaces may be farther by this if that makes them fairer
    int ringsAround = 2;      ///< rings of patches around those that change that are solved for with them
    double worthAll = 0.6;    ///< if more than this share of the control points is free, all are solved for
    bool removesKnots = true; ///< tries to do with fewer knots once the tolerance is kept
    int verifications = 5;    ///< largest number of verifications per attempt
    bool restarts = true;     ///< begins anew where a verification fails, at most three times
};

} // namespace qm
