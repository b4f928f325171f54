# qm-shape: sample meshes.

load helpers.bash

shapes() { qm-shape --list | awk 'NR > 1 { print $1 }'; }

@test "every shape of the list can be made, has the listed size, and is a valid mesh" {
    while read -r name _ quads _; do
        quietly qm-shape "$name" -o mesh.obj
        assert_equal "$(grep -c '^f ' mesh.obj)" "$quads"
        run --separate-stderr qm-basecomplex mesh.obj -o document.json
        assert_success
        assert_equal "$(field .mesh.faces document.json)" "$quads"
    done < <(qm-shape --list | tail -n +2)
}

@test "the same command gives the same bytes" {
    for name in $(shapes); do
        qm-shape "$name" >once
        qm-shape "$name" -o twice
        assert_same_bytes once twice
    done
}

@test "resolution and seed are kept to" {
    qm-shape cube --resolution 3 -o coarse.obj
    assert_equal "$(grep -c '^f ' coarse.obj)" 54
    qm-shape random --seed 1 -o one.obj
    qm-shape random --seed 2 -o two.obj
    run cmp one.obj two.obj
    assert_failure
}

@test "a sheet has a boundary, a ring has none" {
    boundary_edges() {
        awk '/^f/ { for (i = 2; i <= 5; i++) { a = $i; b = i < 5 ? $(i + 1) : $2; n[a < b ? a " " b : b " " a]++ } }
             END { for (edge in n) if (n[edge] == 1) k++; print k + 0 }' "$1"
    }
    assert [ "$(boundary_edges "$(sample plate)")" -gt 0 ]
    assert_equal "$(boundary_edges "$(sample torus)")" 0
}

@test "a shape that there is not is a usage error that says where the list is" {
    run --separate-stderr qm-shape teapot
    assert_failure
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" '^qm-shape: .*teapot'
    assert_regex "$stderr" -- '--list'
    assert_equal "$output" ''
}

@test "neither a name nor --list, or both" {
    misused qm-shape
    misused qm-shape cube --list
}

@test "options out of range" {
    for options in '--resolution -1' '--resolution 1.5' '--resolution 10001' '--voxels 0' '--seed x'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-shape random $options
    done
}

@test "a full disk and a closed pipe are errors" {
    run --separate-stderr bash -c 'qm-shape cube >/dev/full'
    assert_complaint qm-shape
    run --separate-stderr bash -c '{ sleep 0.2; qm-shape cube; echo "status $?" >&2; } | true'
    assert_regex "$stderr" 'status [1-9]'
    complains qm-shape cube -o missing/cube.obj
}
