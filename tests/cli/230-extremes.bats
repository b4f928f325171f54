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
    local status=0
    timeout 60 "$@" >out 2>message || status=$?
    case $status in
    0 | 3) ;;
    1 | 2) assert_equal "$(wc -l <message) $*" "1 $*" ;;
    *) fail "status $status: $*: $(cat message)" ;;
    esac
}

@test "numeric options at their extremes give a result or a clear error" {
    for tool in $(all_tools); do
        operand=$(subject "$tool")
        for option in $(numbers "$tool"); do
            for value in "${extremes[@]}"; do
                survives "$tool" "$option=$value" "$operand" -o "$tool.out"
                rm -f "$tool".out*
            done
        done
    done
}

@test "numeric options of the optimal pruning too" {
    for option in $(numbers qm-prune); do
        for value in "${extremes[@]}"; do
            survives qm-prune --method optimum --front "$option=$value" "$(stage layout cube)" -o out.json
        done
    done
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
