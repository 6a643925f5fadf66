/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Counts what a run sends by MPI, by the stage of an exchange that sends it:
 * preloaded (LD_PRELOAD), it stands before MPI's functions, which go on under
 * their own names PMPI_*. Counts from the start of exchange COUNT_FROM to that of
 * COUNT_TO; writes count.<rank> when the run ends. stages.h is made from the
 * symbols of the library of the coupling.
 *
 * The stage is found on the stack of calls, as nothing in the solver states it. */

#define _GNU_SOURCE
#include <dlfcn.h>
#include <execinfo.h>
#include <malloc.h>
#include <mpi.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FLUID, LIGGGHTS, SMOOTHING, FIRST_STAGE };

static const struct { uintptr_t start, size; const char *name; } stages[] =
{
#include "stages.h"
};

enum
{
    N_STAGES = sizeof(stages)/sizeof(stages[0]),
    N_CLASSES = FIRST_STAGE + N_STAGES,
    DEPTH = 64,
    N_KNOWN = 1 << 15
};

/* Messages to another rank and their bytes; calls of all ranks and their bytes */
static struct counts { long sent, bytes, calls, callBytes; } counted[N_CLASSES],
    atStart[N_CLASSES], atEnd[N_CLASSES];

static long exchange, mostHeap;
static int lastClass = -1;

/* The class that an address of code stands for; FLUID if none */
static int classOf(void *address)
{
    static uintptr_t known[N_KNOWN];
    static unsigned char class[N_KNOWN];
    uintptr_t a = (uintptr_t)address;
    size_t at = (a >> 1)*2654435761u % N_KNOWN;
    Dl_info info;

    while (known[at] && known[at] != a) at = (at + 1) % N_KNOWN;
    if (known[at]) return class[at];

    known[at] = a;
    class[at] = FLUID;

    if (dladdr(address, &info))
    {
        uintptr_t offset = a - (uintptr_t)info.dli_fbase;
        int ours = strstr(info.dli_fname, "libdemCoupling") != NULL;

        for (int i = 0; i < N_STAGES; ++i)
            if (ours && offset - stages[i].start < stages[i].size)
                class[at] = FIRST_STAGE + i;
        if (strstr(info.dli_fname, "libliggghts")) class[at] = LIGGGHTS;
        if (info.dli_sname && strstr(info.dli_sname, "smoothingModels"))
            class[at] = SMOOTHING;
    }

    return class[at];
}

/* Of this call: LIGGGHTS's own, else smoothing, else the stage that it is in */
static int presentClass(void)
{
    void *frames[DEPTH];
    int n = backtrace(frames, DEPTH), found = FLUID, stage = FLUID;

    for (int i = 1; i < n; ++i)
    {
        int c = classOf(frames[i]);
        if (c >= FIRST_STAGE) stage = c;
        else if (c != FLUID && !found) found = c;
    }

    /* Each exchange begins with the grains */
    if (stage != FLUID && stage != lastClass
        && !strcmp(stages[stage - FIRST_STAGE].name, "moveGrains"))
    {
        ++exchange;
        if (exchange == atoi(getenv("COUNT_FROM")))
            memcpy(atStart, counted, sizeof(counted));
        if (exchange == atoi(getenv("COUNT_TO")))
            memcpy(atEnd, counted, sizeof(counted));
    }
    lastClass = stage;

    return found ? found : stage;
}

static void sent(int count, MPI_Datatype type)
{
    int size, c = presentClass();
    PMPI_Type_size(type, &size);
    counted[c].sent++;
    counted[c].bytes += (long)count*size;
}

static void called(int count, MPI_Datatype type)
{
    struct mallinfo2 heap = mallinfo2();
    long used = heap.uordblks + heap.hblkhd;
    int size, c = presentClass();

    if (used > mostHeap) mostHeap = used;
    PMPI_Type_size(type, &size);
    counted[c].calls++;
    counted[c].callBytes += (long)count*size;
}

#define SENDS(name, with, args) \
    int MPI_##name with { sent(n, t); return PMPI_##name args; }
#define CALLS(name, with, args) \
    int MPI_##name with { called(n, t); return PMPI_##name args; }

#define TO (const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c)
SENDS(Send, TO, (b, n, t, to, tag, c))
SENDS(Bsend, TO, (b, n, t, to, tag, c))
SENDS(Rsend, TO, (b, n, t, to, tag, c))
SENDS(Ssend, TO, (b, n, t, to, tag, c))
SENDS(Isend, (const void *b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c,
    MPI_Request *r), (b, n, t, to, tag, c, r))
SENDS(Sendrecv, (const void *b, int n, MPI_Datatype t, int to, int tag, void *b2,
    int n2, MPI_Datatype t2, int from, int tag2, MPI_Comm c, MPI_Status *s),
    (b, n, t, to, tag, b2, n2, t2, from, tag2, c, s))

CALLS(Allreduce, (const void *b, void *b2, int n, MPI_Datatype t, MPI_Op o,
    MPI_Comm c), (b, b2, n, t, o, c))
CALLS(Reduce, (const void *b, void *b2, int n, MPI_Datatype t, MPI_Op o, int root,
    MPI_Comm c), (b, b2, n, t, o, root, c))
CALLS(Scan, (const void *b, void *b2, int n, MPI_Datatype t, MPI_Op o,
    MPI_Comm c), (b, b2, n, t, o, c))
CALLS(Bcast, (void *b, int n, MPI_Datatype t, int root, MPI_Comm c),
    (b, n, t, root, c))

#define BOTH const void *b, int n, MPI_Datatype t, void *b2, int n2, MPI_Datatype t2
CALLS(Alltoall, (BOTH, MPI_Comm c), (b, n, t, b2, n2, t2, c))
CALLS(Allgather, (BOTH, MPI_Comm c), (b, n, t, b2, n2, t2, c))
CALLS(Gather, (BOTH, int root, MPI_Comm c), (b, n, t, b2, n2, t2, root, c))
CALLS(Scatter, (BOTH, int root, MPI_Comm c), (b, n, t, b2, n2, t2, root, c))
CALLS(Allgatherv, (const void *b, int n, MPI_Datatype t, void *b2, const int *n2,
    const int *d2, MPI_Datatype t2, MPI_Comm c), (b, n, t, b2, n2, d2, t2, c))
CALLS(Gatherv, (const void *b, int n, MPI_Datatype t, void *b2, const int *n2,
    const int *d2, MPI_Datatype t2, int root, MPI_Comm c),
    (b, n, t, b2, n2, d2, t2, root, c))

int MPI_Barrier(MPI_Comm c)
{
    called(0, MPI_INT);
    return PMPI_Barrier(c);
}

int MPI_Finalize(void)
{
    static const char *const others[] = {"fluid", "LIGGGHTS", "smoothing"};
    char name[64], line[256];
    long resident = 0;
    int rank;

    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    snprintf(name, sizeof(name), "count.%d", rank);
    FILE *out = fopen(name, "w"), *status = fopen("/proc/self/status", "r");

    while (status && fgets(line, sizeof(line), status))
        sscanf(line, "VmHWM: %ld", &resident);

    if (out)
    {
        fprintf(out, "exchanges %ld\nheap[B] %ld\nresident[kB] %ld\n", exchange,
            mostHeap, resident);
        for (int i = 0; i < N_CLASSES; ++i)
            fprintf(out, "%s %ld %ld %ld %ld\n",
                i < FIRST_STAGE ? others[i] : stages[i - FIRST_STAGE].name,
                atEnd[i].sent - atStart[i].sent, atEnd[i].bytes - atStart[i].bytes,
                atEnd[i].calls - atStart[i].calls,
                atEnd[i].callBytes - atStart[i].callBytes);
        fclose(out);
    }

    return PMPI_Finalize();
}
