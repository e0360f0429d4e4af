/* A program of OSMesa's: 5,000 small draws a frame, each a lit cube of 12 triangles with a matrix
 * and a colour of its own, from vertex arrays. Prints the milliseconds of the fastest of FRAMES
 * frames. usage: draws FRAMES */
#include <GL/osmesa.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { SIZE = 512, ROW = 50, DRAWS = 5000 };

static unsigned char pixels[SIZE * SIZE * 4];

static double milliseconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static void frame(const GLubyte indices[36])
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < DRAWS; ++i) {
        const float x = (float)(i % ROW), y = (float)(i / ROW % ROW), z = (float)(i / (ROW * ROW));

        glColor4f(x / ROW, y / ROW, z, 1);
        glPushMatrix();
        glTranslatef((x - ROW / 2) * 0.04f, (y - ROW / 2) * 0.04f, z * -0.5f);
        glRotatef((float)i, 1, 1, 0);
        glScalef(0.012f, 0.012f, 0.012f);
        glDrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_BYTE, indices);
        glPopMatrix();
    }
    glFinish();
}

int main(int count, char **arguments)
{
    static const GLfloat corner[8][3] = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                         {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
    static const GLubyte indices[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                        2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    const int frames = count == 2 ? atoi(arguments[1]) : 0;
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    double best = 1e30;

    if (frames <= 0 || !context ||
        !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, SIZE, SIZE))
        return 1;
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_COLOR_MATERIAL);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, corner);
    glNormalPointer(GL_FLOAT, 0, corner);
    for (int i = 0; i < frames; ++i) {
        const double began = milliseconds();
        double taken;

        frame(indices);
        taken = milliseconds() - began;
        best = taken < best ? taken : best;
    }
    printf("%.3f\n", best);
    OSMesaDestroyContext(context);
    return glGetError() != GL_NO_ERROR;
}
