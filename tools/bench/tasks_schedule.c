/* A list scheduler: tasks are handed out in order. */
#include "tasks_schedule.h"

uint32_t schedule_times(const task_steps *steps)
{
    uint32_t times = steps->count + 1;

    for (uint32_t s = 0; s < steps->count; ++s)
        times += steps->tasks[s];
    return times;
}

double schedule_step(const double *task, uint32_t count, uint32_t threads)
{
    double free_at[SCHEDULE_MOST_THREADS] = {0.0};
    double end = 0.0;

    for (uint32_t i = 0; i < count; ++i) {
        uint32_t first = 0;

        for (uint32_t t = 1; t < threads; ++t)
            first = free_at[t] < free_at[first] ? t : first;
        free_at[first] += task[i];
        end = free_at[first] > end ? free_at[first] : end;
    }
    return end;
}

double schedule_frame(const task_steps *steps, const double *times, uint32_t threads)
{
    double sum = *times++;

    for (uint32_t s = 0; s < steps->count; ++s) {
        sum += schedule_step(times, steps->tasks[s], threads);
        times += steps->tasks[s];
        sum += *times++;
    }
    return sum;
}

double schedule_serial(const task_steps *steps, const double *times)
{
    double sum = *times;

    for (uint32_t s = 0; s < steps->count; ++s) {
        times += steps->tasks[s] + 1;
        sum += *times;
    }
    return sum;
}

double schedule_longest(const task_steps *steps, const double *times)
{
    double longest = 0.0;

    for (uint32_t s = 0; s < steps->count; ++s) {
        for (uint32_t i = 1; i <= steps->tasks[s]; ++i)
            longest = times[i] > longest ? times[i] : longest;
        times += steps->tasks[s] + 1;
    }
    return longest;
}
