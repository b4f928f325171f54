# qm-features: runs of sharp edges.

load helpers.bash

find_curves() { quietly qm-features "${@:2}" "$(stage basecomplex "$1")" -o out.json; }
curves() { field '.features.curves | length' out.json; }

@test "a shape without long sharp runs far from extraordinary vertices has no curves" {
    find_curves cube
    assert_equal "$(curves)" 0
}

@test "every curve is long enough, sharp everywhere, and has its seed on it" {
    find_curves genus2 --rho 0.3 --tau 8 --zeta 3
    assert [ "$(curves)" -gt 0 ]
    assert_equal "$(field '[.features.curves[] | (.vertices | length) > 8] | all' out.json)" true
    assert_equal "$(field '[.features.curves[] | .seed as $seed | .vertices | index($seed) != null] | all' out.json)" true
    assert_equal "$(field '[.features.curves[].seed] | length == (unique | length)' out.json)" true
    assert_equal "$(field '[.features.curves[].id] == [range(.features.curves | length)]' out.json)" true
    quietly qm-check out.json
}

@test "stricter options never find more edges" {
    edges() { field '[.features.curves[].vertices | length - 1] | add // 0' out.json; }
    find_curves genus2 --rho 0.3 --tau 4 --zeta 1
    most=$(edges)
    for options in '--rho 0.5 --tau 4 --zeta 1' '--rho 0.3 --tau 12 --zeta 1' '--rho 0.3 --tau 4 --zeta 6'; do
        # shellcheck disable=SC2086  # a list of words
        find_curves genus2 $options
        assert [ "$(edges)" -le "$most" ]
    done
}

@test "a closed curve that meets no extraordinary vertex ends infinitely far from any" {
    find_curves genus2 --rho 0.3 --tau 8 --zeta 1000000
    assert_equal "$(field '[.features.curves[] | .vertices[0] == .vertices[-1]] | any' out.json)" true
    # Lines that meet one are separatrices.
    assert_equal "$(field '([.features.curves[].vertices | [.[:-1], .[1:]] | transpose[] | sort] | unique) as $edges
        | ([.baseComplex.separatrices[].vertices | [.[:-1], .[1:]] | transpose[] | sort] | unique) as $lines
        | $edges - $lines == $edges' out.json)" true
}

@test "options are kept in the section and in the history" {
    find_curves block --rho 0.4 --tau 7 --zeta 5
    assert_equal "$(field '.features | [.rho, .tau, .zeta] | join(" ")' out.json)" '0.4 7 5'
    assert_equal "$(field '.history[-1].options | [.rho, .tau, .zeta] | join(" ")' out.json)" '0.4 7 5'
}

@test "curves are at least as long as asked for, in the mesh's unit or per cent of the diagonal" {
    find_curves genus2 --rho 0.3 --tau 2 --zeta 0
    all=$(curves)
    find_curves genus2 --rho 0.3 --tau 2 --zeta 0 --min-length 30%
    long=$(curves)
    assert [ "$long" -lt "$all" ]
    assert [ "$long" -gt 0 ]
    diagonal=$(qm-summary --json out.json | jq .diagonal)
    find_curves genus2 --rho 0.3 --tau 2 --zeta 0 --min-length "$(jq -n "$diagonal * 0.3")"
    assert_equal "$(curves)" "$long"
    # Closed lines meet no extraordinary vertex, so no distance is too great for them.
    find_curves genus2 --rho 0.3 --tau 2 --zeta 0 --min-distance 1000%
    assert_equal "$(curves)" "$all"
}

@test "limits in edges alone are the paper's, without lengths" {
    find_curves genus2 --tau 15 --zeta 30
    assert_equal "$(field '.features | [.minLength, .minDistance, .tau, .zeta] | join(" ")' out.json)" '0% 0% 15 30'
    assert_equal "$(field '.features | .shortRho > 3.14' out.json)" true
    find_curves genus2 --tau 15
    assert_equal "$(field '.features | [.minLength, .minDistance, .tau, .zeta] | join(" ")' out.json)" '0% 1% 15 1'
    find_curves genus2 --tau 15 --min-length 0.5
    assert_equal "$(field '.features | [.minLength, .minDistance] | join(" ")' out.json)" '0.5 1%'
}

@test "lines of a coarse tube are no curves, unless the paper's limits are asked for" {
    qm-shape tube --around 12 -o tube.obj
    qm-basecomplex --quiet tube.obj -o tube.json
    lines() { qm-features "$@" tube.json | jq '.features | "\(.curves | length) \(.maxRoundness)"' -r; }
    assert_equal "$(lines)" '0 0.5'
    assert_equal "$(lines --max-roundness 1)" '12 1'
    assert_equal "$(lines --tau 2)" '12 1'
    assert_equal "$(lines --tau 2 --max-roundness 0.9)" '0 0.9'
}

@test "an angle in degrees is rho" {
    find_curves genus2 --min-angle 30deg
    assert_equal "$(field '.features.rho * 6 * 1000 | round' out.json)" 3142
    cp out.json degrees.json
    find_curves genus2 --min-angle 30
    assert_same_bytes degrees.json out.json
    misused qm-features --min-angle 30deg --rho 0.5 part.json
    misused qm-features --min-angle 200 part.json
    misused qm-features --min-angle 30grad part.json
}

@test "the defaults find the rims of a cylinder, and on real machine parts what the paper's limits do not" {
    find_curves cylinder
    assert_equal "$(curves)" 2
    [[ -d $SHARED_MESHES/dev ]] || skip 'there are no real meshes'
    for part in lever_arm casting mount2; do
        qm-basecomplex --quiet "$SHARED_MESHES/dev/$part.obj" -o part.json
        few=$(qm-features --tau 15 --zeta 30 part.json | jq '.features.curves | length')
        more=$(qm-features part.json | jq '.features.curves | length')
        assert [ "$more" -gt $((2 * few)) ]
    done
}

# A hexagonal bolt's head without its end faces: two quads for each side around, and chamfers at both rims.
bolt_head() {
    awk 'BEGIN {
        split("0.8 1 1 0.8", radius); split("0 0.1 0.6 0.7", height); pi = atan2(0, -1)
        for (j = 1; j <= 4; ++j) for (i = 0; i < 6; ++i) {
            x = radius[j] * cos(i * pi / 3); y = radius[j] * sin(i * pi / 3)
            print "v", x, y, height[j]
            print "v", (x + radius[j] * cos((i + 1) * pi / 3)) / 2, (y + radius[j] * sin((i + 1) * pi / 3)) / 2, height[j]
        }
        for (j = 0; j < 3; ++j) for (i = 0; i < 12; ++i) {
            k = (i + 1) % 12; print "f", 12*j+i+1, 12*j+k+1, 12*j+12+k+1, 12*j+12+i+1
        }
    }'
}

@test "rims and the upright edges that cross them are all borders of patches" {
    bolt_head > bolt.obj
    quadmesh --quiet bolt.obj -o bolt.json
    assert_equal "$(field '.layout.quality.capturedSharpness' bolt.json)" 1
    assert_equal "$(field '.surfaces.patches | length' bolt.json)" 18
}

@test "options out of range" {
    for options in '--min-length -1' '--min-length x%' '--min-distance -1%' '--rho -1' '--rho 4' '--rho nan' '--max-roundness 2' '--max-roundness -0.1' '--short-rho -1' '--short-rho 4' '--tau 0' '--tau 1.5' '--zeta -1' '--tau x' '--rho'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-features $options "$(stage basecomplex block)"
    done
}
