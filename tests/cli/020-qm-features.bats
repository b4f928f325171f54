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

@test "options out of range" {
    for options in '--rho -1' '--rho 4' '--rho nan' '--tau 0' '--tau 1.5' '--zeta -1' '--tau x' '--rho'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-features $options "$(stage basecomplex block)"
    done
}
