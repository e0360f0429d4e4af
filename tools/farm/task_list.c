/* Reads the list of tasks. */
#include "task_list.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *read_whole(const char *path, size_t *size, char reason[REASON_SIZE])
{
    size_t room = 1 << 16;
    char *text = malloc(room);
    FILE *file = fopen(path, "rb");
    *size = 0;
    snprintf(reason, REASON_SIZE, "%s", file == NULL ? strerror(errno) : "not enough memory");
    while (file != NULL && text != NULL) {
        *size += fread(text + *size, 1, room - 1 - *size, file);
        if (ferror(file)) {
            snprintf(reason, REASON_SIZE, "%s", strerror(errno));
            break;
        }
        if (*size < room - 1) {
            fclose(file);
            text[*size] = '\0';
            reason[0] = '\0';
            return text;
        }
        room *= 2;
        char *larger = realloc(text, room);
        if (larger == NULL)
            free(text);
        text = larger;
    }
    if (file != NULL)
        fclose(file);
    free(text);
    return NULL;
}

static int compare(const void *a, const void *b)
{
    return strcmp((*(task *const *)a)->name, (*(task *const *)b)->name);
}

/* Divides a line. Returns what is wrong with it, or null. */
static const char *divide(char *line, task *found)
{
    char *tab = strchr(line, '\t');
    if (tab == line)
        return "no name before the tab";
    if (tab == NULL || tab[1 + strspn(tab + 1, " \t")] == '\0')
        return "a task is a name, a tab and a command";
    *tab = '\0';
    found->name = line;
    found->command = tab + 1;
    found->done = false;
    return NULL;
}

bool task_list_begin(task_list *list, char *text, size_t size, char reason[REASON_SIZE])
{
    size_t lines = 1, number = 0;
    *list = (task_list){text, NULL, NULL, 0};
    reason[0] = '\0';
    if (strlen(text) != size) {
        snprintf(reason, REASON_SIZE, "has a byte 0 at %zu", strlen(text));
        return false;
    }
    for (const char *c = text; *c != '\0'; ++c)
        lines += *c == '\n';
    list->tasks = malloc(lines * sizeof *list->tasks);
    list->by_name = malloc(lines * sizeof(task *));
    if (list->tasks == NULL || list->by_name == NULL) {
        snprintf(reason, REASON_SIZE, "not enough memory");
        return false;
    }
    for (char *line = text, *next; line != NULL; line = next) {
        next = strchr(line, '\n');
        if (next != NULL)
            *next++ = '\0';
        ++number;
        if (*line == '\0' || *line == '#')
            continue;
        const char *wrong = divide(line, &list->tasks[list->count]);
        if (wrong != NULL) {
            snprintf(reason, REASON_SIZE, "line %zu: %s", number, wrong);
            return false;
        }
        list->by_name[list->count] = &list->tasks[list->count];
        ++list->count;
    }
    qsort(list->by_name, list->count, sizeof(task *), compare);
    for (size_t i = 1; i < list->count; ++i)
        if (compare(&list->by_name[i - 1], &list->by_name[i]) == 0) {
            snprintf(reason, REASON_SIZE, "two tasks are called '%.400s'", list->by_name[i]->name);
            return false;
        }
    return true;
}

task *task_list_find(const task_list *list, const char *name, size_t length)
{
    size_t low = 0, high = list->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        const char *other = list->by_name[middle]->name;
        int order = strncmp(other, name, length);
        if (order == 0 && other[length] != '\0')
            order = 1;
        if (order == 0)
            return list->by_name[middle];
        if (order < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return NULL;
}

void task_list_end(task_list *list)
{
    free(list->text);
    free(list->tasks);
    free(list->by_name);
}
