/* Hands out numbered tasks. */
#define _POSIX_C_SOURCE 200809L
#include "tasks.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "progress.h"
#include "ranks.h"
#include "report.h"

/* Kinds of messages. */
enum { KIND_ASK = 20, KIND_ANSWER, KIND_RESULT, KIND_RESULT_BYTES };

/* To rank 0: a rank asks for a task, or says that it has ended. */
typedef struct ask {
    uint32_t done; /* since the last time */
    uint32_t ended;
    int32_t status;
} ask;

/* From rank 0: a task, or that there is none, or that all have ended. */
typedef struct answer {
    uint32_t has_task;
    uint32_t number;
    int32_t status;
} answer;

/* To rank 0, before the bytes of a result. */
typedef struct result_header {
    uint64_t number, size;
    uint64_t status; /* of the rank; not 0: there is nothing to take */
} result_header;

/* Results wait at rank 0 for those before them. No task is handed out that is further than this
 * from the first result that is missing, so a rank that is twice as slow as others holds nobody
 * up, and rank 0 holds at most so many results for each rank. */
#define RESULTS_EACH 4u

/* Bytes of a result that are sent at a time. */
#define PIECE 65536u

struct tasks {
    const tasks_job *job;
    uint32_t here; /* done by this rank */
    int status;    /* of this rank; at rank 0, the largest that it knows */

    /* Rank 0 alone uses these. */
    uint32_t handed; /* tasks below this one have been handed out */
    uint32_t done;
    uint32_t going; /* other ranks that have not ended */
    bool *asking;   /* ranks that wait for an answer until results have come */
    uint32_t asking_count;
    task_result *results; /* of task N at N modulo their number */
    bool *has_result;
    uint32_t results_most, taken; /* results below this one have been taken */
    uint32_t announced, received; /* results of other ranks */
    bool polling;
    progress bar;
};

/* Whoever waits leaves the processor to others: launchers may start more ranks than there are
 * processors. */
static void nap(void)
{
    const struct timespec time = {0, 100000};
    nanosleep(&time, NULL);
}

static void note_status(tasks *t, int status)
{
    if (status > t->status)
        t->status = status;
}

/* Rank 0's side. */

static bool has_tasks_left(const tasks *t)
{
    return t->status == 0 && t->handed < t->job->count;
}

static bool may_hand_out(const tasks *t)
{
    return has_tasks_left(t) && (t->job->take == NULL || t->handed - t->taken < t->results_most);
}

static void answer_rank(tasks *t, uint32_t to)
{
    answer a = {0, 0, 0};
    if (has_tasks_left(t) && !may_hand_out(t)) {
        t->asking[to] = true;
        ++t->asking_count;
        return;
    }
    if (has_tasks_left(t)) {
        a.has_task = 1;
        a.number = t->handed++;
    }
    ranks_send(to, KIND_ANSWER, &a, sizeof a);
}

/* Answers those that waited for results. */
static void answer_again(tasks *t)
{
    for (uint32_t i = 1; t->asking_count > 0 && i < ranks_count(); ++i) {
        if (!t->asking[i])
            continue;
        if (has_tasks_left(t) && !may_hand_out(t))
            return;
        t->asking[i] = false;
        --t->asking_count;
        answer_rank(t, i);
    }
}

static void show_progress(tasks *t)
{
    progress_show(&t->bar, t->done, t->job->count);
}

static void take_ask(tasks *t, uint32_t from)
{
    ask a;
    ranks_receive(from, KIND_ASK, &a, sizeof a);
    t->done += a.done;
    if (t->job->take != NULL)
        t->announced += a.done;
    note_status(t, a.status);
    if (a.ended)
        --t->going;
    else
        answer_rank(t, from);
}

/* Takes the results whose turn it is. */
static void take_in_order(tasks *t)
{
    for (;;) {
        const uint32_t slot = t->taken % t->results_most;
        task_result *result = t->results + slot;
        if (!t->has_result[slot])
            return;
        if (t->status == 0)
            note_status(t, t->job->take(t->job->context, t->taken, result));
        free(result->bytes);
        result->bytes = NULL;
        t->has_result[slot] = false;
        ++t->taken;
    }
}

static void keep_result(tasks *t, uint32_t number, const task_result *result)
{
    const uint32_t slot = number % t->results_most;
    if (number < t->taken || number >= t->handed || t->has_result[slot]) {
        free(result->bytes);
        note_status(t, report_fault("tasks", "task %u was done twice", (unsigned)number));
        return;
    }
    t->results[slot] = *result;
    t->has_result[slot] = true;
}

/* Receives a result. It is dropped if there is no memory for it. */
static void take_result(tasks *t, uint32_t from)
{
    static uint8_t dropped[PIECE];
    result_header header;
    ranks_receive(from, KIND_RESULT, &header, sizeof header);
    note_status(t, (int)header.status);
    task_result result = {malloc(header.size > 0 ? (size_t)header.size : 1), header.size};
    for (uint64_t at = 0; at < header.size; at += PIECE) {
        const uint64_t left = header.size - at, size = left < PIECE ? left : PIECE;
        ranks_receive(from, KIND_RESULT_BYTES, result.bytes != NULL ? result.bytes + at : dropped,
                      size);
    }
    ++t->received;
    if (result.bytes != NULL)
        keep_result(t, (uint32_t)header.number, &result);
    else
        note_status(
            t, report_fault("tasks", "not enough memory for a result of rank %u", (unsigned)from));
}

void tasks_poll(tasks *t)
{
    uint32_t from;
    if (ranks_number() != 0 || ranks_count() == 1 || t->polling)
        return;
    t->polling = true;
    while (ranks_waits(KIND_RESULT, &from))
        take_result(t, from);
    if (t->job->take != NULL)
        take_in_order(t);
    while (ranks_waits(KIND_ASK, &from))
        take_ask(t, from);
    answer_again(t);
    show_progress(t);
    t->polling = false;
}

/* Does a task at this rank. */
static void do_task(tasks *t, uint32_t number, task_result *result)
{
    memset(result, 0, sizeof *result);
    note_status(t, t->job->work(t->job->context, t, number, result));
    ++t->here;
}

static void lead(tasks *t)
{
    while (has_tasks_left(t)) {
        task_result result;
        tasks_poll(t);
        if (!may_hand_out(t)) {
            nap();
            continue;
        }
        const uint32_t number = t->handed++;
        do_task(t, number, &result);
        ++t->done;
        if (t->job->take == NULL)
            continue;
        keep_result(t, number, &result);
        take_in_order(t);
    }
    /* The last results may come after the word that their rank has ended. */
    while (t->going > 0 || t->received < t->announced) {
        tasks_poll(t);
        nap();
    }
    tasks_poll(t);
    if (t->status == 0 && t->done != t->job->count)
        note_status(t, report_fault("tasks", "%u of %u were done", (unsigned)t->done,
                                    (unsigned)t->job->count));
    const answer over = {0, 0, t->status};
    for (uint32_t i = 1; i < ranks_count(); ++i)
        ranks_send(i, KIND_ANSWER, &over, sizeof over);
}

/* The other ranks' side. */

static void send_ask(const tasks *t, uint32_t done, bool ended)
{
    const ask a = {done, ended, t->status};
    ranks_send(0, KIND_ASK, &a, sizeof a);
}

static answer receive_answer(void)
{
    answer a;
    uint32_t from;
    while (!ranks_waits(KIND_ANSWER, &from))
        nap();
    ranks_receive(from, KIND_ANSWER, &a, sizeof a);
    return a;
}

static void send_result(const tasks *t, uint32_t number, const task_result *result)
{
    const result_header header = {number, result->size, (uint64_t)t->status};
    ranks_send(0, KIND_RESULT, &header, sizeof header);
    for (uint64_t at = 0; at < result->size; at += PIECE) {
        const uint64_t left = result->size - at;
        ranks_send(0, KIND_RESULT_BYTES, result->bytes + at, left < PIECE ? left : PIECE);
    }
}

static void follow(tasks *t)
{
    uint32_t told = 0; /* of the tasks done here */
    send_ask(t, 0, false);
    answer next = receive_answer();
    while (next.has_task && t->status == 0) {
        task_result result;
        send_ask(t, t->here - told, false);
        told = t->here;
        do_task(t, next.number, &result);
        if (t->status != 0)
            result.size = 0; /* what a task that failed has made is not taken */
        if (t->job->take != NULL)
            send_result(t, next.number, &result);
        free(result.bytes);
        next = receive_answer();
    }
    send_ask(t, t->here - told, true);
    t->status = receive_answer().status;
}

static int begin(const tasks_job *job, tasks *t)
{
    memset(t, 0, sizeof *t);
    t->job = job;
    t->results_most = RESULTS_EACH * ranks_count();
    if (ranks_number() > 0)
        return 0;
    t->going = ranks_count() - 1;
    t->asking = calloc(ranks_count(), sizeof *t->asking);
    t->results = calloc(t->results_most, sizeof *t->results);
    t->has_result = calloc(t->results_most, sizeof *t->has_result);
    if (ranks_count() > 1)
        progress_begin_lines(&t->bar);
    else
        progress_begin(&t->bar);
    return t->asking != NULL && t->results != NULL && t->has_result != NULL
               ? 0
               : report_fault("tasks", "not enough memory");
}

/* A process that is alone. */
static void do_all(tasks *t)
{
    for (uint32_t i = 0; i < t->job->count && t->status == 0; ++i) {
        task_result result;
        do_task(t, i, &result);
        if (t->status == 0 && t->job->take != NULL)
            note_status(t, t->job->take(t->job->context, i, &result));
        free(result.bytes);
        t->done = i + 1;
        show_progress(t);
    }
}

int tasks_run(const tasks_job *job, uint32_t *here)
{
    tasks t;
    t.status = 0;
    int fault = ranks_agree(begin(job, &t));
    if (fault != 0)
        t.status = fault;
    else if (ranks_count() == 1)
        do_all(&t);
    else if (ranks_number() == 0)
        lead(&t);
    else
        follow(&t);
    if (ranks_number() == 0) {
        progress_end(&t.bar);
        for (uint32_t i = 0; t.results != NULL && i < t.results_most; ++i)
            free(t.results[i].bytes);
        free(t.asking);
        free(t.results);
        free(t.has_result);
    }
    *here = t.here;
    return t.status;
}
