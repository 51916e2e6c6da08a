/* Taut: cloth that keeps a bound on its stretch and crosses nothing, as a library for other programs.
 *
 *   TautOptions options;
 *   TautCloth cloth;
 *   taut_options_init(&options, sizeof options);
 *   options.scene = "tshirt";
 *   if (taut_create(&options, &cloth, NULL) == TAUT_OK) {
 *     TautFrame frame;
 *     taut_frame_init(&frame, sizeof frame);
 *     taut_step(cloth, &frame);
 *     taut_destroy(cloth);
 *   }
 *
 * Units: metres, kilograms, seconds, newtons; y is up. Stretch is length / length at rest - 1. Texts are UTF-8.
 *
 * Errors: calls return a TautResult; taut_last_error() says where, what was found and what was expected. A call that
 * fails has changed nothing, but for TAUT_ERROR_DIVERGED. Arrays stay the caller's: they are read or filled during
 * the call and not kept. Nothing is thrown, printed or ended.
 *
 * Handles are numbers that are never used twice: one that is zero, destroyed or made up gives TAUT_ERROR_HANDLE.
 * A cloth belongs to the process that made it: in a child after fork() its handle gives TAUT_ERROR_HANDLE, to
 * taut_destroy() too, which does no harm; the child makes cloths of its own.
 * The table of handles is all that two cloths share. Cloths are independent, and different threads may use different
 * ones; a cloth does one call at a time, and a second one gives TAUT_ERROR_BUSY.
 *
 * Structs begin with their size, which taut_*_init() sets, and grow at their end alone. All other members are then 0,
 * which is always the default.
 */
#ifndef TAUT_H
#define TAUT_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define TAUT_API __attribute__((visibility("default")))
#else
#define TAUT_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Changes with every change that a program built before would not survive. */
#define TAUT_ABI_VERSION 1

typedef int32_t TautResult;
enum {
  TAUT_OK = 0,
  TAUT_ERROR_HANDLE = 1,   /* no such cloth */
  TAUT_ERROR_BUSY = 2,     /* the cloth is in another call, of another thread */
  TAUT_ERROR_ARGUMENT = 3, /* an argument or a setting cannot be used */
  TAUT_ERROR_INPUT = 4,    /* a file, a scene, a mesh or a saved state cannot be used */
  TAUT_ERROR_PROMISE = 5,  /* the frame cannot be made without a crossing; the cloth is as it was before it */
  TAUT_ERROR_DIVERGED = 6, /* the cloth is lost, until taut_restore() or taut_set_positions() */
  TAUT_ERROR_MEMORY = 7,
  TAUT_ERROR_INTERNAL = 8
};

typedef struct TautCloth {
  uint64_t id;
} TautCloth;

/* The message of a taut_create() that failed, as there is no cloth to ask then. */
typedef struct TautError {
  uint32_t struct_size;
  TautResult result;
  char text[1016];
} TautError;

enum { TAUT_FLOAT = 0, TAUT_DOUBLE = 1 };

/* Points, or vectors, of three numbers each. From one to the next it is `stride` bytes, at least the size of three
 * numbers; numbers need no alignment. */
typedef struct TautPoints {
  const void *data;
  size_t count;
  size_t stride;
  int32_t type; /* TAUT_FLOAT or TAUT_DOUBLE */
} TautPoints;

typedef struct TautPointsOut {
  void *data;
  size_t count;
  size_t stride;
  int32_t type;
} TautPointsOut;

/* Faces of three corners, or of as many as `corners_per_face` says. A mesh is mended as one of a file is, with which it
 * shares all bits: vertices at equal positions at borders are one to the simulation, and so are those of parts whose
 * borders meet within 1 mm, unless garment.weld says otherwise. All keep their numbers for the caller. */
typedef struct TautMesh {
  uint32_t struct_size;
  TautPoints positions;             /* in m */
  const uint32_t *corners;          /* numbers of vertices, face after face */
  size_t corner_count;
  const uint32_t *corners_per_face; /* each at least 3; NULL: triangles */
  size_t face_count;                /* length of corners_per_face */
} TautMesh;

/* A body that the cloth stays out of. Only the solver `bounded`, which is the default, knows bodies of meshes. */
typedef struct TautBody {
  uint32_t struct_size;
  int32_t has_friction;    /* 1: `friction` holds; 0: that of the cloth does */
  const char *name;        /* for messages; may be NULL */
  const TautMesh *mesh;    /* closed; small holes are closed; NULL: the plane */
  double plane_point[3];   /* in m */
  double plane_normal[3];  /* towards the cloth, of any length above 0 */
  double friction;         /* Coulomb's coefficient, at least 0 */
  int32_t dress;           /* in TautOptions: frames before the first, in which a person grows into the clothes */
} TautBody;

/* Told, line by line, what was guessed, repaired or chosen, and what crosses: during taut_create() and taut_add_body(),
 * on their thread. It lives as long as the cloth; callers built before `bodies` came are told in taut_create() alone. */
typedef void (*TautLog)(void *user, const char *text);

/* Exactly one of scene, scene_text and mesh is set. */
typedef struct TautOptions {
  uint32_t struct_size;
  int32_t threads;             /* 1 to 64; 0: chosen by the size of the garment. Never changes a result */
  const char *scene;           /* a scene file, a garment file, or the name of a scene that comes with Taut */
  const char *scene_text;      /* a scene as TOML; the files it names are looked for where the program runs */
  const TautMesh *mesh;        /* a garment at rest that nothing holds and that gravity pulls */
  const TautPoints *start;     /* where its vertices begin, at rest; NULL: as modelled */
  const char *const *settings; /* "wind.speed = 4": any key that `taut help scene` lists, apart from pictures */
  size_t setting_count;
  const char *importer;        /* program that reads model files; NULL: libexec/taut/taut-import beside the library */
  TautLog log;                 /* NULL: nothing is told */
  void *log_user;
  int32_t counts_crossings;    /* 1: every frame is searched for triangles that cross, exactly, which takes time */
  const TautBody *const *bodies; /* there before the start is made; their numbers follow those of the scene */
  size_t body_count;
} TautOptions;

/* The promises and measures of a frame. */
typedef struct TautFrame {
  uint32_t struct_size;
  int32_t frame;                /* counted from 1, or on from where a saved state was */
  double time_s;                /* at the end of the frame */
  double max_edge_stretch;      /* of the most stretched edge */
  double max_surface_stretch;   /* along any direction in any triangle: largest singular value - 1 */
  double smallest_distance_m;   /* of the nearest triangles, or from a body, measured where the frame ends; infinite: more
                                 * than twice cloth.thickness */
  int64_t crossing_pairs;       /* pairs of triangles that cross and did not at the start, nor when a body was added or
                                 * placed, nor within what is left out; -1: not counted */
  uint64_t state_hash;          /* of all bits of positions and velocities, as in the statistics of the program */
  int32_t substeps;             /* time steps that the frame was divided into */
  int32_t is_bound_kept;        /* 1: solver.max_stretch is kept, or the solver has no bound */
  int32_t is_contact_kept;      /* 1: nothing may cross that was apart; 0 only where the scene allows it */
  int32_t is_asleep;            /* 1: at rest, nothing was computed */
  uint64_t measured_crossings;  /* all pairs of triangles that cross where the frame ends, measured in every frame */
  double left_out_share;        /* of the cloth's area, not kept apart in itself: around what crosses since the
                                 * start, and what is nearer than 2 um at rest */
} TautFrame;

typedef struct TautInfo {
  uint32_t struct_size;
  int32_t frame;
  double time_s;
  double frame_rate_hz;
  double max_stretch;      /* the bound of the solver `bounded`; of others infinite */
  size_t vertex_count;
  size_t triangle_count;
  size_t edge_count;
  size_t pin_count;
  size_t body_count;
  /* Pairs of triangles that crossed, and parts of cloth wholly within bodies, where the cloth began and where bodies
   * were added: they may stay so. 0: the cloth began apart. */
  size_t crossings_at_start;
} TautInfo;

/* Set all members to 0 and struct_size to `struct_size`, which is sizeof of the struct. TAUT_ERROR_ARGUMENT on NULL
 * and on a size that no version has. */
TAUT_API TautResult taut_error_init(TautError *error, size_t struct_size);
TAUT_API TautResult taut_mesh_init(TautMesh *mesh, size_t struct_size);
TAUT_API TautResult taut_options_init(TautOptions *options, size_t struct_size);
TAUT_API TautResult taut_body_init(TautBody *body, size_t struct_size);
TAUT_API TautResult taut_frame_init(TautFrame *frame, size_t struct_size);
TAUT_API TautResult taut_info_init(TautInfo *info, size_t struct_size);

/* "0.1.0"; TAUT_ABI_VERSION of the library; version, compiler and processor's vectors for people. Never NULL. */
TAUT_API const char *taut_version(void);
TAUT_API uint32_t taut_abi_version(void);
TAUT_API const char *taut_build_info(void);

/* Names that come with Taut, a line each: for `scene` of TautOptions, and for the key cloth.fabric. Fills in *size,
 * which counts the 0 at the end; with a buffer of NULL nothing else. TAUT_ERROR_ARGUMENT if capacity is below it. */
enum { TAUT_SCENES = 0, TAUT_FABRICS = 1 };
TAUT_API TautResult taut_list(int32_t kind, char *buffer, size_t capacity, size_t *size);

/* Makes a cloth. On failure *cloth is zero and *error, unless NULL, says why. Dressed scenes are dressed first, which
 * takes seconds. TAUT_ERROR_ARGUMENT, _INPUT, _PROMISE, _DIVERGED or _MEMORY. */
TAUT_API TautResult taut_create(const TautOptions *options, TautCloth *cloth, TautError *error);
/* A call of another thread that is under way ends as it would have. TAUT_ERROR_HANDLE. */
TAUT_API TautResult taut_destroy(TautCloth cloth);
/* The text of the cloth's last error, valid until this thread asks for another; empty before the first. Never NULL. */
TAUT_API const char *taut_last_error(TautCloth cloth);

/* Every call below gives TAUT_ERROR_HANDLE and _BUSY, and TAUT_ERROR_ARGUMENT on NULL where it is not named, on
 * numbers that are not finite or beyond 1e30, on arrays of another length than is asked for and on vertices that do
 * not exist. */
TAUT_API TautResult taut_get_info(TautCloth cloth, TautInfo *info);

/* One frame of 1 / frame rate seconds. `frame` may be NULL. TAUT_ERROR_PROMISE and _DIVERGED; targets of pins and
 * bodies are forgotten then, too. */
TAUT_API TautResult taut_step(TautCloth cloth, TautFrame *frame);

/* Changes a setting of wind, gravity, forces, air, solver, cloth or rest: taut_set(cloth, "cloth.fabric", "silk"),
 * ("solver.max_stretch", "0.01"). TAUT_ERROR_ARGUMENT on others. */
TAUT_API TautResult taut_set(TautCloth cloth, const char *key, const char *value);
/* The velocity of the air in m/s; gusts and coefficients stay. */
TAUT_API TautResult taut_set_wind(TautCloth cloth, double x, double y, double z);
/* In m/s^2. */
TAUT_API TautResult taut_set_gravity(TautCloth cloth, double x, double y, double z);
/* Forces in N on single vertices, besides those of the scene, until the next call; count 0: none. `vertices` has
 * forces->count entries. */
TAUT_API TautResult taut_set_forces(TautCloth cloth, const uint32_t *vertices, const TautPoints *forces);

/* Vertices that only taut_move_pins() and motions of the scene move, instead of all pins so far. */
TAUT_API TautResult taut_set_pins(TautCloth cloth, const uint32_t *vertices, size_t count);
/* Fills in info.pin_count vertices, ascending. */
TAUT_API TautResult taut_get_pins(TautCloth cloth, uint32_t *vertices, size_t count);
/* Where these pins are at the end of the next frame, in m: they go there in a straight line and stay. `vertices`
 * has targets->count entries. Of several calls before a frame the last holds. */
TAUT_API TautResult taut_move_pins(TautCloth cloth, const uint32_t *vertices, const TautPoints *targets);

/* Adds a body; *number counts all bodies from 0. Cloth that is in the way is left there, and the log and
 * info.crossings_at_start say so: a mesh lets it go on crossing, a plane pushes it out in the next frame.
 * TAUT_ERROR_INPUT on a mesh that is not closed. */
TAUT_API TautResult taut_add_body(TautCloth cloth, const TautBody *body, int32_t *number);
/* Where the vertices of a mesh that was added are at the end of the next frame, in m: they go there in straight
 * lines, each at most 1 m. `positions` has as many entries as the mesh had. */
TAUT_API TautResult taut_move_body(TautCloth cloth, int32_t number, const TautPoints *positions);
/* The same at once and of any distance, for a start; cloth that is in the way is left there. */
TAUT_API TautResult taut_place_body(TautCloth cloth, int32_t number, const TautPoints *positions);

/* Positions in m, of all vertices: those of the mesh given, in its order, or of the simulated mesh of a scene, as
 * `taut simulate --export` writes them. A vertex without a face stays where it was given. */
TAUT_API TautResult taut_get_positions(TautCloth cloth, const TautPointsOut *positions);
/* Goes on from this shape, at rest, at the same time; it is moved within the bound. */
TAUT_API TautResult taut_set_positions(TautCloth cloth, const TautPoints *positions);
/* At each vertex, the largest surface stretch of its triangles. `count` is info.vertex_count. */
TAUT_API TautResult taut_get_stretch(TautCloth cloth, double *stretch, size_t count);
/* Three vertices for each triangle that is simulated. `count` is 3 * info.triangle_count. */
TAUT_API TautResult taut_get_triangles(TautCloth cloth, uint32_t *vertices, size_t count);
/* Two vertices and the length at rest in m for each edge; either may be NULL. `count` is info.edge_count. */
TAUT_API TautResult taut_get_edges(TautCloth cloth, uint32_t *vertices, double *rest_lengths, size_t count);

TAUT_API TautResult taut_state_hash(TautCloth cloth, uint64_t *hash);
/* All that has to be kept to go on with the same bits, where garment, settings, pins, forces and bodies are set to
 * the same. Fills in *size; with a buffer of NULL nothing else, and TAUT_ERROR_ARGUMENT if capacity is below it. */
TAUT_API TautResult taut_save(TautCloth cloth, void *buffer, size_t capacity, size_t *size);
/* TAUT_ERROR_INPUT on bytes that are damaged or of another garment or solver. */
TAUT_API TautResult taut_restore(TautCloth cloth, const void *buffer, size_t size);
/* The same bytes as a file, which is written whole or not at all; `start.checkpoint` of a scene reads it too, and
 * taut_restore_file() reads what `taut simulate --checkpoint` writes. TAUT_ERROR_INPUT. */
TAUT_API TautResult taut_save_file(TautCloth cloth, const char *path);
TAUT_API TautResult taut_restore_file(TautCloth cloth, const char *path);

#ifdef __cplusplus
}
#endif

#endif
