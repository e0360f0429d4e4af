/* gnomon transform: the coordinates of points at every stage of the pipeline. */
#include "transform.h"

#include <errno.h>
#include <getopt.h>
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
    "  far DISTANCE            distance of the far plane, beyond near; far infinite: none\n"
    "  depth reversed          the near plane has the greater depth; default: depth plain\n"
    "  point X Y Z             a point of the model; there may be any number of points\n"
    "\n"
    "Required are convention, screen, near, far and one of perspective, frustum and\n"
    "orthographic. Pixel (i, j) is the square from (i, j) to (i + 1, j + 1), its centre at\n"
    "+0.5; the third pixel coordinate is the depth. Exit status: 0; 1 if a file cannot be\n"
    "read or written; 2 if the setup or the command line is wrong.\n";

/* What getopt_long returns for --matrices: no letter. */
enum { OPTION_MATRICES = 256 };

/* What the command line says. */
typedef struct asked {
    const char *path; /* the setup; null or "-": standard input */
    bool with_matrices, help;
} asked;

/* Takes a word that is no option. */
static int take_word(const char *word, asked *result)
{
    if (*word == '\0')
        return report_usage("transform", "'': an empty file name");
    if (result->path != NULL)
        return report_usage("transform", "'%s': only one setup", word);
    result->path = word;
    return 0;
}

/* Reads the command line; returns 0, or EXIT_USAGE with the reason printed. */
static int parse(int argc, char **argv, asked *result)
{
    static const struct option options[] = {{"help", no_argument, NULL, 'h'},
                                            {"matrices", no_argument, NULL, OPTION_MATRICES},
                                            {NULL, 0, NULL, 0}};
    int fault = 0;
    opterr = 0;
    optind = 1;
    while (fault == 0) {
        /* An unknown letter alone leaves optind at its word, so the word is remembered. */
        const int word = optind < argc ? optind : argc - 1;
        const int option = getopt_long(argc, argv, "-h", options, NULL);
        if (option == -1)
            break;
        if (option == 'h') {
            result->help = true;
            return 0;
        }
        if (option == OPTION_MATRICES)
            result->with_matrices = true;
        else if (option == '?')
            return report_usage("transform", "%s '%s'",
                                optopt == 'h' || optopt == OPTION_MATRICES ? "no value allowed in"
                                                                           : "unknown option",
                                argv[optind > word ? optind - 1 : word]);
        else
            fault = take_word(optarg, result);
    }
    for (; optind < argc && fault == 0; ++optind) /* behind -- */
        fault = take_word(argv[optind], result);
    return fault;
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
    asked line = {NULL, false, false};
    int fault = parse(argc, argv, &line);
    if (fault != 0)
        return fault;
    if (line.help) {
        fputs(usage, stdout);
        return finish_output(0);
    }
    setup s;
    places p;
    memset(&s, 0, sizeof s);
    memset(&p, 0, sizeof p);
    fault = read_setup(line.path, &s);
    if (fault == 0 && s.points.count == 0 && !line.with_matrices)
        fault = transform_fault(s.file, 0, "no point");
    if (fault == 0)
        fault = transform_compute(&s, &p);
    if (fault == 0)
        transform_print(&s, &p, line.with_matrices);
    transform_places_free(&p);
    transform_setup_free(&s);
    return fault == 0 ? finish_output(0) : fault;
}
