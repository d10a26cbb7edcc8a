// Offers the blocks of all pages, by kind, to boards and reports.
import { offer } from "../blocks/registry.mjs";
import { drawStage, drawText, drawView } from "../boards/own_blocks.mjs";
import { drawActions } from "../grammar/actions_block.mjs";
import { drawOverview } from "../library/overview_block.mjs";
import { drawTracks } from "../library/tracks_block.mjs";
import { drawMap } from "../motion_map/map_block.mjs";
import { drawGraph } from "../motifs/graph_block.mjs";
import { drawMatrix } from "../motifs/matrix_block.mjs";
import { drawMotifs, drawNumbers } from "../motifs/motif_blocks.mjs";
import { drawHits } from "../search/hits_block.mjs";
import { drawSweep } from "../sweeps/sweep_block.mjs";

offer({
  overview: drawOverview, tracks: drawTracks, graph: drawGraph, motifs: drawMotifs, matrix: drawMatrix, numbers: drawNumbers,
  map: drawMap, actions: drawActions, sweep: drawSweep, hits: drawHits, text: drawText, stage: drawStage,
  view: drawView,
});
