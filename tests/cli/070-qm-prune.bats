# qm-prune: boundaries that follow nothing are removed.

load helpers.bash

setup_file() {
    load helpers.bash
    stage layout block >/dev/null
}

prune() { quietly qm-prune "${@:2}" "$(stage layout "$1")" -o out.json; }
is() { assert_equal "$(field "$1" out.json)" true; }

@test "segments never become more, every quad stays in one, and qm-check accepts" {
    for model in block bracket genus2 random plate; do
        before=$(field '.layout.segments | length' "$(stage layout "$model")")
        prune "$model"
        is ".layout.segments | length <= $before"
        is '([.layout.segments[].faces[]] | sort) == [range(.mesh.faces)]'
        quietly qm-check out.json
    done
}

@test "flat tracks go, and the figures say how many" {
    prune block
    is '.layout.prune.removedTracks > 0'
    before=$(field '.layout.segments | length' "$(stage layout block)")
    is ".layout.segments | length < $before"
}

@test "a limit that no track exceeds removes nothing" {
    prune block --eta 1e9
    is '.layout.prune.removedTracks == 0'
    assert_equal "$(field '.layout.tracks | length' out.json)" "$(field '.layout.tracks | length' "$(stage layout block)")"
}

@test "the smoothness criterion only ever keeps tracks" {
    for model in block genus2; do
        prune "$model" --eta -3 --no-smooth
        rough=$(field '.layout.segments | length' out.json)
        prune "$model" --eta -3 --max-turn 180 --min-corner 0
        assert_equal "$(field '.layout.segments | length' out.json)" "$rough"
        prune "$model" --eta -3 --max-turn 0
        assert [ "$(field '.layout.segments | length' out.json)" -ge "$rough" ]
    done
}

@test "tracks go on from corners of sharp edges, unless --max-sharp-turn allows any turn, and qm-check accepts" {
    prune random --max-sharp-turn 180
    is '.layout.prune.addedTracks == 0 and .history[-1].options.maxSharpTurn == 180'
    for model in random bracket; do
        prune "$model" --max-sharp-turn 0
        is '.history[-1].options.maxSharpTurn == 0'
        quietly qm-check out.json
    done
}

# A flat square frame of two rings of twelve quads, without extraordinary vertices.
write_frame() {
    awk 'BEGIN {
        for (ring = 0; ring < 3; ++ring)
            for (k = 0; k < 12; ++k) {
                along = (k % 3 * 2 / 3 - 1) * (1 - .3 * ring); out = 1 - .3 * ring; side = int(k / 3)
                x = side == 0 ? along : side == 1 ? out : side == 2 ? -along : -out
                y = side == 0 ? -out : side == 1 ? along : side == 2 ? out : -along
                print "v", x, y, 0
            }
        for (ring = 0; ring < 2; ++ring)
            for (k = 0; k < 12; ++k) {
                next_one = (k + 1) % 12; first = 12 * ring + 1
                print "f", first + k, first + next_one, first + 12 + next_one, first + 12 + k
            }
    }'
}

@test "corners of an outline become corners of segments, and qm-check accepts" {
    write_frame >frame.obj
    qm-basecomplex -q frame.obj | qm-features -q | qm-cut -q | qm-enum -q | qm-merge -q >frame.json
    quietly qm-prune frame.json -o out.json
    # Four corners, and the one line somewhere that makes the ring a segment.
    is '.layout.segments | length == 5'
    quietly qm-check out.json
    quietly qm-prune --method optimum frame.json -o out.json
    is '.layout.segments | length == 5'
    is '.layout.prune.proven'
    quietly qm-check out.json
    quietly qm-prune --max-sharp-turn 180 frame.json -o out.json
    is '.layout.segments | length == 1'
}

@test "pruning what is pruned removes nothing more" {
    prune block
    cp out.json pruned.json
    quietly qm-prune pruned.json -o out.json
    assert_equal "$(field '.layout.segments | length' out.json)" "$(field '.layout.segments | length' pruned.json)"
}

objective() { field ".layout.cost + $1 * (.layout.segments | length)" "$2"; }

@test "the optimum beats greedy removal, is proven, and qm-check accepts it" {
    for model in block bracket random; do
        prune "$model" --eta -1e9 --no-smooth
        greedy=$(objective 1 out.json)
        prune "$model" --method optimum --no-smooth
        is ".layout.cost + (.layout.segments | length) <= $greedy + 1e-6"
        is '.layout.prune.proven'
        is '.layout.prune.objectiveBound <= .layout.cost + (.layout.segments | length) + 1e-6'
        quietly qm-check out.json
        quietly qm-bspline --quiet --fit interpolate out.json -o surfaces.json
        quietly qm-check surfaces.json
    done
}

@test "the smoothness criterion can only make the optimum more expensive" {
    prune random --method optimum --no-smooth
    rough=$(objective 1 out.json)
    prune random --method optimum --max-turn 1
    is ".layout.cost + (.layout.segments | length) >= $rough - 1e-6"
    quietly qm-check out.json
}

@test "corners may be left without room only where that is asked for" {
    prune random --method optimum --max-turn 180 --min-corner 0
    rough=$(objective 1 out.json)
    prune random --method optimum --max-turn 180 --min-corner 90
    is ".layout.cost + (.layout.segments | length) >= $rough - 1e-6"
    is '.history[-1].options.minCorner == 90'
    quietly qm-check out.json
}

@test "a higher price of segments leaves fewer, and their number can be limited" {
    prune random --method optimum --no-smooth --beta 0
    many=$(field '.layout.segments | length' out.json)
    prune random --method optimum --no-smooth --beta 50
    few=$(field '.layout.segments | length' out.json)
    assert [ "$few" -lt "$many" ]
    prune random --method optimum --no-smooth --max-segments "$few"
    is ".layout.segments | length <= $few"
    run -1 --separate-stderr qm-prune --method optimum --no-smooth --max-segments 1 "$(stage layout random)"
    assert_equal "${#stderr_lines[@]}" 1
}

@test "on the front no layout is as good as another in everything" {
    prune random --front --no-smooth
    is '.layout.prune.front | length >= 1'
    is '.layout.prune.front | [range(length) as $j | range(length) as $k | select($j != $k) | [.[$j], .[$k]]
        | .[0].segments <= .[1].segments and .[0].cost <= .[1].cost and .[0].capturedSharpness >= .[1].capturedSharpness]
        | any | not'
    quietly qm-check out.json
    prune random --no-smooth
    is '.layout.prune.front == []'
}

@test "every layout of a front says what is proven of it, and the front keeps to the time limit" {
    prune random --front --no-smooth --method optimum
    is '.layout.prune.front | map(.proven and (.objectiveBound - .cost - .beta * .segments | fabs) < 1e-6) | all'
    run -0 --separate-stderr qm-prune --front --no-smooth --verbose "$(stage layout random)" -o out.json
    assert_equal "$(grep -c 'front: beta .* proven$' <<<"$stderr")" "$(field '.layout.prune.front | length' out.json)"
    SECONDS=0
    run -0 --separate-stderr qm-prune --front --method optimum --time-limit 0 "$(stage layout block)" -o out.json
    assert [ "$SECONDS" -lt 10 ]
    is '.layout.prune | .proven or (.front | map(.proven) | all) | not'
    assert_regex "$stderr" 'the search was ended early'
    quietly qm-check out.json
}

@test "feature curves are pruned to the optimum at every price" {
    qm-basecomplex "$(sample random)" | qm-features --rho 0.3 --tau 3 --zeta 0 | qm-enum | qm-merge -o curves.json
    assert [ "$(field '.features.curves | length' curves.json)" -gt 2 ]
    for beta in 0 0.1 1 10 1e3; do
        quietly qm-prune --method optimum --no-smooth --beta "$beta" curves.json -o out.json
        best=$(objective "$beta" out.json)
        is ".layout.prune.proven and ($best - .layout.prune.objectiveBound | fabs) < 1e-6"
        quietly qm-check out.json
        quietly qm-prune --no-smooth --eta "-$beta" curves.json -o out.json
        is ".layout.cost + $beta * (.layout.segments | length) >= $best - 1e-6"
    done
}

@test "the fewest patches are no more than any price leaves, and the cheapest of so few" {
    for model in block random; do
        prune "$model" --method optimum --no-smooth --fewest-patches
        is '.layout.prune.proven and .layout.prune.objectiveBound == (.layout.segments | length)'
        quietly qm-check out.json
        fewest=$(field '.layout.segments | length' out.json)
        cost=$(field '.layout.cost' out.json)
        prune "$model" --method optimum --no-smooth --beta 1e4
        is "(.layout.segments | length) == $fewest and (.layout.cost - $cost | fabs) < 1e-6"
    done
    misused qm-prune --method optimum --fewest-patches --max-segments 5 "$(stage layout block)"
}

@test "without time for a proof, each piece of a mesh has a patch all the same" {
    captured qm-prune --method optimum --fewest-patches --time-limit 0 "$(stage layout torus)" -o out.json
    assert_success
    is '.layout.prune.objectiveBound == 1 and (.layout.segments | length) == 1'
    captured qm-prune --method optimum --fewest-patches --time-limit 0 "$(stage layout block)" -o out.json
    assert_success
    is '.layout.prune.objectiveBound == 1 and (.layout.prune.proven | not)'
    assert_regex "$stderr" 'the layout is at most [0-9]+ above the best$'
}

@test "what is required stays, and a layout that does not obey is refused" {
    layout=$(stage layout block)
    quietly qm-prune --eta -100 --no-smooth "$layout" -o bold.json
    gone=$(jq -c --slurpfile bold bold.json '[$bold[0].layout.tracks[].vertices] as $kept
        | [.layout.tracks[].vertices | select(. as $path | $kept | index([$path]) | not)] | first' "$layout")
    assert [ "$gone" != null ]
    jq --argjson path "$gone" '.constraints = {"required": [{"vertices": $path}]}' "$layout" >required.json
    for options in '--eta -100 --no-smooth' '--method optimum --beta 100 --no-smooth'; do
        # shellcheck disable=SC2086  # a list of words
        quietly qm-prune $options required.json -o out.json
        quietly qm-check out.json
    done
    jq --argjson path "$gone" '.constraints = {"forbidden": [{"vertices": $path}]}' "$layout" >forbidden.json
    complains qm-prune forbidden.json
    assert_regex "$stderr" '/constraints: the layout does not obey them'
}

@test "options of the smoothness criterion are wrong without it" {
    for option in max-turn min-corner max-sharp-turn; do
        misused qm-prune --no-smooth "--$option" 30 "$(stage layout block)"
        assert_regex "$stderr" "$option has no effect without the smoothness criterion"
    done
}

@test "options out of range" {
    for options in '--eta x' '--eta nan' '--max-turn -1' '--max-turn 181' '--max-turn' '--max-sharp-turn -1' '--max-sharp-turn 181' '--beta -1' '--beta 1e300' '--max-segments -1' '--method best' '--time-limit x'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-prune $options "$(stage layout block)"
    done
}
