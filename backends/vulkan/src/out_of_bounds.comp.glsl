// Reads a row of a table that a constant names: whatever number that is. For a test that such a fault is found.
struct Table {
    vec4 rows[4];
};
struct Push {
    vec4 row;
};
UNIFORMS(0, Table, table)
IMAGE_2D(1, target)
PUSH_CONSTANTS(Push, push)
LOCAL_SIZE(1, 1, 1)

COMPUTE_MAIN(id) { imageStore(target, ivec2(id.x, 0), vec4(table.rows[int(push.row.x)])); }
