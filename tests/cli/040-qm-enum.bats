# qm-enum: the cheapest graphs, bounds, and counts.

load helpers.bash

search() { quietly qm-enum "${@:2}" "$(stage basecomplex "$1")" -o out.json; }
cost() { field '.enumeration.subMeshes[0].cost' "${1:-out.json}"; }
# is EXPRESSION: a jq expression about out.json holds.
is() { assert_equal "$(field "$1" out.json)" true; }

@test "a cube has one graph, its edges" {
    search cube --count
    is '.enumeration.count == "1"'
    is '.enumeration.complete'
    is '.enumeration.subMeshes[0].graphs[0].tracks | length == 12'
    # Twelve edges of eight quads' length that turn by a right angle cost -pi/2 each.
    is '(.enumeration.subMeshes[0].cost + 12 * 8 * 1.5707963267948966 | fabs) < 1e-9'
}

@test "the optimum is proved: its bound equals its cost" {
    for model in cube block helix random; do
        search "$model" --require-optimal
        is '.enumeration.subMeshes[0] | .cost == .lowerBound'
        quietly qm-check out.json
    done
}

@test "the best graphs come in order of cost and differ" {
    search block --best 5
    # Rounding may part costs that are equal.
    is '[.enumeration.subMeshes[0].graphs[].cost * 1e9 | round] | length == 5 and . == sort'
    is '.enumeration.subMeshes[0].cost == .enumeration.subMeshes[0].graphs[0].cost'
    is '[.enumeration.subMeshes[0].graphs[].tracks | map(.vertices) | sort] | length == (unique | length)'
    cp out.json five.json
    search block
    is '.enumeration.subMeshes[0].graphs | length == 1'
    assert_equal "$(cost)" "$(cost five.json)"
}

@test "counting, listing and the paper's algorithms agree" {
    search random --count --all graphs.jsonl
    count=$(field .enumeration.count out.json)
    assert_equal "$(wc -l <graphs.jsonl)" "$count"
    assert_equal "$(jq -c '.tracks | map(.vertices | if .[0] > .[-1] then reverse else . end) | sort' graphs.jsonl | sort -u | wc -l)" "$count"
    # The cheapest of all is the optimum.
    assert_equal "$(jq -s 'map(.cost) | min * 1e6 | round' graphs.jsonl)" \
        "$(field '.enumeration.subMeshes[0].cost * 1e6 | round' out.json)"
}

@test "a list that cannot be written is refused before the search" {
    complains qm-enum "$(stage basecomplex cube)" --all all.jsonl --list missing/best.jsonl -o out.json
    assert_regex "$stderr" 'there is no folder missing'
    assert [ ! -e all.jsonl ]
}

@test "the paper's algorithms find the optimum too" {
    # Very small: the naive one tries all positions of all particles.
    qm-shape random-open --voxels 2 --resolution 1 -o small.obj
    qm-basecomplex --quiet small.obj -o small.json
    assert_equal "$(field '.baseComplex.ordinaryJunctions > 0' small.json)" true
    quietly qm-enum small.json -o expected.json
    for method in bounds improved; do
        quietly qm-enum --method $method small.json -o out.json
        assert_equal "$(field '.enumeration.subMeshes[0].cost * 1e6 | round' out.json)" \
            "$(field '.enumeration.subMeshes[0].cost * 1e6 | round' expected.json)"
        assert_equal "$(field .enumeration.method out.json)" $method
    done
    # They count up to a cost as well.
    limit=$(jq -n "$(cost expected.json) + 0.1")
    for method in optimum bounds improved; do
        quietly qm-enum --method $method --count --max-cost "$limit" small.json -o out.json
        is '.enumeration.count == "1"'
    done
    # Trying every vector is for the smallest models only.
    search cube --method naive
    is '.enumeration.count == "1"'
}

@test "T-meshes contain the motorcycle graphs, and go on to segments" {
    for model in block helix random; do
        input=$(stage basecomplex "$model")
        quietly qm-enum --count "$input" -o motorcycle.json
        quietly qm-enum --count --class tmesh --sample 3 "$input" -o out.json
        is '.enumeration.class == "tmesh" and (.enumeration.subMeshes[0].samples | length == 3)'
        is '.enumeration.subMeshes[0] | (.cost - .lowerBound | fabs) < 1e-6'
        assert_equal "$(jq -n "$(cost) <= $(cost motorcycle.json) + 1e-9")" true
        assert_equal "$(jq -n "$(field .enumeration.count out.json) >= $(field .enumeration.count motorcycle.json)")" true
        quietly qm-check out.json
        qm-merge out.json | qm-prune -o layout.json
        quietly qm-check layout.json
    done
}

@test "T-meshes of a cut mesh are refused, and so are the paper's algorithms for them" {
    complains qm-enum --class tmesh "$(stage cut random)"
    misused qm-enum --class tmesh --method improved "$(stage basecomplex cube)"
}

@test "a cost is a sum of terms, and the document is checked against it" {
    input=$(stage basecomplex random)
    for sum in length segments dihedral+0.5*segments 2*length-0.1*segments+dihedral; do
        quietly qm-enum --cost "$sum" --best 3 "$input" -o out.json
        is '.enumeration.subMeshes[0] | (.cost - .lowerBound | fabs) < 1e-6'
        quietly qm-check out.json
        qm-merge out.json -o layout.json
        quietly qm-check layout.json
    done
    # Nothing but segments: their number.
    quietly qm-enum --cost segments "$input" -o out.json
    qm-merge out.json -o layout.json
    is '.enumeration.subMeshes[0].cost | . == floor'
    assert_equal "$(field '.layout.segments | length' layout.json)" "$(field '.enumeration.subMeshes[0].cost' out.json)"
    for sum in area '' '+' dihedral+ 2*dihedral*length x*length; do
        misused qm-enum --cost "$sum" "$input"
    done
}

@test "a cost too large or too small for exact sums is refused, wherever it comes from" {
    input=$(stage basecomplex random)
    for sum in '1e308*length+1e308*length' 1e308*segments -1e308*segments 1e16*length; do
        complains qm-enum --cost="$sum" "$input"
        assert_regex "$stderr" 'more than 1e15'
    done
    complains qm-enum --cost='dihedral+1e-8*length' "$input"
    assert_regex "$stderr" 'by their lengths is below 1e-5'
    complains qm-enum --alpha=-1e308 "$input"
    path=$(jq -c '.baseComplex.separatrices[0].vertices' "$input")
    jq --argjson path "$path" '.constraints = {"weights": [{"vertices": $path, "weight": 1e308}]}' "$input" >weighed.json
    complains qm-enum weighed.json
}

@test "weights of edges under constraints" {
    input=$(stage basecomplex random)
    path=$(jq -c '.baseComplex.separatrices[0].vertices' "$input")
    jq --argjson path "$path" '.constraints = {"weights": [{"vertices": $path, "weight": -100}]}' "$input" >weighed.json
    quietly qm-enum weighed.json -o out.json
    quietly qm-check out.json
    is ".enumeration.subMeshes[0].cost < -100 * ($path | length - 1) + 100"
    quietly qm-enum --cost dihedral weighed.json -o plain.json
    quietly qm-enum "$input" -o out.json
    assert_equal "$(cost plain.json)" "$(cost)"
    jq '.constraints.weights[0].weight = "x"' weighed.json >wrong.json
    complains qm-enum wrong.json
}

@test "the best graphs as a list, in order of cost" {
    input=$(stage basecomplex random)
    quietly qm-enum --all all.jsonl --best 50 --list best.jsonl "$input" -o out.json
    is '.enumeration.subMeshes[0].graphs | length == 1'
    quietly qm-enum --best 50 "$input" -o fifty.json
    assert_equal "$(jq -s 'map(.cost * 1e6 | round)' -c best.jsonl)" \
        "$(field '[.enumeration.subMeshes[0].graphs[].cost * 1e6 | round]' fifty.json | jq -c .)"
    assert_equal "$(jq -s 'map(.cost * 1e6 | round) | sort | .[:50]' -c all.jsonl)" \
        "$(jq -s 'map(.cost * 1e6 | round)' -c best.jsonl)"
    limit=$(jq -s '.[20].cost' best.jsonl)
    quietly qm-enum --count --max-cost "$limit" --all below.jsonl "$input" -o out.json
    assert_equal "$(wc -l <below.jsonl)" "$(field .enumeration.count out.json)"
    assert_equal "$(jq -s "map(select(.cost <= $limit + 1e-7)) | length" all.jsonl)" "$(wc -l <below.jsonl)"
}

@test "the plain motorcycle graph is valid and no cheaper than the optimum" {
    for model in block helix random plate; do
        search "$model"
        best=$(cost)
        search "$model" --method plain
        quietly qm-check out.json
        assert_equal "$(jq -n "$(cost) >= $best - 1e-9")" true
    done
}

@test "only graphs up to a cost" {
    search block --best 100
    limit=$(field '.enumeration.subMeshes[0].graphs[2].cost' out.json)
    search block --best 100 --max-cost "$limit"
    is ".enumeration.subMeshes[0].graphs | length >= 2 and all(.cost <= $limit + 1e-9)"
}

@test "a gap ends the search for one graph before its proof" {
    search random --gap 1e6 --require-complete
    is '.enumeration.complete and (.enumeration.subMeshes[0] | .cost > .lowerBound)'
    misused qm-enum --gap 1 --best 2 "$(stage basecomplex random)"
    search random --gap 1e6 --best 2 --list best.jsonl
    is '.enumeration.subMeshes[0] | .cost > .lowerBound'
    assert_equal "$(wc -l <best.jsonl)" 2
}

@test "the paper's methods refuse thousands of particles" {
    qm-shape random --voxels 4000 --resolution 1 -o many.obj
    qm-basecomplex -q many.obj -o many.json
    for method in naive bounds improved; do
        complains qm-enum --method $method --time-limit 1 many.json -o out.json
        assert_regex "$stderr" 'particles are too many for the paper.s methods'
    done
}

@test "a limit of time ends the search with a warning and status 0, or 3 on request" {
    input=$(stage basecomplex bracket)
    run --separate-stderr qm-enum --time-limit 0 "$input" -o out.json
    assert_success
    assert_regex "$stderr" '^qm-enum: '
    assert_equal "${#stderr_lines[@]}" 1
    is '.enumeration.complete == false'
    is '.enumeration.subMeshes[0] | .cost == null or .lowerBound == null or .lowerBound <= .cost'
    run --separate-stderr qm-enum --time-limit 0 --require-complete "$input" -o out.json
    assert_equal "$status" 3
    # The document is written all the same.
    assert_equal "$(field .kind out.json)" enumeration
    run --separate-stderr qm-enum --require-complete --require-optimal "$(stage basecomplex cube)" -o out.json
    assert_success
}

@test "a requirement that is missed is told, although no limit ended the search" {
    run -3 --separate-stderr qm-enum --max-cost -1e9 --require-optimal "$(stage basecomplex bracket)" -o out.json
    assert_equal "$stderr" "qm-enum: $(stage basecomplex bracket): the best graph of 0 of 1 sub-meshes is proved optimal, and no graph is known of 1"
    is '.enumeration.complete == true'
}

@test "the paper's algorithms too end when told to, and when time is up" {
    input=$(stage basecomplex block)
    for method in naive bounds improved; do
        run --separate-stderr timeout --kill-after=20 1 qm-enum --method $method "$input" -o out.json
        assert [ "$status" != 137 ]
        run --separate-stderr timeout 60 qm-enum --method $method --time-limit 0.1 "$input" -o out.json
        assert_success
        is '.enumeration.complete == false'
    done
}

@test "every graph to standard output needs another place for the document" {
    misused qm-enum --all - "$(stage basecomplex cube)"
    run --separate-stderr qm-enum --all - "$(stage basecomplex cube)" -o out.json
    assert_success
    assert_equal "${#lines[@]}" 1
    echo "$output" | jq -e .tracks >/dev/null
}

@test "sub-meshes are searched one by one, and their counts multiply" {
    quietly qm-enum --count "$(stage cut random)" -o out.json
    is '.enumeration.subMeshes | length == 2'
    is '(.enumeration.count | tonumber) == ([.enumeration.subMeshes[].count | tonumber] | reduce .[] as $n (1; . * $n))'
}

@test "demands: an edge forbidden, an edge required" {
    input=$(stage basecomplex block)
    quietly qm-enum "$input" -o free.json
    # An edge that the best graph uses, in the middle of its longest track ...
    edge=$(jq -c '[.enumeration.subMeshes[0].graphs[0].tracks[].vertices] | max_by(length) | .[(length / 2 | floor) - 1:(length / 2 | floor) + 1]' free.json)
    jq --argjson edge "$edge" '.constraints = {"required": [{"vertices": $edge}]}' "$input" >required.json
    quietly qm-enum required.json -o out.json
    assert_equal "$(cost)" "$(cost free.json)"
    # ... and one of a line that it leaves in part: forbidding what it uses costs something.
    unused=$(jq -c '.enumeration.subMeshes[0].graphs[0].tracks as $tracks
        | [$tracks[].vertices | [.[:-1], .[1:]] | transpose[] | sort] as $used
        | [.baseComplex.separatrices[].vertices | [.[:-1], .[1:]] | transpose[] | sort] - $used | first' free.json)
    assert [ "$unused" != null ]
    jq --argjson edge "$unused" '.constraints = {"required": [{"vertices": $edge}]}' "$input" >required.json
    quietly qm-enum required.json -o out.json
    is "[.enumeration.subMeshes[0].graphs[0].tracks[].vertices | [.[:-1], .[1:]] | transpose[] | sort] | index([$unused]) != null"
    assert_equal "$(jq -n "$(cost) >= $(cost free.json) - 1e-9")" true
    jq --argjson edge "$unused" '.constraints = {"forbidden": [{"vertices": $edge}]}' "$input" >forbidden.json
    quietly qm-enum forbidden.json -o out.json
    assert_equal "$(cost)" "$(cost free.json)"
    quietly qm-check out.json
}

@test "the paper's methods obey demands, and the plain graph is refused if it does not" {
    qm-shape random-open --voxels 2 --resolution 1 -o small.obj
    qm-basecomplex --quiet small.obj -o small.json
    quietly qm-enum --best 2 small.json -o free.json
    # An edge of the second graph alone.
    edge=$(jq -c '[.enumeration.subMeshes[0].graphs[] | [.tracks[].vertices | [.[:-1], .[1:]] | transpose[] | sort]]
        | .[1] - .[0] | first' free.json)
    assert [ "$edge" != null ]
    jq --argjson edge "$edge" '.constraints = {"required": [{"vertices": $edge}]}' small.json >required.json
    for method in optimum naive bounds improved; do
        quietly qm-enum --method $method --best 2 --count required.json -o out.json
        is '.enumeration.count == "1" and (.enumeration.subMeshes[0].graphs | length == 1)'
        assert_equal "$(field '.enumeration.subMeshes[0].cost * 1e6 | round' out.json)" \
            "$(field '.enumeration.subMeshes[0].graphs[1].cost * 1e6 | round' free.json)"
    done
    first=$(jq -c '.baseComplex.separatrices[0].vertices[:2]' small.json)
    jq --argjson edge "$first" '.constraints = {"forbidden": [{"vertices": $edge}]}' small.json >none.json
    complains qm-enum --method plain none.json
    assert_regex "$stderr" '/constraints: the plain motorcycle graph does not obey them'
}

@test "demands that nothing fulfils, and demands that are not on any line" {
    input=$(stage basecomplex cube)
    first=$(jq -c '.baseComplex.separatrices[0].vertices[:2]' "$input")
    jq --argjson edge "$first" '.constraints = {"forbidden": [{"vertices": $edge}]}' "$input" >none.json
    complains qm-enum none.json
    jq '.constraints = {"forbidden": [{"vertices": [0, 5000]}]}' "$input" >nowhere.json
    complains qm-enum nowhere.json
    assert_regex "$stderr" '/constraints/forbidden/0'
}

@test "options out of range" {
    for options in '--best 0' '--best 1000001' '--method best' '--epsilon -1' '--epsilon 4' '--time-limit -1' '--gap -1' '--alpha x'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-enum $options "$(stage basecomplex cube)"
    done
}

@test "parts of a search unite to the bytes of one run" {
    once "$SAMPLES/many.cut.json" bash -c 'qm-shape random --voxels 40 --resolution 3 -o "$1" && qm-basecomplex -q "$1" | qm-cut -q --chi 10' _ "$SAMPLES/many.obj"
    input=$SAMPLES/many.cut.json
    for options in '' '--count --best 2 --sample 1' '--method improved --time-limit 0'; do
        # shellcheck disable=SC2086  # a list of words
        qm-enum -q $options "$input" -o whole.json
        for parts in 1 3 50; do
            files=()
            for ((k = 1; k <= parts; ++k)); do
                # shellcheck disable=SC2086
                qm-enum -q $options --part "$k/$parts" "$input" -o "part.$k.json"
                files+=("part.$k.json")
            done
            ((parts > 1)) || cp part.1.json joined.json
            ((parts == 1)) || qm-enum --join "${files[@]}" -o joined.json
            assert_same_bytes whole.json joined.json
        done
    done
    # In any order, and the first from standard input.
    qm-enum -q "$input" -o whole.json
    qm-enum -q --part 1/2 "$input" -o one.json
    qm-enum -q --part 2/2 "$input" | qm-enum --join - one.json >joined.json
    assert_same_bytes whole.json joined.json
}

# refused TEXT COMMAND...: with this text in the message.
refused() {
    complains "${@:2}"
    assert_regex "$stderr" "$1"
}

@test "a part is no whole, and only the parts of one search are united" {
    input=$SAMPLES/many.cut.json
    qm-enum -q --part 1/2 "$input" -o one.json
    qm-enum -q --part 2/2 "$input" -o two.json
    qm-enum -q --part 2/3 "$input" -o third.json
    qm-enum -q --part 2/2 --best 2 "$input" -o other.json
    refused "/enumeration/part" qm-merge one.json
    refused 'part 2 is missing' qm-enum --join one.json
    refused 'part 1 once more' qm-enum --join one.json two.json one.json
    refused 'is not 2, as before' qm-enum --join one.json third.json
    refused 'another document' qm-enum --join one.json other.json
    refused 'is no part' qm-enum --join "$(stage enumeration block)"
    jq 'del(.enumeration.subMeshes[0])' one.json >fewer.json
    refused 'does not hold sub-mesh 0' qm-enum --join fewer.json two.json
    run -1 qm-check one.json
    for options in '--part 0/2' '--part 3/2' '--part 1' '--part 1/2x' '--part 1/2 --list x' '--join --best 2' '--join --part 1/2' 'one.json'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-enum $options "$input"
    done
}

@test "parts, their mesh and the document are not overwritten by what is made of them" {
    cp "$(sample block)" block.obj
    qm-basecomplex block.obj | qm-cut >cut.json
    for part in 1 2; do qm-enum -q --part $part/2 cut.json -o $part.json; done
    complains qm-enum --join 1.json 2.json -o block.obj
    assert_equal "$stderr" "qm-enum: block.obj: is the mesh that the result refers to. Name another file"
    complains qm-enum --join 1.json 2.json -o ./2.json
    assert_equal "$stderr" "qm-enum: ./2.json: is one of the parts. Name another file"
    assert_same_bytes "$(sample block)" block.obj
    complains qm-enum cut.json --list ./cut.json -o other.json
    assert_equal "$stderr" "qm-enum: ./cut.json: is the input. Name another file"
    misused qm-enum cut.json --list graphs.json -o ./graphs.json
    misused qm-enum cut.json --list graphs.json --all ./graphs.json -o other.json
}
