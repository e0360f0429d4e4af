"""Times a thousand pictures of 64x64 pixels, beside OSMesa through PyOpenGL.

usage: bench.py [--model FILE] [--views N] [--size PIXELS]

Without a model it draws a sphere of 2,304 triangles. The texture has stripes. Both sides draw the
textured mesh from cameras around it, and return colours and depths of every view as numpy arrays.
Another line compares the processor's time of normals and labels, of a smooth mesh, with that of colours
and depths. The last line is: bench-python: N views, A a second with one thread, B with T threads, OSMesa C,
ratios A/C and B/C.
"""

import argparse
import math
import os
import sys
import time

import numpy as np

import gnomon


def sphere():
    """Returns a sphere as a Mesh with texture coordinates."""
    rows, columns = 24, 48
    v, u = np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij")
    theta, phi = v * math.pi, u * 2 * math.pi
    points = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], -1)
    faces = []
    for row in range(rows):
        for column in range(columns):
            a = row * (columns + 1) + column
            b = a + columns + 1
            faces += [(a, a + 1, b), (a + 1, b + 1, b)]
    texcoords = np.stack([u, 1 - v], -1).reshape(-1, 2)
    return gnomon.Mesh(points.reshape(-1, 3), np.array(faces), texcoords=texcoords)


def model(path):
    """Returns the triangles of a file as a Mesh with texture coordinates and no colours."""
    mesh = gnomon.load(path, textures=False).merged()
    if mesh.texcoords is None:
        sys.exit(f"bench.py: {path}: has no texture coordinates")
    return gnomon.Mesh(mesh.vertices, mesh.faces, texcoords=mesh.texcoords)


def stripes():
    """Returns a picture of stripes."""
    image = np.zeros((256, 256, 4), np.uint8)
    image[:, :, 0] = np.arange(256)
    image[:, ::16] = 255
    image[..., 3] = 255
    return image


def views(count):
    """Returns the views of cameras around the origin."""
    angles = [2 * math.pi * n / count for n in range(count)]
    eyes = [(3 * math.cos(a), math.sin(5 * a), 3 * math.sin(a)) for a in angles]
    return np.stack([gnomon.look_at(eye, (0, 0, 0), (0, 1, 0)).matrix for eye in eyes])


def time_gnomon(mesh, image, projection, poses, size, threads):
    """Returns the seconds of the second of two runs, and the pictures."""
    texture = gnomon.Texture(image, "linear", "repeat")
    for _ in range(2):
        began = time.perf_counter()
        pictures = gnomon.render(
            mesh, projection=projection, pose=poses, texture=texture, shader="unlit", width=size,
            height=size, outputs=("color", "depth"), threads=threads,
        )
        seconds = time.perf_counter() - began
    return seconds, pictures


def outputs_ratio(mesh, projection, poses, size):
    """Returns the time of normals and labels over that of colours and depths, the least of six runs."""
    smooth = gnomon.Mesh(mesh.vertices, mesh.faces, normals=mesh.vertices)
    least = {}
    for outputs in 6 * [("color", "depth"), ("normals", "labels")]:
        began = time.process_time()
        gnomon.render(
            smooth, projection=projection, pose=poses, width=size, height=size, outputs=outputs, threads=1
        )
        least[outputs] = min(least.get(outputs, math.inf), time.process_time() - began)
    return least["normals", "labels"] / least["color", "depth"]


def time_osmesa(mesh, image, projection, poses, size):
    """Returns the seconds of the second of two runs, and the colours."""
    os.environ["PYOPENGL_PLATFORM"] = "osmesa"
    import OpenGL

    OpenGL.ERROR_CHECKING = False
    from OpenGL import GL, osmesa

    try:
        context = osmesa.OSMesaCreateContextAttribs(
            (osmesa.OSMESA_FORMAT, osmesa.OSMESA_RGBA, osmesa.OSMESA_DEPTH_BITS, 24, 0), None
        )
    except OpenGL.error.NullFunctionError:
        raise ImportError("libOSMesa.so.8 is not found") from None
    buffer = (GL.GLubyte * (size * size * 4))()
    if not osmesa.OSMesaMakeCurrent(context, buffer, GL.GL_UNSIGNED_BYTE, size, size):
        raise OSError("no context of OSMesa")
    vertices = np.concatenate([mesh.vertices, mesh.texcoords], axis=1).astype(np.float32)
    GL.glBindBuffer(GL.GL_ARRAY_BUFFER, GL.glGenBuffers(1))
    GL.glBufferData(GL.GL_ARRAY_BUFFER, vertices.nbytes, vertices, GL.GL_STATIC_DRAW)
    GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, GL.glGenBuffers(1))
    GL.glBufferData(
        GL.GL_ELEMENT_ARRAY_BUFFER, mesh.faces.nbytes, mesh.faces, GL.GL_STATIC_DRAW
    )
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glEnableClientState(GL.GL_TEXTURE_COORD_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 20, None)
    GL.glTexCoordPointer(2, GL.GL_FLOAT, 20, GL.GLvoidp(12))
    GL.glBindTexture(GL.GL_TEXTURE_2D, GL.glGenTextures(1))
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_LINEAR)
    flipped = np.ascontiguousarray(image[::-1])
    layout = GL.GL_RGBA if image.shape[2] == 4 else GL.GL_RGB
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
    GL.glTexImage2D(
        GL.GL_TEXTURE_2D, 0, layout, image.shape[1], image.shape[0], 0, layout,
        GL.GL_UNSIGNED_BYTE, flipped,
    )
    GL.glTexEnvi(GL.GL_TEXTURE_ENV, GL.GL_TEXTURE_ENV_MODE, GL.GL_REPLACE)
    GL.glEnable(GL.GL_TEXTURE_2D)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glClearColor(0, 0, 0, 0)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadMatrixf(np.ascontiguousarray(projection.matrix.T))
    GL.glMatrixMode(GL.GL_MODELVIEW)
    for _ in range(2):
        began = time.perf_counter()
        colors = np.empty((len(poses), size, size, 4), np.uint8)
        depths = np.empty((len(poses), size, size), np.float32)
        for n, pose in enumerate(poses):
            GL.glLoadMatrixf(np.ascontiguousarray(pose.T))
            GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
            GL.glDrawElements(GL.GL_TRIANGLES, mesh.faces.size, GL.GL_UNSIGNED_INT, None)
            GL.glReadPixels(0, 0, size, size, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, colors[n])
            GL.glReadPixels(0, 0, size, size, GL.GL_DEPTH_COMPONENT, GL.GL_FLOAT, depths[n])
        seconds = time.perf_counter() - began
    return seconds, colors[:, ::-1]


def main():
    """Runs the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--model", help="OBJ, PLY, STL or glTF; without it a sphere")
    parser.add_argument("--views", type=int, default=1000, help="pictures (1000)")
    parser.add_argument("--size", type=int, default=64, help="width and height (64)")
    options = parser.parse_args()
    mesh = model(options.model) if options.model else sphere()
    image, poses = stripes(), views(options.views)
    projection = gnomon.perspective(math.radians(45), 1.0, 0.5, 10.0)
    arguments = (mesh, image, projection, poses, options.size)
    threads = min(len(os.sched_getaffinity(0)), 64)
    one, pictures = time_gnomon(*arguments, 1)
    many, _ = time_gnomon(*arguments, threads)
    rates = [options.views / one, options.views / many]
    ratio = outputs_ratio(mesh, projection, poses[:100], options.size)
    print(f"normals and labels take {ratio:.2f} times as long as colours and depths")
    drawn = f"{options.views} views, {rates[0]:.0f} a second with one thread, "
    drawn += f"{rates[1]:.0f} with {threads} threads"
    try:
        peer, colors = time_osmesa(*arguments)
    except ImportError as error:
        print(f"bench-python: {drawn}, no OSMesa ({error})")
        return
    rate = options.views / peer
    equal = (np.abs(colors.astype(int) - pictures.color.astype(int)).max(axis=-1) <= 1).mean()
    if equal < 0.99:
        sys.exit(f"bench.py: only {100 * equal:.1f} % of the pixels are like OSMesa's")
    print(
        f"bench-python: {drawn}, OSMesa {rate:.0f}, ratios {rates[0] / rate:.2f} and "
        f"{rates[1] / rate:.2f}"
    )


if __name__ == "__main__":
    main()
