/* What is observed, acted with and rewarded. See table.h. */

#define RECEPTORS BAD_INDEX(field_index, "field"), UNKNOWNS(receptor_quantity, 0, "quantity")
ROW(mimo_env_layout, ON_ENV, mimo_env_layout(a->env, a->layout_out), NO_NULL(layout_out, "layout"))
ROW(mimo_batch_layout, ON_BATCH | ANYTIME, mimo_batch_layout(a->batch, a->layout_out), NO_NULL(layout_out, "layout"))
ROW(mimo_senses_layout, ON_SENSES, mimo_senses_layout(a->senses, a->layout_out), NO_NULL(layout_out, "layout"))
ROW(mimo_layout_describe, ON_LAYOUT, mimo_layout_describe(a->layout, a->layout_info),
    DESCRIPTION(layout_info, mimo_layout_info, "info"))
ROW(mimo_layout_field, ON_LAYOUT, mimo_layout_field(a->layout, a->index, a->field), BAD_INDEX(index, "index"),
    DESCRIPTION(field, mimo_field, "field"))
ROW(mimo_layout_find, ON_LAYOUT, mimo_layout_find(a->layout, a->field_name, a->count), NO_NULL(field_name, "name"),
    NO_NULL(count, "index"), DO(unknown_field, MIMO_E_NOT_FOUND, "smell"))
ROW(mimo_layout_label, ON_LAYOUT, mimo_layout_label(a->layout, a->index, a->element, a->string),
    BAD_INDEX(index, "field"), BAD_INDEX(element, "element"), NO_NULL(string, "label"))
ROW(mimo_layout_delays, ON_LAYOUT, mimo_layout_delays(a->layout, a->field_index, a->delays, a->delay_count),
    BAD_INDEX(field_index, "field"), NO_NULL(delays, "seconds"),
    SIZE_IS(delay_count, 1, MIMO_E_BUFFER_TOO_SMALL, "count is 1"))
ROW(mimo_layout_directions, ON_LAYOUT,
    mimo_layout_directions(a->layout, a->picture_index, a->directions, a->direction_count),
    BAD_INDEX(picture_index, "field"), SIZE_IS(picture_index, 0, E_ARG, "expected a picture"),
    NO_NULL(directions, "directions"), SIZE_IS(direction_count, 3, MIMO_E_BUFFER_TOO_SMALL, "count is 3"))
ROW(mimo_layout_receptor_width, ON_LAYOUT,
    mimo_layout_receptor_width(a->layout, a->field_index, a->receptor_quantity, a->count), RECEPTORS,
    NO_NULL(count, "value_count"))
ROW(mimo_layout_receptors, ON_LAYOUT,
    mimo_layout_receptors(a->layout, a->field_index, a->receptor_quantity, a->receptors, a->receptor_count), RECEPTORS,
    NO_NULL(receptors, "values"), SHORT(receptor_count, "value"), BAD_SIZE(receptor_count, 1000000, "value_count"))
ROW(mimo_layout_action, ON_LAYOUT, mimo_layout_action(a->layout, a->index, a->described_action),
    BAD_INDEX(index, "index"), DESCRIPTION(described_action, mimo_action, "action"))
ROW(mimo_layout_term, ON_LAYOUT, mimo_layout_term(a->layout, a->index, a->term), BAD_INDEX(index, "index"),
    DESCRIPTION(term, mimo_term, "term"))
#undef RECEPTORS
