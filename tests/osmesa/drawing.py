"""A program of PyOpenGL, which knows nothing of this project: draws by immediate mode, arrays and
buffer objects in an OSMesa window, reads pixels back, and writes all bytes to a file.

usage: PYOPENGL_PLATFORM=osmesa drawing.py FILE
"""
import ctypes
import sys

import numpy
from OpenGL import GL, arrays, osmesa

WIDTH, HEIGHT = 160, 120


def place_camera(angle):
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GL.glFrustum(-0.4, 0.4, -0.3, 0.3, 1.0, 10.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glTranslatef(0.0, 0.0, -4.0)
    GL.glRotatef(angle, 0.3, 1.0, 0.2)


def draw_immediate():
    """A cube of quads, one colour a corner."""
    faces = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    GL.glBegin(GL.GL_QUADS)
    for face in faces:
        for corner in face:
            x, y, z = corner & 1, corner >> 1 & 1, corner >> 2
            GL.glColor3f(x, y, z)
            GL.glVertex3f(0.7 * (2 * x - 1), 0.7 * (2 * y - 1), 0.7 * (2 * z - 1))
    GL.glEnd()


def draw_arrays():
    """A fan and a strip of lines, of numpy's arrays."""
    turns = numpy.linspace(0.0, 2.0 * numpy.pi, 13)
    circle = numpy.stack([numpy.cos(turns), numpy.sin(turns), 0.0 * turns], axis=1).astype("f")
    colors = numpy.stack([turns * 20, 255 - turns * 20, turns * 0 + 90, turns * 0 + 200], axis=1).astype("B")
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glEnableClientState(GL.GL_COLOR_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, circle)
    GL.glColorPointer(4, GL.GL_UNSIGNED_BYTE, 0, colors)
    GL.glDrawArrays(GL.GL_TRIANGLE_FAN, 0, 13)
    GL.glTranslatef(0.0, 0.0, 0.5)
    GL.glDrawElements(GL.GL_LINE_STRIP, 5, GL.GL_UNSIGNED_SHORT, numpy.array([0, 4, 8, 2, 6], "H"))
    GL.glDisableClientState(GL.GL_COLOR_ARRAY)
    GL.glDisableClientState(GL.GL_VERTEX_ARRAY)


def draw_buffer():
    """A triangle of a buffer object, blended."""
    data = numpy.array([-1.3, -1, 0, 1.3, -1, 0, 0, 1.4, 0.3], "f")
    name = GL.glGenBuffers(1)
    GL.glBindBuffer(GL.GL_ARRAY_BUFFER, name)
    GL.glBufferData(GL.GL_ARRAY_BUFFER, data.nbytes, data, GL.GL_STATIC_DRAW)
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, ctypes.c_void_p(0))
    GL.glEnable(GL.GL_BLEND)
    GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA)
    GL.glColor4f(0.9, 0.8, 0.1, 0.4)
    GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3)
    GL.glDisable(GL.GL_BLEND)
    GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
    GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)
    GL.glDeleteBuffers(1, [name])


def main():
    window = arrays.GLubyteArray.zeros((HEIGHT, WIDTH, 4))
    context = osmesa.OSMesaCreateContextExt(osmesa.OSMESA_RGBA, 24, 8, 0, None)
    assert osmesa.OSMesaMakeCurrent(context, window, GL.GL_UNSIGNED_BYTE, WIDTH, HEIGHT)
    images = []
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glClearColor(0.1, 0.2, 0.3, 1.0)
    for angle in (10.0, 75.0, 200.0):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        place_camera(angle)
        draw_immediate()
        draw_arrays()
        draw_buffer()
        GL.glFinish()
        images.append(window.tobytes())
        images.append(GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, outputType=bytes))
        images.append(GL.glReadPixels(3, 5, 40, 30, GL.GL_BGRA, GL.GL_FLOAT, outputType=bytes))
        images.append(GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_DEPTH_COMPONENT, GL.GL_FLOAT, outputType=bytes))
    images.append(GL.glGetFloatv(GL.GL_MODELVIEW_MATRIX).tobytes())
    osmesa.OSMesaDestroyContext(context)
    with open(sys.argv[1], "wb") as file:
        file.write(b"".join(images))


main()
