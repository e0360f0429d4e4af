# shellcheck shell=sh disable=SC2016
# The steps of `make test` and `make whole`, sourced by tests/run.sh, which calls `step` and `whole`:
#   step SUITE/NAME 'WHAT MAKE MUST HAVE BUILT' 'COMMAND'
# `make test` is the everyday gate: at most 6 minutes from a fresh clone on two processors. What `whole`
# names takes longer: other compilers, machines and browsers, back ends that are compiled again, and tests
# of the tools that developers use. Long steps stand first, so that none of them is left alone at the end.
# Each step uses files of its own, and one processor if it can choose. Random tests run from $SEED and,
# outside CI, again from $FRESH, so that every run draws new cases.

replay="|| { echo 'replay with: make test FRESH=$FRESH'; false; }"
engines=$(for engine in openmpi mpich; do ! command -v mpicc.$engine >/dev/null || echo $engine; done)
over_ranks() { for program; do for engine in $engines; do echo "$engine/$program"; done; done; }
web=
! command -v "${WEB_CC:-clang-19}" >/dev/null || ! command -v "${WEB_OPT:-wasm-opt}" >/dev/null || web=web

# Other machines, browsers, ranks, installations, proofs.
whole web/modules "$web gnomon page-pictures-check" 'tests/web/modules.sh $BUILD'
whole web/page "$web docs gnomon" 'tests/web/browser.sh $BUILD'
whole web/explained "$web gnomon" 'tests/web/explained.sh $BUILD'
whole web/lessons "$web lessons" 'tests/web/lessons.sh $BUILD'
whole ranks/installed "all $(over_ranks gnomon)" 'tests/command/ranks/installed.sh $BUILD'
whole ranks/frames "gnomon make-models $(over_ranks gnomon test_tasks) test_tasks" 'tests/command/ranks/frames.sh $BUILD'
whole ranks/one-picture "gnomon make-models $(over_ranks gnomon scenes-over-ranks)" 'tests/command/ranks/onepicture.sh $BUILD'
whole osmesa/mujoco osmesa 'tests/osmesa/mujoco.sh $BUILD'
# One row of each kind of machine, with the other compilers; WebAssembly's modules are tested by web/modules.
# `make cross` builds all rows.
whole machines/builds all 'tests/portability/cross.sh $BUILD --scenes 110 clang-O2 tcc one-lane i686 aarch64 s390x mingw cortex-m4f'
whole machines/freestanding all 'tests/portability/freestanding.sh $BUILD'
whole machines/microcontroller all 'tests/microcontrollers/size.sh $BUILD'
whole machines/firmware all 'tests/microcontrollers/firmware.sh $BUILD'
whole machines/microcontroller-lesson all 'tests/lessons/microcontroller.sh $BUILD'
whole packaging/debian all 'tests/packaging/deb.sh $BUILD'
whole packaging/bare-debian-13 '' 'tests/packaging/debian.sh $BUILD trixie'
whole packaging/cmake all 'tests/packaging/cmake.sh $BUILD && tests/packaging/windows.sh $BUILD'
whole packaging/meson all 'tests/packaging/meson.sh $BUILD'
whole packaging/flags '' 'python3 tests/packaging/flags.py $BUILD'
whole packaging/amalgamation 'all hashes' 'tests/packaging/amalgamation.sh $BUILD'
whole packaging/archive all 'tests/packaging/dist.sh $BUILD'
whole packaging/cplusplus 'all hashes' 'tests/packaging/cplusplus.sh $BUILD'
# A function of each of Frama-C's tools, and mutants that they must reject; `make prove` proves all.
whole proofs/functions '' 'tests/proof/prove_code.sh -q --only begins_outside && tests/proof/prove_code.sh -q --only eva_inverses'
whole proofs/wrong-bounds '' 'tests/proof/test_prove.sh'
whole proofs/wrong-functions '' 'tests/proof/test_prove_code.sh begins_outside wide_product eva_inverses'
[ "$(uname -m)" != x86_64 ] ||
    whole parity/emulated parity-emulated '$BUILD/parity-emulated --seed $SEED --scenes 1100 --keep $BUILD/emulated-failure.scene'
whole parity/shrinking parity 'tests/parity/test_shrink.sh $BUILD/parity'
whole bench/shader bench '$BUILD/bench --frames 1 --scene S4 | grep ": 0 differing"'
whole bench/clears bench '$BUILD/bench --frames 1 --scene S6 | grep ": 0 differing"'
whole bench/states bench-states '$BUILD/bench-states --frames 1 --row "stencil increment, sphere"'

# The reference decides.
if [ -n "$FRESH" ]; then
    step parity/scenes parity '$BUILD/parity --seed $SEED --scenes 2400 --keep $BUILD/parity-failure.scene'
    step parity/fresh-scenes parity "\$BUILD/parity --seed \$FRESH --scenes 600 --keep \$BUILD/fresh-failure.scene $replay"
    step property/fresh property-tests "\$BUILD/property-tests --seed \$FRESH $replay"
else
    step parity/scenes parity '$BUILD/parity --seed $SEED --scenes 3300 --keep $BUILD/parity-failure.scene'
fi
step sanitized/unit/test_long_draws sanitized/test_long_draws '$SANITIZED/test_long_draws'
step sanitized/parity/scenes sanitized/parity '$SANITIZED/parity --seed $SEED --scenes 220 --keep $BUILD/sanitized-failure.scene'
step parity/egl 'parity blits texels textures' 'tests/parity/egl.sh $BUILD --seed $SEED --scenes 112'
step parity/blits blits '$BUILD/blits --seed $SEED --blits 2310'
step parity/textures textures '$BUILD/textures --seed $SEED --quick'
step parity/texels texels '$BUILD/texels --seed $SEED --textures 12'
step parity/kept-scenes parity 'tests/parity/replay.sh $BUILD/parity'
step parity/exact-geometry exact-geometry '$BUILD/exact-geometry --seed $SEED --triangles 60000 --clip-space 6000'
step parity/pairs-of-states parity '$BUILD/parity --pairs --seed $SEED'
step parity/scenes-are-valid parity '$BUILD/parity --check --seed ${FRESH:-$SEED}'
step parity/pinned-beside-pinned unpinned-distance '$BUILD/unpinned-distance --self-test --scenes 110 --seed $SEED'
step sanitized/parity/blits sanitized/blits '$SANITIZED/blits --seed $SEED --blits 330'
step sanitized/parity/textures sanitized/textures '$SANITIZED/textures --seed $SEED --cases 60'
step sanitized/parity/exact-geometry sanitized/exact-geometry '$SANITIZED/exact-geometry --seed $SEED --triangles 4000 --clip-space 400'
step osmesa/scenes 'osmesa osmesa-scenes' '$BUILD/osmesa-scenes $BUILD/osmesa/libOSMesa.so.8 --seed $SEED --scenes 12 && GNOMON_THREADS=3 $BUILD/osmesa-scenes $BUILD/osmesa/libOSMesa.so.8 --seed $SEED --scenes 2'
step osmesa/state 'osmesa osmesa-state' '$BUILD/osmesa-state $BUILD/osmesa/libOSMesa.so.8 $SEED 5000'
step sanitized/osmesa/alone sanitized/osmesa-alone '$SANITIZED/osmesa-alone ${FRESH:-$SEED} 8 && GNOMON_THREADS=3 $SANITIZED/osmesa-alone ${FRESH:-$SEED} 2'
step osmesa/pyopengl osmesa 'tests/osmesa/pyopengl.sh $BUILD'
step contract/scenes contract-check '$BUILD/contract-check --keep $BUILD/contract-failure.scene'
step contract/pictures page-pictures-check '$BUILD/page-pictures-check'
step contract/beside-the-reference 'contract page-pictures' '$BUILD/contract --compare --every 50 && $BUILD/page-pictures --compare'

# How others take it.
step packaging/readme all 'tests/packaging/readme.sh $BUILD'
step packaging/guide all 'tests/packaging/guide.sh $BUILD'
step packaging/shaders all 'tests/packaging/shader_examples.sh $BUILD'
step packaging/install all 'tests/packaging/install.sh $BUILD'
step packaging/python 'all python-parts' 'tests/packaging/python.sh $BUILD'
step machines/headers-alone all 'tests/portability/freestanding.sh $BUILD --quick'
step machines/lanes test-lanes '$BUILD/test-lanes $SEED'
step machines/stack stack '$BUILD/stack --seed $SEED --scenes 1100'
step machines/one-lane one-lane '$BUILD/one-lane/test_basic && $BUILD/one-lane/debug/test_basic && $BUILD/one-lane/test_far_texels && $BUILD/one-lane/test_workspaces && $BUILD/one-lane/stack --seed $SEED --scenes 1100'
step lessons/pictures 'all lesson-tests lessons' 'tests/lessons/lessons.sh $BUILD $SEED'
step lessons/beside-the-reference lesson-tests 'tests/lessons/beside_reference.sh $BUILD'
step lessons/course all 'tests/lessons/course.sh $BUILD'
step lessons/files lesson-files 'tests/lessons/files.sh $BUILD'
step sanitized/lessons/files sanitized/lesson-files 'tests/lessons/files.sh $SANITIZED'
step docs/pages '' 'tests/docs/docs.sh'
step style/layout '' 'tests/style/style.sh'
step style/words '' 'tests/style/words.sh'
step style/layers tool-objects 'tests/style/layers.sh $BUILD'
step style/headers '' 'tests/style/headers.sh'
step style/survivors '' 'tests/mutants/mutants.sh $BUILD --check'

# The command and the page.
step command/demo gnomon '$BUILD/gnomon demo -o $BUILD/teapot-compared.png'
for name in faults drawn_models hostile_files odd_models outputs model_formats pictures files spin render_views view \
    placing shading_command comparison transform_command transform_setups explain overlays; do
    step command/$name "gnomon test_$name" "\$BUILD/test_$name \$BUILD/gnomon"
done
# Those that read files of others. The random options below try every option under the sanitizers.
for name in faults hostile_files odd_models model_formats files; do
    whole sanitized/command/$name "sanitized/gnomon test_$name" "\$BUILD/test_$name \$SANITIZED/gnomon"
done
for name in handover images near_name teapot; do
    step command/$name test_$name "\$BUILD/test_$name"
done
step command/documents 'gnomon documents/gnomon.1 test_documents' '$BUILD/test_documents $BUILD/gnomon'
step command/random-options gnomon 'tests/command/test_random_options.sh $BUILD ${FRESH:-$SEED}'
whole sanitized/command/random-options sanitized/gnomon 'tests/command/test_random_options.sh $SANITIZED $SEED'
step command/explained-pixels explain-pixels '$BUILD/explain-pixels ${FRESH:-$SEED} 12 120'
whole sanitized/command/explained-pixels sanitized/explain-pixels '$SANITIZED/explain-pixels $SEED 3 40'
for name in page page_models less; do
    step web/$name test_$name "\$BUILD/test_$name"
    step sanitized/web/$name sanitized/test_$name "\$SANITIZED/test_$name"
done

# The library by itself. The last property is that every function of the mathematics has one.
step property/all property-tests '$BUILD/property-tests --seed $SEED'
step sanitized/property/all sanitized/property-tests '$SANITIZED/property-tests --seed $SEED --trials 100'
step property/runner test_theft '$BUILD/test_theft'
step property/every-function '' 'tests/coverage/functions.sh'
step accuracy/scalars exhaustive-scalars '$BUILD/exhaustive-scalars --stride 9973'
step accuracy/mathematics accuracy '$BUILD/accuracy --seed $SEED --inputs 20000'
step accuracy/textures texture-accuracy '$BUILD/texture-accuracy --seed $SEED --lookups 2000'
step accuracy/cglm test_cglm '$BUILD/test_cglm $SEED'
step sanitized/accuracy/cglm sanitized/test_cglm '$SANITIZED/test_cglm $SEED'
step sanitized/fuzz/kept-inputs sanitized/fuzz-programs 'tests/fuzz/replay.sh $SANITIZED'
step proofs/bounds '' 'tests/proof/prove.sh -q'
for suite in unit models; do
    for name in tests/$suite/test_*.c; do
        name=$(basename "$name" .c)
        [ $name = test_long_draws ] || step sanitized/$suite/$name sanitized/$name "\$SANITIZED/$name"
        step $suite/$name $name "\$BUILD/$name"
    done
done
