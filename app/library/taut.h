/* Taut: a library that simulates cloth with bounded stretch and without crossings.
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
 * Units: metres, kilograms, seconds, newtons; y is up. Stretch is length / rest length - 1. Texts are UTF-8.
 *
 * Errors: calls return a TautResult; taut_last_error() names the place, the value found and the value expected. A
 * failed call has changed nothing, except for TAUT_ERROR_DIVERGED. Arrays belong to the caller: they are read or filled
 * during the call and not kept. No call throws, prints or ends the program.
 *
 * Handles are numbers that are never used twice: zero, a destroyed or an invented handle gives TAUT_ERROR_HANDLE.
 * A cloth belongs to the process that made it. In a child after fork() every call with its handle gives
 * TAUT_ERROR_HANDLE, even taut_destroy(), and does no harm; the child can make its own cloths.
 *
 * Threads: cloths share only the table of handles, so different threads may use different cloths. A cloth executes one
 * call at a time; a second call meanwhile gives TAUT_ERROR_BUSY.
 *
 * Structs begin with their size and grow only at their end. taut_*_init() sets the size, and all other members to 0,
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

/* Increases with every change that breaks programs built before it. */
#define TAUT_ABI_VERSION 1

typedef int32_t TautResult;
enum {
  TAUT_OK = 0,
  TAUT_ERROR_HANDLE = 1,   /* no such cloth */
  TAUT_ERROR_BUSY = 2,     /* another thread's call uses the cloth */
  TAUT_ERROR_ARGUMENT = 3, /* an argument or a setting is not valid */
  TAUT_ERROR_INPUT = 4,    /* a file, a scene, a mesh or a saved state cannot be used */
  TAUT_ERROR_PROMISE = 5,  /* the frame cannot be made without a crossing; the cloth stays at the frame before */
  TAUT_ERROR_DIVERGED = 6, /* the cloth is unusable until taut_restore() or taut_set_positions() */
  TAUT_ERROR_MEMORY = 7,
  TAUT_ERROR_INTERNAL = 8
};

typedef struct TautCloth {
  uint64_t id;
} TautCloth;

/* Message of a failed taut_create(), which leaves no cloth for taut_last_error(). */
typedef struct TautError {
  uint32_t struct_size;
  TautResult result;
  char text[1016];
} TautError;

enum { TAUT_FLOAT = 0, TAUT_DOUBLE = 1 };

/* Points or vectors of three numbers each. `stride` is the distance in bytes from one to the next, at least the size of
 * three numbers. Numbers need no alignment. */
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

/* A mesh with triangles, or with the corner counts of `corners_per_face`. It is repaired like a mesh of a file and
 * gives the same bits. The simulation merges border vertices at equal positions and, unless garment.weld is set,
 * vertices of parts whose borders meet within 1 mm. All vertices keep their numbers for the caller. */
typedef struct TautMesh {
  uint32_t struct_size;
  TautPoints positions;             /* metres */
  const uint32_t *corners;          /* vertex numbers, face after face */
  size_t corner_count;
  const uint32_t *corners_per_face; /* at least 3 each; NULL: triangles */
  size_t face_count;                /* length of corners_per_face */
} TautMesh;

/* A body that the cloth cannot enter: a mesh or a plane. Only the default solver, `bounded`, supports mesh bodies. */
typedef struct TautBody {
  uint32_t struct_size;
  int32_t has_friction;    /* 1: uses `friction`; 0: uses the cloth's friction */
  const char *name;        /* used in messages; may be NULL */
  const TautMesh *mesh;    /* closed mesh, whose small holes are repaired; NULL: a plane */
  double plane_point[3];   /* metres */
  double plane_normal[3];  /* points towards the cloth; any length above 0 */
  double friction;         /* Coulomb's coefficient, 0 to 10 */
  int32_t dress;           /* frames before the first in which the body grows into the garment; 0 for taut_add_body() */
} TautBody;

/* Receives messages line by line: guesses, repairs, choices and crossings. taut_create() and taut_add_body() call it on
 * their thread, so it must live as long as the cloth. For callers built before TautOptions had `bodies`, only
 * taut_create() calls it. */
typedef void (*TautLog)(void *user, const char *text);

/* Options of a cloth. Exactly one of scene, scene_text and mesh must be set. */
typedef struct TautOptions {
  uint32_t struct_size;
  int32_t threads;             /* 1 to 64; 0: chosen by the garment's size; never changes a result */
  const char *scene;           /* scene file, garment file, or name of a built-in scene */
  const char *scene_text;      /* scene as TOML; its file names are relative to the working folder */
  const TautMesh *mesh;        /* garment at rest, without pins, under gravity */
  const TautPoints *start;     /* start positions of its vertices, at rest; NULL: as modelled */
  const char *const *settings; /* "wind.speed = 4": any key of `taut help scene` */
  size_t setting_count;
  const char *importer;        /* program that reads model files; NULL: libexec/taut/taut-import beside the library */
  TautLog log;                 /* NULL: no messages */
  void *log_user;
  int32_t counts_crossings;    /* 1: counts crossing triangles of every frame exactly, which takes time */
  const TautBody *const *bodies; /* bodies of the start; their numbers follow the scene's bodies */
  size_t body_count;
} TautOptions;

/* Promises and measurements of a frame. */
typedef struct TautFrame {
  uint32_t struct_size;
  int32_t frame;                /* counted from 1, or continued from the frame of a restored state */
  double time_s;                /* time at the end of the frame */
  double max_edge_stretch;      /* largest stretch of any edge */
  double max_surface_stretch;   /* largest stretch of any triangle in any direction: largest singular value - 1 */
  double smallest_distance_m;   /* distance of the nearest triangles, or to a body, at the end of the frame; infinite:
                                 * more than twice cloth.thickness */
  int64_t crossing_pairs;       /* new crossing pairs of triangles: not the pairs that crossed at the start or when a
                                 * body was added or placed, nor pairs within the left-out parts; -1: not counted */
  uint64_t state_hash;          /* hash of all bits of positions and velocities, as in the program's statistics */
  int32_t substeps;             /* number of time steps in the frame */
  int32_t is_bound_kept;        /* 1: within solver.max_stretch, or the solver has no bound */
  int32_t is_contact_kept;      /* 1: no new crossing is possible; 0 only if the scene allows crossings */
  int32_t is_asleep;            /* 1: the cloth is at rest and nothing was computed */
  uint64_t measured_crossings;  /* all crossing pairs of triangles at the end of the frame; always measured */
  double left_out_share;        /* fraction of the cloth's area without self-contact: parts around crossings of the
                                 * start, and parts nearer than 2 um at rest */
  double wind_force_n;          /* force of the wind on the whole cloth at the end of the frame; 0 without wind */
  double wind_power_w;          /* its power; below 0 where air brakes the cloth */
} TautFrame;

/* Size and settings of a cloth. */
typedef struct TautInfo {
  uint32_t struct_size;
  int32_t frame;
  double time_s;
  double frame_rate_hz;
  double max_stretch;      /* bound of the solver `bounded`; infinite for other solvers */
  size_t vertex_count;
  size_t triangle_count;
  size_t edge_count;
  size_t pin_count;
  size_t body_count;
  /* Number of crossing pairs of triangles, and of parts of the cloth wholly within bodies, at the start and when
   * bodies were added. They may stay so. 0: the start had no crossings. */
  size_t crossings_at_start;
} TautInfo;

/* These calls set all members to 0 and struct_size to `struct_size`, the sizeof the struct. TAUT_ERROR_ARGUMENT for
 * NULL or a size that no version has. */
TAUT_API TautResult taut_error_init(TautError *error, size_t struct_size);
TAUT_API TautResult taut_mesh_init(TautMesh *mesh, size_t struct_size);
TAUT_API TautResult taut_options_init(TautOptions *options, size_t struct_size);
TAUT_API TautResult taut_body_init(TautBody *body, size_t struct_size);
TAUT_API TautResult taut_frame_init(TautFrame *frame, size_t struct_size);
TAUT_API TautResult taut_info_init(TautInfo *info, size_t struct_size);

/* Return the version, such as "0.1.0"; the library's TAUT_ABI_VERSION; and a text with version, compiler and the vector
 * units of this processor. The texts are never NULL. */
TAUT_API const char *taut_version(void);
TAUT_API uint32_t taut_abi_version(void);
TAUT_API const char *taut_build_info(void);

/* Lists built-in names, one per line: scenes for TautOptions.scene, or fabrics for the key cloth.fabric. *size becomes
 * the length with the 0 at the end; a NULL buffer asks only for it. TAUT_ERROR_ARGUMENT if capacity is smaller. */
enum { TAUT_SCENES = 0, TAUT_FABRICS = 1 };
TAUT_API TautResult taut_list(int32_t kind, char *buffer, size_t capacity, size_t *size);

/* Makes a cloth. On failure *cloth is zero and *error, unless NULL, gives the reason. A scene with a body to dress is
 * dressed first, which takes seconds. TAUT_ERROR_ARGUMENT, _INPUT, _PROMISE, _DIVERGED or _MEMORY. */
TAUT_API TautResult taut_create(const TautOptions *options, TautCloth *cloth, TautError *error);
/* Destroys a cloth. A call of another thread that uses it still finishes normally. TAUT_ERROR_HANDLE. */
TAUT_API TautResult taut_destroy(TautCloth cloth);
/* Returns the text of the cloth's last error, or an empty text if there was none. Never NULL. The text is valid until
 * this thread's next call of this function. */
TAUT_API const char *taut_last_error(TautCloth cloth);

/* Every call below can give TAUT_ERROR_HANDLE and _BUSY. It gives TAUT_ERROR_ARGUMENT for NULL unless its comment
 * allows NULL, for numbers that are not finite or beyond 1e30, for arrays of the wrong length and for vertices that do
 * not exist. */
TAUT_API TautResult taut_get_info(TautCloth cloth, TautInfo *info);

/* Simulates one frame of 1 / frame rate seconds. `frame` may be NULL. TAUT_ERROR_PROMISE and _DIVERGED. Targets of pins
 * and bodies are forgotten afterwards, also after these errors. */
TAUT_API TautResult taut_step(TautCloth cloth, TautFrame *frame);

/* Changes a setting of wind, gravity, forces, air, solver, cloth, rest, pins.motion, camera or picture: taut_set(cloth,
 * "cloth.fabric", "silk"), ("solver.max_stretch", "0.01"). TAUT_ERROR_ARGUMENT for other keys. */
TAUT_API TautResult taut_set(TautCloth cloth, const char *key, const char *value);
/* Sets the velocity of the air in m/s. Gusts and coefficients do not change. */
TAUT_API TautResult taut_set_wind(TautCloth cloth, double x, double y, double z);
/* Sets the gravity in m/s^2. */
TAUT_API TautResult taut_set_gravity(TautCloth cloth, double x, double y, double z);
/* Sets forces in N on single vertices, in addition to the scene's forces and instead of those of the last call. A count
 * of 0 removes them. `vertices` has forces->count entries. */
TAUT_API TautResult taut_set_forces(TautCloth cloth, const uint32_t *vertices, const TautPoints *forces);

/* Replaces all pins. Only taut_move_pins() and motions of the scene move pinned vertices. */
TAUT_API TautResult taut_set_pins(TautCloth cloth, const uint32_t *vertices, size_t count);
/* Gets the pinned vertices, ascending. `count` is info.pin_count. */
TAUT_API TautResult taut_get_pins(TautCloth cloth, uint32_t *vertices, size_t count);
/* Sets the positions in m of these pins at the end of the next frame. They move there in straight lines and stay.
 * `vertices` has targets->count entries. A later call before the frame replaces an earlier one. */
TAUT_API TautResult taut_move_pins(TautCloth cloth, const uint32_t *vertices, const TautPoints *targets);

/* Adds a body. *number becomes its number, counted from 0 over all bodies; `number` may be NULL. Cloth inside the body
 * stays there, and the log and info.crossings_at_start report it: a mesh lets it go on crossing, a plane pushes it out
 * in the next frame. TAUT_ERROR_INPUT for a mesh that is not closed. */
TAUT_API TautResult taut_add_body(TautCloth cloth, const TautBody *body, int32_t *number);
/* Sets the positions in m of an added mesh's vertices at the end of the next frame. They move there in straight lines
 * of at most 1 m. `positions` has one entry for each position of the mesh. */
TAUT_API TautResult taut_move_body(TautCloth cloth, int32_t number, const TautPoints *positions);
/* Moves a mesh body as taut_move_body() does, but at once and any distance, for a start. Cloth inside the body stays
 * there. */
TAUT_API TautResult taut_place_body(TautCloth cloth, int32_t number, const TautPoints *positions);

/* Gets the positions in m of all vertices: of the caller's mesh in its order, or of a scene's simulated mesh, as
 * `taut simulate --export` writes them. A vertex without a face keeps the caller's position. */
TAUT_API TautResult taut_get_positions(TautCloth cloth, const TautPointsOut *positions);
/* Continues from this shape, without velocity, at the same time. The shape is projected into the bound. */
TAUT_API TautResult taut_set_positions(TautCloth cloth, const TautPoints *positions);
/* Gets the largest surface stretch of the triangles at each vertex. `count` is info.vertex_count. */
TAUT_API TautResult taut_get_stretch(TautCloth cloth, double *stretch, size_t count);
/* Gets the three vertices of each simulated triangle. `count` is 3 * info.triangle_count. */
TAUT_API TautResult taut_get_triangles(TautCloth cloth, uint32_t *vertices, size_t count);
/* Gets the two vertices and the rest length in m of each edge. Either array may be NULL. `count` is info.edge_count. */
TAUT_API TautResult taut_get_edges(TautCloth cloth, uint32_t *vertices, double *rest_lengths, size_t count);

/* Draws the cloth and the bodies as `taut render` does, without its legend: three bytes for each pixel, red, green and
 * blue of sRGB, row by row from the upper left corner. Keys of pictures set the look, except picture.width and .height;
 * the background cannot be transparent. The sides are 16 to 16384 pixels and `size` is 3 * width_px * height_px.
 * TAUT_ERROR_INPUT without Mesa's libOSMesa.so.8 and without EGL, which are opened when the first picture is drawn. */
TAUT_API TautResult taut_draw(TautCloth cloth, int32_t width_px, int32_t height_px, uint8_t *rgb, size_t size);

/* Gets the hash of all bits of positions and velocities: TautFrame.state_hash. */
TAUT_API TautResult taut_state_hash(TautCloth cloth, uint64_t *hash);
/* Saves the state. A cloth with the same garment, settings, pins, forces and bodies continues from it with the same
 * bits. *size becomes the length; a NULL buffer asks only for it. TAUT_ERROR_ARGUMENT if capacity is smaller. */
TAUT_API TautResult taut_save(TautCloth cloth, void *buffer, size_t capacity, size_t *size);
/* Restores a saved state. TAUT_ERROR_INPUT if the bytes are damaged or belong to another garment or solver. */
TAUT_API TautResult taut_restore(TautCloth cloth, const void *buffer, size_t size);
/* Save and restore the same bytes as a file, which is written completely or not at all. The key start.checkpoint of a
 * scene reads this file too, and taut_restore_file() also reads files of `taut simulate --checkpoint`.
 * TAUT_ERROR_INPUT. */
TAUT_API TautResult taut_save_file(TautCloth cloth, const char *path);
TAUT_API TautResult taut_restore_file(TautCloth cloth, const char *path);

#ifdef __cplusplus
}
#endif

#endif
