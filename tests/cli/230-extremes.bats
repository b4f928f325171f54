# Every numeric option of every tool, at its extremes; and meshes that are no files.

load helpers.bash

extremes=(1e300 1e-300 -1e300 nan inf -inf -1 0 9223372036854775808 18446744073709551616 '')

# numbers TOOL: its options that take a number
numbers() { "$1" --json-usage | jq -r '.options[] | select(.type == "number" or .type == "integer") | .name'; }

# subject TOOL: the operand that it works on
subject() {
    case $1 in
    qm-shape) echo cube ;;
    qm-check | qm-export | qm-view) stage surfaces cube ;;
    *) input_of "$1" cube ;;
    esac
}

# survives COMMAND...: a result, or a clear error in one line
survives() {
    captured timeout 60 "$@"
    case $status in
    0 | 3) ;;
    1 | 2) assert_equal "${#stderr_lines[@]} $*" "1 $*" ;;
    *) fail "status $status: $*: $stderr" ;;
    esac
}

@test "numeric options at their extremes give a result or a clear error" {
    for tool in $(all_tools); do
        operand=$(subject "$tool")
        for option in $(numbers "$tool"); do
            for value in "${extremes[@]}"; do
                survives "$tool" "$option=$value" "$operand" -o "$tool.out"
            done
        done
        rm -f "$tool".out*
    done
}

@test "numeric options of the optimal pruning too" {
    for option in $(numbers qm-prune); do
        for value in "${extremes[@]}"; do
            survives qm-prune --method optimum --front "$option=$value" "$(stage layout cube)" -o out.json
        done
    done
}

@test "command lines made at random give a result or a clear error, and nothing but what was asked for" {
    JOBS=1 QM_BIN=$QM_BIN run "$ROOT/tests/faults/options" "$PWD/lines" 20 1
    assert_success
}

@test "a document whose mesh is a device, a pipe or a folder is refused" {
    mkfifo pipe
    for mesh in /dev/zero pipe .; do
        jq --arg mesh "$mesh" '.mesh.path = $mesh' "$(stage basecomplex cube)" >moved.json
        run -1 --separate-stderr timeout 20 qm-cut moved.json
        assert_equal "${#stderr_lines[@]}" 1
        run -1 --separate-stderr timeout 20 qm-cut --mesh "$mesh" "$(stage basecomplex cube)"
        assert_equal "${#stderr_lines[@]}" 1
    done
    run -1 --separate-stderr timeout 20 qm-basecomplex /dev/zero
    assert_equal "${#stderr_lines[@]}" 1
}

# within LIMIT COMMAND...: under a limit of the shell
within() { bash -c "ulimit $1 && exec \"\$@\"" - "${@:2}"; }

@test "where files may not grow an output is refused, and none is left" {
    for tool in "${FILTERS[@]}" qm-basecomplex; do
        run -1 --separate-stderr within '-f 1' "$tool" "$(input_of "$tool" random)" -o out.json
        assert_equal "${#stderr_lines[@]}" 1
        assert_regex "$stderr" 'cannot be written: File too large'
        assert [ -z "$(ls)" ]
    done
}

@test "where there are no more threads the work is done on fewer" {
    within '-v 900000' qm-enum --version &>/dev/null || skip 'a sanitizer takes all addresses'
    for tool in qm-enum qm-merge qm-bspline; do
        input=$(input_of "$tool" random)
        "$tool" --quiet "$input" -o expected.json
        # A stack that is larger than all memory.
        run -0 --separate-stderr within '-s 1000000 -v 900000' "$tool" --quiet --jobs 4 "$input" -o out.json
        assert_same_bytes expected.json out.json
    done
    qm-enum --quiet --all expected.jsonl "$(stage basecomplex cube)" -o expected.json
    run -0 within '-s 1000000 -v 900000' qm-enum --quiet --jobs 4 --all out.jsonl "$(stage basecomplex cube)" -o out.json
    assert_same_bytes expected.jsonl out.jsonl
}
