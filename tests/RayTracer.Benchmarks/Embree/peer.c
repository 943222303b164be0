/* Loops over whole arrays of rays around Embree's C interface, declared by hand: the wheel that it comes in has no headers. EMBREE is its major version. */
#include <immintrin.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <sys/types.h>
#include <time.h>

typedef struct { float ox, oy, oz, tnear, dx, dy, dz, time, tfar; unsigned mask, id, flags; } Ray;
typedef struct { float nx, ny, nz, u, v; unsigned primitive, geometry, instance, instancePrimitive; } Hit;
typedef struct { Ray ray; Hit hit; char spare[64]; } __attribute__((aligned(64))) RayHit;
typedef struct {
    float ox[8], oy[8], oz[8], tnear[8], dx[8], dy[8], dz[8], time[8], tfar[8];
    unsigned mask[8], id[8], flags[8];
    float nx[8], ny[8], nz[8], u[8], v[8];
    unsigned primitive[8], geometry[8], instance[8], instancePrimitive[8];
    char spare[256];
} __attribute__((aligned(64))) RayHit8;
#if EMBREE == 3
/* RTCIntersectContext, which comes before the rays. */
typedef struct { int flags; void *filter; unsigned instance; float minWidth; char spare[64]; } Arguments;
#define COHERENT 1
#define INIT(a) (a).instance = ~0u
#define ORDER(arguments, rays) arguments, rays
#else
/* RTCIntersectArguments and RTCOccludedArguments, which come after the rays. */
typedef struct { int flags; unsigned features; void *context, *filter, *intersect; float minWidth; char spare[64]; } Arguments;
#define COHERENT (1 << 16)
#define INIT(a) (a).features = ~0u
#define ORDER(arguments, rays) rays, arguments
#endif

void *rtcNewDevice(const char *), *rtcNewScene(void *), *rtcNewGeometry(void *, int);
void rtcReleaseDevice(void *), rtcReleaseScene(void *), rtcReleaseGeometry(void *);
void rtcSetSharedGeometryBuffer(void *, int, unsigned, int, const void *, size_t, size_t, size_t);
void rtcCommitGeometry(void *), rtcCommitScene(void *), rtcSetSceneBuildQuality(void *, int), rtcSetSceneFlags(void *, int);
void rtcSetDeviceMemoryMonitorFunction(void *, bool (*)(void *, ssize_t, bool), void *);
unsigned rtcAttachGeometry(void *, void *);
int rtcGetDeviceError(void *);
ssize_t rtcGetDeviceProperty(void *, int);
void rtcIntersect1(void *, ORDER(Arguments *, RayHit *)), rtcOccluded1(void *, ORDER(Arguments *, Ray *));
void rtcIntersect8(const int *, void *, ORDER(Arguments *, RayHit8 *)), rtcOccluded8(const int *, void *, ORDER(Arguments *, RayHit8 *));

enum { FLUSH_DENORMALS = 0x8040, TRIANGLES = 0, INDICES = 0, POSITIONS = 1, UINT3 = 0x5003, FLOAT3 = 0x9003 };
static int64_t allocated;

static bool count_memory(void *user, ssize_t bytes, bool after) {
    __sync_add_and_fetch(&allocated, bytes);
    return true;
}

void *peer_device(const char *settings) {
    void *device = rtcNewDevice(settings);
    if (device) rtcSetDeviceMemoryMonitorFunction(device, count_memory, 0);
    return device;
}

int64_t peer_version(void *device) { return rtcGetDeviceProperty(device, 0); }
void peer_release_device(void *device) { rtcReleaseDevice(device); }
void peer_release(void *scene) { rtcReleaseScene(scene); }

/* Builds a scene of one mesh; seconds and bytes come back. */
void *peer_build(void *device, const float *positions, int64_t positionCount, const int *indices, int64_t triangles, int flags, double *seconds, int64_t *bytes) {
    int64_t before = allocated;
    void *scene = rtcNewScene(device);
    rtcSetSceneBuildQuality(scene, 1);
    rtcSetSceneFlags(scene, flags);
    void *mesh = rtcNewGeometry(device, TRIANGLES);
    rtcSetSharedGeometryBuffer(mesh, POSITIONS, 0, FLOAT3, positions, 0, 12, positionCount);
    rtcSetSharedGeometryBuffer(mesh, INDICES, 0, UINT3, indices, 0, 12, triangles);
    struct timespec start, end;
    clock_gettime(CLOCK_MONOTONIC, &start);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene);
    clock_gettime(CLOCK_MONOTONIC, &end);
    *seconds = (end.tv_sec - start.tv_sec) + 1e-9 * (end.tv_nsec - start.tv_nsec);
    *bytes = allocated - before;
    return rtcGetDeviceError(device) ? 0 : scene;
}

/* Rays: seven arrays of origins, directions, limits. distance and primitive receive what was hit, or -1; for any hit, 0 or -1. */
void peer_trace1(void *scene, float **rays, float *distance, int *primitive, int first, int count, int any, int coherent) {
    unsigned control = _mm_getcsr();
    _mm_setcsr(control | FLUSH_DENORMALS);
    Arguments arguments;
    memset(&arguments, 0, sizeof arguments);
    arguments.flags = coherent ? COHERENT : 0;
    INIT(arguments);
    RayHit r;
    memset(&r, 0, sizeof r);
    for (int i = first; i < first + count; i++) {
        r.ray.ox = rays[0][i]; r.ray.oy = rays[1][i]; r.ray.oz = rays[2][i];
        r.ray.dx = rays[3][i]; r.ray.dy = rays[4][i]; r.ray.dz = rays[5][i];
        r.ray.tnear = 0; r.ray.tfar = rays[6][i]; r.ray.time = 0; r.ray.mask = ~0u; r.ray.flags = 0;
        r.hit.geometry = r.hit.primitive = r.hit.instance = ~0u;
        if (any) {
            rtcOccluded1(scene, ORDER(&arguments, &r.ray));
            primitive[i] = r.ray.tfar < 0 ? 0 : -1;
        } else {
            rtcIntersect1(scene, ORDER(&arguments, &r));
            distance[i] = r.ray.tfar;
            primitive[i] = r.hit.geometry == ~0u ? -1 : (int)r.hit.primitive;
        }
    }
    _mm_setcsr(control);
}

void peer_trace8(void *scene, float **rays, float *distance, int *primitive, int first, int count, int any, int coherent) {
    unsigned control = _mm_getcsr();
    _mm_setcsr(control | FLUSH_DENORMALS);
    Arguments arguments;
    memset(&arguments, 0, sizeof arguments);
    arguments.flags = coherent ? COHERENT : 0;
    INIT(arguments);
    RayHit8 r;
    memset(&r, 0, sizeof r);
    int valid[8] __attribute__((aligned(64)));
    for (int i = first; i < first + count; i += 8) {
        for (int k = 0; k < 8; k++) {
            int j = i + k < first + count ? i + k : first + count - 1;
            valid[k] = i + k < first + count ? -1 : 0;
            r.ox[k] = rays[0][j]; r.oy[k] = rays[1][j]; r.oz[k] = rays[2][j];
            r.dx[k] = rays[3][j]; r.dy[k] = rays[4][j]; r.dz[k] = rays[5][j];
            r.tnear[k] = 0; r.tfar[k] = rays[6][j]; r.time[k] = 0; r.mask[k] = ~0u; r.id[k] = k; r.flags[k] = 0;
            r.geometry[k] = r.primitive[k] = r.instance[k] = ~0u;
        }
        if (any) rtcOccluded8(valid, scene, ORDER(&arguments, &r));
        else rtcIntersect8(valid, scene, ORDER(&arguments, &r));
        for (int k = 0; k < 8 && i + k < first + count; k++) {
            if (any) {
                primitive[i + k] = r.tfar[k] < 0 ? 0 : -1;
            } else {
                distance[i + k] = r.tfar[k];
                primitive[i + k] = r.geometry[k] == ~0u ? -1 : (int)r.primitive[k];
            }
        }
    }
    _mm_setcsr(control);
}
