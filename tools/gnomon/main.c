/* The gnomon command: dispatch and the overview. */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "command.h"
#include "image.h"
#include "model_formats.h"
#include "report.h"

static const char overview[] =
    "gnomon: 3D models to pictures, by a software renderer whose every pixel is checked.\n"
    "\n"
    "  gnomon render MODEL -o OUT.png   draw a model\n"
    "  gnomon compare MODEL             draw it with OSMesa as well and count the pixels\n"
    "                                   that differ\n"
    "  gnomon demo                      do that with a teapot, which needs no model\n"
    "  gnomon transform < SETUP         where points are at every stage: local, world, view,\n"
    "                                   clip, NDC and pixel coordinates\n"
    "\n"
    "gnomon COMMAND --help explains a command and has examples. To see something at once:\n"
    "\n"
    "  gnomon demo --picture teapot.png\n"
    "\n"
    "Results go to standard output, errors and warnings to standard error, one line each,\n"
    "with the file or option they are about. Exit status: 0 success (compare, demo: the\n"
    "pictures are equal), 1 something is wrong with the input (or the pictures differ), 2 the\n"
    "command line, or transform's text, is not understood. An output file appears whole or\n"
    "not at all.\n";

static const char picture_help[] =
    "MODEL is a file in one of these formats, known by its extension:\n"
    "  " MODEL_FORMATS_IN_WORDS ".\n"
    "\n"
    "Camera (without any of these the whole model is framed, seen from +z, a little from\n"
    "the right and from above; what is not given is chosen to fit the rest):\n"
    "  --eye X,Y,Z             where the camera is\n"
    "  --target X,Y,Z          what it looks at; the middle of the model\n"
    "  --up X,Y,Z              what is up in the picture; 0,1,0. With 0,0,1, for models\n"
    "                          made that way, the view is from -y\n"
    "  --fov DEGREES           angle seen from bottom to top; 40\n"
    "  --orthographic HEIGHT   parallel projection; HEIGHT in the model's units is seen\n"
    "                          from bottom to top\n"
    "\n"
    "Shaders:\n"
    "  --shader NAME           vertex-color  the vertices' colours, without light\n"
    "                          unlit         these times the texture\n"
    "                          flat          lit, a normal for each triangle\n"
    "                          gouraud       lit at the vertices\n"
    "                          toon          lit in bands\n"
    "                          phong         lit at every pixel, with maps and highlights\n"
    "                          blinn-phong   the same with Blinn's highlights\n"
    "                          normals       the normals as colours\n"
    "                          depth         the depth as grey\n"
    "                          Without it: phong where there is a map, else gouraud\n"
    "  --shadows               of a shadow map; with flat, toon, phong and blinn-phong\n"
    "  --exponent N            of highlights, 1 to 1024: the more, the smaller; the\n"
    "                          material's, or 32\n"
    "  --bands N               of toon, 2 to 256; 4\n"
    "\n"
    "Maps, as far as the shader takes them, are those that the options name; otherwise the\n"
    "material's; otherwise MODEL_diffuse, MODEL_nm_tangent or else MODEL_nm, MODEL_spec and\n"
    "MODEL_glow, each .tga, .png or .jpg, beside MODEL.obj. What is used is printed.\n"
    "  --texture FILE          the diffuse map, " IMAGE_FORMATS_IN_WORDS ";\n"
    "                          none: the colours as they are\n"
    "  --normal-map KIND       any; tangent or world: those of that space alone, of a file\n"
    "                          with tangent:FILE or world:FILE; none: the vertices' normals\n"
    "  --specular-map FILE     what highlights are multiplied by; or none\n"
    "  --glow-map FILE         what shines by itself; or none\n"
    "  --filter NAME           mipmap, linear or nearest; mipmap, trilinear\n"
    "\n"
    "Look:\n"
    "  --light X,Y,Z           direction towards the light; over the viewer's left shoulder\n"
    "  --wireframe             the edges of triangles, one pixel wide\n"
    "  --samples 4             four samples a pixel: smooth edges; 1\n"
    "  --background COLOR      #rrggbb or #rrggbbaa (the # may be left out); #edeeef\n"
    "\n"
    "Limits of importing, which a child process does, from regular files alone:\n"
    "  --import-seconds N      time it may take; 30\n"
    "  --import-memory MIB     memory it may take; 2048\n"
    "  --import-output MIB     what the model and its maps may take, once imported; 1024\n"
    "  --map-pixels N          of one map, times 1024x1024, 1 to 256; 64\n"
    "\n"
    "Speed:\n"
    "  --backend NAME          the instruction set to draw with: auto, portable, sse2, avx2,\n"
    "                          avx512, neon or wasm-simd128; auto, the fastest there is. All\n"
    "                          give the same pixels\n"
    "\n"
    "Colours are the vertices', else the material's, else light grey; a diffuse map takes the\n"
    "place of the material's colour. Missing normals are computed, smooth over the model.\n"
    "A map that the material names but that is not there is an error; go on without it with\n"
    "--texture none and the like. What else cannot be drawn as the file has it is warned of:\n"
    "numbers that are not finite, material files that are missing, triangles without area.\n";

void print_picture_help(void)
{
    fputs(picture_help, stdout);
}

int finish_output(int status)
{
    if (fflush(stdout) != 0 || ferror(stdout) != 0)
        return report_fault("standard output", "cannot be written: %s", strerror(errno));
    return status;
}

/* Where memory is short, a scene's allocation calls exit, and a C++ library whose exception
 * nobody catches calls abort. The user still gets the command's own line and exit status. */
static const char ended_early[] = "gnomon: memory: most likely not enough; had to end early\n";
static bool finished;

static void explain_exit(void)
{
    if (!finished)
        fputs(ended_early, stderr);
}

static void explain_abort(int number)
{
    (void)number;
    ssize_t written = write(STDERR_FILENO, ended_early, sizeof ended_early - 1);
    (void)written;
    _exit(EXIT_FAULT);
}

static int run(int argc, char **argv)
{
    if (argc < 2)
        return report_usage("", "no command");
    if (strcmp(argv[1], "render") == 0)
        return command_render(argc - 1, argv + 1);
    if (strcmp(argv[1], "compare") == 0)
        return command_compare(argc - 1, argv + 1);
    if (strcmp(argv[1], "demo") == 0)
        return command_demo(argc - 1, argv + 1);
    if (strcmp(argv[1], "transform") == 0)
        return command_transform(argc - 1, argv + 1);
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 ||
        strcmp(argv[1], "help") == 0) {
        fputs(overview, stdout);
        return finish_output(0);
    }
    return report_usage("", "'%s': no such command", argv[1]);
}

/* Where standard input, output or error is closed, a file opened later would take its number and
 * be written to by mistake. What takes it instead cannot be written to, so that writing fails. */
static void occupy_standard_files(void)
{
    for (int i = 0; i < 3; i++) {
        if (fcntl(i, F_GETFD) == -1 && open("/dev/null", O_RDONLY) < 0)
            return;
    }
}

int main(int argc, char **argv)
{
    occupy_standard_files();
    atexit(explain_exit);
    signal(SIGABRT, explain_abort);
    int status = run(argc, argv);
    finished = true;
    return status;
}
