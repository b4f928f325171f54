# scripts/check-references: references to sections of documents.

load helpers.bash

setup() {
    cd "$BATS_TEST_TMPDIR" || return
    mkdir -p docs lib/cut
    printf '%s\n' '# The method' '## Mesh cut' 'See [above](#the-method) and [Knuth](#knuth-2011).' \
        '- <a id="knuth-2011"></a>D. E. Knuth' >docs/METHOD.md
    echo '/// \file Cutting (docs/METHOD.md#mesh-cut).' >lib/cut/cut.h
    echo '[cut](docs/METHOD.md#mesh-cut)' >README.md
}

check() { run --separate-stderr "$ROOT/scripts/check-references" .; }

@test "references that lead somewhere pass and are counted" {
    check
    assert_success
    assert_output 'references: 4 passed, 0 failed'
    assert [ -z "$stderr" ]
}

@test "a section that does not exist is named with the place, in sources and documents" {
    echo '/// See docs/METHOD.md#mesh-cuts.' >>lib/cut/cut.h
    echo '[cut](docs/METHOD.md#cuts) and [no](docs/NO.md#page)' >>README.md
    check
    assert_failure
    assert_output 'references: 4 passed, 3 failed'
    assert_equal "$(sort <<<"$stderr")" "$(printf '%s\n' \
        'README.md:2: docs/METHOD.md has no section cuts' \
        'README.md:2: there is no document docs/NO.md' \
        'lib/cut/cut.h:2: docs/METHOD.md has no section mesh-cuts')"
}

@test "a section by its number is refused" {
    printf '// As in method %s\n// The paper'\''s %s\n' 4 4.2 >lib/cut/cut.cpp
    check
    assert_failure
    assert_output 'references: 4 passed, 2 failed'
}

@test "documents below folders refer from where they are" {
    mkdir schemas
    echo '[cut](../docs/METHOD.md#mesh-cut), [not](docs/METHOD.md#mesh-cut)' >schemas/FORMAT.md
    check
    assert_failure
    assert_output 'references: 5 passed, 1 failed'
    assert_equal "$stderr" 'schemas/FORMAT.md:1: there is no document schemas/docs/METHOD.md'
}
