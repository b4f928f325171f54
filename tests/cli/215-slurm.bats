# pipelines/slurm: on a cluster of two nodes where Slurm is installed, and what it asks of Slurm everywhere.

load helpers.bash

slurm() { "$ROOT/pipelines/slurm" "$@"; }

@test "a folder of models on two nodes, one of which fails; a repeat runs only what is missing" {
    run "$ROOT/tests/slurm/run" "$BATS_TEST_TMPDIR/cluster" 6 pruned
    ((status != 77)) || skip "$output"
    assert_success
}

# Programs named like Slurm's that write down how they were called.
stand_ins() {
    mkdir stand-ins
    printf '#!/bin/bash\nprintf "%%s\\n" "$*" >>calls\nwc -l <calls\n' >stand-ins/sbatch
    printf '#!/bin/bash\ncat queue 2>/dev/null # which fails, as squeue does, if there is none\n' >stand-ins/squeue
    chmod +x stand-ins/*
    PATH=$PWD/stand-ins:$PATH
}

@test "models of like size share an array, and what is queued or finished is not submitted" {
    stand_ins
    mkdir meshes
    cp "$(sample cube)" meshes/a.obj
    cp "$(sample cube)" meshes/b.obj
    { cat "$(sample block)" && yes '# a large file' | head -c 20000000; } >meshes/large.obj
    run -0 slurm --sbatch '--partition long' meshes
    assert_equal "$(grep -c -- '--array 0-1 --mem 512M .*--partition long' calls)" 1
    assert_equal "$(grep -c -- '--array 0-0 --mem 2048M' calls)" 1
    assert_equal "$(grep -cE -- '--dependency afterany:(1:2|2:1) ' calls)" 1
    # As Slurm would run them.
    for job in 1 2; do
        for task in 0 1; do
            command=$(sed -n "${job}p" calls | sed 's/.*--wrap //')
            [[ $task == 0 || $(sed -n "${job}p" calls) == *'--array 0-1 '* ]] || continue
            SLURM_ARRAY_TASK_ID=$task bash -c "$command"
        done
    done
    run -0 slurm --status meshes
    assert_output -p 'large                    finished'
    run -0 slurm meshes
    assert_output -p 'nothing to submit'
    # Other options, or a document gone, and it is no longer finished; what waits is not submitted again.
    run -1 slurm --status meshes CUT_OPTIONS='--chi 7'
    assert_output -p 'a                        missing'
    rm out/a.surfaces.json out/b.surfaces.json
    job=$(awk '{ print $1; exit }' out/.slurm/jobs)
    list=$(awk '{ print $2; exit }' out/.slurm/jobs)
    grep -qx a "out/.slurm/$list" || { job=$(awk 'NR == 2 { print $1 }' out/.slurm/jobs) list=$(awk 'NR == 2 { print $2 }' out/.slurm/jobs); }
    echo "$job $(($(grep -nx a "out/.slurm/$list" | cut -d: -f1) - 1)) PENDING" >queue
    run -1 slurm --status meshes
    assert_output -p 'a                        PENDING'
    assert_output -p 'b                        missing'
    run -0 slurm meshes
    assert_output -p ': 1 models'
}

@test "folders and models whose names have blanks" {
    stand_ins
    mkdir 'my meshes'
    cp "$(sample cube)" 'my meshes/part one.obj'
    cp "$(sample cube)" 'my meshes/part two.obj'
    run -0 slurm --kind cut 'my meshes'
    assert_equal "$(grep -c -- '--array 0-1 ' calls)" 1
    command=$(sed -n 1p calls | sed 's/.*--wrap //')
    SLURM_ARRAY_TASK_ID=0 bash -c "$command"
    run -1 slurm --kind cut --status 'my meshes'
    assert_line -p 'part_one                 finished'
    assert_line -p 'part_two                 missing'
    SLURM_ARRAY_TASK_ID=1 bash -c "$command"
    run -0 slurm --kind cut 'my meshes'
    assert_output -p 'nothing to submit'
    quietly qm-check out/part_two.cut.json
}

# submitted JOB: runs its tasks, which are COUNT, as Slurm would.
submitted() {
    local command task
    command=$(sed -n "$1p" calls | sed 's/.*--wrap //')
    for ((task = 0; task < $2; ++task)); do SLURM_ARRAY_TASK_ID=$task bash -c "$command"; done
}

@test "names of models with dots are not taken for one another" {
    stand_ins
    mkdir meshes
    cp "$(sample cube)" meshes/part.obj
    run -0 slurm --kind cut meshes
    submitted 1 1
    cp "$(sample cube)" meshes/part.v2.obj
    run -0 slurm --kind cut meshes
    submitted 3 1
    run -0 slurm --kind cut --status meshes
    assert_line -p 'part                     finished'
    # While one is in the queue, another whose name differs by a dot is submitted.
    rm -r meshes out calls
    mkdir meshes
    cp "$(sample cube)" meshes/axb.obj
    run -0 slurm --kind cut meshes
    cp "$(sample cube)" meshes/a.b.obj
    echo '1 0 RUNNING' >queue
    run -0 slurm --kind cut meshes
    assert_output -p ': 1 models'
    run -1 slurm --kind cut --status meshes
    assert_line -p 'axb                      RUNNING'
}

@test "a mesh that is left out, and a folder without meshes, are told" {
    stand_ins
    mkdir meshes empty
    cp "$(sample cube)" meshes/part.obj
    qm-shape cube -o meshes/part.ply
    run -0 --separate-stderr slurm --kind cut meshes
    assert_regex "$stderr" 'meshes/part.ply: left out, as part is meshes/part.obj'
    submitted 1 1
    run -1 slurm --kind cut --status meshes
    assert_line -p 'part                     finished'
    run -2 slurm empty
    assert_output 'slurm: no meshes in empty'
}

@test "a wrong command line of slurm" {
    mkdir meshes
    for words in '' 'no-folder' '--what meshes' '--out' 'meshes meshes'; do
        # shellcheck disable=SC2086  # a list of words
        run --separate-stderr slurm $words
        assert_equal "$status" 2
        assert_regex "$stderr" '^slurm: '
    done
    run -0 slurm --help
    assert_output -p '--status'
}
