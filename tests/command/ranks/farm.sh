#!/bin/sh
# Tests the farm, which runs lists of shell commands over ranks, and what uses it: campaigns and
# mutants over ranks, with every engine of MPI. Each task runs once; what is killed goes on where it
# was; results are those of a run without ranks.
# usage: farm.sh BUILD-DIRECTORY [PART...]   (from the root of the project; BUILD-DIRECTORY has the
# farm and parity)
# Parts: each_once no_waiting failing apart faulty killed campaigns real_campaign tiny_mutants; all
# without PART
set -u
case ${1:---help} in --help | -h) sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; exit 0 ;; esac
. tests/skip.sh
. tests/result.sh
. tests/command/ranks/launch.sh
build=$(cd "$1" && pwd) || exit 2
shift
all='each_once no_waiting failing apart faulty killed campaigns real_campaign tiny_mutants'
parts=${*:-$all}
for part in $parts; do
    case " $all " in *" $part "*) ;; *) echo "farm.sh: '$part': no such part; there are: $all" >&2; exit 2 ;; esac
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
first=
list=$work/list
results=$work/results
log=$work/log
tab=$(printf '\t')

# make_list NUMBER SECONDS: tasks that write their names, their ranks and process numbers to the log.
make_list() {
    for task in $(seq "$1"); do
        printf 'task %d\techo "%d $FARM_RANK $$ $PPID" >>%s; sleep %s; echo "task %d done"\n' "$task" "$task" "$log" "$2" "$task"
    done >"$list"
}
begin() { # begin NUMBER SECONDS
    rm -f "$results" "$log" "$work/said" "$work/error"
    : >"$log"
    make_list "$@"
}
# farm N OPTION...: sets status; the output is in $work/out and $work/error.
farm() {
    count=$1
    shift
    over_ranks "$engine" "$count" "$build/$engine/farm" --tasks "$list" --results "$results" "$@" \
        >"$work/out" 2>"$work/error" </dev/null
    status=$?
}
# holds WHAT CONDITION...: shows the output of the run if the condition does not hold.
holds() {
    what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $engine, $what: exit status ${status:-?}"
        tail -n 15 "$work/out" "$work/error" | sed 's/^/    /'
    fi
}
names() { cut -d ' ' -f "$1" "$2" | sort -n | tr '\n' ' '; }
# All tasks have one line.
complete() { [ "$(sort -V "$results")" = "$(seq "$1" | sed 's/.*/task & done/')" ]; }
said() { grep -q -e "$1" "$work/error"; }
figures() { grep -q -x -e "farm: $1" "$work/out"; }

# Whether this is the first engine: for what the engine has no part in.
only_once() { [ "$engine" = "$first" ]; }

each_once() {
    for n in 1 2 3 4; do
        begin 24 0.04
        farm $n --ranks $n
        holds "$n ranks: success" [ $status = 0 ]
        holds "$n ranks: each task once" [ "$(names 1 "$log")" = "$(seq 24 | tr '\n' ' ')" ]
        holds "$n ranks: each has a line" complete 24
        holds "$n ranks: all of them work" [ "$(cut -d ' ' -f 2 "$log" | sort -u | tr '\n' ' ')" = "$(seq 0 $((n - 1)) | tr '\n' ' ')" ]
        holds "$n ranks: one line of figures" [ "$(wc -l <"$work/out")" = 1 ]
        holds "$n ranks: the figures" figures "24 tasks, 24 done now by $n ranks in [0-9.]* s, 0 done before, 0 without a result, 0 not run"
    done
    farm 2
    holds "nothing is left" [ $status = 0 -a "$(wc -l <"$log")" = 24 ]
    farm 2 --again
    holds "--again" [ $status = 0 -a "$(wc -l <"$log")" = 48 -a "$(wc -l <"$results")" = 48 ]
}

# Ranks do not wait for each other: while one runs a long task, the others run all short ones.
no_waiting() {
    begin 13 0.02
    sed -i '1s/sleep 0.02/sleep 1.5/' "$list"
    farm 3
    holds "a long task: all done" complete 13
    holds "a long task: its line is the last one" [ "$(tail -n 1 "$results")" = "task 1 done" ]
}

failing() {
    begin 6 0
    {
        printf 'worse\techo "worse 1 2 3"; exit 3\n'
        printf 'silent\texit 4\n'
        printf 'half\techo "half"; echo "halfway to nowhere"; printf "half a line"; kill -9 $$\n'
        printf 'killed\tkill -9 $$\n'
    } >>"$list"
    farm 2
    holds "tasks without a result: status 1" [ $status = 1 ]
    holds "tasks without a result: named" said "task 'silent', run by rank [01]: exit status 4"
    holds "tasks without a result: a signal" said "task 'killed', run by rank [01]: signal 9"
    holds "the others have their lines" [ "$(grep -c '^task' "$results")" = 6 ]
    holds "a task that fails with a line has a result" grep -q -x "worse 1 2 3" "$results"
    holds "the last whole line of a task's name counts" grep -q -x half "$results"
    holds "their figures" figures "10 tasks, 8 done now by 2 ranks in .* s, 0 done before, 2 without a result, 0 not run"
    farm 2
    holds "they are tried again, and no others" figures "10 tasks, 0 done now by 2 ranks in .* s, 8 done before, 2 without a result, 0 not run"
    begin 20 0.1
    sed -i '3s/.*/task 3\texit 1/' "$list"
    farm 2 --stop
    holds "--stop: no more tasks" [ $status = 1 -a "$(wc -l <"$log")" -lt 8 ]
    holds "--stop: tasks that are running end" [ "$(wc -l <"$log")" = "$(wc -l <"$results")" ]
}

# await CONDITION...: at most ten seconds.
await() {
    for _ in $(seq 200); do
        ! "$@" || return 0
        sleep 0.05
    done
    return 1
}
has_begun() { [ "$(wc -l <"$log")" = "$1" ]; }
none_runs() { # none_runs PROCESS...
    for process; do
        [ ! -d "/proc/$process" ] || return 1
    done
}
# Prints a process and all below it, parents first: what a task starts must not end before its rank.
family() { # family PROCESS
    echo "$1"
    for child in $(pgrep -P "$1"); do
        family "$child"
    done
}

killed() {
    kill_and_go_on "a rank"
    kill_and_go_on "the launcher"
    only_once || return 0
    kill_and_go_on "the first rank"
    kill_and_go_on everything
}
kill_and_go_on() { # kill_and_go_on WHAT: a rank, the first rank, the launcher, or everything
    begin 9 0.1
    sed -i '4,$s/sleep 0.1/sleep 60/' "$list" # three tasks end, and each rank is in one that does not
    over_ranks "$engine" 3 "$build/$engine/farm" --tasks "$list" --results "$results" >"$work/out" 2>"$work/error" </dev/null &
    started=$!
    holds "before killing $1: works" await has_begun 6
    case $1 in
    "a rank") victims=$(awk '$2 == 1 { print $4; exit }' "$log") ;;
    "the first rank") victims=$(awk '$2 == 0 { print $4; exit }' "$log") ;;
    "the launcher") victims=$(pgrep -P "$(pgrep -P $started)") ;;
    everything) victims=$(family $started) ;;
    esac
    # shellcheck disable=SC2086
    kill -9 $victims 2>/dev/null # some may just have ended
    wait $started 2>/dev/null
    status=$?
    holds "$1 killed: a status that is not 0" [ $status -ne 0 ]
    holds "$1 killed: its end is soon" [ $status -ne 124 ]
    case $1 in
    *rank) holds "$1 killed: named" said "rank $([ "$1" = "a rank" ] && echo 1 || echo 0) (process $victims) was killed" ;;
    esac
    # shellcheck disable=SC2046
    holds "$1 killed: no task and no rank is left running" await none_runs $(cut -d ' ' -f 3,4 "$log")
    holds "$1 killed: whole lines" [ -z "$(grep -v -x 'task [0-9]* done' "$results")" ]
    holds "$1 killed: what had ended has its line" [ "$(wc -l <"$results")" = 3 ]
    printf 'task 9 do' >>"$results"
    : >"$log"
    make_list 9 0.1
    farm 3
    holds "$1 killed: goes on" [ $status = 0 ]
    holds "$1 killed: no task is lost or done twice" complete 9
    holds "$1 killed: runs what was left" [ "$(wc -l <"$log")" = 6 ]
}

# A task is no rank of the launcher, and none that srun has started beside the launcher.
apart() {
    begin 0 0
    {
        printf 'variables\techo "variables $(env | grep -c "^\\(OMPI\\|PMIX\\|PMI\\|HYDI\\|SLURM_STEP\\)_")"\n'
        printf 'program\t"%s" --help >/dev/null && echo "program runs"\n' "$build/farm"
    } >"$list"
    export SLURM_STEP_NUM_TASKS=2 SLURM_STEP_ID=0
    farm 2
    unset SLURM_STEP_NUM_TASKS SLURM_STEP_ID
    holds "tasks know no launcher" [ $status = 0 ]
    holds "tasks have no variables of one" grep -q -x "variables 0" "$results"
}

faulty() {
    begin 4 0
    results=$work/absent/results farm 3
    holds "an absent directory" [ $status = 1 ]
    holds "an absent directory: said once" [ "$(grep -c 'absent/results: No such file' "$work/error")" = 1 ]
    results=/dev/full farm 2
    holds "no regular file" said '/dev/full: is no regular file'
    holds "no task was run" [ ! -s "$log" ]
    # The limit of the size of files is met by the second line; MPI needs some size for itself.
    head -c 16777200 /dev/zero | tr '\0' '#' >"$results"
    echo >>"$results"
    limited() { (ulimit -f 32768 && farm "$@"; exit $status) 2>/dev/null; }
    limited 2
    status=$?
    holds "a full disk: status" [ $status != 0 -a $status != 124 ]
    holds "a full disk: named" said "rank 0: $results: File too large"
    holds "a full disk: whole lines" [ "$(tail -n +2 "$results" | grep -c -v -x 'task [0-9]* done')" = 0 ]
    holds "a full disk: some lines" [ "$(tail -n +2 "$results" | wc -l)" = 1 ]

    begin 4 1
    "$build/farm" --tasks "$list" --results "$results" >/dev/null 2>&1 &
    other=$!
    await test -s "$log"
    farm 2
    kill $other
    wait $other 2>/dev/null
    holds "another run writes" [ $status = 1 ]
    holds "another run writes: said" said "$results: another run is writing to it"

    begin 2 0
    farm 2 --ranks 3
    holds "another number of ranks" [ $status = 2 -a "$(grep -c '3 ranks are wanted, and there are 2' "$work/error")" = 1 ]
    only_once || return 0
    printf 'task 1\ttrue\n' >>"$list"
    farm 2
    holds "a name twice" said "$list: two tasks are called 'task 1'"
    echo 'task 3 true' >"$list"
    farm 2
    holds "no tab" said "$list: line 1: a task is a name, a tab and a command"
    rm "$list"
    farm 2
    holds "no list" said "$list: No such file"
    begin 3 0
    printf 'task 4\techo "task 4 done" \0\ntask 5\techo "task 5 done"\n' >>"$list"
    farm 2
    holds "a byte 0" [ $status = 1 -a ! -s "$log" ]
    holds "a byte 0: said" said "$list: has a byte 0 at [0-9]*"
    : >"$list"
    farm 2
    holds "an empty list" [ $status = 0 ]
    farm 2 --rank 3
    holds "an unknown option" [ $status = 2 -a "$(grep -c -e "'--rank': no such option" "$work/error")" = 1 ]
    over_ranks "$engine" 3 "$build/$engine/farm" --help >"$work/out" 2>"$work/error"
    status=$?
    holds "--help once" [ $status = 0 -a "$(grep -c '^usage' "$work/out")" = 1 ]
    begin 3 0
    "$build/farm" --tasks "$list" --results "$results" >"$work/out" 2>"$work/error"
    status=$?
    holds "without MPI" [ $status = 0 ]
    holds "without MPI: all" complete 3
}

use_engine() {
    export MPIRUN="mpirun.$engine" OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    case $engine in
    openmpi) export MPIRUN_FLAGS='--oversubscribe --bind-to none' ;;
    *) export MPIRUN_FLAGS= ;;
    esac
}

# Campaigns, with a stand-in for the parity program: seed 9 has a difference.
campaign() { # campaign DIRECTORY OPTION...
    at=$1
    shift
    timeout -k 5 120 tests/parity/campaign.sh --farm "$build/$engine/farm" --kept "$work/none" "$@" "$at" \
        >"$work/out" 2>"$work/error"
    status=$?
}
same_campaign() { # same_campaign DIRECTORY: the last line and the state are those without ranks
    [ "$(tail -n 1 "$work/out")" = "$(cat "$work/plain/sums")" ] &&
        [ "$(sort "$1/campaign/state.txt")" = "$(sort "$work/plain/campaign/state.txt")" ]
}
has_state() { [ "$(grep -s -c ^done "$work/over/campaign/state.txt")" = "$1" ]; }
stand_in() { # stand_in DIRECTORY
    mkdir -p "$1"
    cat >"$1/parity" <<'PARITY'
#!/bin/sh
# arguments: --seed S --skip K --scenes N --jobs N --keep FILE
sleep 0.1
differ=0
[ "$2" != 9 ] || { differ=2; : >"${10}"; }
echo "all $6 $(($2 * 10)) $(($4 + 100)) 50 $differ 0"
echo "parity: $6 scenes, 100 pixels compared, $differ differ, 0 scenes refused"
[ $differ = 0 ]
PARITY
    chmod +x "$1/parity"
}
campaigns() {
    set -- --scenes 45 --chunk 10 --seeds '3 4'
    if [ ! -d "$work/plain" ]; then
        stand_in "$work/plain"
        campaign "$work/plain" "$@"
        tail -n 1 "$work/out" >"$work/plain/sums"
        holds "a campaign without ranks" grep -q '^campaign: 46 scenes of 2 seeds' "$work/plain/sums"
    fi
    for n in 1 2 3 4; do
        rm -rf "$work/over"
        stand_in "$work/over"
        campaign "$work/over" "$@" --ranks $n
        holds "a campaign over $n ranks: success" [ $status = 0 ]
        holds "a campaign over $n ranks: as without" same_campaign "$work/over"
    done
    rm -rf "$work/over/campaign"
    campaign "$work/over" "$@" --chunks 2
    campaign "$work/over" "$@" --chunks 2 --ranks 2
    holds "begun without ranks, goes on with them: some are left" [ $status = 1 -a "$(grep -c ^done "$work/over/campaign/state.txt")" = 4 ]
    campaign "$work/over" "$@"
    holds "and back" same_campaign "$work/over"

    rm -rf "$work/over/campaign"
    sed -i 's/sleep 0.1/[ $4 = 0 ] || sleep 60/' "$work/over/parity" # the first chunks end, the others do not
    timeout -k 5 60 tests/parity/campaign.sh --farm "$build/$engine/farm" --kept "$work/none" "$@" --ranks 3 "$work/over" >/dev/null 2>&1 &
    started=$!
    holds "before killing a campaign: works" await has_state 2
    # shellcheck disable=SC2046
    kill -9 $(family $started) 2>/dev/null
    wait $started 2>/dev/null
    holds "a campaign killed: its lock is free" await flock -n "$work/over/campaign/lock" true
    holds "a campaign killed: some chunks are left" has_state 2
    sed -i 's/.*sleep 60/sleep 0.1/' "$work/over/parity"
    campaign "$work/over" "$@" --ranks 2
    holds "a campaign killed: goes on" same_campaign "$work/over"

    campaign "$work/over" --scenes 20 --chunk 10 --seeds 9 --ranks 2
    holds "a difference: status 1" [ $status = 1 ]
    holds "a difference: the sums" grep -q '^campaign: 20 scenes of 1 seeds, .* 4 differing' "$work/out"
    holds "a difference: the scene is named" said 'failure-9-10.scene'
    printf '#!/bin/sh\necho "parity: no reference"\nexit 1\n' >"$work/over/parity"
    campaign "$work/over" --scenes 200 --chunk 10 --seeds 5 --ranks 2
    holds "parity that cannot run: status 1" [ $status = 1 ]
    holds "parity that cannot run: said" said 'could not be run, exit status 1'
    holds "parity that cannot run: nothing is recorded" [ "$(grep -c '^done 5' "$work/over/campaign/state.txt")" = 0 ]
    holds "parity that cannot run: few are tried" [ "$(grep -c 'could not be run' "$work/error")" -lt 6 ]
    campaign "$work/over" --ranks 0
    holds "no ranks" [ $status = 2 ]
}
# Scenes that are really drawn.
real_campaign() {
    set -- --scenes 112 --chunk 28 --seeds '3 4'
    if [ ! -d "$work/drawn" ]; then
        mkdir "$work/drawn"
        cp "$build/parity" "$work/drawn/parity"
        campaign "$work/drawn" "$@"
        tail -n 1 "$work/out" >"$work/sums"
        holds "scenes drawn without ranks" grep -q '^campaign: 112 scenes of 2 seeds, [1-9].*, 0 differing' "$work/sums"
    fi
    rm -rf "$work/drawn/campaign"
    campaign "$work/drawn" "$@" --ranks 3
    holds "scenes drawn over 3 ranks: the same sums" [ "$(tail -n 1 "$work/out")" = "$(cat "$work/sums")" ]
}

# Mutants of a library of one file, whose Makefile records commands as the project's does.
tiny_project() {
    tiny=$work/tiny
    mkdir -p "$tiny/include" "$tiny/src/tiny" "$tiny/reference" "$tiny/tools/threads" "$tiny/tests/unit"
    cp -r tests/mutants tests/assurance "$tiny/tests/"
    echo '- : unused' >"$tiny/reference/text"
    echo 'int tiny_sum(const int *values, int count);' >"$tiny/include/tiny.h"
    cat >"$tiny/src/tiny/tiny.c" <<'C'
#include "../../include/tiny.h"

int tiny_sum(const int *values, int count)
{
    int sum = 0;
    for (int i = 0; i < count; ++i)
        if (values[i] > 2)
            sum += values[i] * 3;
    if (count == 100)
        sum = 7;
    return sum;
}
C
    cat >"$tiny/tests/unit/test_tiny.c" <<'C'
#include "../../include/tiny.h"

int main(void)
{
    const int values[] = {1, 2, 3, 4};
    return tiny_sum(values, 4) != 21;
}
C
    cat >"$tiny/Makefile" <<'MAKE'
build/src/%.o build/tests/%.o: FORCE
	mkdir -p $(@D)
	$(CC) -O0 -fPIC -MMD -c $(@:build/%.o=%.c) -o $@
	echo '$(CC) -O0 -fPIC' >$@.command
build/libgnomon.so: build/src/tiny/tiny.o
	$(CC) -shared -Wl,-soname,libgnomon.so.0 build/src/tiny/tiny.o -o $@
	echo '$(CC) -shared -Wl,-soname,libgnomon.so.0 build/src/tiny/tiny.o ' >$@.command
build/libgnomon.a: build/src/tiny/tiny.o
	$(AR) rcs $@ $<
build/test_tiny: build/tests/unit/test_tiny.o build/libgnomon.a
	$(CC) $^ -o $@
	echo '$(CC) build/tests/unit/test_tiny.o build/libgnomon.a ' >$@.command
FORCE:
MAKE
    echo 'tiny: test_tiny' >"$tiny/tests/mutants/steps.txt"
}
mutants() { # mutants OPTION...
    (cd "$tiny" && timeout -k 5 120 tests/mutants/mutants.sh build --farm "$build/$engine/farm" "$@") \
        >"$work/out" 2>"$work/error"
    status=$?
}
verdicts() { cut -f 1-3,6-9 "$tiny/build/mutants/results-1.txt" | sort -n; }
tiny_mutants() {
    if [ ! -d "$work/tiny" ]; then
        tiny_project
        mutants --mutants 8 --jobs 1
        verdicts >"$work/verdicts"
        cp "$work/out" "$work/report"
        holds "mutants without ranks" grep -q '^mutants: 8, [1-9] killed, 0 equivalent, [1-9] survived' "$work/report"
    fi
    rm "$tiny/build/mutants/results-1.txt"
    mutants --mutants 8 --ranks 3
    holds "mutants over 3 ranks: the same report" cmp -s "$work/out" "$work/report"
    holds "mutants over 3 ranks: the same verdicts" [ "$(verdicts)" = "$(cat "$work/verdicts")" ]
    holds "mutants over 3 ranks: a tree each" [ -d "$tiny/build/mutants/job3" ]
    only_once || return 0
    rm "$tiny/build/mutants/results-1.txt"
    mutants --mutants 3 --ranks 2
    mutants --mutants 5 --jobs 1
    mutants --mutants 8 --ranks 2
    holds "mutants with ranks, without, with them: the same verdicts" [ "$(verdicts)" = "$(cat "$work/verdicts")" ]
    # Other tests: survivors are tried again, nothing else is.
    echo >>"$tiny/tests/unit/test_tiny.c"
    mutants --mutants 8 --ranks 2
    holds "other tests: survivors are tried again" [ "$(verdicts | wc -l)" = $(($(wc -l <"$work/verdicts") + $(grep -c survived "$work/verdicts"))) ]
    sed -i '$d' "$tiny/tests/unit/test_tiny.c"
    # A step that fails without a mutant ends the run.
    cp "$tiny/tests/unit/test_tiny.c" "$work/test_tiny.c"
    sed -i 's/!= 21/!= 22/' "$tiny/tests/unit/test_tiny.c"
    rm "$tiny/build/mutants/results-1.txt"
    mutants --mutants 8 --ranks 2
    holds "a test that fails without a mutant: status 2" [ $status = 2 ]
    holds "a test that fails without a mutant: named" said "'test_tiny' fails with the unchanged library"
    holds "a test that fails without a mutant: no verdict" [ "$(wc -l <"$tiny/build/mutants/results-1.txt")" = 1 ]
    cp "$work/test_tiny.c" "$tiny/tests/unit/test_tiny.c"
}

for engine in $engines; do
    if ! has_engine "$engine" || [ ! -x "$build/$engine/farm" ]; then
        skip "the farm over ranks: $engine is absent: 'make setup-mpi' installs it"
        continue
    fi
    first=${first:-$engine}
    use_engine
    for part in $parts; do
        $part
    done
done
echo "farm: $passed passed, $failed failed"
[ "$failed" = 0 ]
