# What design promises of every tool, whichever it is. A new tool is tested as soon as it is built.

load helpers.bash

# Runs a function once for each tool, and names the tool that it fails for.
for_every_tool() {
    local tool
    for tool in $(all_tools); do
        echo "# $tool" >&2
        "$1" "$tool"
    done
}

@test "there are tools" {
    run all_tools
    assert_line qm-basecomplex
    assert_line qm-bspline
}

helps() {
    quietly "$1" --help
    assert_line --regexp '^Usage:|^Usage '
    assert_line --regexp '^Examples'
    assert_line --regexp '--version'
    assert_line --regexp '--quiet'
    assert_line --regexp '--schema|--output'
    quietly "$1" -h
}
@test "--help explains, on standard output, with examples" { for_every_tool helps; }

names_its_version() {
    quietly "$1" --version
    assert_equal "${lines[0]}" "$1 (quadmesh) $(cat "$ROOT/VERSION")"
}
@test "--version begins with tool, suite and number" { for_every_tool names_its_version; }

refuses_unknown_options() {
    misused "$1" --no-such-option
    assert_regex "$stderr" 'no-such-option'
}
@test "an unknown option is a usage error that names it" { for_every_tool refuses_unknown_options; }

refuses_values_of_flags() {
    local value
    for value in 1 no false true x ''; do
        misused "$1" "--verbose=$value"
        assert_regex "$stderr" '--verbose: takes no value'
    done
}
@test "a flag with a value is a usage error" { for_every_tool refuses_values_of_flags; }

accepts_its_defaults() {
    local name value
    while read -r name value; do
        captured "$1" "$name" "$value" no-such-file
        refute_regex "$stderr" "$name: "
    done < <("$1" --json-usage | jq -r '.options[] | select(has("default") and .name != "--jobs") | "\(.name) \(.default)"')
}
@test "a default that --help tells may be given" { for_every_tool accepts_its_defaults; }

refuses_extra_operands() { misused "$1" a b c d e; }
@test "too many operands are a usage error" { for_every_tool refuses_extra_operands; }

refuses_output_without_name() { misused "$1" -o; }
@test "-o without a name is a usage error" { for_every_tool refuses_output_without_name; }

opens_nothing_when_misused() {
    captured "$1" no-such-file --no-such-option
    assert_equal "$status" 2
}
@test "the command line is read to its end before a file is opened" { for_every_tool opens_nothing_when_misused; }

reports_a_closed_output() {
    captured bash -c "$1 --help >&-"
    assert_failure
    captured bash -c "$1 --help >/dev/full"
    assert_equal "$status" 1
    assert_regex "$stderr" "^$1: "
}
@test "help that cannot be written is an error" { for_every_tool reports_a_closed_output; }

has_a_manual_page() {
    run --separate-stderr "$ROOT/scripts/man" "$QM_BIN/$1"
    assert_success
    assert_line --regexp '^\.SH NAME'
    assert_line --regexp '^\.SH (OPTIONS|.*OPTIONS)'
    assert_line --regexp '^\.SH "?EXIT STATUS'
}
@test "a manual page can be made of every tool" { for_every_tool has_a_manual_page; }
