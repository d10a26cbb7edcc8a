// Ids of components, and what stores hold. Written by scripts/generate_ids.py from webapp.features.grammar.names:
// change that module and run `make bundle`.
/** @import { StoreId } from "../shared/ids.mjs" */

