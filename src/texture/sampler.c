/* Validation of samplers: returns the status of the first fault. */
#include "sampler_faults.h"

gn_status gn_sampler_check(const gn_sampler *sampler)
{
    return fault_of_sampler(sampler);
}
