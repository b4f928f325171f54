# make install, and what it puts where.

load helpers.bash

setup_file() {
    load helpers.bash
    make --no-print-directory -C "$ROOT" "config=$(config)" install prefix=/usr "DESTDIR=$BATS_FILE_TMPDIR/root" >/dev/null
}

config() { if [[ $QM_BIN == */build/*/bin ]]; then basename "$(dirname "$QM_BIN")"; else echo release; fi; }

@test "the installed tools run" {
    for tool in $(all_tools); do
        quietly "$BATS_FILE_TMPDIR/root/usr/bin/$tool" --version
    done
}

@test "every tool has a manual page and completion" {
    for tool in $(all_tools); do
        assert [ -s "$BATS_FILE_TMPDIR/root/usr/share/man/man1/$tool.1" ]
        assert [ -s "$BATS_FILE_TMPDIR/root/usr/share/bash-completion/completions/$tool" ]
    done
}

@test "manual pages have no formatting errors and no dates" {
    for page in "$BATS_FILE_TMPDIR"/root/usr/share/man/man1/*.1; do
        run grep -E '^\.TH .*(19|20)[0-9][0-9]' "$page"
        assert_failure
        if command -v groff >/dev/null; then
            run --separate-stderr groff -man -Tascii -ww "$page"
            assert_equal "$stderr" ''
        fi
    done
}

@test "manual pages show every example as a line of its own" {
    command -v groff >/dev/null || skip "there is no groff"
    local tool example
    for tool in $(all_tools); do
        groff -man -Tascii -P-cbou -rLL=200n "$BATS_FILE_TMPDIR/root/usr/share/man/man1/$tool.1" | sed 's/^ *//' >page
        while IFS= read -r example; do
            run grep -Fx -- "$example" page
            assert_success
        done < <("$QM_BIN/$tool" --help | sed -nE '/^Examples/,$ s/^ +//p')
    done
}

# completed WORD...: what bash offers for the last of the words.
completed() {
    bash -c "source '$BATS_FILE_TMPDIR/root/usr/share/bash-completion/completions/$1'
        COMP_WORDS=($*); COMP_CWORD=$(($# - 1))
        _quadmesh $1 '${!#}' '${*: -2:1}'
        printf '%s\n' \"\${COMPREPLY[@]}\""
}

@test "completion offers options, choices, layers and shapes" {
    run completed qm-cut --ch
    assert_line -- --chi
    run completed qm-enum --method pl
    assert_output plain
    run completed qm-view --show segments,bor
    assert_output segments,borders
    run completed qm-shape bra
    assert_output bracket
    # A flag has no value: what follows it may be the operand. An option that has one is followed by that.
    run completed qm-shape --list bra
    assert_output bracket
    run completed qm-shape --output bra
    assert_output ''
    # Of --method=pl, bash makes three words.
    run completed qm-enum --method = pl
    assert_output plain
    run completed qm-enum --method =
    assert_line optimum
    run completed qm-view --show = segments,bor
    assert_output segments,borders
    # quadmesh takes the options of its stages, but not those that it sets itself.
    run completed quadmesh --cut.ch
    assert_output -- --cut.chi
    run completed quadmesh --export.
    assert_line -- --export.join
    refute_line -- --export.unit
    run completed quadmesh --prune.method g
    assert_output greedy
}

@test "completion for zsh and fish is whole and offers the same" {
    local share=$BATS_FILE_TMPDIR/root/usr/share tool
    for tool in quadmesh $(all_tools); do
        grep -q "^$tool)" "$share/zsh/site-functions/_quadmesh"
        assert [ -s "$share/fish/vendor_completions.d/$tool.fish" ]
    done
    if command -v zsh >/dev/null; then zsh -n "$share/zsh/site-functions/_quadmesh"; fi
    command -v fish >/dev/null || skip 'there is no fish'
    run fish -c "source '$share/fish/vendor_completions.d/qm-view.fish'; complete -C 'qm-view --show segments,bor' | cut -f 1"
    assert_output segments,borders
    run fish -c "source '$share/fish/vendor_completions.d/qm-shape.fish'; complete -C 'qm-shape bra' | cut -f 1"
    assert_output bracket
}

@test "the Debian package has the version of the program" {
    run sed -n '1s/.*(\(.*\)).*/\1/p' "$ROOT/debian/changelog"
    assert_output "$(cat "$ROOT/VERSION")"
}

@test "the installed pipeline finds the installed tools" {
    cp "$(sample cube)" part.obj
    PATH=/usr/bin:/bin QM_BIN='' run make --no-print-directory -f "$BATS_FILE_TMPDIR/root/usr/share/quadmesh/pipelines/layout.mk" \
        out/part.surfaces.json
    assert_success
    PATH=/usr/bin:/bin QM_BIN='' "$BATS_FILE_TMPDIR/root/usr/share/quadmesh/pipelines/layout.sh" part.obj -o pipe.json
    assert_same_bytes pipe.json out/part.surfaces.json
}

@test "a program is compiled and linked against the installed library" {
    case $(config) in release | debug) ;; *) skip "a library of this configuration links with its own flags" ;; esac
    local copy=$BATS_TEST_TMPDIR/copy expected
    make --no-print-directory -C "$ROOT" "config=$(config)" install "prefix=$copy" >/dev/null
    # The program and the command are those of README.md.
    sed -n '/^```cpp$/,/^```$/ { /^```/d; p }' "$ROOT/README.md" >patches.cpp
    command=$(sed -n 's/^ \{4\}\(g++ .*patches\.cpp.*\)/\1/p' "$ROOT/README.md")
    assert [ -n "$command" ]
    PKG_CONFIG_PATH=$copy/lib/pkgconfig quietly bash -c "$command"

    cp "$(sample block)" part.obj
    expected=$(qm-basecomplex part.obj | qm-enum | qm-merge |
        jq -r '"\(.layout.segments | length) patches, cost \(.layout.cost * 1000 | round / 1000)"')
    run ./patches
    assert_output "$expected"
}

@test "editors learn how every source is compiled" {
    quietly env "command=g++ -DTEXT='\"a b\"' -I\\" "$ROOT/scripts/compile-commands" lib/one.cpp tools/two.cpp
    assert_equal "$(jq -r '.[1].command' <<<"$output")" "g++ -DTEXT='\"a b\"' -I\\ -c tools/two.cpp"
    assert_equal "$(jq -r '.[0].file' <<<"$output")" lib/one.cpp
}

@test "what is missing is named, and only installed on request" {
    mkdir folder
    printf '#!/bin/sh\nexit 1\n' >folder/dpkg-query
    chmod +x folder/dpkg-query
    PATH=$PWD/folder:$PATH run --separate-stderr "$ROOT/scripts/install-dependencies" --verify fuzz lint
    assert_equal "$status" 1
    assert_equal "$stderr" 'packages are missing. As root, run: apt-get install clang clang-format clang-tidy libclang-rt-dev shellcheck'
}

@test "nothing installs packages but deps, check and demo" {
    run awk '/^[a-z-]+:/ { target = $1 } /install-dependencies/ && !/--verify/ { print target }' "$ROOT/Makefile"
    assert_output $'deps:\ncheck:\ndemo:'
}

@test "uninstalling leaves nothing" {
    make --no-print-directory -C "$ROOT" "config=$(config)" install prefix=/usr "DESTDIR=$PWD/root" >/dev/null
    assert [ -e root/usr/lib/pkgconfig/quadmesh.pc ]
    make --no-print-directory -C "$ROOT" "config=$(config)" uninstall prefix=/usr "DESTDIR=$PWD/root" >/dev/null
    run find root -not -type d
    assert_output ''
}

@test "only qm-export needs OpenCASCADE" {
    for tool in $(all_tools); do
        [[ $tool == qm-export ]] && continue
        run ldd "$QM_BIN/$tool"
        refute_output --partial libTK
    done
}
