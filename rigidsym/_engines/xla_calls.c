/* XLA's calls of the compiled engine: handlers of its foreign function interface.

The engine's functions are bound by address, so that this file serves any library of them.  Bodies
and times that are refused have states of NaN.  The threads of XLA share the work; results do not
depend on their number. */

#include <math.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "torque_free.h"
#include "torque_free_step.h"
#include "xla/ffi/api/c_api.h"

/* Bodies, and times, that are computed by one call of the engine. */
enum { BODIES = 256, TIMES = 512, STEPS = 64 };

static struct {
    __typeof__(torque_free_propagate) *propagate;
    __typeof__(torque_free_propagate_with_columns) *propagate_with_columns;
    __typeof__(torque_free_states_at) *states_at;
    __typeof__(torque_free_states_with_columns) *states_with_columns;
    __typeof__(torque_free_last_time) *last_time;
    __typeof__(torque_free_steps) *steps;
} engine;

/* Bind the functions of the engine, in the order of the struct. */
void rigidsym_bind(void *const functions[6])
{
    memcpy(&engine, functions, sizeof engine);
}

/* One call: arrays as XLA has them, rows of `inertia` and so on for each body. */
typedef struct {
    const double *arrays[4];
    double *results[6];
    size_t sizes[6]; /* doubles in a body's, or a time's, row of each result */
    size_t bodies, times, rows; /* rows: of times, each for as many bodies */
    int columns, nonphysical;
} request;

typedef void piece(const request *asked, size_t begin, size_t end);

/* Work that threads share: each takes the next part when it is done with one. */
typedef struct {
    atomic_size_t next, done;
    atomic_int users; /* threads that may still read this; the last frees it */
    size_t count, part;
    piece *run;
    const request *asked; /* gone once all is done */
} shared;

static void work(void *data)
{
    shared *all = data;
    size_t begin;
    while ((begin = atomic_fetch_add(&all->next, all->part)) < all->count) {
        size_t left = all->count - begin, some = left < all->part ? left : all->part;
        all->run(all->asked, begin, begin + some);
        atomic_fetch_add(&all->done, some);
    }
    if (atomic_fetch_sub(&all->users, 1) == 1) {
        free(all);
    }
}

/* Run a piece for all of `count` rows, of which each costs as much as `cost` states. */
static void run(XLA_FFI_CallFrame *frame, piece *one, const request *asked, size_t count, size_t cost)
{
    size_t helpers = count * cost / (LEAST * PIECE);
    helpers = helpers > MOST ? MOST : helpers;
    int64_t threads = 1;
    XLA_FFI_ThreadPool_NumThreads_Args pool = {
        .struct_size = XLA_FFI_ThreadPool_NumThreads_Args_STRUCT_SIZE,
        .ctx = frame->ctx,
        .num_threads = &threads,
    };
    shared *all = NULL;
    XLA_FFI_Error *error = NULL;
    if (helpers > 1) {
        error = frame->api->XLA_FFI_ThreadPool_NumThreads(&pool);
        all = error || threads < 2 ? NULL : malloc(sizeof *all);
    }
    if (!all) {
        one(asked, 0, count);
    } else {
        helpers = helpers > (size_t)threads ? (size_t)threads : helpers;
        size_t part = PIECE / cost;
        *all = (shared){.count = count, .part = part ? part : 1, .run = one, .asked = asked};
        /* One more user than threads, so that it is there until all is done. */
        atomic_store(&all->users, 2);
        for (size_t k = 1; k < helpers && !error; k++) {
            XLA_FFI_ThreadPool_Schedule_Args task = {
                .struct_size = XLA_FFI_ThreadPool_Schedule_Args_STRUCT_SIZE,
                .ctx = frame->ctx,
                .task = work,
                .data = all,
            };
            atomic_fetch_add(&all->users, 1);
            error = frame->api->XLA_FFI_ThreadPool_Schedule(&task);
            if (error) {
                atomic_fetch_sub(&all->users, 1);
            }
        }
        work(all);
        while (atomic_load(&all->done) < count) {
            sched_yield();
        }
        if (atomic_fetch_sub(&all->users, 1) == 1) {
            free(all);
        }
    }
    /* Without threads of XLA this one has done all of it. */
    if (error) {
        XLA_FFI_Error_Destroy_Args gone = {
            .struct_size = XLA_FFI_Error_Destroy_Args_STRUCT_SIZE,
            .error = error,
        };
        frame->api->XLA_FFI_Error_Destroy(&gone);
    }
}

static void refuse(double *row, size_t size)
{
    for (size_t k = 0; k < size; k++) {
        row[k] = NAN;
    }
}

/* The largest moment is beyond the sum of the others, or a moment is not positive: as
   `batches.possible` decides, exactly, in moments scaled to between 1 and 2. */
static int impossible(const double inertia[3])
{
    double low = inertia[0], middle = inertia[1], high = inertia[2], swap;
    if (low > middle) {
        swap = low, low = middle, middle = swap;
    }
    if (middle > high) {
        swap = middle, middle = high, high = swap;
    }
    if (low > middle) {
        swap = low, low = middle, middle = swap;
    }
    if (!(low > 0) || !isfinite(high)) {
        return 1;
    }
    int exponent;
    (void)frexp(high, &exponent);
    low = ldexp(low, 1 - exponent), middle = ldexp(middle, 1 - exponent);
    high = ldexp(high, 1 - exponent);
    double total = low + middle, part = total - low;
    double rest = (low - (total - part)) + (middle - part);
    double over = high - total, beyond = over - rest;
    part = beyond - over;
    double more = (over - (beyond - part)) + (-rest - part);
    double allowed = ROUNDING * low;
    return high > total && (beyond > allowed || (beyond == allowed && more > 0));
}

static void refuse_impossible(const request *asked, size_t begin, size_t end, int results)
{
    for (size_t body = begin; body < end && !asked->nonphysical; body++) {
        if (impossible(asked->arrays[0] + 3 * body)) {
            for (int k = 0; k < results; k++) {
                refuse(asked->results[k] + body * asked->sizes[k], asked->sizes[k]);
            }
        }
    }
}

static void propagate_bodies(const request *asked, size_t begin, size_t end)
{
    size_t each = asked->bodies / asked->rows, last = 0, failed;
    int codes[BODIES];
    for (size_t body = begin; body < end; body = last) {
        last = end - body < BODIES ? end : body + BODIES;
        /* Times are one row for all of a call, or one for each body. */
        size_t row = body / each, common = (row + 1) * each;
        if (each > 1 && last > common) {
            last = common;
        }
        size_t count = last - body, stride = each > 1 ? 0 : asked->times;
        const double *inertia = asked->arrays[0] + 3 * body, *omega0 = asked->arrays[1] + 3 * body;
        const double *attitude0 = asked->arrays[2] + 4 * body;
        const double *t = asked->arrays[3] + row * asked->times;
        double *to[6] = {0};
        for (int k = 0; k < (asked->columns ? 6 : 2); k++) {
            to[k] = asked->results[k] + body * asked->sizes[k];
        }
        if (asked->columns) {
            engine.propagate_with_columns(count, inertia, omega0, attitude0, asked->times, t,
                stride, asked->columns, to[0], to[1], to[2], to[3], to[4], to[5], codes, &failed);
        } else {
            engine.propagate(count, inertia, omega0, attitude0, asked->times, t, stride, to[0],
                to[1], codes, &failed);
        }
    }
    refuse_impossible(asked, begin, end, asked->columns ? 6 : 2);
}

static void step_bodies(const request *asked, size_t begin, size_t end)
{
    size_t failed;
    for (size_t body = begin, last = begin; body < end; body = last) {
        size_t until = end - body < STEPS ? end : body + STEPS;
        /* A refused body ends a call, before those just before it are written. */
        for (last = until; last > body;) {
            int code = engine.steps(last - body, asked->arrays[0] + 3 * body, 3,
                asked->arrays[1] + 4 * body, asked->arrays[2] + 3 * body, asked->arrays[3] + body, 1,
                asked->results[0] + 4 * body, asked->results[1] + 3 * body, &failed);
            if (!code) {
                break;
            }
            last = body + failed;
        }
        if (last < until) {
            refuse(asked->results[0] + 4 * last, 4);
            refuse(asked->results[1] + 3 * last, 3);
            last++;
        }
    }
    refuse_impossible(asked, begin, end, 2);
}

static void states_at_times(const request *asked, size_t begin, size_t end)
{
    const torque_free_motion *motion = (const torque_free_motion *)asked->arrays[0];
    double final = engine.last_time(motion), near[TIMES];
    for (size_t first = begin, last = begin; first < end; first = last) {
        last = end - first < TIMES ? end : first + TIMES;
        const double *t = asked->arrays[1] + first;
        size_t count = last - first;
        for (size_t k = 0; k < count; k++) {
            near[k] = fabs(t[k]) <= final ? t[k] : 0.0;
        }
        double *to[4] = {0};
        int results = asked->columns ? 4 : 2;
        for (int k = 0; k < results; k++) {
            to[k] = asked->results[k] + first * asked->sizes[k];
        }
        if (asked->columns) {
            engine.states_with_columns(motion, count, near, asked->columns, to[0], to[1], NULL,
                NULL, to[2], to[3]);
        } else {
            engine.states_at(motion, count, near, to[0], to[1]);
        }
        for (size_t k = 0; k < count; k++) {
            for (int j = 0; j < results && !(fabs(t[k]) <= final); j++) {
                refuse(to[j] + k * asked->sizes[j], asked->sizes[j]);
            }
        }
    }
}

static size_t elements(const XLA_FFI_Buffer *buffer)
{
    size_t count = 1;
    for (int64_t k = 0; k < buffer->rank; k++) {
        count *= (size_t)buffer->dims[k];
    }
    return count;
}

static size_t width(const XLA_FFI_Buffer *buffer)
{
    return (size_t)buffer->dims[buffer->rank - 1];
}

/* Answer a question about the handler.  Returns 0 for a call. */
static int described(XLA_FFI_CallFrame *frame)
{
    XLA_FFI_Extension_Base *extension = frame->extension_start;
    if (!extension || extension->type != XLA_FFI_Extension_Metadata) {
        return 0;
    }
    XLA_FFI_Metadata *metadata = ((XLA_FFI_Metadata_Extension *)extension)->metadata;
    metadata->api_version = (XLA_FFI_Api_Version){
        .struct_size = XLA_FFI_Api_Version_STRUCT_SIZE,
        .major_version = XLA_FFI_API_MAJOR,
        .minor_version = XLA_FFI_API_MINOR,
    };
    metadata->traits = 0;
    return 1;
}

/* The arrays, results and attributes of a call.  Each result has `count` rows. */
static request requested(const XLA_FFI_CallFrame *frame, size_t count)
{
    request asked = {.bodies = count};
    XLA_FFI_Buffer **arrays = (XLA_FFI_Buffer **)frame->args.args;
    XLA_FFI_Buffer **results = (XLA_FFI_Buffer **)frame->rets.rets;
    for (int64_t k = 0; k < frame->args.size; k++) {
        asked.arrays[k] = arrays[k]->data;
    }
    for (int64_t k = 0; k < frame->rets.size; k++) {
        asked.results[k] = results[k]->data;
        asked.sizes[k] = count ? elements(results[k]) / count : 0;
    }
    /* Sorted by name: columns, nonphysical. */
    asked.columns = *(const int32_t *)((XLA_FFI_Scalar *)frame->attrs.attrs[0])->value;
    asked.nonphysical = *(const int32_t *)((XLA_FFI_Scalar *)frame->attrs.attrs[1])->value;
    return asked;
}

/* inertia (..., 3), omega0 (..., 3), attitude0 (..., 4) and t (..., N) to q, omega and, by columns,
   attitude, rates, attitude_t, rates_t.  The leading shape of t begins as that of the bodies does. */
XLA_FFI_Error *rigidsym_propagate(XLA_FFI_CallFrame *frame)
{
    if (described(frame)) {
        return NULL;
    }
    const XLA_FFI_Buffer *inertia = frame->args.args[0], *t = frame->args.args[3];
    size_t bodies = elements(inertia) / 3, times = width(t);
    if (bodies && times) {
        request asked = requested(frame, bodies);
        asked.times = times;
        asked.rows = elements(t) / times;
        size_t cost = PREPARATION + (asked.columns ? SENSITIVITY : 1) * times;
        run(frame, propagate_bodies, &asked, bodies, cost);
    }
    return NULL;
}

/* inertia (..., 3), q (..., 4), omega (..., 3) and dt (...) to q and omega. */
XLA_FFI_Error *rigidsym_step(XLA_FFI_CallFrame *frame)
{
    if (described(frame)) {
        return NULL;
    }
    size_t bodies = elements(frame->args.args[0]) / 3;
    if (bodies) {
        request asked = requested(frame, bodies);
        run(frame, step_bodies, &asked, bodies, STEP);
    }
    return NULL;
}

/* A prepared motion, as bytes, and t (...) to q, omega and, by columns, attitude_t and rates_t. */
XLA_FFI_Error *rigidsym_states(XLA_FFI_CallFrame *frame)
{
    if (described(frame)) {
        return NULL;
    }
    size_t times = elements(frame->args.args[1]);
    if (times) {
        request asked = requested(frame, times);
        run(frame, states_at_times, &asked, times, asked.columns ? SENSITIVITY : 1);
    }
    return NULL;
}
