# qm-bspline: a surface through every segment, and how far it is from the mesh.

load helpers.bash

setup_file() {
    load helpers.bash
    stage pruned block >/dev/null
}

fit() { quietly qm-bspline --quiet "${@:2}" "$(stage pruned "$1")" -o out.json; }
is() { assert_equal "$(field "$1" out.json)" true; }

@test "interpolation: one patch per segment, with as many control points as it needs" {
    for model in block plate torus; do
        fit "$model" --fit interpolate
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
    fit torus
    is '.surfaces.deviation | .max >= .percentile95 and .max >= .rms and .rms >= 0 and .max > 0'
    is '([.surfaces.patches[].deviation.max] | max) - .surfaces.deviation.max | fabs < 1e-9'
}

@test "flat faces are met exactly" {
    fit cube
    is '.surfaces.deviation.maxRelative <= 1e-5' # what is as small is not measured any closer
    # Every face has a coordinate that all of its control points share.
    is '[.surfaces.patches[].controlPoints | add | transpose | any((max - min) < 1e-13)] | all'
}

@test "smooth borders are smooth, and there are no gaps" {
    for model in block torus bracket; do
        fit "$model" --tolerance 0.5%
        is '.surfaces.deviation | .largestGapRelative <= 1e-12 and .largestNormalAngle <= 1e-6'
        quietly qm-check out.json -o verdict
    done
}

@test "creases are listed, and nothing is a crease that is no path of edges" {
    fit cylinder
    is '.surfaces.creases | length == 2 and all(.vertices[0] == .vertices[-1])'
    fit torus
    is '.surfaces.creases == []'
    fit cylinder
    jq '.surfaces.creases[0].vertices[1] = 999999' out.json >edited.json
    complains qm-export edited.json -o part.step
    assert_regex "$stderr" '/surfaces/creases/0/vertices/1'
    jq 'del(.surfaces.creases[0])' out.json >edited.json
    run qm-check edited.json
    assert_failure
    assert_output --partial 'largestNormalAngle'
}

@test "a tolerance is kept, and a looser one takes no more control points" {
    control_points() { field '[.surfaces.patches[].controlPoints | length * (.[0] | length)] | add' out.json; }
    fit torus --tolerance 0.1%
    is '.surfaces.deviation.maxRelative <= 0.001'
    quietly qm-check out.json -o verdict
    strict=$(control_points)
    fit torus --tolerance 1%
    is '.surfaces.deviation.maxRelative <= 0.01'
    assert [ "$(control_points)" -le "$strict" ]
}

@test "a tight tolerance is kept around the bends of a mesh of few quads" {
    qm-shape random --voxels 5 --resolution 2 -o coarse.obj
    qm-basecomplex -q coarse.obj | qm-features -q | qm-cut -q | qm-enum -q | qm-merge -q | qm-prune -q >coarse.json
    quietly qm-bspline --tolerance 0.03% coarse.json -o out.json
    is '.surfaces.deviation.maxRelative <= 0.0003'
    quietly qm-check out.json -o verdict
}

@test "a tolerance is a length, or with % a share of the diagonal; the document says which" {
    fit torus --tolerance 0.1%
    is '.history[-1].options.tolerance == "0.1%"'
    fit torus --tolerance 0.05
    is '.history[-1].options.tolerance == 0.05 and .surfaces.deviation.max <= 0.05'
}

@test "a fit that is interrupted is written, whole, and says so" {
    for signal in INT TERM; do
        # The tolerance cannot be kept, which is tried for half a minute; timeout sends its signal to the tool and to its group.
        run -3 --separate-stderr timeout --preserve-status -s "$signal" 1 \
            qm-bspline --tolerance 1e-5 "$(stage pruned genus3)" -o "$signal.json"
        assert_regex "$stderr" 'interrupted'
        quietly qm-check "$signal.json"
    done
}

@test "a limit of time ends the fit with the best so far, which is told" {
    run -3 --separate-stderr qm-bspline --tolerance 1e-5 --time-limit 0 "$(stage pruned genus3)" -o out.json
    assert_regex "${stderr_lines[0]}" '^qm-bspline: .*: a limit ended the fit; with more time it may be closer$'
    assert_regex "$stderr" 'the tolerance is missed'
    quietly qm-check out.json
    quietly qm-bspline --time-limit 1e6 "$(stage pruned cube)" -o out.json
    misused qm-bspline --fit interpolate --time-limit 1 "$(stage pruned cube)"
}

@test "a tolerance that cannot be kept is told with its place, and the exit status" {
    run -3 --separate-stderr qm-bspline --tolerance 1e-12 "$(stage pruned bracket)" -o out.json
    assert_regex "$stderr" 'tolerance is missed in patch [0-9]+ at u = .*times as far'
    quietly qm-check out.json -o verdict
}

@test "gaps that a STEP reader would see are told, with how large they are" {
    run -0 --separate-stderr qm-bspline --fit interpolate "$(stage pruned block)" -o out.json
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" '^qm-bspline: patches are up to [0-9.]+ apart, and STEP joins what is nearer than 1e-07\. .*--fit smooth'
    quietly qm-bspline --fit interpolate "$(stage pruned cube)" -o out.json
    is '.surfaces.deviation.largestGap <= 1e-7'
}

@test "vertices that are left because their quads are folded are told" {
    # A plate one vertex of which lies beyond its neighbours.
    {
        for j in {0..8}; do for i in {0..8}; do
            if ((i == 4 && j == 4)); then echo "v 5.6 4.3 0.8"; else echo "v $i $j 0"; fi
        done; done
        for j in {0..7}; do for i in {0..7}; do
            echo "f $((9 * j + i + 1)) $((9 * j + i + 2)) $((9 * j + i + 11)) $((9 * j + i + 10))"
        done; done
    } >plate.obj
    quietly qm-basecomplex -q plate.obj -o plate.json
    quietly qm-enum plate.json -o plate.enum.json
    quietly qm-merge plate.enum.json -o plate.layout.json
    run -0 --separate-stderr qm-bspline plate.layout.json -o out.json
    assert_equal "$stderr" "qm-bspline: folded or nearly folded quads are bridged: a vertex is 0.8 away from the surfaces, in patch 0. If they should pass through it, unfold the quads there"
    quietly qm-summary out.json
    assert_line --regexp '^vertices +up to 0.8 mm away where quads fold or nearly fold, patch 0$'
    quietly qm-summary --json out.json
    jq -e '.surfaces.bridged == {distance: .surfaces.bridged.distance, patch: 0} and .surfaces.bridged.distance > 0.79' <<<"$output"
    run -0 --separate-stderr qm-bspline --fit interpolate plate.layout.json -o out.json
    refute_regex "$stderr" bridged
}

@test "patches that may fold are told, with how often and where" {
    run -0 --separate-stderr qm-bspline --tolerance 0.5% "$(stage pruned bracket)" -o out.json
    folds=$(field .surfaces.deviation.folds out.json)
    [[ $folds == 0 ]] || assert_regex "$stderr" "^qm-bspline: $folds pieces? of patches may fold over, [0-9]+ of them in patch [0-9]+ at \\([-0-9e., ]+\\)\\. "
    is "(.surfaces.foldPlaces // [] | length) == $folds"
    quietly qm-bspline --tolerance 0.5% "$(stage pruned block)" -o out.json
    is '.surfaces.deviation.folds == 0'
}

@test "options that have no effect are wrong" {
    misused qm-bspline --fit interpolate --tolerance 1% "$(stage pruned block)"
    misused qm-bspline --fit interpolate --reference scan.stl "$(stage pruned block)"
}

@test "options out of range" {
    for options in '--fit loosely' '--tolerance -1' '--tolerance x' '--tolerance 0%' '--tolerance 1%%' '--rho 4'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-bspline $options "$(stage pruned block)"
    done
}

@test "--rank writes the layout whose surfaces take the fewest control points" {
    control_points() { field '[.surfaces.patches[].controlPoints | length * (.[0] | length)] | add' "$1"; }
    for beta in 0.5 4; do
        quietly qm-prune --quiet --method optimum --beta $beta "$(stage layout bracket)" -o beta.$beta.json
        quietly qm-bspline --quiet beta.$beta.json -o alone.$beta.json
    done
    quietly qm-bspline --quiet --rank beta.0.5.json beta.4.json -o out.json
    is '[.surfaces.ranking[].path] | sort == ["beta.0.5.json", "beta.4.json"]'
    is '.surfaces.ranking | all(.keepsTolerance) and .[0].controlPoints <= .[1].controlPoints'
    is '.surfaces.ranking[0].segments == (.surfaces.patches | length)'
    is ".surfaces.ranking[0].controlPoints == $(control_points out.json)"
    best=$(field '.surfaces.ranking[0].path' out.json)
    # The same surfaces as of that layout alone.
    field .surfaces.patches "alone.${best#beta.}" >expected
    field .surfaces.patches out.json >actual
    quietly cmp expected actual
    quietly qm-check out.json -o verdict
}

@test "--rank compares layouts of one mesh, and nothing but --rank takes several" {
    complains qm-bspline --rank "$(stage pruned block)" "$(stage pruned torus)" -o out.json
    assert_regex "$stderr" 'is of another mesh than'
    complains qm-bspline --rank "$(stage pruned block)" - -o out.json <"$(stage pruned torus)"
    assert_regex "$stderr" 'standard input: /mesh/sha256: is of another mesh than'
    misused qm-bspline "$(stage pruned block)" "$(stage pruned block)" -o out.json
    assert_regex "$stderr" 'several layouts are for --rank to choose from'
    misused qm-bspline --fit interpolate --rank "$(stage pruned block)" -o out.json
    assert_regex "$stderr" 'rank has no effect without --fit smooth'
    assert [ ! -e out.json ]
}

# A box 35 x 40 x 500 whose quads grow 1.8 times from row to row: along the first direction from one end, along the
# third from both.
graded_box() {
    awk 'function v(i, j, k,   key) {
        key = i "," j "," k
        if (!(key in number)) { number[key] = ++count; print "v", x[i], y[j], z[k] }
        return number[key]
    }
    function f(a, b, c, d) { print "f", a, b, c, d }
    BEGIN {
        OFMT = CONVFMT = "%.12g"
        for (i = 0; i <= 10; ++i) x[i] = 35 * (1.8 ^ i - 1) / (1.8 ^ 10 - 1)
        for (j = 0; j <= 6; ++j) y[j] = 40 * j / 6
        for (k = 0; k <= 12; ++k) {
            z[k] = 250 * (1.8 ^ k - 1) / (1.8 ^ 12 - 1)
            z[24 - k] = 500 - z[k]
        }
        for (i = 0; i < 10; ++i) for (j = 0; j < 6; ++j) {
            f(v(i, j, 0), v(i, j + 1, 0), v(i + 1, j + 1, 0), v(i + 1, j, 0))
            f(v(i, j, 24), v(i + 1, j, 24), v(i + 1, j + 1, 24), v(i, j + 1, 24))
        }
        for (j = 0; j < 6; ++j) for (k = 0; k < 24; ++k) {
            f(v(0, j, k), v(0, j, k + 1), v(0, j + 1, k + 1), v(0, j + 1, k))
            f(v(10, j, k), v(10, j + 1, k), v(10, j + 1, k + 1), v(10, j, k + 1))
        }
        for (i = 0; i < 10; ++i) for (k = 0; k < 24; ++k) {
            f(v(i, 0, k), v(i + 1, 0, k), v(i + 1, 0, k + 1), v(i, 0, k + 1))
            f(v(i, 6, k), v(i, 6, k + 1), v(i + 1, 6, k + 1), v(i + 1, 6, k))
        }
    }'
}

@test "a box stays plane where its quads are narrower than the tolerance" {
    graded_box > box.obj
    quadmesh --quiet box.obj --tolerance 0.5 -o box.json
    assert_equal "$(field '.surfaces.deviation | .folds == 0 and .max < 0.01 and .largestNormalDeviation < 0.001' box.json)" true
}
