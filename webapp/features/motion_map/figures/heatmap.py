"""The motion map as a heatmap with posture icons on its regions: pure builders of what the page shows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import plotly.graph_objects as go

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.motion_map import layers
from core.motion_map.motion_map import MotionMap
from webapp.features.motion_map.figures.posture_icons import body_of, figure_svg, turned
from webapp.shell import theme
from webapp.ui.brief_names import brief_names
from webapp.ui.charts import themed
from webapp.ui.filmstrip import ICON_COLOURS, data_uri
from webapp.ui.timeline import motif_colour

COLOURINGS = {  # value -> name, what it shows
    "height": ("Ridges", "U-matrix: ridges separate postures that differ; in flat areas they are alike."),
    "density": ("Time spent", "Seconds of motion on each node."),
    "speed": ("Speed", "Mean speed over the ground, m/s."),
    "region": ("Region", "Regions between ridges: postures of one kind."),
    "label": ("Label", "The label with most time on a node."),
    "motif": ("Motif", "The motif with most time on a node."),
    "clip": ("Clip", "The clip that spends most time on a node."),
}
ACTIONS = (  # as the timeline colours labels (assets/motifs/timeline.mjs)
    "#4e79a7", "#f28e2b", "#59a14f", "#e15759", "#b07aa1", "#9c755f", "#76b7b2", "#d4a720", "#ff9da7", "#79706e",
)  # fmt: skip
SCALES: dict[str, list[tuple[float, str]]] = {
    "light": [(0, "#f7f9fc"), (0.35, "#d5deeb"), (0.7, "#9fb2cd"), (1, "#62799c")],
    "dark": [(0, "#181e27"), (0.35, "#27313f"), (0.7, "#47576e"), (1, "#8396b3")],
}
MOST_NAMED = 24  # categories that stand in the legend


class Layer(NamedTuple):
    """What the nodes are coloured by. values: ``(nx, ny)``, nan where there is nothing; names and colours of

    categories (then values are their numbers), else empty; unit: of the numbers.
    """

    values: np.ndarray
    names: tuple[str, ...] = ()
    colours: tuple[str, ...] = ()
    unit: str = ""


def label_segments(dataset: Dataset) -> dict[str, list[Segment]]:
    """The segments of every label, by name, in the order of names."""
    segments: dict[str, list[Segment]] = {}
    for label in dataset.labels:
        segments.setdefault(label.action, []).append(Segment(label.clip, label.start, label.end))
    return dict(sorted(segments.items()))


def layer_of(motion_map: MotionMap, dataset: Dataset, graph: MotifGraph | None, colouring: str | None) -> Layer:
    """The layer of a colouring (see COLOURINGS); the U-matrix where it is unknown or there is nothing to colour by."""
    if colouring == "density":
        return Layer(np.where(motion_map.density > 0, motion_map.density, np.nan), unit="s")
    if colouring == "speed":
        return Layer(layers.mean_speed(motion_map), unit="m/s")
    if colouring == "region":
        n = len(motion_map.icons)
        names = tuple(f"Region {k}" for k in range(n))
        return Layer(motion_map.regions.astype(float), names, tuple(motif_colour(k) for k in range(n)))
    groups: Mapping[str, Sequence[Segment]] = {}
    colours: tuple[str, ...] = ()
    if colouring == "label":
        groups = label_segments(dataset)
        colours = tuple(ACTIONS[k] if k < len(ACTIONS) else motif_colour(k) for k in range(len(groups)))
    elif colouring == "motif" and graph is not None:
        groups = {f"Motif {motif.id}": motif.segments for motif in graph.motifs}
        colours = tuple(motif_colour(motif.id) for motif in graph.motifs)
    elif colouring == "clip":
        led = layers.leading(layers.seconds_of_clips(motion_map)).astype(float)
        shades = tuple(motif_colour(k) for k in range(len(motion_map.clips)))
        return Layer(np.where(led < 0, np.nan, led), tuple(brief_names(motion_map.clips, 28)), shades)
    if groups:
        led = layers.leading(layers.seconds_on_nodes(motion_map, list(groups.values()))).astype(float)
        return Layer(np.where(led < 0, np.nan, led), tuple(groups), colours)
    return Layer(motion_map.heights, unit="m")


def map_figure(motion_map: MotionMap, layer: Layer, scheme: str | None, icons: bool = True) -> go.Figure:
    """The heatmap, node (0, 0) at the top left, with the icons as one picture over it."""
    nx, ny = motion_map.grid
    scheme = scheme if scheme in ICON_COLOURS else "light"
    figure = go.Figure(_heatmap(layer, scheme))
    axis = {"visible": False, "fixedrange": True, "constrain": "domain"}
    figure = themed(figure, scheme, height=None, margin={"l": 0, "r": 0, "t": 0, "b": 0}, hovermode=False)
    figure.update_xaxes(range=[-0.5, nx - 0.5], **axis)
    figure.update_yaxes(range=[ny - 0.5, -0.5], scaleanchor="x", **axis)
    if icons:
        picture = {"source": data_uri(icons_svg(motion_map, scheme)), "xref": "x", "yref": "y", "layer": "above"}
        figure.add_layout_image(picture | {"x": -0.5, "y": -0.5, "sizex": nx, "sizey": ny, "sizing": "stretch"})
    return figure


def _heatmap(layer: Layer, scheme: str) -> go.Heatmap:
    z = np.round(layer.values.T, 4)
    if not layer.names:
        return go.Heatmap(z=z, colorscale=SCALES[scheme], hoverinfo="skip", showscale=False, name=layer.unit)
    n = len(layer.names)
    steps = [[edge / n, _faded(colour, scheme)] for k, colour in enumerate(layer.colours) for edge in (k, k + 1)]
    return go.Heatmap(z=z, zmin=-0.5, zmax=n - 0.5, colorscale=steps, hoverinfo="skip", showscale=False, name="value")


def _faded(colour: str, scheme: str) -> str:
    """A category's colour drawn towards the page, so that icons and keys stand out."""
    ground = theme.CANVAS[scheme]["surface"]
    mix = 0.62 if scheme == "light" else 0.55
    parts = [round(mix * int(colour[k : k + 2], 16) + (1 - mix) * int(ground[k : k + 2], 16)) for k in (1, 3, 5)]
    return "#" + "".join(f"{part:02x}" for part in parts)


def legend(layer: Layer) -> list[dict[str, Any]]:
    """The categories that are the most frequent on some node, at most MOST_NAMED: name, colour, number of nodes."""
    if not layer.names:
        return []
    numbers = layer.values[~np.isnan(layer.values)].astype(int)
    counts = np.bincount(numbers, minlength=len(layer.names))
    order = [int(k) for k in np.argsort(-counts, kind="stable") if counts[k]]
    return [{"name": layer.names[k], "colour": layer.colours[k], "nodes": int(counts[k])} for k in order[:MOST_NAMED]]


def scale_of(layer: Layer, scheme: str | None) -> dict[str, str] | None:
    """The colour scale: smallest value, largest with its unit, and the colours as CSS; None for categories."""
    numbers = layer.values[~np.isnan(layer.values)]
    if layer.names or not len(numbers):
        return None
    colours = ", ".join(f"{colour} {100 * at:g}%" for at, colour in SCALES["dark" if scheme == "dark" else "light"])
    return {"least": f"{numbers.min():.2g}", "most": f"{numbers.max():.2g} {layer.unit}", "colours": colours}


def icon_sizes(icons: np.ndarray, regions: np.ndarray) -> np.ndarray:
    """Side of each icon in nodes ``(n_regions,)``: larger in larger regions, never much into the next icon."""
    areas = np.bincount(regions.ravel(), minlength=len(icons))
    sizes = np.clip(0.95 * np.sqrt(areas), 1.7, 0.16 * max(regions.shape) + 1.2)
    if len(icons) < 2:
        return sizes
    apart = np.abs(icons[:, None] - icons[None]).max(axis=-1).astype(float)
    np.fill_diagonal(apart, np.inf)
    return np.clip(sizes, 1.0, np.maximum(1.1 * apart.min(axis=1), 1.0))


def icons_svg(motion_map: MotionMap, scheme: str) -> str:
    """One picture for the whole map: borders of the regions and the posture of every region, a node being a unit."""
    nx, ny = motion_map.grid
    body = body_of(motion_map)
    line = theme.CANVAS[scheme]["line"]
    parts = [f'<path d="{_borders(motion_map.regions)}" stroke="{line}" stroke-width=".09" fill="none" opacity=".8"/>']
    for (x, y), side in zip(motion_map.icons, icon_sizes(motion_map.icons, motion_map.regions), strict=True):
        posture = motion_map.postures[x, y]
        seen = turned(np.vstack([posture, np.zeros((1, 3))]))
        low, high = seen[:, :2].min(axis=0) - 0.05, seen[:, :2].max(axis=0) + np.array([0.05, 0.24])
        scale = side / max(high[1] - low[1], 1.1)
        at = np.array([x, y]) - scale * (low + high) / 2 * [1, -1]
        room = [at + scale * np.array([low[0], -high[1]]), at + scale * np.array([high[0], -low[1]])]
        at += np.maximum(-0.5 - room[0], 0) - np.maximum(room[1] - [nx - 0.5, ny - 0.5], 0)  # all of it on the map
        figure = figure_svg(posture, body, ICON_COLOURS[scheme])
        parts.append(f'<g transform="translate({at[0]:.2f} {at[1]:.2f}) scale({scale:.3f})">{figure}</g>')
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-.5 -.5 {nx} {ny}" width="{nx * 24}" height="{ny * 24}" '
        f'preserveAspectRatio="none" stroke-linecap="round" stroke-linejoin="round">{"".join(parts)}</svg>'
    )


def _borders(regions: np.ndarray) -> str:
    """Lines between nodes of different regions."""
    across = [f"M{x + 0.5} {y - 0.5}v1" for x, y in np.argwhere(regions[1:] != regions[:-1])]
    down = [f"M{x - 0.5} {y + 0.5}h1" for x, y in np.argwhere(regions[:, 1:] != regions[:, :-1])]
    return "".join(across + down)
