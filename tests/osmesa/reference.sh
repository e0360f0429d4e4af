# Sourced: runs programs with the reference's libOSMesa, or with this project's in $library.

# reference COMMAND...: in the pinned environment (reference/osmesa/context.c), with the loader of
# the reference's libraries.
reference() {
    libraries=$(ls -d "${MESA:-build/mesa}"/usr/lib/*-linux-gnu 2>/dev/null)
    loader=$(ls "${MESA:-build/mesa}"/usr/lib/*-linux-gnu/ld-linux*.so.* 2>/dev/null)
    if [ -n "$loader" ]; then
        set -- "$loader" --library-path "$libraries:/usr/lib/$(basename "$libraries")" "$@"
    fi
    GALLIUM_DRIVER=llvmpipe GALLIUM_OVERRIDE_CPU_CAPS=sse4.1 GALLIVM_PERF=no_quad_lod,no_aos_sampling,nopt \
        MESA_GLSL_DISABLE_IO_OPT=true LP_NUM_THREADS=0 MESA_SHADER_CACHE_DISABLE=true "$@"
}

ours() { LD_LIBRARY_PATH=$library "$@"; }
