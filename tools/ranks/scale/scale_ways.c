/* What ranks do, as programs of steps, and the formulas. A rank of a picture goes through the
 * phases below in order; a rank of a sequence draws pictures until rank 0 has no more. */
#include "scale_ways.h"

#include <stdio.h>
#include <stdlib.h>

#include "scale_cost.h"

enum { TAG_MODEL, TAG_RING, TAG_BAND, TAG_REQUEST, TAG_ANSWER, TAG_FRAME };

typedef enum phase {
    PHASE_START,
    PHASE_READ,
    PHASE_PARTS, /* sort-last shares in this phase, the other ways in the next four */
    PHASE_EXTRACTED,
    PHASE_SCATTER_RECEIVE,
    PHASE_SCATTER_SEND,
    PHASE_RING_SEND,
    PHASE_RING_RECEIVE,
    PHASE_PREPARE,
    PHASE_PREPARED, /* an agreement, like other phases in the past tense */
    PHASE_CLEAR,
    PHASE_VERTICES,
    PHASE_TRIANGLES,
    PHASE_FRAGMENTS,
    PHASE_DRAWN,
    PHASE_PIECES,
    PHASE_BAND_SEND,
    PHASE_BAND_RECEIVE,
    PHASE_MERGE,
    PHASE_MERGED,
    PHASE_COMPRESS,
    PHASE_COMPRESSED,
    PHASE_WRITE,
    PHASE_WRITTEN,
    PHASE_END,
    /* Sequences, from PHASE_CLEAR on instead. */
    PHASE_ASK,
    PHASE_FRAME_SEND,
    PHASE_TAKE,
    PHASE_LOOK_REQUEST,
    PHASE_LOOKED_REQUEST,
    PHASE_ANSWER,
    PHASE_LOOK_FRAME,
    PHASE_LOOKED_FRAME,
    PHASE_COLLECT,
    PHASE_CHOOSE,
    PHASE_FINISHED
} phase;

typedef struct rank_place {
    phase at;
    uint32_t round;
    uint32_t frame;  /* the one that it draws */
    uint32_t answer; /* a rank's: the frame it will get */
    uint32_t asks;   /* rank 0's: who asked */
} rank_place;

typedef struct way_state {
    way_kind way;
    const work *w;
    const figures *f;
    uint32_t ranks;
    double latency; /* of most messages, in seconds */
    rank_place *place;
    uint32_t next_frame, sent_away, collected; /* rank 0's books */
} way_state;

const char *way_name(way_kind way)
{
    static const char *const names[WAY_COUNT] = {"sort-first", "sort-last", "frames", "animation"};
    return names[way];
}

bool way_has_frames(way_kind way)
{
    return way >= WAY_FRAMES;
}

static void work_for(step *s, time_kind kind, double seconds)
{
    *s = (step){.kind = STEP_WORK, .spent_on = kind, .seconds = seconds};
}

static void message_step(step *s, step_kind kind, time_kind spent_on, uint32_t other, int tag,
                         double bytes)
{
    *s = (step){.kind = kind, .spent_on = spent_on, .other = other, .tag = tag, .bytes = bytes};
}

/* Sort-last: rank 0 chooses the part of each rank and sends it, its own one last. */
static bool parts_step(const way_state *state, uint32_t rank, rank_place *p, step *s)
{
    const uint32_t n = state->ranks;
    if (state->way != WAY_SORT_LAST) {
        p->at = PHASE_SCATTER_RECEIVE;
        return false;
    }
    if (p->at == PHASE_EXTRACTED && rank == 0 && p->round < n) {
        p->at = PHASE_PARTS;
        message_step(s, STEP_SEND, TIME_SHARE, p->round, TAG_MODEL, state->w->model_bytes / n);
        return true;
    }
    if (rank > 0 || p->round == n || n == 1) {
        p->at = PHASE_PREPARE;
        if (rank == 0)
            return false;
        message_step(s, STEP_RECEIVE, TIME_SHARE, 0, TAG_MODEL, 0.0);
        return true;
    }
    ++p->round;
    p->at = PHASE_EXTRACTED;
    work_for(s, TIME_SHARE, cost_ns(state->f, FIGURE_EXTRACT, state->w->vertices));
    return true;
}

/* The model goes from rank 0 to all: halves of what a rank has go on to others until every rank has
 * one part of N, and the parts then go round a ring. MPI shares long messages so (van de Geijn;
 * Thakur, Rabenseifner, Gropp, 2005). */
static bool share_step(const way_state *state, uint32_t rank, rank_place *p, step *s)
{
    const uint32_t n = state->ranks;
    const double part = state->w->model_bytes / n;
    const uint32_t lowest = rank == 0 ? n : rank & (~rank + 1);
    switch (p->at) {
    case PHASE_SCATTER_RECEIVE:
        p->at = PHASE_SCATTER_SEND;
        p->round = lowest / 2;
        if (rank == 0)
            return false;
        message_step(s, STEP_RECEIVE, TIME_SHARE, rank - lowest, TAG_MODEL, 0.0);
        return true;
    case PHASE_SCATTER_SEND:
        if (p->round == 0) {
            p->at = PHASE_RING_SEND;
            return false;
        }
        message_step(s, STEP_SEND, TIME_SHARE, rank + p->round, TAG_MODEL, part * p->round);
        p->round /= 2;
        return true;
    case PHASE_RING_SEND:
        if (p->round == n - 1) {
            p->at = PHASE_PREPARE;
            return false;
        }
        p->at = PHASE_RING_RECEIVE;
        message_step(s, STEP_SEND, TIME_SHARE, (rank + 1) % n, TAG_RING, part);
        return true;
    default:
        p->at = PHASE_RING_SEND;
        ++p->round;
        message_step(s, STEP_RECEIVE, TIME_SHARE, (rank + n - 1) % n, TAG_RING, 0.0);
        return true;
    }
}

/* In round i a rank sends a band to the rank i + 1 after it, and receives its own from the rank
 * i + 1 before it; then it merges all. A band that goes in several pieces is one message here, and
 * the latencies of the others pass beforehand. */
static bool exchange_step(const way_state *state, uint32_t rank, rank_place *p, step *s)
{
    const uint32_t n = state->ranks;
    const double pixels = cost_pixels(state->w) / n;
    switch (p->at) {
    case PHASE_PIECES:
        p->at = PHASE_BAND_SEND;
        work_for(s, TIME_EXCHANGE,
                 state->way != WAY_SORT_LAST
                     ? 0.0
                     : (n - 1) * (cost_pieces(state->w, n) - 1) * state->latency);
        return true;
    case PHASE_BAND_SEND:
        p->at = p->round == n - 1 ? PHASE_MERGE : PHASE_BAND_RECEIVE;
        if (state->way != WAY_SORT_LAST)
            p->at = PHASE_MERGED;
        if (p->at != PHASE_BAND_RECEIVE)
            return false;
        message_step(s, STEP_SEND, TIME_EXCHANGE, (rank + p->round + 1) % n, TAG_BAND,
                     8.0 * pixels);
        return true;
    case PHASE_BAND_RECEIVE:
        p->at = PHASE_BAND_SEND;
        message_step(s, STEP_RECEIVE, TIME_EXCHANGE, (rank + n - p->round - 1) % n, TAG_BAND, 0.0);
        ++p->round;
        return true;
    default:
        p->at = PHASE_MERGED;
        work_for(s, TIME_MERGE, cost_ns(state->f, FIGURE_MERGE, pixels * (n - 1)));
        return true;
    }
}

/* The work of one picture or frame. */
static bool draw_step(const cost *c, rank_place *p, step *s)
{
    switch (p->at) {
    case PHASE_CLEAR:
        work_for(s, TIME_CLEAR, c->clear);
        break;
    case PHASE_VERTICES:
        work_for(s, TIME_VERTICES, c->vertices);
        break;
    case PHASE_TRIANGLES:
        work_for(s, TIME_TRIANGLES, c->triangles);
        break;
    case PHASE_FRAGMENTS:
        work_for(s, TIME_FRAGMENTS, c->fragments);
        break;
    case PHASE_COMPRESS:
        work_for(s, TIME_COMPRESS, c->compress);
        break;
    default:
        *s = (step){.kind = STEP_WRITE, .spent_on = TIME_WRITE, .bytes = c->bytes};
        break;
    }
    ++p->at;
    return true;
}

static bool picture_step(way_state *state, uint32_t rank, rank_place *p, step *s)
{
    switch (p->at) {
    case PHASE_PIECES:
    case PHASE_BAND_SEND:
    case PHASE_BAND_RECEIVE:
    case PHASE_MERGE:
        return exchange_step(state, rank, p, s);
    case PHASE_MERGED:
        if (state->way != WAY_SORT_LAST) {
            p->at = PHASE_COMPRESS;
            return false;
        }
        break;
    case PHASE_DRAWN:
    case PHASE_COMPRESSED:
    case PHASE_WRITTEN:
        break;
    case PHASE_END:
        *s = (step){.kind = STEP_END};
        return true;
    default: {
        const cost c = cost_of_picture(state->way, state->w, state->f, state->ranks, rank);
        return draw_step(&c, p, s);
    }
    }
    *s = (step){.kind = STEP_AGREE, .spent_on = TIME_AGREE};
    ++p->at;
    p->round = 0;
    return true;
}

/* A frame is drawn in the phases of a picture, but without agreements. Returns false after the
 * last. */
static bool frame_step(const way_state *state, rank_place *p, step *s)
{
    const cost c = cost_of_frame(state->w, state->f, p->frame);
    if (p->at >= PHASE_WRITTEN)
        return false;
    draw_step(&c, p, s);
    if (p->at == PHASE_DRAWN)
        p->at = PHASE_COMPRESS;
    else if (p->at == PHASE_COMPRESSED)
        p->at = PHASE_WRITE;
    return true;
}

/* A rank above 0 begins with the frame of its number. It asks for the next one before it draws, so
 * that the answer is there when it has drawn. */
static bool worker_step(way_state *state, rank_place *p, step *s)
{
    const uint32_t frames = state->w->scene.frames;
    switch (p->at) {
    case PHASE_ASK:
        if (p->frame >= frames) {
            p->at = PHASE_FINISHED;
            return false;
        }
        p->at = PHASE_CLEAR;
        message_step(s, STEP_SEND, TIME_HANDOUT, 0, TAG_REQUEST, 0.0);
        return true;
    case PHASE_WRITE:
        if (state->way != WAY_ANIMATION)
            break;
        p->at = PHASE_TAKE;
        message_step(s, STEP_SEND, TIME_EXCHANGE, 0, TAG_FRAME,
                     cost_of_frame(state->w, state->f, p->frame).bytes);
        return true;
    case PHASE_TAKE:
        p->at = PHASE_FRAME_SEND;
        message_step(s, STEP_RECEIVE, TIME_HANDOUT, 0, TAG_ANSWER, 0.0);
        return true;
    case PHASE_FRAME_SEND:
        p->frame = p->answer;
        p->at = PHASE_ASK;
        return false;
    default:
        break;
    }
    if (frame_step(state, p, s))
        return true;
    p->at = PHASE_TAKE;
    return false;
}

/* Rank 0 answers and writes what has come, then draws a frame itself; when none is left, it waits
 * for the others. */
static bool master_step(way_state *state, rank_place *p, const step_result *last, step *s)
{
    const uint32_t frames = state->w->scene.frames;
    const uint32_t begun = state->ranks - 1 < frames - 1 ? state->ranks - 1 : frames - 1;
    switch (p->at) {
    case PHASE_LOOK_REQUEST:
        p->at = PHASE_LOOKED_REQUEST;
        message_step(s, STEP_LOOK, TIME_HANDOUT, 0, TAG_REQUEST, 0.0);
        return true;
    case PHASE_LOOKED_REQUEST:
        p->at = last->found ? PHASE_ANSWER : PHASE_LOOK_FRAME;
        if (last->found)
            message_step(s, STEP_RECEIVE_ANY, TIME_HANDOUT, 0, TAG_REQUEST, 0.0);
        return last->found;
    case PHASE_ANSWER:
        p->at = PHASE_LOOK_REQUEST;
        state->place[last->from].answer = state->next_frame;
        if (state->next_frame < frames)
            ++state->next_frame;
        else
            ++state->sent_away;
        message_step(s, STEP_SEND, TIME_HANDOUT, last->from, TAG_ANSWER, 0.0);
        return true;
    case PHASE_LOOK_FRAME:
        p->at = PHASE_LOOKED_FRAME;
        message_step(s, STEP_LOOK, TIME_EXCHANGE, 0, TAG_FRAME, 0.0);
        return true;
    case PHASE_LOOKED_FRAME:
        p->at = last->found ? PHASE_COLLECT : PHASE_CHOOSE;
        if (last->found)
            message_step(s, STEP_RECEIVE_ANY, TIME_EXCHANGE, 0, TAG_FRAME, 0.0);
        return last->found;
    case PHASE_COLLECT:
        p->at = PHASE_LOOK_REQUEST;
        ++state->collected;
        *s = (step){.kind = STEP_WRITE,
                    .spent_on = TIME_WRITE,
                    .bytes = cost_of_frame(state->w, state->f, 0).bytes};
        return true;
    case PHASE_CHOOSE:
        if (p->frame < frames) {
            p->at = PHASE_CLEAR;
            return false;
        }
        if (state->next_frame < frames) {
            p->frame = state->next_frame++;
            p->at = PHASE_CLEAR;
            return false;
        }
        if (state->sent_away < begun) {
            p->at = PHASE_ANSWER;
            message_step(s, STEP_RECEIVE_ANY, TIME_HANDOUT, 0, TAG_REQUEST, 0.0);
            return true;
        }
        if (state->way == WAY_ANIMATION && state->collected < frames - p->round) {
            p->at = PHASE_COLLECT;
            message_step(s, STEP_RECEIVE_ANY, TIME_HANDOUT, 0, TAG_FRAME, 0.0);
            return true;
        }
        p->at = PHASE_FINISHED;
        return false;
    default:
        break;
    }
    if (frame_step(state, p, s))
        return true;
    ++p->round; /* frames that rank 0 has drawn */
    p->frame = frames;
    p->at = PHASE_LOOK_REQUEST;
    return false;
}

static bool sequence_step(way_state *state, uint32_t rank, rank_place *p, const step_result *last,
                          step *s)
{
    if (p->at == PHASE_FINISHED) {
        p->at = PHASE_END;
        *s = (step){.kind = STEP_AGREE, .spent_on = TIME_AGREE};
        return true;
    }
    if (p->at == PHASE_END) {
        *s = (step){.kind = STEP_END};
        return true;
    }
    return rank == 0 ? master_step(state, p, last, s) : worker_step(state, p, s);
}

static void next_step(void *context, uint32_t rank, const step_result *last, step *s)
{
    way_state *state = context;
    rank_place *p = &state->place[rank];
    const figures *f = state->f;
    bool found = false;
    while (!found) {
        found = true;
        if (p->at == PHASE_START) {
            work_for(s, TIME_START, f->value[FIGURE_START]);
            ++p->at;
        } else if (p->at == PHASE_READ) {
            /* Other ranks wait as long. */
            work_for(s, TIME_READ, cost_ns(f, FIGURE_READ, state->w->triangles));
            ++p->at;
        } else if (p->at <= PHASE_EXTRACTED) {
            found = parts_step(state, rank, p, s);
        } else if (p->at <= PHASE_RING_RECEIVE) {
            found = share_step(state, rank, p, s);
        } else if (p->at == PHASE_PREPARE) {
            work_for(s, TIME_PREPARE, cost_of_preparing(state->way, state->w, f, state->ranks));
            ++p->at;
        } else if (p->at == PHASE_PREPARED) {
            *s = (step){.kind = STEP_AGREE, .spent_on = TIME_SHARE};
            p->at = !way_has_frames(state->way) ? PHASE_CLEAR
                    : rank == 0                 ? PHASE_LOOK_REQUEST
                                                : PHASE_ASK;
            p->frame = rank;
            p->round = 0;
        } else if (way_has_frames(state->way)) {
            found = sequence_step(state, rank, p, last, s);
        } else {
            found = picture_step(state, rank, p, s);
        }
    }
}

static machine_room room_of(const figures *f, uint32_t ranks, const way_place *place)
{
    return (machine_room){
        .ranks = ranks,
        .ranks_a_machine = place->ranks_a_machine,
        .one_machine = place->one_machine,
        .latency = f->value[FIGURE_LATENCY] * 1e-6,
        .bandwidth = f->value[FIGURE_BANDWIDTH] * 1e6,
        .local_latency = f->value[FIGURE_LOCAL_LATENCY] * 1e-6,
        .local_bandwidth = f->value[FIGURE_LOCAL_BANDWIDTH] * 1e6,
        .disk_bandwidth = f->value[FIGURE_DISK] * 1e6,
        .shared_disk_bandwidth = f->value[FIGURE_SHARED_DISK] * 1e6,
    };
}

/* All but the beginning happens as often as there are pictures. */
static void repeat(run_times *result, uint32_t pictures)
{
    result->seconds = 0.0;
    for (int k = 0; k < TIME_KINDS; ++k) {
        if (!time_kind_begins((time_kind)k))
            result->spent[k] *= pictures;
        result->seconds += result->spent[k];
    }
}

bool way_run(way_kind way, const work *w, const figures *f, uint32_t ranks, const way_place *place,
             run_times *result)
{
    const machine_room room = room_of(f, ranks, place);
    way_state state = {.way = way, .w = w, .f = f, .ranks = ranks};
    state.latency = ranks <= room.ranks_a_machine ? room.local_latency : room.latency;
    const rank_program program = {next_step, &state};
    state.place = calloc(ranks, sizeof *state.place);
    if (state.place == NULL) {
        fprintf(stderr, "scale: not enough memory\n");
        return false;
    }
    /* Every rank begins with the frame of its number. */
    state.next_frame = ranks < w->scene.frames ? ranks : w->scene.frames;
    const bool good = engine_run(&room, &program, result);
    free(state.place);
    if (!way_has_frames(way) && good)
        repeat(result, w->scene.frames);
    return good;
}
