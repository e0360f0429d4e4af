/* What the command receives from the process that imports a model, which a hostile file may have
 * taken over: any bytes are records, of which the last is a model that can be drawn, or a state
 * that says why not. A model that was received is sent and received again, equal. */
#define _GNU_SOURCE
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "fuzz.h"
#include "handover.h"

/* A file without a name, in place of the pipe. */
static int file_of(const uint8_t *bytes, size_t size)
{
    const int descriptor = memfd_create("handover", 0);

    FUZZ_REQUIRE(descriptor >= 0);
    FUZZ_REQUIRE(size == 0 || write(descriptor, bytes, size) == (ssize_t)size);
    FUZZ_REQUIRE(lseek(descriptor, 0, SEEK_SET) == 0);
    return descriptor;
}

static void free_model(imported *i)
{
    for (size_t p = 0; i->maps && p < i->model.part_count; ++p)
        for (int m = 0; m < MAP_COUNT; ++m)
            free(i->maps[p].images[m].texels);
    free(i->maps);
    model_free(&i->model);
}

static void require_sound(const imported *result)
{
    for (size_t p = 0; p < result->model.part_count; ++p) {
        const model_part *const part = &result->model.parts[p];

        FUZZ_REQUIRE((unsigned)part->kind <= MODEL_POINTS);
        FUZZ_REQUIRE(part->index_count % model_corners(part->kind) == 0);
        FUZZ_REQUIRE(part->surface.shine.exponent >= 1 &&
                     part->surface.shine.exponent <= MODEL_MAX_EXPONENT);
        for (uint32_t i = 0; i < part->index_count; ++i)
            FUZZ_REQUIRE(part->indices[i] < part->vertex_count);
        for (int m = 0; m < MAP_COUNT; ++m) {
            const image *const map = &result->maps[p].images[m];

            FUZZ_REQUIRE(map->width <= GN_MAX_SIZE && map->height <= GN_MAX_SIZE);
            FUZZ_REQUIRE((map->texels != NULL) == (map->width > 0));
        }
    }
}

/* Receives records up to a model. Returns whether there was one. */
static bool receive(handover *h, imported *result)
{
    static char text[HANDOVER_TEXT_SIZE];
    handover_record kind;

    memset(result, 0, sizeof *result);
    while (handover_receive(h, &kind, text)) {
        FUZZ_REQUIRE(memchr(text, 0, sizeof text));
        FUZZ_REQUIRE((int)kind >= 0 && kind <= HANDOVER_RESULT);
        if (kind == HANDOVER_FAULT)
            return false;
        if (kind == HANDOVER_RESULT)
            return handover_receive_model(h, result);
    }
    return false;
}

/* Sends a model through a file and receives it again. */
static void require_round_trip(const imported *first)
{
    const int descriptor = file_of(NULL, 0);
    imported again;

    FUZZ_REQUIRE(handover_send_model(descriptor, first));
    const off_t sent = lseek(descriptor, 0, SEEK_CUR);

    FUZZ_REQUIRE(lseek(descriptor, 0, SEEK_SET) == 0);
    handover h = {descriptor, {0, 0}, (uint64_t)sent, HANDOVER_GOING, {NULL, 0}};

    clock_gettime(CLOCK_MONOTONIC, &h.deadline);
    h.deadline.tv_sec += 60;
    FUZZ_REQUIRE(receive(&h, &again));
    FUZZ_REQUIRE(h.bytes_left == 0 && again.model.part_count == first->model.part_count);
    for (size_t p = 0; p < again.model.part_count; ++p) {
        const model_part *const a = &first->model.parts[p], *const b = &again.model.parts[p];

        FUZZ_REQUIRE(a->vertex_count == b->vertex_count && a->index_count == b->index_count);
        FUZZ_REQUIRE(a->vertex_count == 0 ||
                     !memcmp(a->positions, b->positions, a->vertex_count * 3 * sizeof(float)));
        FUZZ_REQUIRE(a->index_count == 0 ||
                     !memcmp(a->indices, b->indices, a->index_count * sizeof(uint32_t)));
    }
    free_model(&again);
    close(descriptor);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const int descriptor = file_of(bytes, size);
    handover h = {descriptor, {0, 0}, (uint64_t)1 << 20, HANDOVER_GOING, {NULL, 0}};
    imported result;

    clock_gettime(CLOCK_MONOTONIC, &h.deadline);
    h.deadline.tv_sec += 60;
    if (receive(&h, &result)) {
        require_sound(&result);
        require_round_trip(&result);
        /* Normals are completed with what the importer sent. */
        uint64_t memory = UINT64_MAX;
        FUZZ_REQUIRE(model_complete_normals(&result.model, MODEL_CREASE_DEGREES, &memory));
    }
    free_model(&result);
    close(descriptor);
    return 0;
}
