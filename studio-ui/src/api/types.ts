// Every request, answer and event of the studio's server. The server's models are the same, name by name:
// src/swifttailor/studio/models.py; tests/studio/test_contract.py compares the two.
// Lengths are centimetres. Ids are opaque. Fields are only ever added.

// --- shared -------------------------------------------------------------------------------------------------

export interface ErrorAnswer {
  error: ErrorInfo;
}

export interface ErrorInfo {
  /** Stable kebab-case name, such as "pattern-unreadable"; listed in API.md. */
  code: string;
  /** What is wrong, with the value. */
  message: string;
  /** What to do next; may be empty. */
  hint: string;
}

export type Severity = "error" | "warning" | "info";
export type Part = "upper" | "lower" | "whole";
export type FabricName =
  | "cotton"
  | "linen"
  | "twill"
  | "denim"
  | "silk"
  | "chiffon"
  | "wool"
  | "leather"
  | "polyester"
  | "jersey"
  | "rib-knit"
  | "sweatshirt"
  | "ponte"
  | "fleece"
  | "swimwear";
export type Figure = "women" | "men" | "children";
export type Unit = "cm" | "pieces" | "times";

export interface EdgePlace {
  panel: string;
  edge: number;
}

// --- GarmentCode's pattern JSON -----------------------------------------------------------------------------

export type Point = [number, number];
export type Vector = [number, number, number];

export interface Curvature {
  type: "circle" | "quadratic" | "cubic";
  /** circle: [radius, large 0|1, right 0|1]; quadratic: [[x, y]]; cubic: [[x, y], [x, y]], relative to the chord. */
  params: [number, number, number] | [Point] | [Point, Point];
}

export interface EdgeJson {
  endpoints: [number, number];
  curvature?: Curvature;
  label?: string;
}

export interface PanelJson {
  translation: Vector;
  rotation: Vector;
  vertices: Point[];
  edges: EdgeJson[];
  label?: string;
}

export type StitchJson = [EdgePlace, EdgePlace] | [EdgePlace, EdgePlace, "right_wrong"];

/** GarmentCode's specification file. In answers always in cm, loops in order, panels and stitches canonical. */
export interface PatternJson {
  pattern: {
    panels: Record<string, PanelJson>;
    stitches: StitchJson[];
    panel_order?: string[];
  };
  properties?: Record<string, unknown>;
  parameters?: Record<string, unknown>;
  parameter_order?: string[];
}

// --- what is known of a pattern -----------------------------------------------------------------------------

export interface FindingInfo {
  /** Such as "self-crossing"; docs/checks.md lists them. */
  code: string;
  severity: Severity;
  message: string;
  why: string;
  /** What mends it, in words. */
  repair: string;
  /** Empty where it is about the whole pattern. */
  panel: string;
  edge: number | null;
  stitch: number | null;
  /** Edges to show; the two sides of a stitch, the edges of a crossing. */
  edges: EdgePlace[];
  /** Panel-local cm points to zoom to. */
  points: Point[];
  /** Whether POST /api/repair mends it. */
  mendable: boolean;
}

export interface SeamSide extends EdgePlace {
  length: number;
}

export interface SeamInfo {
  /** Index into pattern.stitches of the same document. */
  stitch: number;
  first: SeamSide;
  second: SeamSide;
  right_wrong: boolean;
  /** Length of the first side less that of the second, cm. */
  mismatch: number;
  /** The longer side over the shorter. */
  ratio: number;
  /** Whether that is a fault, and not meant as a gather. */
  uneven: boolean;
}

/** Where a pocket, a button, a zip or a line of stitches lies on a panel. Belts go around, and lie on none. */
export interface TrimMark {
  /** Its name in the pattern's properties.trims. */
  trim: string;
  panel: string;
  /** "outline": closed, of what is sewn on; "line": stitches, openings, cords. */
  kind: "outline" | "line" | "zip" | "button";
  /** Panel-local cm: of outlines and lines in order, of a button its middle. */
  points: Point[];
  /** Of a button, cm; else 0. */
  radius: number;
}

export interface DimensionInfo {
  /** What to send back in a change. */
  name: string;
  /** For people. */
  about: string;
  unit: Unit;
  value: number;
  min: number;
  max: number;
  step: number;
  /** "length", "width", "neck", "sleeves" or "details", to group sliders. */
  group: string;
}

export interface RangeInfo {
  min: number;
  max: number;
  step: number;
}

export interface Chip {
  /** Unique within a reading. */
  id: string;
  /** Name of the claim to send back in a change; null where it cannot be changed. */
  claim: string | null;
  /** Name of a dimension, where it is a step ("longer"); null otherwise. */
  dimension: string | null;
  /** What it is about: "where the hem of a dress or skirt ends". */
  about: string;
  /** Short: "hem". */
  label: string;
  value: string | number | null;
  /** As shown: "hem: knee". */
  text: string;
  unit: "" | Unit;
  /** 0 to 1; null where it is read off the pattern. */
  certainty: number | null;
  from: "text" | "picture" | "pattern";
  /** Whether it is so in the pattern; null where that cannot be told. */
  holds: boolean | null;
  /** Words it can be changed to, this one included; empty for numbers. */
  choices: string[];
  /** For numbers. */
  range: RangeInfo | null;
}

export interface Reading {
  made: Chip[];
  assumed: Chip[];
  cannot: Chip[];
  unknown: Chip[];
  /** What the pattern shows besides: chips that were not asked for, and can be changed all the same. */
  shown: Chip[];
  /** "en", "de", "fr", "es"; null without text. */
  language: string | null;
  /** "#rrggbb" of the cloth; null where none was named. */
  color: string | null;
  fabric: FabricName | null;
}

export interface QualityInfo {
  accepted: boolean;
  reasons: string[];
}

export type Origin =
  | "example"
  | "generate"
  | "edit"
  | "sew"
  | "finish"
  | "drape"
  | "alter"
  | "repair"
  | "open"
  | "live"
  | "fit";

/** How a part looks, where that is otherwise than the rest: a white collar, sleeves of lace. */
export interface PartLook {
  part: string;
  color?: string | null;
  cloth?: string | null;
  opacity?: number | null;
  /** Whether it has the print, where the rest of the garment has a colour instead. */
  printed?: boolean | null;
}

/** How a panel looks. */
export interface PanelLook {
  /** "#rrggbb"; null: as the garment. */
  color: string | null;
  /** Share of what lies beneath that it hides. */
  opacity: number;
  /** Whether the garment's print is on it; absent in what earlier versions have saved. */
  printed?: boolean;
}

export interface Looks {
  /** As requests take them. */
  parts: PartLook[];
  /** The panels that these are, by name. */
  panels: Record<string, PanelLook>;
}

/** Bands, crossing bands, tartan, dots, or a drawing that repeats. */
export type PrintKind = "stripes" | "checks" | "plaid" | "dots" | "motif";
export type PrintMotif =
  | "flowers"
  | "leaves"
  | "blotches"
  | "spots"
  | "shapes"
  | "bands"
  | "hearts"
  | "stars"
  | "moons"
  | "bolts"
  | "cherries"
  | "strawberries"
  | "lemons"
  | "mushrooms"
  | "foxes"
  | "cats"
  | "bears"
  | "rabbits"
  | "birds"
  | "butterflies"
  | "bees"
  | "fishes"
  | "dinosaurs"
  | "anchors"
  | "boats"
  | "splatters"
  | "cranes"
  | "elephants"
  | "dogs"
  | "horses"
  | "flamingos"
  | "owls"
  | "turtles"
  | "pineapples"
  | "skulls"
  | "snowflakes"
  | "crosses"
  | "leopard"
  | "zebra"
  | "tiger"
  | "giraffe"
  | "cowhide"
  | "dalmatian"
  | "scales"
  | "crocodile"
  | "tie_dye"
  | "batik"
  | "marble"
  | "clouds"
  | "bleach"
  | "ikat"
  | "palms"
  | "paisley"
  | "lozenges"
  | "argyle"
  | "patchwork"
  | "serape"
  | "medallions"
  | "waves"
  | "triangles"
  | "curls"
  | "cables"
  | "sequins"
  | "pile"
  | "foil"
  | "channels"
  | "fur"
  | "marl"
  | "linen"
  | "sprigs"
  | "penguins"
  | "pandas"
  | "sharks"
  | "whales"
  | "unicorns"
  | "parrots"
  | "tigers"
  | "rockets"
  | "cacti"
  | "daisies"
  | "sunflowers"
  | "galaxy"
  | "camouflage"
  | "zigzag"
  | "herringbone"
  | "rainbow"
  | "ombre"
  | "blocks"
  | "aztec"
  | "wax_print"
  | "two_blocks"
  | "four_blocks"
  | "houndstooth"
  | "granny_squares"
  | "palm_trees";
/**
 * cm: width and gap of stripes, width of checks, spacing of plaid and dots, radius of dots, repeat of motifs; angle,
 * degrees: 0 runs around the body, 90 down it.
 */
export type PrintSize = "width" | "gap" | "spacing" | "radius" | "repeat" | "angle";

/** What is printed on or woven into a cloth. GET /api/prints/tile draws one repeat of it. */
export interface ClothPrint {
  kind: PrintKind;
  /** Two to four, "#rrggbb": of stripes the band's and the gap's, else the ground's first. */
  colors: string[];
  motif?: PrintMotif;
  /** Those that are not what is usual. */
  sizes?: Partial<Record<PrintSize, number>>;
}

/** What all work answers with. */
export interface Document {
  origin: Origin;
  title: string;
  pattern: PatternJson;
  findings: FindingInfo[];
  seams: SeamInfo[];
  /** Absent in what earlier versions have saved: they had none. */
  trims?: TrimMark[];
  /** Content hash of the garment's mesh: GET /api/meshes/{mesh}; null where it was not, or cannot be, sewn. */
  mesh: string | null;
  /** Why there is no mesh. */
  unsewable: ErrorInfo | null;
  /** Mesh of who wears it: GET /api/body/{body}. */
  body: string;
  reading: Reading;
  dimensions: DimensionInfo[];
  /** The pattern in one English sentence or two. */
  description: string;
  notes: string[];
  warnings: string[];
  /** What an edit, alteration or repair did, in words. */
  changes: string[];
  /** What was asked for and does not hold. */
  open: string[];
  /** Of draped garments. */
  quality: QualityInfo | null;
  /** How the 3D garment came about. */
  garment: "none" | "sewn" | "finished" | "draped" | "stopped";
  color: string | null;
  /** Absent in what earlier versions have saved: they had none. */
  looks?: Looks;
  /** What is printed on the cloth; absent in what earlier versions have saved. */
  print?: ClothPrint | null;
  fabric: FabricName;
  edge_length: number;
  seed: number | null;
  prompt: string;
  /** Where it is worn, of the two garments that a text asked for; absent in what earlier versions have saved. */
  part?: Part | null;
  /** By stage. */
  seconds: Record<string, number>;
}

// --- GET /api/state -----------------------------------------------------------------------------------------

export interface Example {
  id: string;
  title: string;
  prompt: string;
  /** Of a picture, from the server's root; image/webp. */
  thumbnail: string;
}

export interface ClaimOption {
  name: string;
  label: string;
  about: string;
  /** Empty for numbers. */
  choices: string[];
  unit: "" | Unit;
  /** Kinds of garments that can have it: "dress", "skirt", "top", "trousers", "shorts", "jumpsuit", "playsuit". */
  kinds: string[];
}

export interface DimensionOption {
  name: string;
  about: string;
  unit: Unit;
  step: number;
  group: string;
}

export interface Limits {
  upload_bytes: number;
  picture_pixels: number;
  pattern_bytes: number;
  panels: number;
  edges: number;
  prompt_letters: number;
  variants: number;
  queue: number;
  job_seconds: number;
  project_versions: number;
}

export interface State {
  version: string;
  limits: Limits;
  units: ("cm" | "in")[];
  examples: Example[];
  projects: ProjectSummary[];
  claims: ClaimOption[];
  dimensions: DimensionOption[];
  fabrics: FabricName[];
  /** What POST /api/export and projects can be written as: "glb", "obj", ..., "svg", "json", "zip". */
  formats: FormatInfo[];
  wearers: WearerOptions;
  /** Mesh of the default body. */
  body: string;
  /** Whether the networks are loaded; work that needs them waits until they are. */
  ready: boolean;
  /** What is off, in words, such as weights that are missing. */
  notices: string[];
}

/** Whom garments can be made for. */
export interface WearerOptions {
  figures: Figure[];
  sizes: SizeChart[];
  measures: MeasureOption[];
}

/** "women EU 44" is figure, region (but for "letters") and label. */
export interface SizeChart {
  figure: Figure;
  region: string;
  labels: string[];
}

export interface MeasureOption {
  name: string;
  label: string;
  /** How it is taken. */
  about: string;
  min: number;
  max: number;
  /** Of the default body, cm. */
  default: number;
}

export interface FormatInfo {
  /** Without a dot. */
  name: string;
  about: string;
  of: "pattern" | "garment" | "both";
}

// --- quick work: answered at once ---------------------------------------------------------------------------

/** POST /api/open: any GarmentCode JSON, as uploaded. Answer: Document, sewn where that can be done. */
export interface OpenRequest {
  pattern: PatternJson;
  title?: string;
  /** Whether it is sewn too; true without it. */
  sew?: boolean;
}

/** POST /api/check. Answer: CheckAnswer. */
export interface CheckRequest {
  pattern: PatternJson;
}

export interface CheckAnswer {
  findings: FindingInfo[];
  seams: SeamInfo[];
  trims: TrimMark[];
}

/** POST /api/repair. Answer: RepairAnswer. */
export interface RepairRequest {
  pattern: PatternJson;
}

export interface RepairAnswer {
  pattern: PatternJson;
  /** What was mended. */
  changes: string[];
  findings: FindingInfo[];
  seams: SeamInfo[];
  trims: TrimMark[];
}

/** POST /api/describe. Answer: DescribeAnswer. */
export interface DescribeRequest {
  pattern: PatternJson;
}

export interface DescribeAnswer {
  description: string;
  reading: Reading;
  dimensions: DimensionInfo[];
}

/** One of: {claim, value} | {dimension, value} | {dimension, by}. */
export interface ChangeRequest {
  claim?: string | null;
  dimension?: string | null;
  value?: string | number | null;
  by?: number | null;
}

/** POST /api/alter: chips and sliders. Answer: Document (origin "alter"), sewn unless sew is false. */
export interface AlterRequest {
  pattern: PatternJson;
  changes: ChangeRequest[];
  sew?: boolean;
  color?: string | null;
  looks?: PartLook[];
  print?: ClothPrint | null;
}

// --- bodies -------------------------------------------------------------------------------------------------

/**
 * POST /api/fit: the pattern refitted to a body, and sewn on it; without size, figure and measures to the default
 * body. Answer: Document (origin "fit"). The pattern names its body from then on (properties.drafted_for), and
 * whatever is asked of it is done on that body.
 */
export interface FitRequest {
  pattern: PatternJson;
  /** Of a chart: "women EU 44", "M", "children 128". */
  size?: string | null;
  figure?: Figure | null;
  /** cm; they outrank those of the size. */
  measures?: Record<string, number>;
  /** What the body is called; made up without it. */
  called?: string;
  /** BodyAnswer.body of a mesh that was loaded, in place of size, figure and measures. */
  body?: string | null;
  color?: string | null;
  looks?: PartLook[];
  print?: ClothPrint | null;
}

/** POST /api/wearer: who wears a pattern. Answer: WearerAnswer; the mesh can be fetched then. */
export interface WearerRequest {
  pattern: PatternJson;
}

export interface WearerAnswer {
  /** GET /api/body/{body} */
  body: string;
  /** Empty for the default body. */
  name: string;
  figure: Figure | null;
  /** What the body was made to, cm. */
  given: Record<string, number>;
  /** All of State.wearers.measures as they are on the body, cm. */
  measures: Record<string, number>;
  /** Of a body that was loaded as a mesh. */
  mesh?: string | null;
  /** Whether that mesh is not kept by the server, and a body of the same measures wears the pattern. */
  stands_in?: boolean;
}

/** POST /api/bodies?file_name=me.obj, its bytes as application/octet-stream. Answer: BodyAnswer. */
export interface BodyAnswer {
  /** For FitRequest.body. */
  body: string;
  name: string;
  vertices: number;
  faces: number;
  /** As they are on it, cm. */
  measures: Record<string, number>;
}

/** POST /api/measures: a file of measures, GarmentCode's or FreeSewing's (YAML or JSON). Answer: MeasuresAnswer. */
export interface MeasuresRequest {
  file_name: string;
  text: string;
}

export interface MeasuresAnswer {
  measures: Record<string, number>;
}

// --- live sewing --------------------------------------------------------------------------------------------

/** POST /api/live: for patterns while they are dragged. Per client the highest sequence wins. */
export interface LiveRequest {
  /** Made up by the client, 8 to 64 letters of [A-Za-z0-9_-], new for each page load. */
  client: string;
  /** From 1, growing. */
  sequence: number;
  pattern: PatternJson;
  /** Of the mesh, cm; 2 to 5; 2.5 without it. */
  edge_length?: number;
  /** Whether another state follows: sewn in less time, and less finely. */
  dragging?: boolean;
}

export interface LiveAnswer {
  client: string;
  sequence: number;
  /** "stale": a later sequence has arrived, drop it. "unsewable": see error; findings say why. */
  status: "sewn" | "unsewable" | "stale";
  mesh: string | null;
  findings: FindingInfo[];
  seams: SeamInfo[];
  trims: TrimMark[];
  error: ErrorInfo | null;
  seconds: Record<string, number>;
}

// --- jobs ---------------------------------------------------------------------------------------------------

export interface GenerateJob {
  kind: "generate";
  text?: string;
  /** Ids of POST /api/files, at most two (front and back). */
  pictures?: string[];
  part?: Part | null;
  seed?: number;
  /** 1 to 4. */
  variants?: number;
  finish?: boolean;
  /** Who wears it, unless the text says so. */
  wearer?: WearerRef | null;
}

/** A body by what it is made to, as in a pattern's properties.drafted_for. */
export interface WearerRef {
  name?: string;
  figure?: Figure | null;
  /** By the names of State.wearers.measures (and others of `swifttailor fit`), cm. */
  measures?: Record<string, number>;
  /** Of a body that was loaded as a mesh. */
  mesh?: string | null;
}

export interface EditJob {
  kind: "edit";
  pattern: PatternJson;
  instruction: string;
  color?: string | null;
  looks?: PartLook[];
  print?: ClothPrint | null;
  seed?: number;
  finish?: boolean;
}

export interface SewJob {
  kind: "sew";
  pattern: PatternJson;
  edge_length?: number;
  repair?: boolean;
  color?: string | null;
  looks?: PartLook[];
  print?: ClothPrint | null;
}

/** Physics from the sewn garment (finish) or from the flat panels (drape), with live frames. */
export interface DrapeJob {
  kind: "finish" | "drape";
  pattern: PatternJson;
  /** finish: the mesh to go on from, where it is this pattern's; it is sewn anew otherwise. */
  mesh?: string | null;
  fabric?: FabricName;
  /** Of the mesh, cm, 1 to 5. Without it, to finish a garment, that of its mesh; else 2. */
  edge_length?: number | null;
  color?: string | null;
  looks?: PartLook[];
  print?: ClothPrint | null;
}

export interface AlterJob {
  kind: "alter";
  pattern: PatternJson;
  changes: ChangeRequest[];
  color?: string | null;
  looks?: PartLook[];
  print?: ClothPrint | null;
}

export type JobRequest = GenerateJob | EditJob | SewJob | DrapeJob | AlterJob;

export type JobState = "queued" | "running" | "done" | "failed" | "cancelled" | "stopped";

export interface StageInfo {
  /** "loading", "reading", "writing", "sewing", "draping", ... */
  name: string;
  /** 0 to 1. */
  share: number;
  /** Since it began. */
  seconds: number;
}

export interface FailureInfo {
  seed: number;
  error: ErrorInfo;
}

export interface Job {
  id: string;
  kind: JobRequest["kind"];
  state: JobState;
  /** Jobs before it; 0 when it runs. */
  place: number;
  /** In the order in which they began; the last one is at work. */
  stages: StageInfo[];
  /** Number of the latest frame (GET /api/jobs/{id}/frame); 0 when there is none. */
  frame: number;
  /** Of the mesh that frames are of: GET /api/meshes/{frame_mesh}; null when there are none. */
  frame_mesh: string | null;
  /** One for each variant that was made, in order of seeds; also of a stopped drape, its last frame. */
  documents: Document[];
  failures: FailureInfo[];
  error: ErrorInfo | null;
  /** Since it began to run. */
  seconds: number;
}

/**
 * GET /api/jobs/{id}/events: server-sent events, each with a whole Job as JSON in `data`, and `event` one of these.
 * The first comes at once. After done, failed, cancelled or stopped the stream ends: close the EventSource.
 * documents are empty but in done and stopped.
 */
export type JobEventName = "place" | "stage" | "frame" | "done" | "failed" | "cancelled" | "stopped";

// --- files --------------------------------------------------------------------------------------------------

/** POST /api/files with the picture's bytes as body and its Content-Type (image/png, image/jpeg, image/webp). */
export interface FileInfo {
  id: string;
  width: number;
  height: number;
  /** The picture, upright, as PNG. */
  url: string;
  /** What is looked at in it (the mask), as PNG; made when first asked for. 404 where no garment is seen. */
  seen_url: string;
}

// --- projects -----------------------------------------------------------------------------------------------

export interface ProjectSummary {
  id: string;
  name: string;
  /** ISO 8601, UTC. */
  saved: string;
  versions: number;
  /** preview.png; null where there is none yet. */
  thumbnail: string | null;
  /** Folder's name, for the command line. */
  folder: string;
  /** Whether an autosave is newer than what was saved. */
  draft: boolean;
}

export interface ProjectVersion {
  /** From 1. */
  number: number;
  /** What was done: "made from words", "hem: knee", ... */
  label: string;
  saved: string;
  pattern: PatternJson;
  mesh: string | null;
  color: string | null;
  /** Absent in what earlier versions have saved. */
  looks?: Looks;
  /** What is printed on the cloth; absent in what earlier versions have saved. */
  print?: ClothPrint | null;
  seed: number | null;
}

export interface ProjectContent {
  name: string;
  prompt: string;
  seed: number | null;
  /** What is shown now. */
  document: Document;
  /** Oldest first; the last ones are kept where there are more than limits.project_versions. */
  versions: ProjectVersion[];
  /** Anything the client wants back after a reload: view, units, selection; at most 64 kB of JSON. */
  view: Record<string, unknown>;
}

export interface Project extends ProjectContent {
  id: string;
  folder: string;
  /** Grows by one with every save; send it back. */
  revision: number;
  saved: string;
  /** Of an autosave that is newer than what was saved. */
  draft: ProjectContent | null;
}

/** POST /api/projects. Answer: Project (201). */
export interface CreateProjectRequest {
  content: ProjectContent;
}

/** PUT /api/projects/{id}: saves; 409 "project-changed" where revision is not the latest. PUT .../draft: autosaves. */
export interface SaveProjectRequest {
  revision: number;
  content: ProjectContent;
}

export interface SavedAnswer {
  id: string;
  revision: number;
  saved: string;
  /** What a person should know of how it was saved; mostly empty. */
  notes: string[];
}

/** POST /api/export: the file's bytes. What is not saved in a project is exported so. */
export interface ExportRequest {
  pattern: PatternJson;
  /** null: sewn first where the format needs a garment. */
  mesh?: string | null;
  /** A name of State.formats. */
  format: string;
  title?: string;
  color?: string | null;
  looks?: PartLook[];
  print?: ClothPrint | null;
  prompt?: string;
  seed?: number | null;
}

// --- meshes: GET /api/meshes/{hash}, GET /api/body/{hash} ---------------------------------------------------

/** JSON header of a mesh file; see API.md for the bytes around it. */
export interface MeshHeader {
  version: 1;
  kind: "garment" | "body";
  /** Of the split vertices: each belongs to one panel. */
  vertices: number;
  triangles: number;
  /** Vertices after seams are closed; weld maps to them, frames are of them. */
  welded: number;
  /** Panel names; the block panel indexes them. Empty for bodies. */
  panels: string[];
  /** Seam k is vertices seam_vertices[seam_offsets[k] : seam_offsets[k + 1]], of both sides in turn. */
  seams: MeshSeam[];
  /** Edge k is vertices edge_vertices[edge_offsets[k] : edge_offsets[k + 1]], corners included. */
  edges: EdgePlace[];
  /** "#rrggbb"; null where none was named. */
  color: string | null;
  /** Parts that look otherwise than the rest; absent where there are none. */
  looks?: PartLook[];
  /** On all that has no look of its own; absent where there is none. */
  print?: ClothPrint;
  /**
   * Of each panel a to f: what is at u, v on it was cut from a u + b v + c, d u + e v + f of the cloth, cm. Absent in
   * meshes of earlier versions.
   */
  on_cloth?: number[][];
  /** Pockets, buttons and the like, in the order in which they lie in the blocks; absent where there are none. */
  trims?: MeshTrim[];
  blocks: MeshBlock[];
}

/** What is put on the cloth in one look, such as all buttons. */
export interface MeshTrim {
  /** Such as "patch pockets (cloth)". */
  name: string;
  look: TrimLook;
  /** "#rrggbb" where it is of another colour than its look has on this cloth. */
  color?: string;
  /** Whether trim_uv tells where it lies on its panel: prints of the cloth run on over it. */
  on_panel: boolean;
  /** How many of each are its own. */
  vertices: number;
  triangles: number;
  lines: number;
}

/** "cloth" and "dark" (stitches, openings) follow the colour of the garment's cloth, buttons its lightness. */
export type TrimLook = "cloth" | "dark" | "metal" | "button" | "leather";

export interface MeshSeam {
  first: EdgePlace;
  second: EdgePlace;
}

export interface MeshBlock {
  /**
   * positions (n,3) f32 cm; normals (n,3) f32, smooth across seams; uv (n,2) f32: garments, panel-local cm, the
   * same coordinates as the pattern's vertices (prints at true scale, 3D to 2D picking); panel (n,) u32; weld (n,)
   * u32; triangles (t,3) u32 into the n vertices; strain (n,) f32: (length / rest - 1) of the most stretched
   * direction; seam_vertices, seam_offsets, edge_vertices, edge_offsets u32; color (n,3) f32 0..1, bodies only.
   * Of trims: trim_positions (m,3) f32 cm; trim_uv (m,2) f32 panel-local cm, 0 of what goes around the body;
   * trim_panel (m,) u32, the panels on which that is;
   * trim_triangles (s,3) u32 and trim_lines (l,2) u32, edges that show, both counted from the trim's first vertex.
   */
  name: string;
  type: "f32" | "u32";
  /** Number of items, all columns. */
  count: number;
  /** From the start of the data, a multiple of 4. */
  offset: number;
}
