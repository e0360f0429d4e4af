/* Tells how the samples of a pixel become one word. The library does it in src/surfaces, in the
 * same order: ((((0 + s0) + s1) + s2) + s3) * 0.25 of each channel. */
#include "resolve.h"

#include "told.h"

void tell_resolve(const uint32_t *sample_word, uint32_t samples, uint32_t resolved)
{
    static const char channel[4][6] = {"red", "green", "blue", "alpha"};
    node_id word[4], byte[4];

    if (!told.fragment_count || samples > 4)
        return;
    graph_clear();
    trace.is_recording = true;
    report_begin("Resolve: the mean of the samples");
    for (uint32_t s = 0; s < samples; ++s) {
        word[s] = graph_add(OP_INTEGER, sample_word[s], 0, 0, 0, 0);
        report_given_word(joined_number("stored.sample", s, ""), word[s],
                          "the surface, after all draws");
    }
    for (uint32_t c = 0; c < 4; ++c) {
        node_id sum = graph_number(0.0f);

        for (uint32_t s = 0; s < samples; ++s) {
            const float value = (float)(sample_word[s] >> 8 * c & 255) * (float)(1.0 / 255.0);

            sum = graph_compute(OP_ADD, sum,
                                graph_add(OP_UNPACK_BYTE, bits_of_float(value), word[s], c, 0, 0));
        }
        const node_id mean = graph_compute(OP_MUL, sum, graph_number(0.25f));

        report_node(joined("mean.", channel[c], ""), mean);
        byte[c] = graph_add(OP_PACK_BYTE, resolved >> 8 * c & 255, mean, 0, 0, 0);
        report_node(joined("resolved.", channel[c], ""), byte[c]);
    }
    report_word("resolved", graph_add(OP_PACK_WORD, resolved, byte[0], byte[1], byte[2], byte[3]));
    report_check_nodes();
    trace.is_recording = false;
    told.fragments[told.fragment_count - 1].own_end = told.stage_count;
}
