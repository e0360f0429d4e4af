/* The rows of the table of options. */
#include "option_table.h"

#include <string.h>

#include "image.h"

#define STILL (COMMAND_RENDER | COMMAND_COMPARE)
#define MODELS COMMANDS_OF_MODELS
#define PICTURES (MODELS | COMMAND_DEMO)
#define FILES (COMMAND_DIFF | COMMAND_INFO)
#define IMPORTS (MODELS | FILES)
#define ALL (PICTURES | FILES | COMMAND_TRANSFORM)

#define AT(member) .place = offsetof(options, member)
#define GIVEN(member) .given = offsetof(options, member)
#define VALUE(...)                                                                                 \
    {                                                                                              \
        .kind = __VA_ARGS__                                                                        \
    }
#define FLAG(member) VALUE(OPTION_FLAG, AT(member))
#define FILE_NAME(member) VALUE(OPTION_FILE, AT(member), .form = "a file name")
#define FORMAT VALUE(OPTION_FORMAT, AT(format), GIVEN(format_given))
#define SHADER VALUE(OPTION_SHADER, AT(shading), GIVEN(shading_given))
#define SAMPLES VALUE(OPTION_SAMPLES, AT(samples), GIVEN(samples_given), .form = "1 or 4")
#define SIZE VALUE(OPTION_SIZE, .form = "WIDTHxHEIGHT, as in 800x600")
#define MAP(which) VALUE(OPTION_MAP, AT(maps[which]), .form = "a file name, or none")
#define WHOLE_OF(words, member, from, to)                                                          \
    VALUE(OPTION_WHOLE, AT(member), .least = from, .most = to, .form = words)
#define WHOLE(member, from, to) WHOLE_OF("a whole number", member, from, to)
#define MEBIBYTES(member) WHOLE_OF("a whole number of MiB", member, 1, 1048576)
#define NUMBER(words, member, given) VALUE(OPTION_NUMBER, AT(member), GIVEN(given), .form = words)
#define VECTOR(kind, member)                                                                       \
    VALUE(kind, AT(member), GIVEN(member##_given), .form = "three numbers X,Y,Z")

#define FORMATS "png tga ppm"
#define SHADERS                                                                                    \
    "vertex-color unlit flat gouraud toon phong blinn-phong normals depth metallic-roughness"

#define HEADING(title, commands, brief, text)                                                      \
    title, NULL, commands, VALUE(OPTION_HEADING), NULL, brief, text

const option_row option_table[] = {
    {HEADING("All commands", ALL, NULL, NULL)},
    {"help", NULL, ALL, VALUE(OPTION_HELP),
     .text = "print the options, as gnomon help COMMAND does"},
    {"help-all", NULL, MODELS, VALUE(OPTION_HELP_ALL), .text = "explain every option"},
    {HEADING("Output", ALL, NULL, NULL)},
    {"output", "OUT", COMMAND_RENDER, FILE_NAME(output), "FILE",
     ".png, .tga, .ppm (no alpha) or .raw; - is standard output",
     "the picture, by its suffix: .png, .tga (uncompressed), .ppm, which has no alpha, or .raw: "
     "red, green, blue and alpha of 8 bits each, top row first, and nothing else. - is standard "
     "output; messages then go to standard error. It must be given"},
    {"output", "OUT", COMMAND_COMPARE, FILE_NAME(output), "FILE",
     "both pictures and the difference; default: bunny_compared.png for models/bunny.obj",
     "one picture (.png, .tga or .ppm), three times as wide: Gnomon's, OSMesa's and the "
     "difference. The difference is black where both are equal, amplified elsewhere, magenta "
     "where only alpha or depth differ. Default: the first model's name and _compared.png in the "
     "current directory. - is standard output; messages then go to standard error"},
    {"output", "OUT", COMMAND_DEMO, FILE_NAME(output), "FILE",
     "Gnomon's picture, OSMesa's and the difference, side by side; .png, .tga or .ppm; default: "
     "gnomon-demo.png. For this option and the next, - is standard output; messages then go to "
     "standard error",
     NULL},
    {"output", "OUT", COMMAND_SPIN, FILE_NAME(output), "FILE",
     "one animated PNG, or with %04d numbered frames: .png, .tga or .ppm; - is standard output; "
     "default: spin.png",
     "one animated PNG, or with %04d numbered frames, from 0 on: .png, .tga or .ppm; %% stands "
     "for a percent sign; - is standard output; default: spin.png"},
    {"output", "OUT", COMMAND_VIEW, FILE_NAME(output), "FILE",
     "where s saves: .png, .tga or .ppm; default: view.png", NULL},
    {"output", "HEAT", COMMAND_DIFF, FILE_NAME(output), "FILE",
     "a picture (.png, .tga or .ppm; - is standard output) of the largest difference at each "
     "pixel: black where A and B are equal, otherwise dark red, red, yellow to white for black "
     "beside white",
     NULL},
    {"picture", "OUT", COMMAND_DEMO, FILE_NAME(picture_output), "FILE", "Gnomon's picture alone",
     NULL},
    {"format", "NAME", COMMAND_RENDER, FORMAT, FORMATS " raw",
     "png, tga, ppm or raw, for an OUT without a suffix",
     "format of an OUT without a suffix, such as -: png, tga, ppm or raw; default: png"},
    {"format", "NAME", COMMAND_SPIN | COMMAND_DIFF, FORMAT, FORMATS,
     "format of an output without a suffix: png, tga or ppm; default: png", NULL},
    {"depth", "OUT.png", COMMAND_RENDER, FILE_NAME(depth_output), "FILE",
     "writes the depth too, as 16-bit grey",
     "writes the depth too, as 16-bit grey: 0 at the near plane, 65535 at the far plane"},
    {"axis", "AXIS", COMMAND_SPIN,
     VALUE(OPTION_AXIS, AT(axis), .form = "x, y, z, or three numbers X,Y,Z"), "x y z",
     "x, y, z or X,Y,Z; default: y", "the axis of the turn: x, y, z or X,Y,Z; default: y"},
    {"frames", "N", COMMAND_SPIN, WHOLE(frames, 1, 100000), NULL,
     "frames of the turn, 1 to 100000; default: 101", NULL},
    {"rate", "N", COMMAND_SPIN, WHOLE(rate, 1, 1000), NULL,
     "frames a second of an animated PNG, 1 to 1000; default: 25", NULL},
    {"pixel", "X,Y", COMMAND_EXPLAIN,
     VALUE(OPTION_PAIR, AT(pixel), .form = "two whole numbers X,Y"), NULL,
     "the pixel, from the left and from the top, from 0 on", NULL},
    {"primitive", "DRAW,PRIMITIVE", COMMAND_EXPLAIN,
     VALUE(OPTION_PAIR, AT(primitive), .form = "two whole numbers DRAW,PRIMITIVE"), NULL,
     "also tells why this one has no fragment there; from 0 on",
     "also tells why this primitive has no fragment at the pixel: it is outside, culled, too "
     "small, or an edge has the pixel on its other side. Both numbers count from 0, as the "
     "fragments of a pixel have them; the triangles of a material are a draw"},
    {"json", NULL, COMMAND_EXPLAIN, FLAG(json), NULL,
     "prints JSON instead of text, with rows from the bottom", NULL},
    {"state", "STATE", COMMAND_EXPLAIN, VALUE(OPTION_TEXT, AT(state)), NULL,
     "draws the web page's state, behind # in its address",
     "instead of models: the picture of a state of the web page, which is what its address has "
     "behind #; only --pixel, --primitive, --json and --backend go with it"},
    {"size", "WxH", COMMAND_RENDER, SIZE, NULL,
     "pixels; above 16384x16384 in tiles; default: 1024x1024",
     "size in pixels; default: 1024x1024. Pictures above 16384x16384, up to 1048576x1048576, are "
     "drawn in tiles, each with its part of the projection. Their pixels are not bit-equal to "
     "those of one large target: edges and colours may differ in their last bits"},
    {"size", "WxH", COMMAND_COMPARE | COMMAND_SPIN | COMMAND_EXPLAIN, SIZE, NULL,
     "size in pixels, up to 16384x16384; default: 1024x1024", NULL},
    {"size", "WxH", COMMAND_DEMO, SIZE, NULL, "size in pixels, up to 16384x16384; default: 800x600",
     NULL},
    {"size", "WxH", COMMAND_VIEW, SIZE, NULL, "size of the window; default: 800x600", NULL},
    {"script", "FILE", COMMAND_VIEW, FILE_NAME(script), "FILE",
     "plays events from a text, then ends; see --help-all",
     "plays events from a text, one a line, then ends: drag X Y (left button), pan X Y, wheel "
     "STEPS, key CHARACTER, resize WIDTH HEIGHT, wait MILLISECONDS. # begins a comment, at the "
     "beginning of a line or behind a blank; key # is the key"},
    {"sort", "NAME", COMMAND_RENDER, VALUE(OPTION_CHOICE, AT(sort)), "first last",
     "how ranks divide it: first, by rows, or last, by triangles",
     "how several ranks divide the picture, if mpirun or srun has started them; it has the same "
     "pixels in both ways.\n"
     "first (default), by rows: a rank has the memory of its rows and the whole model; for large "
     "pictures.\n"
     "last, by triangles: a rank has its part of the model, rank 0 while it reads all of it, and "
     "memory for the whole picture; for large models. What depends on the order of triangles is "
     "refused, such as --no-depth-test"},
    {"views", "FILE", COMMAND_RENDER, FILE_NAME(views), "FILE",
     "one picture for each line of camera options; OUT has %04d",
     "draws one picture for each line of FILE. A line has options of the camera, as in --eye "
     "0,1,5 --fov 30; those that it lacks are as on the command line. --fov of a line replaces "
     "--orthographic of the command line, and the other way round. # begins a comment. OUT, and "
     "that of --depth, is a pattern such as view_%04d.png, numbered from 0 on.\n"
     "If the command is built with MPI, mpirun -n 8 gnomon render ... divides the pictures among "
     "8 processes; the files are the same"},
    {"tessellation", "N", COMMAND_DEMO, WHOLE(tessellation, 1, 128), NULL,
     "segments along each side of a patch of the teapot, 1 to 128; default: 16", NULL},
    {"matrices", NULL, COMMAND_TRANSFORM, FLAG(matrices), NULL,
     "print the matrices of model, view, projection and viewport, and the first three combined, "
     "each with its inverse; for row vectors with direct3d",
     NULL},

    {HEADING("Camera", MODELS,
             "Camera; what is not given is chosen to show everything from the front, right "
             "and above:",
             "Without these options the picture shows everything, seen from +z, a little from "
             "the right and from above. If some are given, the others are chosen to fit.")},
    {"eye", "X,Y,Z", MODELS, VECTOR(OPTION_PLACE, camera.eye), NULL, "where it is",
     "position of the camera"},
    {"target", "X,Y,Z", MODELS, VECTOR(OPTION_PLACE, camera.target), NULL, "+what it looks at",
     "point that the camera looks at; default: the middle of the models"},
    {"up", "X,Y,Z", MODELS, VECTOR(OPTION_VECTOR, camera.up), NULL, "+what points up",
     "direction that points up in the picture; default: 0,1,0. Use 0,0,1 for models whose z axis "
     "points up; the camera is then towards -y"},
    {"from", "SIDE", MODELS, VALUE(OPTION_CHOICE, AT(camera.side), GIVEN(camera.side_given)),
     "front back left right top bottom iso", "front, back, left, right, top, bottom or iso",
     "side from which the camera looks, in place of --eye: front, back, left, right, top, bottom "
     "or iso, which is from the front, the right and above alike"},
    {"fov", "DEGREES", MODELS, NUMBER("a number of degrees", camera.fov_degrees, camera.fov_given),
     NULL, "vertical angle of view; default: 40", NULL},
    {"orthographic", "HEIGHT", MODELS,
     NUMBER("a height", camera.orthographic_height, camera.orthographic), NULL,
     "parallel projection of HEIGHT units of the model",
     "parallel projection; the picture is HEIGHT of the models' units high"},
    {"near", "DISTANCE", MODELS, NUMBER("a distance", camera.near, camera.near_given), NULL,
     "clipping planes; default: closely around the models",
     "distance of the near clipping plane from the eye, above 0 unless the projection is parallel"},
    {"far", "DISTANCE", MODELS, NUMBER("a distance", camera.far, camera.far_given), NULL, "+",
     "distance of the far clipping plane; default for both: the planes enclose the models closely"},

    {HEADING("Place", MODELS,
             "Place of the MODEL before it, in the order written; before the first MODEL, of "
             "all:",
             "A transformation applies to the MODEL before it on the command line; those "
             "before the first MODEL apply to all models. Transformations apply in the order "
             "written.")},
    {"rotate", "AXIS,DEGREES", MODELS,
     VALUE(OPTION_ROTATE, .form = "AXIS,DEGREES where AXIS is x, y, z or X,Y,Z"), NULL,
     "about x, y, z or X,Y,Z through the origin",
     "turns the model about an axis through the origin: x, y, z or X,Y,Z; counterclockwise for a "
     "viewer towards whom the axis points"},
    {"scale", "S", MODELS, VALUE(OPTION_SCALE, .form = "a number, or three numbers X,Y,Z"), NULL,
     "a factor or three", "multiplies the model's coordinates by S, or by X,Y,Z; not 0"},
    {"translate", "X,Y,Z", MODELS, VALUE(OPTION_TRANSLATE, .form = "three numbers X,Y,Z"), NULL,
     "+a distance", "moves the model"},

    {HEADING("Look", MODELS, "Look:", NULL)},
    {"shader", "NAME", MODELS, SHADER, SHADERS,
     "vertex-color, unlit, flat, gouraud, toon, phong, blinn-phong, normals, depth or "
     "metallic-roughness; default: what fits the material and --shadows",
     "the shader:\n"
     "vertex-color: the vertices' colours, without light\n"
     "unlit: the vertices' colours times the texture\n"
     "flat: lit, one normal per triangle\n"
     "gouraud: lit at the vertices\n"
     "toon: lit in bands\n"
     "phong: lit at every pixel, with maps and highlights\n"
     "blinn-phong: as phong, with Blinn's highlights\n"
     "normals: the normals as colours\n"
     "depth: the depth as grey\n"
     "metallic-roughness: glTF's material, with linear light\n"
     "default: metallic-roughness for glTF's materials, otherwise phong if there is a map, a "
     "highlight or --shadows, otherwise gouraud"},
    {"shader", "NAME", COMMAND_DEMO, SHADER, SHADERS,
     "a ready-made shader (gnomon render --help lists them), with maps made for the teapot; "
     "default: gouraud, with --shadows phong, both without maps",
     NULL},
    {"light", "X,Y,Z", MODELS, VECTOR(OPTION_VECTOR, light), NULL, "direction towards the light",
     "direction towards the light; default: the lights of a glTF file, scaled to one brightness, "
     "or over the viewer's left shoulder"},
    {"shadows", NULL, PICTURES, FLAG(shadows), NULL, "+shadows from it",
     "shadows from a shadow map, with flat, toon, phong, blinn-phong and metallic-roughness"},
    {"exponent", "N", PICTURES, WHOLE(exponent, 1, 1024), NULL, "size of highlights, 1 to 1024",
     "exponent of highlights, 1 to 1024: the greater, the smaller the highlight; default: the "
     "material's, otherwise 32"},
    {"bands", "N", PICTURES, WHOLE(bands, 2, 256), NULL, "+bands of toon, 2 to 256",
     "bands of toon, 2 to 256; default: 4"},
    {"crease", "DEGREES", MODELS,
     VALUE(OPTION_NUMBER, AT(crease_degrees), .form = "a number of degrees, 0 to 180"), NULL,
     "computed normals keep sharper edges; default: 40",
     "angle of creases, 0 to 180 degrees; default: 40. Where normals are computed, because the "
     "file has none, an edge stays sharp if the normals of its two triangles differ by more; with "
     "180 everything is smooth"},
    {"wireframe", NULL, MODELS, FLAG(wireframe), NULL, "draws edges",
     "draws only the edges of triangles, one pixel wide"},
    {"points", "[=SIZE]", MODELS, VALUE(OPTION_POINTS, .form = "a size in pixels, above 0"), NULL,
     "+or vertices SIZE pixels wide (default: 1)",
     "draws only the vertices of triangles, as squares SIZE pixels wide; default: 1. Points and "
     "lines of a model are drawn in any case, in this size"},
    {"edges", "[=COLOR]", MODELS, VALUE(OPTION_EDGES, .form = "#rrggbb or #rrggbbaa"), NULL,
     "lines where surfaces bend or end",
     "draws lines, one pixel wide, over the edges at which a surface bends or ends, but not over "
     "those between two triangles in one plane; surfaces hide the lines behind them. COLOR is "
     "rrggbb or rrggbbaa; default: 000000b3, and ffffffb3 on dark materials. Triangles are moved "
     "back a little for this, also in --depth. Not with --wireframe or --points"},
    {"grid", NULL, MODELS, FLAG(grid), NULL, "+grid on the ground",
     "draws a grid through the lowest point of the models, across the y axis, or across z with "
     "--up 0,0,1. Its lines are at multiples of 1, 2 or 5 times a power of ten, which is printed, "
     "and fade out around the models. Camera, depth and shadows are as without it"},
    {"cull", "SIDE", MODELS, VALUE(OPTION_CHOICE, AT(cull), GIVEN(cull_given)), "none back front",
     "leaves out back or front",
     "which side is left out: back, the triangles whose corners turn clockwise in the picture; "
     "front, the others; none; default: none, and back for glTF's one-sided materials"},
    {"no-depth-test", NULL, MODELS, FLAG(depth_test_disabled), NULL, "+later triangles cover all",
     "draws every triangle over those before it; depth is not written"},
    {"samples", "N", COMMAND_RENDER | COMMAND_SPIN | COMMAND_VIEW | COMMAND_EXPLAIN, SAMPLES, "1 4",
     "samples a pixel, 1 or 4; default: 4",
     "samples a pixel: 4, for smooth edges, or 1; default: 4, but 1 for pictures of more than "
     "4096x4096 pixels"},
    {"samples", "N", COMMAND_COMPARE | COMMAND_DEMO, SAMPLES, "1 4",
     "samples a pixel, 1 or 4; default: 1", "samples a pixel, 1 or 4; default: 1"},
    {"background", "COLOR", MODELS,
     VALUE(OPTION_BACKGROUND,
           .form = "#rrggbb or #rrggbbaa, or two of them with a comma between them"),
     NULL, "rrggbb or rrggbbaa, or TOP,BOTTOM; default: edeeef",
     "colour of the background: rrggbb or rrggbbaa, perhaps behind a #; default: edeeef. Two "
     "colours with a comma between them, as in ffffff,9aa4b0, are a gradient: the top row of "
     "pixels has the first colour, the bottom row the second, and rows between have colours in "
     "equal steps"},

    {HEADING("Maps", MODELS, NULL,
             "A shader uses the maps that it supports. A map is the file that an option "
             "names; otherwise the material's; otherwise MODEL_diffuse, MODEL_nm_tangent or "
             "else MODEL_nm, MODEL_spec and MODEL_glow with .tga, .png or .jpg, beside "
             "MODEL.obj. The maps in use are printed. The Exif orientation of a JPEG or PNG "
             "is not applied.")},
    {"texture", "FILE", MODELS, MAP(MAP_DIFFUSE), "FILE", "maps; none: without",
     "the diffuse map, " IMAGE_FORMATS_IN_WORDS "; none: no diffuse map"},
    {"specular-map", "FILE", MODELS, MAP(MAP_SPECULAR), "FILE", "+",
     "the map that scales highlights; none: no specular map"},
    {"glow-map", "FILE", MODELS, MAP(MAP_GLOW), "FILE", "+",
     "the map of light that the model emits; none: no glow map"},
    {"normal-map", "KIND", MODELS,
     VALUE(OPTION_NORMAL_MAP, .form = "any, tangent, world, none, tangent:FILE or world:FILE"),
     "any tangent world none", "any, tangent, world, none, tangent:FILE or world:FILE",
     "the normal map: any (default), of either space; tangent or world, of that space; "
     "tangent:FILE or world:FILE, this file; none, the vertices' normals"},
    {"normal-map", "KIND", COMMAND_DEMO, VALUE(OPTION_NORMAL_MAP), "tangent world none",
     "the normal map: tangent, world or none, for shaders with maps; default: tangent", NULL},
    {"filter", "NAME", PICTURES, VALUE(OPTION_CHOICE, AT(filter), GIVEN(filter_given)),
     "mipmap linear nearest", "mipmap, linear or nearest",
     "the filter of maps: mipmap (trilinear), linear or nearest; default: the model's, or else "
     "mipmap"},
    {"opaque", NULL, MODELS, FLAG(opaque), NULL, "+without translucency",
     "draws translucent materials as opaque ones. Without this option they are drawn last, from "
     "back to front by triangle"},

    {HEADING("Limits", IMPORTS, "Limits, speed:",
             "A child process imports each model and its maps, or each picture, and reads "
             "regular files only.")},
    {"import-seconds", "N", IMPORTS, WHOLE(limits.seconds, 1, 86400), NULL, "of each MODEL",
     "the most seconds that importing takes, 1 to 86400; default: 30"},
    {"import-memory", "N", IMPORTS, MEBIBYTES(limits.memory), NULL, "+",
     "the most memory of importing, in MiB, 1 to 1048576; default: 2048"},
    {"import-output", "N", IMPORTS, MEBIBYTES(limits.output), NULL, "+",
     "the most MiB of what is imported, 1 to 1048576; default: 1024"},
    {"map-pixels", "N", IMPORTS, WHOLE(limits.megapixels, 1, 256), NULL, "+",
     "the most pixels of a map or picture, in units of 1024x1024, 1 to 256; default: 64"},
    {HEADING("Speed, counts", MODELS, NULL, NULL)},
    {"backend", "NAME", MODELS, VALUE(OPTION_BACKEND, AT(backend)),
     "auto portable sse41 avx2 avx512 neon wasm-simd128",
     "the instruction set; all draw the same pixels",
     "the instruction set to draw with: auto, portable, sse41, avx2, avx512, neon or "
     "wasm-simd128; "
     "default: auto, the fastest available. All draw the same pixels"},
    {"statistics", NULL, STILL | COMMAND_DEMO, FLAG(statistics), NULL,
     "counts what became of triangles and pixels",
     "prints how many triangles were drawn, clipped, outside the view volume, culled and so on, "
     "and how many pixels they covered. Without this option, the command says why if nothing is "
     "drawn. It is refused with --views, with --sort last, over several ranks and for sizes above "
     "16384x16384"},
};
const size_t option_count = sizeof option_table / sizeof option_table[0];

char option_letter(const option_row *row)
{
    return row->value.kind == OPTION_HELP ? 'h' : strcmp(row->name, "output") == 0 ? 'o' : '\0';
}
