/* Validation of samplers: the first fault's status. */
#include "sampler_faults.h"

gn_status gn_sampler_check(const gn_sampler *sampler)
{
    return fault_of_sampler(sampler);
}
