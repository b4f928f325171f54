# qm-basecomplex: from a mesh to the first document.

load helpers.bash

# counts FILE: faces, extraordinary vertices, separatrices, ordinary junctions.
counts() {
    field '[.mesh.faces, (.baseComplex.extraordinaryVertices, .baseComplex.separatrices | length), .baseComplex.ordinaryJunctions] | join(" ")' "$1"
}

# A flat sheet of 3 x 2 quads, in three formats.
write_sheets() {
    cat >sheet.obj <<'END'
v 0 0 0
v 1 0 0
v 2 0 0
v 3 0 0
v 0 1 0
v 1 1 0
v 2 1 0
v 3 1 0
v 0 2 0
v 1 2 0
v 2 2 0
v 3 2 0
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 5 6 10 9
f 6 7 11 10
f 7 8 12 11
END
    {
        printf 'OFF\n12 6 0\n'
        sed -n 's/^v //p' sheet.obj
        awk '/^f/ { print 4, $2 - 1, $3 - 1, $4 - 1, $5 - 1 }' sheet.obj
    } >sheet.off
    {
        printf 'ply\nformat ascii 1.0\nelement vertex 12\nproperty double x\nproperty double y\nproperty double z\n'
        printf 'element face 6\nproperty list uchar int vertex_indices\nend_header\n'
        sed -n '3,$p' sheet.off
    } >sheet.ply
}

@test "a cube: eight extraordinary vertices, twelve lines walked from both ends" {
    quietly qm-basecomplex --quiet "$(sample cube)" -o out.json
    assert_equal "$(counts out.json)" "384 8 24 0"
    # Every separatrix has an opposite, which is the same path backwards.
    assert_equal "$(field '.baseComplex.separatrices as $s | [$s[] | . as $a
        | ($a.vertices | reverse) == $s[$a.opposite].vertices and $s[$a.opposite].opposite == $a.id] | all' out.json)" true
}

@test "surfaces without extraordinary vertices have an empty base complex" {
    for model in torus tube; do
        quietly qm-basecomplex --quiet "$(sample $model)" -o out.json
        assert_equal "$(field '.baseComplex | tojson' out.json)" \
            '{"extraordinaryVertices":[],"ordinaryJunctions":0,"separatrices":[]}'
    done
}

@test "lines that end at the boundary have no opposite" {
    quietly qm-basecomplex --quiet "$(sample plate)" -o out.json
    assert_equal "$(field '[.baseComplex.separatrices[] | .opposite == null] | any' out.json)" true
}

@test "lines that wind around the model cross themselves or each other many times" {
    quietly qm-basecomplex --quiet "$(sample helix)" -o out.json
    run field .baseComplex.ordinaryJunctions out.json
    assert [ "$output" -gt 20 ]
}

@test "OBJ, OFF and PLY of one mesh give the same base complex" {
    write_sheets
    for format in obj off ply; do
        quietly qm-basecomplex --quiet "sheet.$format" -o "$format.json"
        jq 'del(.mesh.path, .mesh.sha256)' "$format.json" >"$format.stripped"
    done
    assert_same_bytes obj.stripped off.stripped
    assert_same_bytes obj.stripped ply.stripped
}

@test "the document names the mesh and pins it" {
    write_sheets
    quietly qm-basecomplex --quiet sheet.obj -o out.json
    assert_equal "$(field .mesh.path out.json)" sheet.obj
    assert_equal "$(field .mesh.sha256 out.json)" "$(sha256sum sheet.obj | cut -d' ' -f1)"
    assert_equal "$(field '.mesh.vertices, .mesh.faces' out.json | xargs)" '12 6'
}

@test "lines of any ending, comments, texture and normal indices, negative indices" {
    write_sheets
    quietly qm-basecomplex --quiet sheet.obj -o expected.json
    sed 's/$/\r/' sheet.obj >dos.obj
    sed -E '/^f/ s/ ([0-9]+)/ \1\/1\/1/g; 1i # a comment\nvt 0 0\nvn 0 0 1' sheet.obj >slashes.obj
    awk '/^f/ { print "f", $2 - 13, $3 - 13, $4 - 13, $5 - 13; next } { print }' sheet.obj >negative.obj
    for variant in dos slashes negative; do
        quietly qm-basecomplex --quiet $variant.obj -o $variant.json
        assert_equal "$(field '.baseComplex | tojson' $variant.json)" "$(field '.baseComplex | tojson' expected.json)"
    done
}

@test "faces that are not four-sided" {
    write_sheets
    echo 'f 9 10 11' >>sheet.obj
    complains qm-basecomplex sheet.obj -o out.json
    assert_regex "$stderr" '^qm-basecomplex: sheet.obj: face 6 \(line 19\): it has 3 sides'
    assert [ ! -e out.json ]
}

@test "faces that name vertices that are not there, or twice" {
    write_sheets
    echo 'f 9 10 11 99' >>sheet.obj
    complains qm-basecomplex sheet.obj
    assert_regex "$stderr" 'line 19'
    write_sheets
    echo 'f 9 10 10 11' >>sheet.obj
    complains qm-basecomplex sheet.obj
    assert_regex "$stderr" 'twice'
}

@test "coordinates that are no numbers" {
    for text in nan inf 1e999 x; do
        write_sheets
        sed -i "2s/.*/v $text 0 0/" sheet.obj
        complains qm-basecomplex sheet.obj
        assert_regex "$stderr" 'line 2'
    done
}

@test "three faces at an edge" {
    write_sheets
    printf 'v 1 1 1\nv 2 1 1\nf 6 7 14 13\n' >>sheet.obj
    complains qm-basecomplex sheet.obj
    assert_regex "$stderr" 'edge between vertices 5 and 6: 3 faces'
}

@test "faces that are turned over, and --repair" {
    write_sheets
    sed -i 's/^f 2 3 7 6/f 6 7 3 2/' sheet.obj
    complains qm-basecomplex sheet.obj
    assert_regex "$stderr" -- '--repair'
    run --separate-stderr qm-basecomplex --repair sheet.obj -o out.json
    assert_success
    assert_equal "$(field .mesh.faces out.json)" 6
    # The repaired mesh is a file beside the document, and the pipe goes on from it.
    assert_equal "$(field .mesh.path out.json)" sheet.repaired.obj
    quietly qm-features out.json
    quietly qm-basecomplex --quiet sheet.repaired.obj
    run --separate-stderr qm-basecomplex -q --repair sheet.obj -o sheet.repaired.obj
    assert_complaint qm-basecomplex
    assert_regex "$(head -n 1 sheet.repaired.obj)" "^v "
}

@test "a soup of quads, and --repair" {
    awk '/^v/ { v[++n] = $0 } /^f/ { for (i = 2; i <= 5; i++) { print v[$i]; k++ } print "f", k - 3, k - 2, k - 1, k }' \
        "$(sample cube)" >soup.obj
    run --separate-stderr qm-basecomplex soup.obj -o soup.json
    assert_success
    assert_regex "$stderr" -- '--repair'
    run --separate-stderr qm-basecomplex --repair soup.obj -o welded.json
    assert_success
    assert_equal "$(counts welded.json)" "384 8 24 0"
}

@test "no mesh at all" {
    complains qm-basecomplex /dev/null
    echo hello >hello.obj
    complains qm-basecomplex hello.obj
    seq 20000 | gzip -n >garbage.obj
    complains qm-basecomplex garbage.obj
    cp garbage.obj garbage.ply
    complains qm-basecomplex garbage.ply
    cp garbage.obj garbage.off
    complains qm-basecomplex garbage.off
}

@test "counts that promise more than the file holds take no memory" {
    bash -c "ulimit -v 2000000; qm-basecomplex --version" &>/dev/null || skip "a sanitizer takes all addresses"
    printf 'OFF\n2000000000 2000000000 0\n' >huge.off
    printf 'ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n' >huge.ply
    for file in huge.off huge.ply; do
        run --separate-stderr bash -c "ulimit -v 2000000; qm-basecomplex $file"
        assert_complaint qm-basecomplex
        refute_regex "$stderr" 'out of memory'
    done
}

@test "real meshes that are not valid, where they are at hand" {
    [[ -d $SHARED_MESHES/bad ]] || skip "there are none"
    for mesh in "$SHARED_MESHES"/bad/*.{obj,off,ply}; do
        [[ -e $mesh ]] || continue
        echo "# $mesh" >&2
        complains qm-basecomplex "$mesh" -o out.json
        assert [ ! -e out.json ]
        run ls -A
        assert_output ''
    done
}

@test "an open mesh is told with the lengths of its loops" {
    run --separate-stderr qm-basecomplex "$(sample plate)"
    assert_success
    assert_regex "$stderr" ': the mesh is open: 2 boundary loops, 16 long \(at vertex [0-9]+\), 1\.[0-9]+ long \(at vertex [0-9]+\)\. '
}

@test "vertices where several fans meet are named, and split with --repair" {
    printf 'v %s\n' '0 0 0' '1 0 0' '1 1 0' '0 1 0' '2 1 0' '2 2 0' '1 2 0' >fans.obj
    printf 'f %s\n' '1 2 3 4' '3 5 6 7' >>fans.obj
    complains qm-basecomplex fans.obj
    assert_regex "$stderr" 'vertex 2 \(line 3\): the faces around it fall into several fans.* --repair splits'
    run --separate-stderr qm-basecomplex --repair fans.obj -o fans.json
    assert_success
    assert_regex "$stderr" '1 vertex split\. The mesh is now fans.repaired.obj'
    assert_equal "$(field .mesh.vertices fans.json)" 8
}

@test "--stats tells the tool's own seconds from those of its input" {
    run --separate-stderr bash -c "{ sleep 1; cat '$(sample cube)'; } | qm-basecomplex --stats >/dev/null"
    assert_success
    jq -e '.seconds < 0.9 and .inputSeconds > 0.9' <<<"$stderr"
}
