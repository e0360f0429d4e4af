/* How far a word is from another. */
#include "edit_distance.h"

#include <stdlib.h>
#include <string.h>

/* With at most two edits, a character's place differs by at most two, so that five columns of each
 * row suffice. */
int edit_distance(const char *a, const char *b)
{
    enum { FAR = EDIT_DISTANCE_FAR, BAND = FAR - 1, WIDTH = 2 * BAND + 1 };
    const int length_a = (int)strlen(a), length_b = (int)strlen(b);
    int row[WIDTH + 1]; /* row[k] belongs to the first i of a, and the first i + k - BAND of b */
    if (abs(length_a - length_b) > BAND)
        return FAR;
    for (int k = 0; k < WIDTH; ++k)
        row[k] = k >= BAND ? k - BAND : FAR;
    row[WIDTH] = FAR;
    for (int i = 1; i <= length_a; ++i) {
        for (int k = 0; k < WIDTH; ++k) {
            const int j = i + k - BAND;
            int least = FAR;
            if (j >= 0 && j <= length_b) {
                const int removed = row[k + 1] + 1;
                const int inserted = j > 0 && k > 0 ? row[k - 1] + 1 : FAR;
                const int replaced = j > 0 ? row[k] + (a[i - 1] != b[j - 1]) : FAR;
                least = removed < inserted ? removed : inserted;
                least = replaced < least ? replaced : least;
            }
            row[k] = least < FAR ? least : FAR;
        }
    }
    return row[length_b - length_a + BAND];
}

const char *edit_distance_nearer(const char *word, const char *best, const char *name)
{
    const int edits = edit_distance(word, name);
    if (edits == EDIT_DISTANCE_FAR || strlen(name) <= 2 * (size_t)edits)
        return best;
    return best == NULL || edits < edit_distance(word, best) ? name : best;
}
