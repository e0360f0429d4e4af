#!/bin/sh
# An unmodified program of PyOpenGL draws the same bytes with this project's libOSMesa and with the
# reference's. It needs Debian's python3-opengl and python3-numpy.
# usage: tests/osmesa/pyopengl.sh BUILD
set -u
. tests/script.sh
begin osmesa

library=$(realpath "$1/osmesa")
python=/usr/bin/python3
export PYOPENGL_PLATFORM=osmesa
if ! "$python" -c 'import OpenGL, numpy' 2>/dev/null; then
    skip "PyOpenGL: needs python3-opengl and python3-numpy: 'make setup' installs them"
    finish
fi

. tests/osmesa/reference.sh

version='from OpenGL.GL import glGetString, GL_VERSION
from OpenGL import osmesa, arrays
pixels = arrays.GLubyteArray.zeros((4, 4, 4))
context = osmesa.OSMesaCreateContextExt(osmesa.OSMESA_RGBA, 24, 8, 0, None)
assert osmesa.OSMesaMakeCurrent(context, pixels, 0x1401, 4, 4)
assert b"Mesa 25.0.7" in glGetString(GL_VERSION), glGetString(GL_VERSION)'
result "the reference is Mesa 25.0.7" reference "$python" -c "$version"
result "the reference draws" reference "$python" tests/osmesa/drawing.py "$work/reference"
result "this library draws" ours "$python" tests/osmesa/drawing.py "$work/ours"
result "all bytes are equal" cmp "$work/reference" "$work/ours"
result "there are pixels" test "$(wc -c <"$work/ours")" -ge 200000

printf 'from OpenGL.GL import glCreateShader, GL_VERTEX_SHADER\nfrom OpenGL import osmesa, arrays\n' >"$work/lacking.py"
cat >>"$work/lacking.py" <<'END'
pixels = arrays.GLubyteArray.zeros((4, 4, 4))
context = osmesa.OSMesaCreateContextExt(osmesa.OSMESA_RGBA, 24, 8, 0, None)
assert osmesa.OSMesaMakeCurrent(context, pixels, 0x1401, 4, 4)
for _ in range(2):
    try:
        glCreateShader(GL_VERTEX_SHADER)
    except Exception as error:
        assert error.err == 0x502
    else:
        raise SystemExit("no error")
END
GNOMON_DEBUG=1 ours "$python" "$work/lacking.py" 2>"$work/names"
result "what is not supported is an error" test $? = 0
result "and is named once" test "$(grep -c 'glCreateShader: this function is not supported' "$work/names")" = 1
finish
