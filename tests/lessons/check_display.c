/* Whether lesson 21's display shows its picture the right way up: see check_display.c in
 * tests/microcontrollers. */
#define PROGRAM "../../tools/examples/21_microcontroller.c"
#include "../microcontrollers/check_display.c"
