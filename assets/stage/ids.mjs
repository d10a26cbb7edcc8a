// Ids of components, and what stores hold. Written by scripts/generate_ids.py from webapp.stage.names:
// change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

export const STAGE = "stage";
export const STAGE_CANVAS = "stage-canvas";
export const STAGE_SHOWN = /** @type {StoreId<any>} */ ("stage-shown");
