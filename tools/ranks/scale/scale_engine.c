/* The event simulation: a queue of events in the order of their times. */
#include "scale_engine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum event_kind {
    EVENT_READY,    /* a rank goes on */
    EVENT_ARRIVES,  /* the first byte of a message is at the receiver's port */
    EVENT_DELIVERED /* the last byte is there */
} event_kind;

typedef struct event {
    double time;
    uint64_t number; /* events of one time happen in the order in which they were made */
    event_kind kind;
    uint32_t what; /* a rank, or a message */
} event;

typedef struct message {
    uint32_t from, to;
    int tag;
    double bytes;
    double left;   /* when its first byte left */
    uint32_t next; /* in its receiver's list, or in the list of free ones */
} message;

/* A rank above all others stands for the file system. */
#define NONE UINT32_MAX
#define FILE_SYSTEM (UINT32_MAX - 1)

typedef struct rank_state {
    step current;
    double since; /* when the current step began */
    step_result last;
    bool waits; /* for a message */
    bool ended;
    uint32_t first, newest; /* messages that wait for it */
} rank_state;

typedef struct engine {
    const machine_room *room;
    const rank_program *program;
    event *events; /* a heap: the earliest first */
    size_t event_count, event_room;
    uint64_t event_number;
    message *messages;
    uint32_t message_count, message_room, free_message;
    rank_state *ranks;
    double *out, *in;             /* when each machine's ports are free */
    double *local_out, *local_in; /* each rank's */
    double disk;
    uint32_t agreed; /* ranks that wait for all others */
    uint32_t ended;
    bool short_of_memory;
    double now;
    run_times *result;
} engine;

static const struct {
    const char *word, *text;
} kinds[TIME_KINDS] = {
    [TIME_START] = {"start", "starting the processes"},
    [TIME_READ] = {"read", "reading the model"},
    [TIME_SHARE] = {"share", "sharing the model"},
    [TIME_PREPARE] = {"prepare", "preparing the model"},
    [TIME_VERTICES] = {"vertices", "vertices"},
    [TIME_TRIANGLES] = {"triangles", "triangles"},
    [TIME_FRAGMENTS] = {"fragments", "fragments"},
    [TIME_CLEAR] = {"clear", "clearing"},
    [TIME_EXCHANGE] = {"exchange", "exchanging bands"},
    [TIME_MERGE] = {"merge", "merging bands"},
    [TIME_COMPRESS] = {"compress", "compressing"},
    [TIME_WRITE] = {"write", "writing files"},
    [TIME_HANDOUT] = {"handout", "waiting for frames"},
    [TIME_AGREE] = {"agree", "messages of agreement"},
    [TIME_UNEQUAL] = {"unequal", "unequal loads"},
};

const char *time_kind_text(time_kind kind)
{
    return kinds[kind].text;
}

const char *time_kind_word(time_kind kind)
{
    return kinds[kind].word;
}

uint32_t engine_log2(uint32_t n)
{
    uint32_t result = 0;
    while (((uint64_t)1 << result) < n)
        ++result;
    return result;
}

static bool is_before(const event *a, const event *b)
{
    return a->time < b->time || (a->time <= b->time && a->number < b->number);
}

static void add_event(engine *e, double time, event_kind kind, uint32_t what)
{
    if (e->event_count == e->event_room) {
        const size_t more = 2 * e->event_room + 1024;
        event *moved = realloc(e->events, more * sizeof *moved);
        if (moved == NULL) {
            e->short_of_memory = true;
            return;
        }
        e->events = moved;
        e->event_room = more;
    }
    const event added = {time, e->event_number++, kind, what};
    size_t i = e->event_count++;
    while (i > 0 && is_before(&added, &e->events[(i - 1) / 2])) {
        e->events[i] = e->events[(i - 1) / 2];
        i = (i - 1) / 2;
    }
    e->events[i] = added;
}

static event take_event(engine *e)
{
    const event result = e->events[0];
    const event last = e->events[--e->event_count];
    size_t i = 0;
    for (;;) {
        size_t child = 2 * i + 1;
        if (child >= e->event_count)
            break;
        if (child + 1 < e->event_count && is_before(&e->events[child + 1], &e->events[child]))
            ++child;
        if (!is_before(&e->events[child], &last))
            break;
        e->events[i] = e->events[child];
        i = child;
    }
    e->events[i] = last;
    return result;
}

static uint32_t new_message(engine *e)
{
    if (e->free_message != NONE) {
        const uint32_t result = e->free_message;
        e->free_message = e->messages[result].next;
        return result;
    }
    if (e->message_count == e->message_room) {
        const uint32_t more = 2 * e->message_room + 1024;
        message *moved = realloc(e->messages, more * sizeof *moved);
        if (moved == NULL) {
            e->short_of_memory = true;
            return NONE;
        }
        e->messages = moved;
        e->message_room = more;
    }
    return e->message_count++;
}

static bool same_machine(const engine *e, uint32_t a, uint32_t b)
{
    return a / e->room->ranks_a_machine == b / e->room->ranks_a_machine;
}

/* When a port or disk that is wanted from `time` on begins; it is then busy for some seconds. */
static double occupy(double *free_at, double time, double seconds)
{
    const double begins = time > *free_at ? time : *free_at;
    *free_at = begins + seconds;
    return begins;
}

static void end_step(engine *e, uint32_t rank, double spent_until)
{
    rank_state *r = &e->ranks[rank];
    e->result->spent[r->current.spent_on] += spent_until - r->since;
}

/* Sends the first byte of a message on its way. Returns when the sender is free again. */
static double send_bytes(engine *e, uint32_t from, uint32_t to, int tag, double bytes)
{
    const machine_room *room = e->room;
    const uint32_t m = new_message(e);
    if (m == NONE)
        return e->now;
    const bool on_disk = to == FILE_SYSTEM && room->one_machine;
    const bool local = to != FILE_SYSTEM && same_machine(e, from, to);
    const double bandwidth = local ? room->local_bandwidth : room->bandwidth;
    const double latency = on_disk ? 0.0 : local ? room->local_latency : room->latency;
    double *port = local ? &e->local_out[from] : &e->out[from / room->ranks_a_machine];
    const double begins = on_disk ? e->now : occupy(port, e->now, bytes / bandwidth);
    e->messages[m] = (message){from, to, tag, bytes, begins, NONE};
    add_event(e, begins + latency, EVENT_ARRIVES, m);
    if (to != FILE_SYSTEM) {
        e->result->sent_bytes += bytes;
        ++e->result->messages;
    }
    return begins + (on_disk ? 0.0 : bytes / bandwidth);
}

static void arrive(engine *e, uint32_t number)
{
    const machine_room *room = e->room;
    const message *m = &e->messages[number];
    double ends;
    if (m->to == FILE_SYSTEM) {
        const double bandwidth =
            room->one_machine ? room->disk_bandwidth : room->shared_disk_bandwidth;
        ends = occupy(&e->disk, e->now, m->bytes / bandwidth) + m->bytes / bandwidth;
        const double through = e->now + m->bytes / room->bandwidth;
        if (!room->one_machine && through > ends)
            ends = through;
    } else {
        const bool local = same_machine(e, m->from, m->to);
        const double seconds = m->bytes / (local ? room->local_bandwidth : room->bandwidth);
        double *port = local ? &e->local_in[m->to] : &e->in[m->to / room->ranks_a_machine];
        ends = occupy(port, e->now, seconds) + seconds;
    }
    add_event(e, ends, EVENT_DELIVERED, number);
}

/* Takes the first message out of a rank's list that its current step asks for. */
static bool take_message(engine *e, uint32_t rank)
{
    rank_state *r = &e->ranks[rank];
    uint32_t before = NONE;
    for (uint32_t m = r->first; m != NONE; before = m, m = e->messages[m].next) {
        const message *found = &e->messages[m];
        if (found->tag != r->current.tag ||
            (r->current.kind == STEP_RECEIVE && found->from != r->current.other))
            continue;
        r->last = (step_result){true, found->from};
        if (r->current.kind == STEP_LOOK)
            return true;
        if (before == NONE)
            r->first = found->next;
        else
            e->messages[before].next = found->next;
        if (r->newest == m)
            r->newest = before;
        e->messages[m].next = e->free_message;
        e->free_message = m;
        return true;
    }
    return false;
}

static void deliver(engine *e, uint32_t number)
{
    message *m = &e->messages[number];
    if (m->to == FILE_SYSTEM) {
        end_step(e, m->from, e->now);
        add_event(e, e->now, EVENT_READY, m->from);
        m->next = e->free_message;
        e->free_message = number;
        return;
    }
    const uint32_t to = m->to;
    rank_state *r = &e->ranks[to];
    m->next = NONE;
    if (r->first == NONE)
        r->first = number;
    else
        e->messages[r->newest].next = number;
    r->newest = number;
    if (r->waits && take_message(e, to)) {
        r->waits = false;
        end_step(e, to, e->now);
        add_event(e, e->now, EVENT_READY, to);
    }
}

/* A rank has come to an agreement; the last one lets all go on. */
static void agree(engine *e)
{
    const machine_room *room = e->room;
    if (++e->agreed < room->ranks)
        return;
    const bool local = room->ranks <= room->ranks_a_machine;
    const double latency = local ? room->local_latency : room->latency;
    const double messages = engine_log2(room->ranks) * latency;
    e->agreed = 0;
    for (uint32_t i = 0; i < room->ranks; ++i) {
        const time_kind kind = e->ranks[i].current.spent_on;
        const bool begins = time_kind_begins(kind);
        e->result->spent[begins ? kind : TIME_UNEQUAL] += e->now - e->ranks[i].since;
        e->result->spent[begins ? kind : TIME_AGREE] += messages;
        add_event(e, e->now + messages, EVENT_READY, i);
    }
}

static void begin_step(engine *e, uint32_t rank)
{
    rank_state *r = &e->ranks[rank];
    step *s = &r->current;
    const step_result last = r->last;
    memset(s, 0, sizeof *s);
    e->program->next(e->program->state, rank, &last, s);
    r->since = e->now;
    r->last = (step_result){false, 0};
    switch (s->kind) {
    case STEP_END:
        r->ended = true;
        ++e->ended;
        break;
    case STEP_WORK:
        end_step(e, rank, e->now + s->seconds);
        add_event(e, e->now + s->seconds, EVENT_READY, rank);
        break;
    case STEP_SEND: {
        const double ends = send_bytes(e, rank, s->other, s->tag, s->bytes);
        end_step(e, rank, ends);
        add_event(e, ends, EVENT_READY, rank);
        break;
    }
    case STEP_RECEIVE:
    case STEP_RECEIVE_ANY:
        if (take_message(e, rank))
            add_event(e, e->now, EVENT_READY, rank);
        else
            r->waits = true;
        break;
    case STEP_LOOK:
        take_message(e, rank);
        add_event(e, e->now, EVENT_READY, rank);
        break;
    case STEP_AGREE:
        agree(e);
        break;
    case STEP_WRITE:
        send_bytes(e, rank, FILE_SYSTEM, 0, s->bytes);
        break;
    }
}

static void run(engine *e)
{
    for (uint32_t i = 0; i < e->room->ranks; ++i)
        add_event(e, 0.0, EVENT_READY, i);
    while (e->event_count > 0 && !e->short_of_memory) {
        const event next = take_event(e);
        e->now = next.time;
        switch (next.kind) {
        case EVENT_READY:
            begin_step(e, next.what);
            break;
        case EVENT_ARRIVES:
            arrive(e, next.what);
            break;
        case EVENT_DELIVERED:
            deliver(e, next.what);
            break;
        }
    }
}

/* Ranks that end early wait for the last one; sums become means. */
static bool finish(engine *e)
{
    run_times *result = e->result;
    if (e->short_of_memory || e->ended < e->room->ranks) {
        fprintf(stderr, "scale: %s\n",
                e->short_of_memory ? "not enough memory"
                                   : "ranks wait for messages that nobody sends");
        return false;
    }
    result->seconds = e->now;
    for (uint32_t i = 0; i < e->room->ranks; ++i)
        result->spent[TIME_UNEQUAL] += e->now - e->ranks[i].since;
    for (int k = 0; k < TIME_KINDS; ++k)
        result->spent[k] /= e->room->ranks;
    return true;
}

bool engine_run(const machine_room *room, const rank_program *program, run_times *result)
{
    const size_t count = room->ranks;
    engine e = {.room = room, .program = program, .free_message = NONE, .result = result};
    memset(result, 0, sizeof *result);
    e.ranks = calloc(count, sizeof *e.ranks);
    double *ports = calloc(4 * count, sizeof *ports);
    e.short_of_memory = e.ranks == NULL || ports == NULL;
    if (!e.short_of_memory) {
        e.out = ports;
        e.in = ports + count;
        e.local_out = ports + 2 * count;
        e.local_in = ports + 3 * count;
        for (size_t i = 0; i < count; ++i)
            e.ranks[i].first = e.ranks[i].newest = NONE;
        run(&e);
    }
    const bool good = finish(&e);
    free(e.events);
    free(e.messages);
    free(e.ranks);
    free(ports);
    return good;
}
