/* Steps that every rank does for itself and in which all find the same faults, such as looking at
 * options. A fault is printed once; a fault that some ranks alone have, such as too little memory
 * on their machine, is printed by them. */
#ifndef TOGETHER_H
#define TOGETHER_H

/* Begins a step: lines of ranks above 0 are kept back. */
void together_begin(void);

/* Collective. Ends the step with the status of this rank. Returns the largest of all. If rank 0 has
 * no fault, the lines of ranks with a fault are printed; all others are dropped. */
int together_end(int status);

/* Collective. Returns rank 0's status at all ranks. */
int together_as_first(int status);

#endif
