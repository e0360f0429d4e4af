# Sourced by the tests of lessons.
. tests/script.sh

# lesson_files: the lessons find their models in build/examples of the working directory, here $work, and
# write there. $build is the absolute path of the build.
lesson_files() {
    mkdir -p "$work/build/examples"
    ln -s "$build"/examples/*.obj "$build"/examples/teapot_*.tga "$build"/examples/head.tga "$build"/examples/eyes.tga \
        "$work/build/examples"
}
