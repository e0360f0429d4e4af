/* gnomon transform: the coordinates of points at every stage of the pipeline. */
#include "transform.h"

#include <errno.h>
#include <string.h>

#include "command.h"
#include "help.h"
#include "report.h"

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
    options o;
    int fault;
    options_result result = options_parse(COMMAND_TRANSFORM, argc, argv, &o, &fault);
    if (result == OPTIONS_HELP)
        return help_print(COMMAND_TRANSFORM, false);
    if (result == OPTIONS_WRONG)
        return fault;
    setup s;
    places p;
    memset(&s, 0, sizeof s);
    memset(&p, 0, sizeof p);
    fault = read_setup(o.model, &s);
    if (fault == 0 && s.points.count == 0 && !o.matrices)
        fault = transform_fault(s.file, 0, "no point");
    if (fault == 0)
        fault = transform_compute(&s, &p);
    if (fault == 0)
        transform_print(&s, &p, o.matrices);
    transform_places_free(&p);
    transform_setup_free(&s);
    return fault == 0 ? finish_output(0) : fault;
}
