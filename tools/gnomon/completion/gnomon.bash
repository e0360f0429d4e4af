# Completion of gnomon's commands, options and values for bash. Source this file, or install it as
# share/bash-completion/completions/gnomon.

_gnomon()
{
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
    local command=${COMP_WORDS[1]} options=
    local limits='--import-seconds --import-memory --import-output --map-pixels'
    local drawing="--help --help-all --output --size --eye --target --up --fov --orthographic --near
        --far --rotate --scale --translate --shader --light --shadows --exponent --bands --texture
        --normal-map --specular-map --glow-map --filter --opaque --wireframe --points --cull
        --no-depth-test --samples --background --backend $limits"

    COMPREPLY=()
    if [ "$COMP_CWORD" = 1 ]; then
        COMPREPLY=($(compgen -W 'render compare demo spin view explain diff info transform help --help
            --version' -- "$word"))
        return
    fi
    # bash cuts --option=value into three words.
    if [ "$word" = = ]; then
        word=
    elif [ "$previous" = = ]; then
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    case $previous in
    --shader) options='vertex-color unlit flat gouraud toon phong blinn-phong normals depth metallic-roughness' ;;
    --filter) options='mipmap linear nearest' ;;
    --cull) options='back front none' ;;
    --format)
        options='png tga ppm'
        [ "$command" != render ] || options="$options raw"
        ;;
    --sort) options='first last' ;;
    --samples) options='1 4' ;;
    --axis) options='x y z' ;;
    --normal-map)
        options='tangent world none'
        [ "$command" = demo ] || options="any $options"
        ;;
    --backend) options='auto portable sse2 avx2 avx512 neon wasm-simd128' ;;
    esac
    if [ -n "$options" ]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
        return
    fi
    case $word in
    -*) ;;
    *) return ;; # a file
    esac
    case $command in
    render) options="$drawing --format --depth --views --sort --statistics" ;;
    compare) options="$drawing --statistics" ;;
    demo) options='--help --output --picture --size --samples --tessellation --shader --normal-map
        --filter --shadows --exponent --bands --statistics' ;;
    spin) options="$drawing --format --axis --frames --rate" ;;
    view) options="$drawing --script" ;;
    explain) options="${drawing/--output /} --pixel --primitive --json --state" ;;
    diff) options="--help --output --format $limits" ;;
    info) options="--help $limits" ;;
    transform) options='--help --matrices' ;;
    esac
    COMPREPLY=($(compgen -W "$options" -- "$word"))
}

complete -o filenames -o bashdefault -o default -F _gnomon gnomon
