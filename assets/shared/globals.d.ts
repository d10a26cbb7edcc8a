// What Dash, its component libraries and our own events put into the browser's global scope.
import type { Standing, StageState } from "../stage/types.d.ts";

interface DashClientside {
  set_props(id: string, props: Record<string, any>): void;
  no_update: any;
  callback_context: { triggered: { prop_id: string }[]; inputs_list: { id: string; property: string }[] };
  [namespace: string]: any;
}

declare global {
  var dash_clientside: DashClientside;
  var dash_component_api: { getLayout(id: string): { props: { data?: any } } };
  var dashAgGridFunctions: Record<string, (params: any) => any>;
  var dashAgGridComponentFunctions: Record<string, (props: any) => any>;
  var dash_ag_grid: { getApiAsync(id: string): Promise<any> };
  var React: {
    createElement(...parts: any[]): any;
    lazy(load: () => Promise<{ default: any }>): any;
    useLayoutEffect(effect: () => void, dependencies: unknown[]): void;
    useRef(value: HTMLElement | null): { current: HTMLElement | null };
    useState<T>(value: T): [T, (value: T) => void];
    Suspense: any;
  };
  var Plotly: {
    relayout(plot: Element, change: object): Promise<void>;
    downloadImage(plot: Element, options: object): Promise<string>;
    toImage(plot: Element, options: object): Promise<string>;
  };
  var motionscape: Record<string, any>;

  interface WindowEventMap {
    "stage-frame": CustomEvent<{ time: number; duration: number; playing: boolean; items: Standing[] }>;
    "stage-state": CustomEvent<StageState & { items: Standing[] }>;
  }
}
