/* The elements of SVG that the pictures use. */
#include "plot_parts.h"

#include <stdarg.h>

void part_begin(FILE *out, int width, int height, const char *title, const char *subtitle)
{
    fprintf(out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
            "viewBox=\"0 0 %d %d\" font-family=\"Helvetica, Arial, DejaVu Sans, sans-serif\">\n"
            "<title>%s</title>\n"
            "<rect width=\"%d\" height=\"%d\" rx=\"6\" fill=\"#ffffff\"/>\n",
            width, height, width, height, title, width, height);
    part_text(out, 24, 34, ANCHOR_START, 18, INK, "%s", title);
    part_text(out, 24, 54, ANCHOR_START, 12, MIDDLING, "%s", subtitle);
}

void part_end(FILE *out)
{
    fprintf(out, "</svg>\n");
}

void part_line(FILE *out, double x0, double y0, double x1, double y1, const char *color,
               double width)
{
    fprintf(out,
            "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" "
            "stroke-width=\"%.1f\"/>\n",
            x0, y0, x1, y1, color, width);
}

void part_bar(FILE *out, double x, double y, double width, double height, const char *color)
{
    fprintf(out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>\n", x, y,
            width, height, color);
}

void part_dot(FILE *out, double x, double y, const char *color)
{
    fprintf(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", x, y, color);
}

void part_text(FILE *out, double x, double y, anchor a, int size, const char *color,
               const char *format, ...)
{
    static const char *const anchors[] = {"start", "middle", "end"};
    va_list arguments;

    fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%d\" fill=\"%s\" text-anchor=\"%s\">", x,
            y, size, color, anchors[a]);
    va_start(arguments, format);
    vfprintf(out, format, arguments);
    va_end(arguments);
    fprintf(out, "</text>\n");
}
