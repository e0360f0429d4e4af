#!/bin/sh
# Tests what the Makefile makes again and what it leaves, in a copy of the project that has only the
# scalar functions, which compile in a second.
# usage: test_makefile.sh   (from the root of the project)
set -u
export MAKEFLAGS= # not those of the make that runs this
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
trap 'exit 1' INT TERM HUP
mkdir "$directory/src"
cp -r Makefile include "$directory/"
find tests tools -name '*.mk' | tar -cf - -T - | tar -xf - -C "$directory"
cp -r src/config src/scalars "$directory/src/"
cd "$directory" || exit 1
objects=$(find src -name '*.c' | wc -l)
passed=0
failed=0

# build OPTION...: makes the library; the file made lists what make said it compiled and linked.
build() {
    make "$@" library >log 2>&1
    status=$?
    sed -n -e 's/^  \(CC\|AR\|LD\) //p' -e "s/^echo '  \(CC\|AR\|LD\) \(.*\)'/\2/p" log | sort >made
}

# check WHAT CONDITION...
check() {
    what=$1
    shift
    if [ "$status" = 0 ] && "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what: exit status $status" >&2
        sed 's/^/    /' made log >&2
    fi
}

nothing() {
    [ ! -s made ]
}

# All objects, and the libraries that are linked from them.
everything() {
    [ "$(grep -c '\.o$' made)" = "$objects" ] && [ "$(grep -c '^libgnomon\.' made)" = 2 ]
}

build CFLAGS=-O0
check "at first: everything" everything
build CFLAGS=-O0
check "again: nothing" nothing

touch Makefile tests/*.mk
build CFLAGS=-O0
check "Makefile touched: nothing" nothing

touch src/scalars/exponential.h
build CFLAGS=-O0
grep -l '[ /]exponential\.h' build/src/scalars/*.d | sed 's|build/\(.*\)d$|\1o|' >users
check "header touched: its users" [ "$(grep '\.o$' made)" = "$(cat users)" ]
check "header touched: some, not all" [ "$(wc -l <users)" -gt 0 -a "$(wc -l <users)" -lt "$objects" ]

build -n CFLAGS=-O1
check "other flags, make -n: everything" everything
build CFLAGS=-O0
check "after make -n: nothing" nothing
build CFLAGS=-O1
check "other flags: everything" everything
build CFLAGS=-O1
check "other flags again: nothing" nothing
build CFLAGS=-O1 BUILD=other
check "another directory: everything" everything
build CFLAGS=-O1
check "another directory: the first is as it was" nothing
build CFLAGS=-O1 CC="${CC:-cc} -DGN_SMALL"
check "another compiler: everything" everything
build CFLAGS=-O1

# A file that fails to compile leaves no object with other flags behind.
build CFLAGS='-O2 -Dfloat=' && status=0
check "flags that do not compile: nothing is linked" [ "$(grep -c '^libgnomon' made)" = 0 ]
build CFLAGS=-O1
find build -name '*.o.command' -exec grep -L -e ' -O1 ' {} + >wrong
check "the flags before them: every record names them" [ ! -s wrong ]

printf '$(BUILD)/src/scalars/sqrt.o: SANITIZE = -DONE\n' >>Makefile
build CFLAGS=-O1
check "flags of one object: that one" [ "$(grep '\.o$' made)" = src/scalars/sqrt.o ]

rm src/scalars/tangent.c
build CFLAGS=-O1
check "a source removed: nothing is compiled" [ "$(grep -c '\.o$' made)" = 0 ]
check "a source removed: it is not in the library" [ "$(ar t build/libgnomon.a | grep -c ^tangent)" = 0 ]

# The archive of `make static` is not position-independent code; whatever else is made is.
make BUILD=archive static >log 2>&1
status=$?
ls archive >made
check "make static: the archive alone" cmp -s - made <<'END'
libgnomon.a
libgnomon.a.command
src
END
check "make static: no -fPIC" sh -c '! grep -q -e -fPIC archive/src/scalars/sqrt.o.command'
for goals in "static library" library; do
    # shellcheck disable=SC2086
    make -n BUILD=both $goals >log 2>&1
    grep -c -e -fPIC log >made
    status=0
    check "make $goals: -fPIC" [ "$(cat made)" -ge "$((objects - 1))" ]
done

make help >log 2>&1
status=$?
sed -n 's/^  make \([a-z-]*\) .*/\1/p' log | sort >made
cat Makefile $(find tests tools -name '*.mk') | sed -n 's/^\([a-z][a-z-]*\):.*## .*/\1/p' | sort >targets
check "make help: the targets of every file" cmp -s targets made

# What is told to the sanitizers is one word of the shell, and their own parser takes the quotes.
mkdir 'a blank'
cp -r Makefile include src tests tools 'a blank/'
printf '#!/bin/sh\nprintf "%%s\\n" "$ASAN_OPTIONS" "$LSAN_OPTIONS"\n' >'a blank/tests/run.sh'
chmod +x 'a blank/tests/run.sh'
make -C 'a blank' --no-print-directory -s test-steps >made 2>log
status=$?
check "a path with a blank: the sanitizers get it" grep -q -x "suppressions=\"$PWD/a blank/tests/leaks.supp\":print_suppressions=0" made

echo "makefile: $passed passed, $failed failed"
[ "$failed" = 0 ]
