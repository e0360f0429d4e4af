/* The faults of samplers in words. */
#define GN_FAULT_TEXTS
#include "sampler_faults.h"

const char *gn_sampler_fault(const gn_sampler *sampler)
{
    return fault_of_sampler(sampler);
}
