# qm-bspline: a surface through every segment, and how far it is from the mesh.

load helpers.bash

setup_file() {
    load helpers.bash
    stage pruned block >/dev/null
}

fit() { quietly qm-bspline "${@:2}" "$(stage pruned "$1")" -o out.json; }
is() { assert_equal "$(field "$1" out.json)" true; }

@test "one patch per segment, with as many control points as interpolation needs" {
    for model in block plate torus; do
        fit "$model"
        is '[.surfaces.patches[].segment] == [.layout.segments[].id]'
        # An a x b grid has a + 1 by b + 1 vertices, and two more control points each way.
        is '[.layout.segments[].size | [.[0] + 3, .[1] + 3]]
            == [.surfaces.patches[].controlPoints | [(.[0] | length), length]]'
        is '[.surfaces.patches[] | (.knots[0] | length) == (.controlPoints[0] | length) + 4
            and (.knots[1] | length) == (.controlPoints | length) + 4] | all'
        quietly qm-check out.json
    done
}

@test "the deviation is measured, between the vertices too" {
    fit block
    is '.surfaces.deviation | .max >= .percentile95 and .max >= .rms and .rms >= 0 and .max > 0'
    is '([.surfaces.patches[].deviation.max] | max) - .surfaces.deviation.max | fabs < 1e-9'
}

@test "flat faces are met exactly" {
    fit cube
    is '.surfaces.deviation.maxRelative < 1e-6'
}

@test "shared borders leave no gaps" {
    fit block --watertight
    is '.surfaces.deviation.largestGap <= 1e-9'
    quietly qm-check out.json
}

@test "a tolerance is kept, and a looser one takes no more control points" {
    control_points() { field '[.surfaces.patches[].controlPoints[] | length] | add' out.json; }
    fit block --fit tolerance --tolerance 0.2%
    is '.surfaces.deviation.maxRelative <= 0.002'
    quietly qm-check out.json -o verdict
    strict=$(control_points)
    fit block --fit tolerance --tolerance 2%
    is '.surfaces.deviation.maxRelative <= 0.02'
    assert [ "$(control_points)" -le "$strict" ]
}

@test "neighbours meet more smoothly, for as many control points as the budget allows" {
    control_points() { field '[.surfaces.patches[].controlPoints[] | length] | add' out.json; }
    model=torus
    fit "$model" --fit tolerance --tolerance 0.5% --max-kink 180
    rough=$(field .surfaces.deviation.rmsKink out.json)
    fewest=$(control_points)
    fit "$model" --fit tolerance --tolerance 0.5% --max-kink 0.5 --kink-budget 0
    assert [ "$(control_points)" -le "$fewest" ]
    fit "$model" --fit tolerance --tolerance 0.5% --max-kink 0.5 --kink-budget 2
    assert [ "$(control_points)" -gt "$fewest" ]
    is ".surfaces.deviation.rmsKink < 0.7 * $rough and .surfaces.deviation.maxRelative <= 0.005"
    is '.history[-1].options | .maxKink == 0.5 and .kinkBudget == 2'
    quietly qm-check out.json -o verdict
}

@test "a tolerance is a length, or with % a share of the diagonal; the document says which" {
    fit block --fit tolerance --tolerance 0.1%
    is '.history[-1].options.tolerance == "0.1%"'
    fit block --fit tolerance --tolerance 0.05
    is '.history[-1].options.tolerance == 0.05 and .surfaces.deviation.max <= 0.05'
    quietly qm-check out.json -o verdict
}

@test "options out of range" {
    for options in '--fit loosely' '--tolerance -1' '--tolerance x' '--tolerance 0%' '--tolerance 1%%' '--rho 4' '--samples-per-edge 0' \
        '--max-kink -1' '--max-kink 181' '--kink-budget -1' '--kink-budget x'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-bspline $options "$(stage pruned block)"
    done
}
