/* A program of OSMesa's: clears a window, and reads one of its bytes. Exit status 0 if it is as
 * cleared. */
#include <GL/osmesa.h>

int main(void)
{
    static GLubyte window[4][4][4];
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, 0);

    if (!context || !OSMesaMakeCurrent(context, window, GL_UNSIGNED_BYTE, 4, 4))
        return 1;
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    return window[2][3][1] != 255;
}
