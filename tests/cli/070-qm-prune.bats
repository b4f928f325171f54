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
        prune "$model" --eta -3 --max-turn 180
        assert_equal "$(field '.layout.segments | length' out.json)" "$rough"
        prune "$model" --eta -3 --max-turn 0
        assert [ "$(field '.layout.segments | length' out.json)" -ge "$rough" ]
    done
}

@test "pruning what is pruned removes nothing more" {
    prune block
    cp out.json pruned.json
    quietly qm-prune pruned.json -o out.json
    assert_equal "$(field '.layout.segments | length' out.json)" "$(field '.layout.segments | length' pruned.json)"
}

@test "options out of range" {
    for options in '--eta x' '--eta nan' '--max-turn -1' '--max-turn 181' '--max-turn'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-prune $options "$(stage layout block)"
    done
}
