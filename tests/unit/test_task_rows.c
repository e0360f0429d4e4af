/* Tasks of a draw write different rows, so that two may run at once. The test runs on one thread.
 * Each row is a page of memory, write-protected until a task's first write to it is caught. */
#define _DEFAULT_SOURCE
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include "drawing.h"
#include "noise.h"

enum { PAGE = 4096, ROWS = 256, TRIANGLES = 3000, WIDTH_MOST = PAGE / 4 };

static unsigned char *rows;
static uint32_t writer[ROWS]; /* the number of the task that wrote a row in this round, plus 1 */
static volatile sig_atomic_t at_work, shared_rows, tasks_that_wrote;
static struct sigaction before;

static void catch_write(int number, siginfo_t *info, void *context)
{
    const ptrdiff_t offset = (unsigned char *)info->si_addr - rows;
    const ptrdiff_t row = offset / PAGE;

    (void)context;
    if (offset < 0 || row >= ROWS) {
        sigaction(number, &before, NULL);
        return;
    }
    shared_rows += writer[row] != 0 && writer[row] != (uint32_t)at_work;
    writer[row] = (uint32_t)at_work;
    mprotect(rows + row * PAGE, PAGE, PROT_READ | PROT_WRITE);
}

static void one_by_one(void *user, gn_task *task, void *context, uint32_t count)
{
    (void)user;
    memset(writer, 0, sizeof writer);
    for (uint32_t i = 0; i < count; ++i) {
        assert_int_equal(mprotect(rows, ROWS * PAGE, PROT_READ), 0);
        at_work = (sig_atomic_t)(i + 1);
        task(context, i);
        for (int row = 0; row < ROWS; ++row) {
            if (writer[row] == i + 1) {
                ++tasks_that_wrote;
                break;
            }
        }
    }
    assert_int_equal(mprotect(rows, ROWS * PAGE, PROT_READ | PROT_WRITE), 0);
}

/* Small triangles on the last columns of a surface; their blocks reach over its edge. */
static void draw_at_the_edge(uint32_t width, bool ready, uint32_t *seed)
{
    static float positions[3 * TRIANGLES][2];
    static unsigned char memory[8 << 20];
    const gn_mesh mesh = mesh_of(positions[0], 2, 3 * TRIANGLES);
    gn_target target = {{gn_surface_bottom_up(rows, GN_FORMAT_RGBA8, width, ROWS)}, {0}};
    gn_pipeline pipeline = colored_pipeline(GN_TRIANGLES);
    gn_workspace workspace = {
        .memory = memory, .size = sizeof memory, .parallel = one_by_one, .threads = 8};

    target.color[0].row_stride = PAGE;
    for (int v = 0; v < 3 * TRIANGLES; ++v) {
        const float middle = (float)(v / 3 * ROWS / TRIANGLES);
        const float x = 24.0f * noise(seed) - 20.0f, y = 12.0f * noise(seed) - 6.0f;

        positions[v][0] = 2.0f * ((float)width + x) / (float)width - 1.0f;
        positions[v][1] = 2.0f * (middle + y) / (float)ROWS - 1.0f;
    }
    if (!ready) {
        pipeline.program.vertex_shader = pass_positions;
        pipeline.program.fragment_shader = shade_white;
        pipeline.program.varying_count = 0;
    }
    assert_int_equal(gn_draw(&target, &pipeline, &mesh, &workspace), GN_OK);
}

static void tasks_write_rows_of_their_own(void **state)
{
    struct sigaction action;
    uint32_t seed = 1;

    /* Rows of larger pages would make other surfaces than those that the edges here are made
     * for. */
    if (sysconf(_SC_PAGESIZE) != PAGE)
        skip();
    rows = mmap(NULL, ROWS * PAGE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_true(rows != MAP_FAILED);
    memset(&action, 0, sizeof action);
    action.sa_sigaction = catch_write;
    action.sa_flags = SA_SIGINFO;
    assert_int_equal(sigaction(SIGSEGV, &action, &before), 0);
    for (uint32_t width = WIDTH_MOST - 8; width <= WIDTH_MOST; ++width)
        for (int ready = 0; ready < 2; ++ready)
            draw_at_the_edge(width, ready, &seed);
    assert_int_equal(sigaction(SIGSEGV, &before, NULL), 0);
    assert_true(tasks_that_wrote > 2 * 9 * 2); /* more than two per draw */
    assert_int_equal(shared_rows, 0);
    munmap(rows, ROWS * PAGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tasks_write_rows_of_their_own),
    };
    return cmocka_run_group_tests_name("task rows", tests, NULL, NULL);
}
