/* gnomon transform: the coordinates of points at every stage of the pipeline. */
#include "transform.h"

#include <errno.h>
#include <string.h>

#include "command.h"
#include "report.h"

static const char usage[] =
    "gnomon transform [--matrices] < SETUP: print where points are at every stage of the\n"
    "pipeline: local, world, view, clip and normalised device coordinates (NDC), and pixels.\n"
    "The output says which points are behind the eye or outside the view volume.\n"
    "\n"
    "  gnomon transform < setup.txt\n"
    "  gnomon transform --matrices setup.txt\n"
    "\n"
    "  --matrices    print the matrices of model, view, projection and viewport, and the first\n"
    "                three combined, each with its inverse; for row vectors with direct3d\n"
    "\n"
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
    "  far DISTANCE            distance of the far plane; far infinite: there is none\n"
    "  depth reversed          the near plane has the greater depth; default: depth plain\n"
    "  point X Y Z             a point of the model; there may be any number of points\n"
    "\n"
    "Required are convention, screen, near, far and one of perspective, frustum and\n"
    "orthographic. Pixel (i, j) is the square from (i, j) to (i + 1, j + 1), its centre at\n"
    "+0.5; the third pixel coordinate is the depth. Exit status: 0; 1 if a file cannot be\n"
    "read or written; 2 if the setup or the command line is wrong.\n";

/* Reads the setup's file name, where "-" is standard input, and whether matrices are asked for. */
static int parse(int argc, char **argv, const char **path, bool *with_matrices, bool *help)
{
    for (int i = 1; i < argc; ++i)
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0)
            *help = true;
        else if (strcmp(argv[i], "--matrices") == 0)
            *with_matrices = true;
        else if (argv[i][0] == '-' && argv[i][1] != '\0')
            return report_usage("transform", "'%s': unknown option", argv[i]);
        else if (*path != NULL)
            return report_usage("transform", "'%s': only one setup", argv[i]);
        else
            *path = argv[i];
    return 0;
}

static int read_setup(const char *path, setup *s)
{
    if (path == NULL || strcmp(path, "-") == 0)
        return transform_read(stdin, "standard input", s);
    FILE *in = fopen(path, "r");
    if (in == NULL)
        return report_fault(path, "%s", strerror(errno));
    int fault = transform_read(in, path, s);
    fclose(in);
    return fault;
}

int command_transform(int argc, char **argv)
{
    const char *path = NULL;
    bool with_matrices = false, help = false;
    int fault = parse(argc, argv, &path, &with_matrices, &help);
    if (fault != 0)
        return fault;
    if (help) {
        fputs(usage, stdout);
        return finish_output(0);
    }
    setup s;
    places p;
    memset(&s, 0, sizeof s);
    memset(&p, 0, sizeof p);
    fault = read_setup(path, &s);
    if (fault == 0 && s.points.count == 0 && !with_matrices)
        fault = transform_fault(s.file, 0, "no point");
    if (fault == 0)
        fault = transform_compute(&s, &p);
    if (fault == 0)
        transform_print(&s, &p, with_matrices);
    transform_places_free(&p);
    transform_setup_free(&s);
    return fault == 0 ? finish_output(0) : fault;
}
