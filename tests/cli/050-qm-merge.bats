# qm-merge: one graph of the whole mesh, and its segments.

load helpers.bash

setup_file() {
    load helpers.bash
    stage layout block >/dev/null
    stage layout random >/dev/null
}

merge() { quietly qm-merge "${@:2}" "$(stage enumeration "$1")" -o out.json; }
is() { assert_equal "$(field "$1" out.json)" true; }

@test "the segments tile the mesh, and qm-check accepts them" {
    for model in cube block random helix plate genus2; do
        merge "$model"
        is '[.layout.segments[].faces[]] | sort == [range(length)]'
        is '([.layout.segments[].faces | length] | add) == .mesh.faces'
        is '[.layout.segments[] | .size[0] * .size[1] == (.faces | length)] | all'
        quietly qm-check out.json
    done
}

@test "components without extraordinary vertices are laid out too" {
    for model in torus tube; do
        merge "$model"
        is '.layout.segments | length >= 1'
        quietly qm-check out.json
    done
}

@test "the cost is the sum over the tracks, and no higher than the plain motorcycle graph's" {
    for model in block random helix; do
        merge "$model"
        is '([.layout.tracks[] | select(.transversal | not) | .cost] | add) - .layout.cost | fabs < 1e-6'
        plain=$(qm-enum --quiet --method plain "$(stage features "$model")" | jq '[.enumeration.subMeshes[].cost] | add')
        is ".layout.cost <= $plain + 1e-6"
    done
}

@test "without a cut the layout is the optimum, and says so" {
    qm-enum --quiet "$(stage features block)" -o enumeration.json
    quietly qm-merge enumeration.json -o out.json
    is '.layout.lowerBound - .layout.cost | fabs < 1e-6'
    is ".layout.cost - $(field '.enumeration.subMeshes[0].cost' enumeration.json) | fabs < 1e-6"
}

@test "a bound never exceeds the cost" {
    for model in block random genus2; do
        merge "$model"
        is '.layout.lowerBound == null or .layout.lowerBound <= .layout.cost + 1e-6'
    done
}

@test "no round at all still gives a valid layout" {
    merge random --max-rounds 0
    quietly qm-check out.json
}

@test "an improved layout is never more expensive, and proven where there is time" {
    for model in block random helix; do
        merge "$model"
        before=$(field .layout.cost out.json)
        merge "$model" --improve 60
        is ".layout.cost <= $before + 1e-9 and .layout.merge.costBefore - $before == 0"
        is '.layout.lowerBound - .layout.cost | fabs < 1e-6'
        is '.layout.quality.gap | fabs < 1e-6'
        optimum=$(qm-enum --quiet "$(stage features "$model")" | jq '.enumeration.subMeshes[0].cost')
        is ".layout.cost - $optimum | fabs < 1e-6"
        quietly qm-check out.json
    done
}

@test "no time to improve still gives a valid layout with a bound" {
    merge random --improve 0.000001
    is '.layout.lowerBound <= .layout.cost'
    quietly qm-check out.json
}

@test "options out of range" {
    for options in '--max-rounds -1' '--max-rounds x' '--max-rounds 1.5' '--max-rounds' '--improve -1' '--improve x'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-merge $options "$(stage enumeration block)"
    done
}

# A torus whose lines wind around it many times, with holes of one quad.
helical() {
    awk -v n=100 -v shift=37 -v holes=30 '
        function at(i, j) {
            if (j == n) { j = 0; i += shift }
            return 1 + (i % n) * n + j
        }
        BEGIN {
            for (i = 0; i < n; ++i)
                for (j = 0; j < n; ++j) {
                    u = 6.283185 * (i + shift * j / n) / n
                    v = 6.283185 * j / n
                    print "v", (3 + cos(v)) * cos(u), (3 + cos(v)) * sin(u), sin(v)
                }
            for (h = 0; h < holes; ++h)
                hole[(h * 37 + int(h * h / 3)) % n, (h * 61 + 5) % n] = 1
            for (i = 0; i < n; ++i)
                for (j = 0; j < n; ++j)
                    if (!((i, j) in hole)) print "f", at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
        }'
}

# Harder than can be proven in seconds.
hard() {
    once "$SAMPLES/hard.obj" helical
    once "$SAMPLES/hard.json" bash -c 'qm-basecomplex -q "$1" | qm-cut --chi 20 | qm-enum -q --time-limit 5' _ "$SAMPLES/hard.obj"
    echo "$SAMPLES/hard.json"
}

@test "an improvement that is interrupted is written, and says so" {
    input=$(hard)
    for signal in INT TERM; do
        # timeout sends its signal to the tool and once more to its group.
        run -3 --separate-stderr timeout --preserve-status -s "$signal" 4 qm-merge --improve 600 "$input" -o "$signal.json"
        assert_regex "$stderr" 'interrupted'
        quietly qm-check "$signal.json"
    done
}

@test "a limit of time ends all searches with a valid graph, a warning and status 0" {
    input=$(hard)
    for options in '' '--improve 600'; do
        # shellcheck disable=SC2086  # a list of words
        run -0 --separate-stderr qm-merge --time-limit 0 $options "$input" -o out.json
        assert_equal "$stderr" "qm-merge: $input: a limit ended the search; there may be cheaper layouts"
        is '.layout.merge.windows == 0'
        quietly qm-check out.json
    done
    # Where it ends nothing, nothing is said.
    quietly qm-merge --time-limit 0 "$(stage enumeration cube)" -o out.json
}

@test "what is known is said every few seconds" {
    input=$(hard)
    run -0 --separate-stderr qm-merge --improve 5 "$input" -o out.json
    assert_regex "$stderr" 'qm-merge: cost -?[0-9.]+, (no bound yet|at least -?[0-9.]+, gap [0-9.]+)'
    run -0 --separate-stderr qm-merge --quiet --improve 4 "$input" -o out.json
    assert_equal "$stderr" ''
}

@test "a cost with segments is improved without a bound of the edges' cost" {
    for cost in segments dihedral+0.5*segments; do
        quietly qm-enum --cost "$cost" "$(stage cut cube)" -o cube.json
        quietly qm-merge --improve 0.5 cube.json -o improved.json
        quietly qm-check improved.json
        assert_equal "$(field .layout.lowerBound improved.json)" null
    done
}

@test "a cost with segments holds where tracks end on the mesh boundary past a cut" {
    qm-shape random-open --seed 4 -o open.obj
    qm-basecomplex -q open.obj | qm-cut --chi 5 >open.cut.json
    quietly qm-enum --cost dihedral+0.5*segments open.cut.json -o open.enumeration.json
    quietly qm-check open.enumeration.json
    quietly qm-merge open.enumeration.json -o out.json
    quietly qm-check out.json
    jq '.enumeration.subMeshes[0].graphs[0].cost += 0.25' open.enumeration.json >wrong.json
    complains qm-merge wrong.json
    run -1 qm-check wrong.json
}

@test "a T-mesh is not improved, which is said" {
    quietly qm-enum --class tmesh "$(stage basecomplex helix)" -o tmesh.json
    captured qm-merge --improve 1 tmesh.json -o out.json
    assert_success
    assert_equal "$stderr" "qm-merge: tmesh.json: class tmesh is not improved"
    quietly qm-check out.json
}

@test "a bound above the cost of its graph is refused" {
    quietly qm-enum "$(stage basecomplex cube)" -o whole.json
    jq '.enumeration.subMeshes[0].lowerBound += 1' whole.json >edited.json
    complains qm-merge edited.json -o out.json
    assert_regex "$stderr" '/enumeration/subMeshes/0/lowerBound: is above the cost of the first graph'
}
