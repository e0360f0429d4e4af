#!/bin/sh
# Fuzzes the targets of this directory, or merges what fuzzing found into the committed corpus; --help
# says how. Ends on one line of figures; exit status 0 only if there was no finding and every chosen
# engine ran.
set -u
cd "$(dirname "$0")/../.."

help() {
    cat <<'END'
usage: tests/fuzz/fuzz.sh [--seconds N] [--engines "asan msan afl"] [--targets "NAME..."]
                          [--seed S] [--jobs N] [--merge] BUILD
       make fuzz [FUZZ_SECONDS=60] [FUZZ_ENGINES=...] [FUZZ_TARGETS=...] [SEED=1] [JOBS=2]
       make fuzz-merge [FUZZ_TARGETS=...]

Builds every target for every engine in BUILD/fuzz and runs each of them for N seconds: with all
targets and engines it takes about 42 times N seconds, divided by the jobs.

  asan   libFuzzer with AddressSanitizer and UndefinedBehaviorSanitizer, which also finds casts of
         floats that do not fit and, in the library and the command, implicit conversions that
         lose bits; not divisions by zero, whose results the library's contract defines
  msan   libFuzzer with MemorySanitizer, for targets without libraries that it does not instrument
  afl    AFL++ without sanitizers; what it finds new runs under asan once, if that engine is chosen

Inputs grow in BUILD/fuzz/corpus and begin with the committed ones. An input that shows an error goes
to BUILD/fuzz/found, with the command that replays it. Exit status: 0: nothing was found; 1: there
are findings, or the compiler of a chosen engine is absent; 2: the command line is wrong.

  --merge   does not fuzz: replaces tests/fuzz/corpus by those inputs of it and of BUILD/fuzz/corpus
            that reach the edges of the code, as few as reach all, at most 80 of a target: the first
            ones each reach the most edges that those before them have not reached

A program alone: make build/fuzz-draws && build/fuzz-draws FILE-OR-FOLDER... replays without a fuzzer.
END
}

seconds=60
engines='asan msan afl'
targets=$(ls tests/fuzz/fuzz_*.c | sed 's|.*/fuzz_\(.*\)\.c|\1|' | tr '\n' ' ')
all=$targets
jobs=2
seed=1
merge=
most=80
build=
while [ $# -gt 0 ]; do
    case $1 in
    --help) help; exit 0 ;;
    --merge) merge=yes ;;
    --seconds | --engines | --targets | --jobs | --seed)
        [ $# -gt 1 ] || { echo "fuzz: missing value after $1 (--help says more)" >&2; exit 2; }
        case $1 in
        --seconds) seconds=$2 ;;
        --engines) engines=$2 ;;
        --targets) targets=${2:-$targets} ;;
        --jobs) jobs=$2 ;;
        --seed) seed=$2 ;;
        esac
        shift ;;
    -*) echo "fuzz: unknown option $1 (--help says more)" >&2; exit 2 ;;
    *) build=$1 ;;
    esac
    shift
done
[ -n "$build" ] || { help >&2; exit 2; }
for number in "$seconds" "$jobs" "$seed"; do
    case $number in
    '' | *[!0-9]* | 0) echo "fuzz: not a number above 0: $number" >&2; exit 2 ;;
    esac
done
# known WHAT NAMES WORD...: ends the script unless each word is one of the names.
known() {
    what=$1 names=$2
    shift 2
    for word; do
        case " $names " in
        *" $word "*) ;;
        *) echo "fuzz: no $what '$word'; there are: $names" >&2; exit 2 ;;
        esac
    done
}
# shellcheck disable=SC2086
known target "$all" $targets
# shellcheck disable=SC2086
known engine 'asan msan afl' $engines

work=$build/fuzz
found=$work/found
mkdir -p "$work/corpus" "$work/log" "$found"
# Memory that OSMesa keeps is no leak of ours.
export LSAN_OPTIONS=suppressions=tests/leaks.supp:print_suppressions=0
export ASAN_OPTIONS=intercept_tls_get_addr=0 # tests/steps.mk says why
export UBSAN_OPTIONS=print_stacktrace=1

# Libraries that these targets call are not instrumented, and MemorySanitizer would take what they
# write for unwritten.
has_target() { # has_target ENGINE TARGET
    case $1-$2 in
    msan-assimp | msan-pictures | msan-reference) return 1 ;;
    esac
}

compiler_of() { # compiler_of ENGINE
    case $1 in
    afl) echo afl-clang-fast ;;
    *) echo clang-19 ;;
    esac
}

# build_engine ENGINE: builds the chosen targets of an engine; false if it has none of them.
build_engine() {
    compiler=$(compiler_of "$1")
    level='-O1 -g1 -DGN_SMALLEST_TASKS'
    flags=
    case $1 in
    asan)
        sanitize='-fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow,implicit-conversion -fno-sanitize-recover=all'
        flags='-fsanitize-ignorelist=tests/fuzz/ignore.txt' ;;
    msan) sanitize='-fsanitize=fuzzer-no-link,memory -fno-sanitize-recover=all' ;;
    afl)
        level='-O2 -g1 -DGN_SMALLEST_TASKS'
        sanitize= ;;
    esac
    programs=
    for target in $targets; do
        ! has_target "$1" "$target" || programs="$programs $work/$1/fuzz-$target"
    done
    [ -n "$programs" ] || return 1
    echo "fuzz: builds for $1" >&2
    AFL_QUIET=1 make --no-print-directory -j"$jobs" BUILD="$work/$1" CC=$compiler CFLAGS="$level" \
        SANITIZE="$sanitize" FUZZ_FLAGS="$flags" FUZZ_MAIN= FUZZ_LIBRARIES=-fsanitize=fuzzer \
        $programs >"$work/log/build-$1" 2>&1 || {
        tail -n 20 "$work/log/build-$1" >&2
        echo "fuzz: the build for $1 failed: $work/log/build-$1" >&2
        exit 1
    }
}

dictionary() { # dictionary OPTION TARGET
    [ ! -f "tests/fuzz/$2.dict" ] || echo "$1tests/fuzz/$2.dict"
}

# The folders of inputs that a target begins with.
seeds() { # seeds TARGET
    for folder in "tests/fuzz/corpus/$1" "tests/fuzz/found/$1"; do
        [ ! -d "$folder" ] || echo "$folder"
    done
}

# The longest inputs: text is longer than numbers.
longest() {
    case $1 in
    scene_text | transform | pictures | handover | obj | ply | stl | gltf) echo 4096 ;;
    *) echo 1024 ;;
    esac
}

# tell PROGRAM LOG [INPUT]: what was found, and the command that shows it again; without an INPUT the one
# that the log names.
tell() {
    grep -h -m 2 -e 'does not hold' -e 'ERROR: ' -e 'runtime error' -e 'WARNING: MemorySanitizer' "$2" >&2
    input=${3:-$(sed -n 's/.*Test unit written to //p' "$2" | tail -n 1)}
    echo "fuzz: replay with: $1 ${input:-(see $2)}" >&2
}

# Each of the next functions runs one target and sets runs and findings.

run_libfuzzer() { # run_libfuzzer ENGINE TARGET
    log=$work/log/$1-$2
    mkdir -p "$work/corpus/$2"
    prefix=$found/$1-$2-
    before=$(ls "$prefix"* 2>/dev/null | wc -l)
    "$work/$1/fuzz-$2" "$work/corpus/$2" $(seeds "$2") -max_total_time="$seconds" -seed="$seed" \
        -timeout=60 -report_slow_units=60 -rss_limit_mb=4096 -max_len="$(longest "$2")" \
        -artifact_prefix="$prefix" -print_final_stats=1 $(dictionary -dict= "$2") >"$log" 2>&1
    status=$?
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    after=$(ls "$prefix"* 2>/dev/null | wc -l)
    findings=$((after - before))
    # Found again, or ended without an input.
    [ $status -eq 0 ] || [ "$findings" -gt 0 ] || findings=1
    [ "$findings" -eq 0 ] || tell "$work/$1/fuzz-$2" "$log"
}

run_afl() { # run_afl TARGET
    log=$work/log/afl-$1
    out=$work/afl-out/$1
    start=$work/afl-in/$1
    rm -rf "$out" "$start"
    mkdir -p "$out" "$start"
    printf 0 >"$start/none"
    for folder in $(seeds "$1") "$work/corpus/$1"; do
        [ ! -d "$folder" ] || find "$folder" -type f -size -9 -exec cp {} "$start/" \;
    done
    env -u ASAN_OPTIONS -u LSAN_OPTIONS -u UBSAN_OPTIONS AFL_SKIP_CPUFREQ=1 AFL_NO_AFFINITY=1 AFL_NO_UI=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_QUIET=1 \
        AFL_SKIP_CRASHES=1 AFL_FORKSRV_INIT_TMOUT=60000 afl-fuzz -V "$seconds" -s "$seed" -t 20000+ -m none \
        -i "$start" -o "$out" -G "$(longest "$1")" $(dictionary '-x ' "$1") -- "$work/afl/fuzz-$1" >"$log" 2>&1
    status=$?
    runs=$(sed -n 's/^execs_done *: *//p' "$out/default/fuzzer_stats" 2>/dev/null)
    findings=0
    [ -n "$runs" ] || { findings=1; echo "fuzz: afl-fuzz ended with status $status: see $log" >&2; }
    for input in "$out"/default/crashes/id* "$out"/default/hangs/id*; do
        [ -f "$input" ] || continue
        # AFL++ calls slow what takes many times the usual; on a busy machine that may be anything.
        case $input in
        */hangs/*)
            timeout 60 "$work/afl/fuzz-$1" "$input" >/dev/null 2>&1
            [ $? -eq 124 ] || continue ;;
        esac
        findings=$((findings + 1))
        name=$found/afl-$1-$(sha1sum "$input" | cut -c1-16)
        cp "$input" "$name"
        echo "fuzz: replay with: $work/afl/fuzz-$1 $name" >&2
    done
    # What is new to AFL++ may hold an error that only a sanitizer sees.
    if [ -x "$work/asan/fuzz-$1" ] && case " $engines " in *' asan '*) ;; *) false ;; esac; then
        "$work/asan/fuzz-$1" "$out/default/queue" -runs=0 -timeout=60 -rss_limit_mb=4096 \
            -artifact_prefix="$found/asan-$1-" >>"$log" 2>&1 || {
            findings=$((findings + 1))
            tell "$work/asan/fuzz-$1" "$log"
        }
    fi
    mkdir -p "$work/corpus/$1"
    for input in "$out"/default/queue/id*; do
        [ ! -f "$input" ] || cp "$input" "$work/corpus/$1/$(sha1sum "$input" | cut -c1-40)"
    done
}

# run_one ENGINE-TARGET: leaves a line of its runs, findings and CPU seconds.
run_one() (
    engine=${1%%-*}
    target=${1#*-}
    if [ "$engine" = afl ]; then run_afl "$target"; else run_libfuzzer "$engine" "$target"; fi
    times >"$work/log/$1.times" # in a pipeline these would be the times of another shell
    processor=$(tr ms '  ' <"$work/log/$1.times" | awk '{ s += 60 * $1 + $2 + 60 * $3 + $4 } END { printf "%d", s }')
    echo "${runs:-0} $findings $processor" >"$work/log/$1.result"
    echo "fuzz: $engine $target: ${runs:-0} runs, $findings findings, $processor CPU seconds" >&2
)

[ -z "$merge" ] || engines=asan
for engine in $engines; do
    command -v "$(compiler_of "$engine")" >/dev/null || {
        echo "fuzz: $engine needs $(compiler_of "$engine"): 'make setup-verify' installs it; FUZZ_ENGINES (--engines) chooses other engines" >&2
        exit 1
    }
done

if [ -n "$merge" ]; then
    build_engine asan || exit 1
    for target in $targets; do
        new=$work/merged/$target
        rm -rf "$new"
        mkdir -p "$new" "$work/corpus/$target"
        "$work/asan/fuzz-$target" -set_cover_merge=1 -use_counters=0 -timeout=60 -rss_limit_mb=4096 \
            -max_len="$(longest "$target")" "$new" $(seeds "$target") "$work/corpus/$target" \
            >"$work/log/merge-$target" 2>&1 || {
            echo "fuzz: merging $target failed: $work/log/merge-$target" >&2
            exit 1
        }
        rm -rf "tests/fuzz/corpus/$target"
        mkdir -p "tests/fuzz/corpus/$target"
        # The merge writes first what reaches most.
        for name in $(ls -tr "$new" | head -n "$most"); do
            cp "$new/$name" "tests/fuzz/corpus/$target/$(sha1sum "$new/$name" | cut -c1-12)"
        done
        echo "fuzz: $target: $(ls "tests/fuzz/corpus/$target" | wc -l) inputs" >&2
    done
    echo "fuzz: corpus of $(find tests/fuzz/corpus -type f | wc -l) inputs," \
        "$(find tests/fuzz/corpus -type f -exec cat {} + | wc -c) bytes"
    exit 0
fi

rm -f "$work"/log/*.result
list=
used=0
for engine in $engines; do
    build_engine "$engine" || continue
    used=$((used + 1))
    for target in $targets; do
        ! has_target "$engine" "$target" || list="$list $engine-$target"
    done
done

# Runs `jobs` at a time: each worker takes the next one that no other has taken.
taken=$(mktemp -d)
trap 'trap - INT TERM; rm -rf "$taken"; kill 0' INT TERM
work_off() {
    for one in $list; do
        ! mkdir "$taken/$one" 2>/dev/null || run_one "$one"
    done
}
for worker in $(seq "$jobs"); do
    work_off &
done
wait

rm -rf "$taken"
read -r runs findings processors lost <<END
$(for one in $list; do
    cat "$work/log/$one.result" 2>/dev/null || echo "0 0 0 lost"
done | awk '{ runs += $1; findings += $2; processors += $3; lost += $4 != "" } END { printf "%.0f %d %d %d", runs, findings, processors, lost }')
END
grouped=$(echo "$runs" | sed ':a; s/\B[0-9]\{3\}\>/,&/; ta')
echo "fuzz: $(echo $targets | wc -w) targets, $used engines, $grouped runs, $processors CPU seconds, $findings findings"
[ "$findings" -eq 0 ] && [ "$lost" -eq 0 ] && [ "$used" -gt 0 ]
