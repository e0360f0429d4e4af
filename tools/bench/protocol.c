/* Reading from the pipes and writing to them. */
#include "protocol.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

static const char *const kind_names[RENDERER_COUNT] = {"gnomon", "shipped", "tuned", "tuned-2",
                                                       "pinned"};

const char *renderer_kind_name(renderer_kind kind)
{
    return kind_names[kind];
}

renderer_kind renderer_kind_of(const char *name)
{
    int kind = 0;

    while (kind < RENDERER_COUNT && strcmp(name, kind_names[kind]) != 0)
        ++kind;
    return (renderer_kind)kind;
}

bool protocol_write(int file, const void *data, size_t size)
{
    const char *at = data;

    while (size > 0) {
        const ssize_t done = write(file, at, size);

        if (done < 0 && errno == EINTR)
            continue;
        if (done <= 0)
            return false;
        at += done;
        size -= (size_t)done;
    }
    return true;
}

bool protocol_read(int file, void *data, size_t size)
{
    char *at = data;

    while (size > 0) {
        const ssize_t done = read(file, at, size);

        if (done < 0 && errno == EINTR)
            continue;
        if (done <= 0)
            return false;
        at += done;
        size -= (size_t)done;
    }
    return true;
}
