/* What test_mutate.sh looks for mutations in. if (a < b) return 1; is a comment. */
#include <stdint.h>

#define LIMIT(x) ((x) < 3 && (x) > 1)

enum { ROOM = 8 };

typedef struct pair {
    int values[2];
    unsigned first : 3;
} pair;

_Static_assert(sizeof(int) == 4, "1 + 1 == 3");

static const float steps[3] = {0.0f, 0x1p-3f, 2.5f};

int chosen(const int *values, int count, int *sum)
{
    int copy[4] = {0}, found = -1;
    const char *const text = "a + b < 1";

    (void)text;
    *sum = 0;
    for (int i = 0; i < count; ++i) {
        *sum += values[i] * 2;
        if (values[i] == 7 && !copy[0])
            return i;
        copy[i % 4] = values[i] & 0xF;
    }
    switch (count) {
    case 3:
        found = count > 2 ? -found : ~found;
        break;
    default:
        found = 1;
    }
    while (found > 0)
        --found;
    return found;
}
