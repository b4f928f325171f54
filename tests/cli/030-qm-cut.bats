# qm-cut: sub-meshes of bounded complexity.

load helpers.bash

cut_mesh() { quietly qm-cut "${@:2}" "$(stage features "$1")" -o out.json; }
parts() { field '.cut.subMeshes | length' out.json; }

@test "every vertex has a label, every label a sub-mesh, and every sub-mesh vertices" {
    for model in block helix plate; do
        cut_mesh "$model" --chi 20
        assert_equal "$(field '(.cut.labels | length) == .mesh.vertices' out.json)" true
        assert_equal "$(field '(.cut.labels | unique) == [range(.cut.subMeshes | length)]' out.json)" true
        assert_equal "$(field '[.cut.subMeshes[].id] == [range(.cut.subMeshes | length)]' out.json)" true
        quietly qm-check out.json
    done
}

@test "sub-meshes are simpler than chi" {
    cut_mesh block --chi 20
    assert [ "$(parts)" -gt 1 ]
    assert_equal "$(field '[.cut.subMeshes[].quasiComplexity < 20] | all' out.json)" true
}

@test "a chi that nothing reaches leaves one sub-mesh" {
    cut_mesh block --chi 1000000
    assert_equal "$(parts)" 1
    assert_equal "$(field '.cut.labels | add' out.json)" 0
}

@test "a smaller chi never gives fewer sub-meshes" {
    before=1
    for chi in 1000 60 40 20 10; do
        cut_mesh block --chi $chi
        assert [ "$(parts)" -ge "$before" ]
        before=$(parts)
    done
}

@test "a mesh without extraordinary vertices is left whole" {
    cut_mesh torus --chi 20
    assert_equal "$(parts)" 1
}

@test "all ways to choose terminals" {
    for terminals in irregular farthest box; do
        cut_mesh block --chi 20 --terminals $terminals
        assert_equal "$(field .cut.terminals out.json)" "$terminals"
        quietly qm-check out.json
    done
}

@test "cuts that avoid features" {
    cut_mesh genus2 --chi 20 --avoid-features
    assert_equal "$(field '.history[-1].options.avoidFeatures' out.json)" true
    quietly qm-check out.json
}

@test "options out of range" {
    for options in '--chi -3' '--chi nan' '--chi x' '--terminals nowhere' '--lambda -1'; do
        # shellcheck disable=SC2086  # a list of words
        misused qm-cut $options "$(stage features block)"
    done
}
