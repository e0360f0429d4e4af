/* The rows of the table of commands. */
#include "command_table.h"

#include "image.h"
#include "model_formats.h"

const command_row command_table[] = {
    {COMMAND_RENDER, "render", "MODEL... -o OUT", "draw models", "draw models.",
     "  gnomon render head.obj -o head.png --size 1920x1080 --eye 0,0.5,3 --fov 35\n"
     "  gnomon render part.stl -o part.tga --up 0,0,1 --orthographic 120 --shader flat\n"
     "  gnomon render car.glb tree.obj --scale 2 --translate 3,0,0 -o both.png\n"
     "  gnomon render head.obj --views around.txt -o head_%04d.png\n"
     "  mpirun -n 4 gnomon render city.ply -o city.png --size 40000x30000",
     NULL,
     "If the command is built for MPI (make mpi), it draws one picture over the processes that "
     "mpirun or srun has started, its ranks. Over ranks the model is read once, by rank 0, and all "
     "ranks write the file, which must be on a disk that they share. TGA, PPM and raw files have "
     "the bytes of one process. A PNG has its pixels, and bytes that do not depend on the number "
     "of ranks; those that one process without mpirun writes may be others. The memory of a rank "
     "is printed.",
     "0: drawn; 1: a model, an output or an impossible value is at fault; 2: wrong usage."},
    {COMMAND_COMPARE, "compare", "MODEL... [-o OUT]",
     "draw models with Gnomon and with OSMesa, and count the pixels that differ",
     "draw models with Gnomon and with OSMesa, Mesa's software OpenGL, and count the pixels that "
     "differ in any bit of colour or depth.",
     "  gnomon compare bunny.obj\n"
     "  gnomon compare head.obj -o head_compared.png --eye 0,0.5,3 --size 512x512",
     NULL,
     "If OSMesa is not installed, or the environment has REFERENCE=egl, the same Mesa draws "
     "through EGL.",
     "0: no pixel differs; 1: some do, or a file or an impossible value is at fault; 2: wrong "
     "usage."},
    {COMMAND_DEMO, "demo", "[-o OUT]", "compare pictures of a teapot; needs no model",
     "draw the Utah teapot, tessellated from Newell's Bezier patches, with Gnomon and with OSMesa, "
     "and count the pixels that differ in any bit.",
     "  gnomon demo\n"
     "  gnomon demo --picture teapot.png --tessellation 32 --size 1600x1200",
     NULL, NULL,
     "0: no pixel differs; 1: some do, or an output or an impossible value is at fault; 2: wrong "
     "usage."},
    {COMMAND_SPIN, "spin", "[MODEL...] [-o OUT]",
     "turn models, or a triangle: frames or one animated PNG",
     "turn models, or a plain triangle, once about an axis through their middle. The triangle's "
     "default shader: vertex-color.",
     "  gnomon spin                                          # the triangle, to spin.png\n"
     "  gnomon spin head.obj --axis y -o frame_%04d.png      # frame_0000.png and so on",
     NULL,
     "A progress bar is shown on terminals. Frame I shows the models turned by I / N of a circle, "
     "counterclockwise for a viewer towards whom the axis points. Without a model, maps are "
     "refused. The command prints how many frames it draws in a second, not counting the writing "
     "of files. If it is built with MPI, mpirun -n 8 gnomon spin ... divides the frames among 8 "
     "processes, on one machine or on several that share the directory of the output; the files "
     "are the same. Rank 0 alone reads models and maps, and also prints how many frames the ranks "
     "drew and how much memory each of them took at most. If a rank fails, the others end too.",
     "0: drawn; 1: a model, an output or an impossible value is at fault; 2: wrong usage. An "
     "interrupted run leaves no incomplete file."},
    {COMMAND_VIEW, "view", "MODEL...", "look at models from all sides, in a window",
     "look at models from all sides, in a window.", "  gnomon view head.obj --shader toon",
     "  left button, arrows     turn around the target\n"
     "  other buttons, shift    move sideways\n"
     "  wheel, + and -          zoom\n"
     "  1 to 9, 0               shaders, in the order of --shader; 0: the default\n"
     "  w, p, e, g              wireframe, points, edges, grid: on or off\n"
     "  c, h, m                 culling, shadows, four samples: on or off\n"
     "  r, s, ?                 the first view again; save the picture; print these keys\n"
     "  q, Escape               end",
     "s also prints the options with which gnomon render draws what is saved, as with ...; they "
     "come behind those of this command. Maps that the shader lacks are taken back, as in "
     "--specular-map none. If a line says without, the options that it names, such as --shadows, "
     "must be left out. SDL2 is opened at run time.",
     "0: ended by the user; 1: a model or the window failed; 2: wrong usage."},
    {COMMAND_DIFF, "diff", "A B [-o HEAT]", "count the pixels in which pictures differ",
     "count the pixels in which two pictures differ, in red, green, blue and alpha. A picture "
     "without alpha counts as opaque.",
     "  gnomon diff before.png after.png\n"
     "  gnomon diff expected.ppm drawn.tga -o heat.png",
     "A and B are " IMAGE_FORMATS_IN_WORDS
     " files. For each channel it prints how many pixels differ, "
     "the largest difference and the mean, in steps of 1/255; if a picture has 16 bits a channel, "
     "of 1/65535.",
     NULL,
     "0: the pictures are equal; 1: they differ; 2: they cannot be compared, since a file cannot "
     "be read or written, their sizes differ, or the command line is wrong."},
    {COMMAND_INFO, "info", "FILE...", "say what is in models and pictures",
     "say what is in models and pictures, at most 64.", "  gnomon info head.obj head_diffuse.tga",
     "For a model it prints triangles, lines, points, vertices, bounds, attributes, materials in "
     "use, draws, and the maps that gnomon render would use; for a picture size, channels and "
     "bits. A model is known by its extension, a picture by its contents. Both are read as gnomon "
     "render reads them.",
     NULL,
     "0: all files were read; 1: a file cannot be read, or an impossible value is at fault; 2: "
     "wrong usage."},
    {COMMAND_EXPLAIN, "explain", "MODEL... --pixel X,Y",
     "take a pixel apart: every value on the way to it", "take a pixel apart.",
     "  gnomon explain head.obj --pixel 512,400 --shader phong\n"
     "  gnomon explain part.stl --pixel 10,20 --size 64x48 --json > pixel.json",
     "Draws the models as gnomon render does with the same options, and prints every value on the "
     "way to one pixel, with its bits and the expression that made it: the vertices of each "
     "triangle that covers the pixel at every stage, clipping, edge functions, barycentric "
     "coordinates, depth and its test, what is interpolated, texels, shader, the stored word.",
     "The library's own stages are compiled once more for this, over numbers that remember how "
     "they were computed. All that is printed is computed anew from its operands, and the pixel is "
     "compared with that of the picture.",
     "0: explained; 1: a model or an impossible value is at fault, or a check failed; 2: wrong "
     "usage."},
    {COMMAND_TRANSFORM, "transform", "[--matrices] < SETUP",
     "print where points are at every stage: local, world, view, clip, NDC and pixel coordinates",
     "print where points are at every stage of the pipeline: local, world, view, clip and "
     "normalised device coordinates (NDC), and pixels. The output says which points are behind the "
     "eye or outside the view volume.",
     "  gnomon transform < setup.txt\n"
     "  gnomon transform --matrices setup.txt",
     "SETUP holds one statement per line, in any order; # starts a comment:\n"
     "  convention opengl       right-handed, the camera looks along -z, depth -1..1,\n"
     "                          pixel rows from the bottom\n"
     "  convention direct3d     left-handed, the camera looks along +z, depth 0..1,\n"
     "                          pixel rows from the top\n"
     "  convention vulkan       right-handed, the camera looks along -z, depth 0..1,\n"
     "                          clip y down, pixel rows from the top\n"
     "  screen WIDTH HEIGHT     size of the window in pixels\n"
     "  scale X Y Z             the model is scaled (scale S: by one factor),\n"
     "  rotate X Y Z DEGREES    then turned about each axis, in the order of the lines,\n"
     "  translate X Y Z         then moved\n"
     "  position X Y Z          position of the camera in the world; default: 0 0 0\n"
     "  target X Y Z            point that the camera looks at; default: straight ahead along z\n"
     "  up X Y Z                direction that points up; default: 0 1 0\n"
     "  right X Y Z             right, up and forward in place of target: the camera's axes,\n"
     "  forward X Y Z           perpendicular, of any length\n"
     "  perspective DEGREES     what the camera sees: the vertical angle of view,\n"
     "  frustum L R B T         or a rectangle at the near distance,\n"
     "  orthographic L R B T    or a box\n"
     "  near DISTANCE           distance of the near plane from the camera\n"
     "  far DISTANCE            distance of the far plane, beyond near; far infinite: none\n"
     "  depth reversed          the near plane has the greater depth; default: depth plain\n"
     "  point X Y Z             a point of the model; there may be any number of points\n"
     "\n"
     "Required are convention, screen, near, far and one of perspective, frustum and orthographic. "
     "Pixel (i, j) is the square from (i, j) to (i + 1, j + 1), its centre at +0.5; the third "
     "pixel coordinate is the depth.",
     NULL,
     "0; 1 if a file cannot be read or written; 2 if the setup or the command line is wrong."},
};
const size_t command_count = sizeof command_table / sizeof command_table[0];

const command_row *command_row_of(command which)
{
    const command_row *row = command_table;
    while (row->which != which)
        ++row;
    return row;
}

const char *command_name(command which)
{
    return command_row_of(which)->name;
}

const char command_models[] =
    "Each MODEL is a file in one of these formats, recognised by its "
    "extension: " MODEL_FORMATS_IN_WORDS ". A command takes at most 64 of them.";

const char command_drawing[] =
    "Colours are the material's times the vertices' times the diffuse map's; without any of them "
    "light grey. Missing normals are computed as the format says. Points and lines have the size "
    "that --points gives, and are not lit if they have no normals. If a map that the material "
    "names is missing, that is an error; to draw without the map, use --texture none and the like. "
    "The command warns of everything else that it cannot draw as the file says; the guide lists "
    "what it draws of each format (tools/guide/models.md).";

const char command_results[] =
    "Results go to standard output; errors and warnings go to standard error, one line each, which "
    "names the file or option, in colour on terminals unless NO_COLOR is set. An output file is "
    "written completely or not at all.";

const char command_statuses[] =
    "0: success;\n"
    "1: an input, an output or an impossible value is at fault, or pictures that are compared "
    "differ;\n"
    "2: wrong usage, a wrong text for transform, or pictures that diff cannot compare.";
