"""C sources of as much as an engine is made of, quick to compile."""

import re

STUB = """/* digest {digest} */
#include <stddef.h>
typedef struct {{ double x; }} torque_free_motion;
const char *torque_free_digest(void) {{ return "{digest}"; }}
const char *torque_free_message(int code) {{ (void)code; return "inertia: refused"; }}
const char *torque_free_field(int code) {{ (void)code; return "inertia"; }}
const char *torque_free_rule(int code) {{ (void)code; return "refused"; }}
size_t torque_free_motion_size(void) {{ return 8; }}
int torque_free_motion_init(torque_free_motion *motion, const double inertia[3],
                            const double omega0[3], const double attitude0[4])
{{ return motion && inertia && omega0 && attitude0 ? 2 : 0; }}
int torque_free_state_at(const torque_free_motion *motion, double t, double q[4], double omega[3])
{{ return motion && t && q && omega ? 6 : 6; }}
int torque_free_propagate(size_t bodies)
{{ return bodies > 0 ? 2 : 0; }}
"""


def stub(digit):
    source = STUB.format(digest=digit * 64)
    declared = re.findall(r"^[^/#{}]+(?=\s*\{)", source.partition("motion;")[2], re.MULTILINE)
    header = "enum {\n    TORQUE_FREE_ARITHMETIC = 8\n};\n"
    header += "".join(f"{head.strip()};\n" for head in declared)
    return {"torque_free.h": header, "torque_free.c": source}
