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

@test "round shapes have as many quads around as asked for" {
    qm-shape tube --around 30 -o tube.obj
    assert_equal "$(awk '$1 == "v" && $4 == 0' tube.obj | wc -l)" 30
    qm-shape cylinder --around 30 -o cylinder.obj
    assert_equal "$(awk '$1 == "v" && $4 == 0 && $2 ^ 2 + $3 ^ 2 > 0.999' cylinder.obj | wc -l)" 30
    complains qm-shape block --around 30
    complains qm-shape sphere --around 31
}

@test "all formats hold the same mesh" {
    for format in obj off ply; do
        qm-shape bracket --format $format >by-option
        qm-shape bracket -o by-name.$format
        assert_same_bytes by-option by-name.$format
        qm-basecomplex by-name.$format -o $format.json
        assert_equal "$(jq -c .baseComplex $format.json)" "$(jq -c .baseComplex obj.json)"
    done
}

@test "a scan has about as many triangles as asked for, and the noise of its seed" {
    qm-shape block --scan 20000 -o clean.obj
    faces=$(grep -c '^f ' clean.obj)
    assert [ "$faces" -gt 18000 ] && assert [ "$faces" -lt 22000 ]
    assert_equal "$(grep '^f ' clean.obj | awk 'NF != 4' | wc -l)" 0
    qm-shape block --scan 20000 --noise 0.05% -o noisy.obj
    qm-shape block --scan 20000 --noise 0.05% --seed 1 -o same.obj
    qm-shape block --scan 20000 --noise 0.05% --seed 2 -o other.obj
    assert_same_bytes noisy.obj same.obj
    run cmp noisy.obj other.obj
    assert_failure
    # The points of a sphere are away from it by what was asked for: 0.1% of the diagonal, or a length.
    spread() { awk '$1 == "v" { d = sqrt($2 ^ 2 + $3 ^ 2 + $4 ^ 2) - 1; s += d * d; n++ } END { printf "%.4f", sqrt(s / n) }'; }
    assert_equal "$(qm-shape sphere --scan 100000 --noise 0.1% | spread)" 0.0035
    assert_equal "$(qm-shape sphere --scan 100000 --noise 0.02 | spread | cut -c 1-4)" 0.02
}

@test "noise beyond what a file can hold is refused" {
    for ending in stl obj; do
        complains qm-shape cube --scan 100 --noise 1e308 -o far.$ending
        assert_regex "$stderr" 'noise: is more than'
        assert [ ! -e far.$ending ]
    done
}

@test "a scan as STL has the size that its number of facets says" {
    qm-shape torus --scan 5000 -o scan.stl
    facets=$(($(od -An -t u4 -j 80 -N 4 scan.stl)))
    assert_equal "$(wc -c <scan.stl)" $((84 + 50 * facets))
    assert_equal "$facets" "$(qm-shape torus --scan 5000 | grep -c '^f ')"
}

@test "what belongs to scans and what does not" {
    misused qm-shape cube --noise 0.1%
    misused qm-shape cube --format stl
    misused qm-shape cube -o cube.stl
    misused qm-shape cube --scan 100 --resolution 3
    misused qm-shape sphere --scan 100 --around 8
    misused qm-shape sphere --resolution 3 --around 8
    misused qm-shape cube --scan 100 --noise 0
    misused qm-shape cube --seed 2
    misused qm-shape cube --scan 100 --seed 2
    misused qm-shape cube --voxels 2
    misused qm-shape --list --format off
    misused qm-shape cube --scan 20000001
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
