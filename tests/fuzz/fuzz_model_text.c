/* The checks of OBJ and PLY files that run before Assimp reads them: any bytes are accepted,
 * perhaps with a warning, or refused with one line that names the file. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <string.h>

#include "fuzz.h"
#include "model_formats.h"
#include "report.h"

static int faults;

static void look_at_line(const char *line)
{
    FUZZ_REQUIRE(strncmp(line, "gnomon: model: ", 15) == 0);
    faults += strncmp(line + 15, "warning: ", 9) != 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size < 2)
        return -1;
    FILE *const file = fmemopen((void *)(bytes + 1), size - 1, "r");

    FUZZ_REQUIRE(file);
    faults = 0;
    report_to(look_at_line);
    const int fault =
        bytes[0] & 1 ? model_check_ply("model", file, size - 1) : model_check_obj("model", file);

    FUZZ_REQUIRE(faults == (fault != 0) && (fault == 0 || fault == EXIT_FAULT));
    fclose(file);
    return 0;
}
