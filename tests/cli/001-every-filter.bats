# What holds for all tools of the pipe that read a document and write a document.

load helpers.bash

setup_file() {
    load helpers.bash
    stage surfaces block >/dev/null
}

for_every_filter() {
    local tool
    for tool in "${FILTERS[@]}"; do
        echo "# $tool" >&2
        "$1" "$tool"
    done
}

# ------------------------------------------------------------------------------------------- bad input

@test "empty input" {
    local tool
    for tool in "${FILTERS[@]}"; do
        complains "$tool" /dev/null
        complains "$tool" </dev/null
        complains "$tool" - </dev/null
    done
}

@test "a file that is not there" {
    for tool in "${FILTERS[@]}"; do
        complains "$tool" no-such-file.json
        assert_regex "$stderr" "^$tool: no-such-file.json: "
    done
}

@test "a folder" {
    mkdir folder
    for tool in "${FILTERS[@]}"; do
        complains "$tool" folder
    done
}

@test "random bytes" {
    # The same on every machine.
    seq 20000 | gzip -n >garbage
    for tool in "${FILTERS[@]}"; do
        complains "$tool" garbage
        assert_regex "$stderr" "^$tool: garbage: "
    done
}

@test "text that is not JSON" {
    for text in 'v 0 0 0' '{' '{"kind": "layout",' '[1, 2' '{"a": 1} {"b": 2}' $'{"kind": "lay\x80out"}' '{"kind": layout}'; do
        echo "$text" >text
        for tool in "${FILTERS[@]}"; do
            complains "$tool" text
        done
    done
}

@test "JSON that is no document" {
    for text in '{}' '[]' 'null' '1e999' '"layout"' '{"kind": 3}' '{"kind": "layout"}' '{"kind": "spoon", "version": 1}' \
        '{"kind": "layout", "version": 1}' '{"kind": "layout", "version": 99}' '{"kind": "basecomplex", "version": 1, "mesh": {}}'; do
        echo "$text" >text
        for tool in "${FILTERS[@]}"; do
            complains "$tool" text
        done
    done
}

@test "brackets nested without end" {
    { printf '{"x":'; head -c 1000000 /dev/zero | tr '\0' '['; } >nested
    for tool in "${FILTERS[@]}"; do
        captured timeout 20 "$tool" nested
        assert_complaint "$tool"
    done
}

@test "a document cut off anywhere" {
    for tool in "${FILTERS[@]}"; do
        input=$(input_of "$tool" block)
        size=$(stat -c %s "$input")
        for share in 1 10 50 90; do
            head -c $((size * share / 100)) "$input" >short
            complains "$tool" short
        done
        head -c $((size - 3)) "$input" >short
        complains "$tool" short
    done
}

@test "a document of too early a kind" {
    complains qm-merge "$(stage cut block)"
    assert_regex "$stderr" 'qm-enum'
    complains qm-prune "$(stage enumeration block)"
    assert_regex "$stderr" 'qm-merge'
    complains qm-bspline "$(stage enumeration block)"
    assert_regex "$stderr" 'qm-merge'
}

@test "a mesh where a document is due" {
    for tool in "${FILTERS[@]}"; do
        complains "$tool" "$(sample block)"
    done
}

# ------------------------------------------------------------------------------------------- streams

@test "standard input, - and a file give the same" {
    for tool in "${FILTERS[@]}"; do
        input=$(input_of "$tool" block)
        quietly "$tool" "$input" -o by-name
        "$tool" <"$input" >by-default
        "$tool" - <"$input" >by-dash
        "$tool" "$input" -o - >to-dash
        # shellcheck disable=SC2002  # a pipe cannot be read twice or sought
        cat "$input" | "$tool" >by-pipe
        for file in by-default by-dash to-dash by-pipe; do
            assert_same_bytes by-name "$file"
        done
    done
}

@test "a terminal as standard input is refused, not waited for" {
    timeout 20 script --quiet --return --command true /dev/null </dev/null || skip "no terminal can be made here"
    for tool in qm-basecomplex "${FILTERS[@]}"; do
        run timeout 20 script --quiet --return --command "$tool" /dev/null
        assert_equal "$status" 2
        assert_output --partial "$tool: "
        assert_output --partial 'terminal'
    done
}

@test "progress is for terminals only" {
    for tool in "${FILTERS[@]}"; do
        quietly "$tool" "$(input_of "$tool" block)" -o /dev/null
    done
}

@test "a full disk is an error" {
    for tool in "${FILTERS[@]}"; do
        input=$(input_of "$tool" block)
        captured bash -c "$tool '$input' >/dev/full"
        assert_complaint "$tool"
    done
}

@test "a closed pipe is not silence" {
    for tool in "${FILTERS[@]}"; do
        input=$(input_of "$tool" block)
        # The reader is gone before the first byte is written.
        captured bash -c "{ sleep 0.2; $tool '$input'; echo \"status \$?\" >&2; } | true"
        assert_regex "$stderr" 'status [1-9]'
        refute_regex "$stderr" 'terminate called'
    done
}

@test "a closed standard output is an error" {
    for tool in "${FILTERS[@]}"; do
        captured bash -c "$tool '$(input_of "$tool" block)' >&-"
        assert_failure
    done
}

# ------------------------------------------------------------------------------------------- output files

@test "-o writes the whole file or nothing" {
    for tool in "${FILTERS[@]}"; do
        echo 'as it was' >output
        complains "$tool" /dev/null -o output
        assert_equal "$(cat output)" 'as it was'
        rm output
        complains "$tool" /dev/null -o output
        # Nothing else either: no temporary file is left behind.
        run ls -A
        assert_output ''
    done
}

@test "-o into a folder that is not there" {
    for tool in "${FILTERS[@]}"; do
        complains "$tool" "$(input_of "$tool" block)" -o missing/output
        assert_regex "$stderr" 'missing'
    done
}

@test "-o may name the input" {
    for tool in "${FILTERS[@]}"; do
        input=$(input_of "$tool" block)
        quietly "$tool" "$input" -o expected
        cp "$input" same
        quietly "$tool" same -o same
        assert_same_bytes same expected
    done
}

@test "an interrupted run leaves no file" {
    # The tool waits for input that never ends, and is then interrupted.
    for tool in qm-basecomplex "${FILTERS[@]}"; do
        for signal in INT TERM; do
            mkfifo pipe
            # Background jobs ignore SIGINT unless they are told otherwise.
            bash -c "set -m; trap - INT; exec $tool - -o output" <pipe 2>message &
            tool_pid=$!
            exec 9>pipe
            printf '{' >&9
            sleep 0.2
            kill -s "$signal" "$tool_pid"
            run wait "$tool_pid"
            exec 9>&-
            rm -f pipe message
            run ls -A
            assert_output ''
        done
    done
}

# ------------------------------------------------------------------------------------------- documents

@test "--schema is a schema of draft 7, and --stats one line of JSON" {
    for tool in qm-basecomplex "${FILTERS[@]}"; do
        quietly "$tool" --schema
        echo "$output" | jq -e '."$schema" | test("draft-07")' >/dev/null
        captured "$tool" --stats "$(input_of "$tool" block)" -o /dev/null
        assert_success
        assert_equal "${#stderr_lines[@]}" 1
        echo "$stderr" | jq -e 'type == "object"' >/dev/null
    done
}

@test "every document says its kind, and history grows by one" {
    before=$(stage basecomplex block)
    for tool in "${FILTERS[@]}"; do
        input=$(input_of "$tool" block)
        quietly "$tool" "$input" -o output
        assert_equal "$(field .kind output)" "$(kind_of "$tool")"
        assert_equal "$(field .version output)" 1
        assert_equal "$(field '.history[-1].tool' output)" "$tool"
        assert_equal "$(field '.history | length' output)" "$(($(field '.history | length' "$input") + 1))"
    done
}

@test "running a stage again gives the same bytes and drops what came later" {
    last=$(stage surfaces block)
    for tool in qm-features qm-enum qm-merge; do
        input=$(input_of "$tool" block)
        options=()
        quietly "$tool" "${options[@]}" "$input" -o once
        quietly "$tool" "${options[@]}" once -o twice
        assert_same_bytes once twice
    done
    quietly qm-features "$last" -o again
    assert_equal "$(field .kind again)" features
    assert_equal "$(field 'has("cut") or has("enumeration") or has("layout") or has("surfaces")' again)" false
    assert_equal "$(field '[.history[].tool] | join(" ")' again)" 'qm-basecomplex qm-features'
}

@test "keys of the user's own are kept" {
    for tool in "${FILTERS[@]}"; do
        jq '. + {"x-owner": {"name": "Ada", "numbers": [1, 2.5, null]}}' "$(input_of "$tool" block)" >mine
        quietly "$tool" mine -o output
        assert_equal "$(field '."x-owner" | tojson' output)" '{"name":"Ada","numbers":[1,2.5,null]}'
    done
}

@test "how the JSON is laid out, and in what order, does not matter" {
    for tool in "${FILTERS[@]}"; do
        input=$(input_of "$tool" block)
        quietly "$tool" "$input" -o expected
        jq --indent 7 . "$input" >spread
        quietly "$tool" spread -o output
        assert_same_bytes expected output
    done
}

@test "the result does not depend on the number of threads" {
    for model in helix random; do
        for tool in "${FILTERS[@]}"; do
            input=$(input_of "$tool" "$model")
            # The helix has a spike where the tolerance is missed: status 3.
            "$tool" --quiet --jobs 1 "$input" -o one || assert_equal "$?" 3
            "$tool" --quiet --jobs 2 "$input" -o two || assert_equal "$?" 3
            assert_same_bytes one two
        done
    done
}

# ------------------------------------------------------------------------------------------- the mesh

@test "a mesh that has changed is refused" {
    cp "$(sample block)" part.obj
    qm-basecomplex part.obj -o part.basecomplex.json
    echo '# a comment' >>part.obj
    complains qm-features part.basecomplex.json
    assert_regex "$stderr" 'part.obj'
    assert_regex "$stderr" 'changed|qm-basecomplex'
    rm part.obj
    complains qm-features part.basecomplex.json
    assert_regex "$stderr" 'part.obj'
}

@test "no output takes the place of the mesh, by whatever name" {
    cp "$(sample block)" part.obj
    ln -s part.obj link.obj
    mkdir folder
    cp part.obj before.obj
    for name in part.obj ./part.obj folder/../part.obj link.obj "$PWD/part.obj"; do
        complains qm-basecomplex part.obj -o "$name"
        assert_equal "$stderr" "qm-basecomplex: $name: is the mesh that the result refers to. Name another file"
    done
    complains qm-basecomplex link.obj -o part.obj
    complains qm-basecomplex -o part.obj <part.obj
    qm-basecomplex part.obj -o part.json
    complains qm-features part.json -o link.obj
    complains qm-enum --all part.obj part.json -o out.json
    complains qm-check part.json -o part.obj
    complains qm-view part.json -o part.obj
    (cd folder && complains qm-features ../part.json -o ../part.obj)
    assert [ ! -e out.json ]
    assert_same_bytes part.obj before.obj
    assert [ -L link.obj ]
}

@test "another folder: --mesh says where the mesh is" {
    cp "$(sample block)" part.obj
    qm-basecomplex part.obj -o part.basecomplex.json
    mkdir elsewhere
    mv part.obj elsewhere/
    quietly qm-features --mesh elsewhere/part.obj part.basecomplex.json -o output
}

@test "a key that looks like one of ours is told, and anybody's own is not" {
    local document
    document=$(stage surfaces cube)
    jq '.layout.qualty = .layout.quality | del(.layout.quality) | .note = 1 | .layout.mine = 2 | .constrants = {}' "$document" >keys.json
    run --separate-stderr qm-export --mesh "$(sample cube)" keys.json -o out.obj
    assert_success
    assert_regex "$stderr" 'keys.json: /layout/qualty: no tool reads this key. Is it .quality.\?'
    assert_regex "$stderr" 'keys.json: /constrants: no tool reads this key. Is it .constraints.\?'
    refute_regex "$stderr" '/note|/layout/mine'
}
