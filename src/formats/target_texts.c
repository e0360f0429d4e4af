/* The faults of targets in words. */
#define GN_FAULT_TEXTS
#include "surface_faults.h"

const char *gn_target_fault(const gn_target *target)
{
    return fault_of_target(target);
}
