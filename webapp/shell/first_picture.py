"""The first picture of a page: its layout as plain HTML, which can be read and followed before any script has run.

A browser needs most of a second to run the scripts of a page. Until they have drawn it, the HTML itself shows the same
text, rows and boxes at the same places, with links that work; buttons look as if they were off, because they are.
``assets/shell/first_picture.mjs`` takes the picture away when the page stands. It is drawn in a shadow root that no
script and no style sheet of the page looks into.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from html import escape
from typing import Any

from webapp.shell.links import View, format_link, page_of, parse
from webapp.shell.names import FIRST_PICTURE

Props = Mapping[str, Any]
Draw = Callable[[Props, str], str]
"""HTML of a component from its properties and the link of what is shown, which its own links begin with."""

# before anything is shown: the colours that the person chose, as Mantine sets them later
SCHEME = """<script>
(() => {
  let scheme = null;
  try { scheme = localStorage.getItem("mantine-color-scheme-value"); } catch { /* private mode */ }
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  if (scheme !== "light" && scheme !== "dark") scheme = dark ? "dark" : "light";
  document.documentElement.dataset.mantineColorScheme = scheme;
})();
</script>"""

_NOT_DRAWN = {"Store", "Location", "Modal", "Drawer", "Interval", "Download", "MenuDropdown"}
_NOT_DRAWN |= {"PopoverDropdown", "HoverCardDropdown", "TooltipFloating", "Upload"}
_VOID = {"img", "input", "br", "hr"}
_PLAIN = {"title", "role", "href", "src", "alt", "type", "id", "placeholder"}
_SPACES = {"xs": 10, "sm": 12, "md": 16, "lg": 20, "xl": 32}  # Mantine's, in pixels
_SPACED = {"pt": "padding-top", "mb": "margin-bottom", "mt": "margin-top", "gap": "gap"}


def picture(layout: Any, link: str, style_sheets: Sequence[str], draws: Mapping[str, Draw]) -> str:
    """HTML that shows a layout (Dash's JSON, parsed) until the page's scripts do; "" where it has no page yet.

    link: path and search of what is shown. style_sheets: addresses of the page's own.
    draws: kind of a component, or its id -> its drawing, for those of which a library draws more than their children.
    """
    page = page_of(link.partition("?")[0])
    if page is None:
        return ""
    sheets = "".join(f'<link rel="stylesheet" href="{address}">' for address in style_sheets)
    drawing = _Drawing(page, link, draws)
    drawn = drawing(layout)
    return (
        f'<div id="{FIRST_PICTURE}" class="first-picture" data-until="{escape(" ".join(drawing.awaited))}">'
        '<template shadowrootmode="closed">'
        f"{sheets}{drawn}</template></div>"
    )


class _Drawing:
    """Turns components into HTML."""

    def __init__(self, page: str, link: str, draws: Mapping[str, Draw]):
        self.page = page
        self.link = link
        self.dataset = parse(*link.partition("?")[::2])[0].dataset
        self.draws = draws
        self.tab = ""  # the open one of the tabs that are being drawn
        self.awaited: list[str] = []  # ids of what libraries draw

    def __call__(self, node: Any) -> str:
        if isinstance(node, list):
            return "".join(map(self, node))
        if not isinstance(node, dict):
            return "" if node is None else escape(str(node))
        kind, props = node.get("type", ""), node.get("props", {})
        if kind in _NOT_DRAWN:
            return ""
        name = props.get("id")
        if draw := self.draws.get(name if isinstance(name, str) else "") or self.draws.get(kind):
            self.awaited += [name] if isinstance(name, str) else []
            return draw(props, self.link)
        if node["namespace"] == "dash_html_components":
            return self._element(kind.lower(), props)
        special = getattr(self, f"_{_snake(kind)}", None)
        return special(props) if special else self(props.get("children"))

    def _element(self, tag: str, props: Props, class_name: str = "") -> str:
        """An HTML element with the children and those of the properties that make it look as it does."""
        classes = " ".join(filter(None, (class_name, props.get("className"))))
        written = {name: props[name] for name in props if name in _PLAIN or name.startswith("aria-")}
        written |= {"class": classes, "style": _style(props)}
        words = "".join(
            f' {name}="{escape(str(value))}"'
            for name, value in written.items()
            if isinstance(value, (str, int, float)) and value != ""
        )
        words += " disabled" if tag in ("button", "input", "select") else ""
        words += " hidden" if props.get("hidden") else ""
        return f"<{tag}{words}>" + ("" if tag in _VOID else f"{self(props.get('children'))}</{tag}>")

    def _box(self, props: Props, class_name: str, content: str, tag: str = "div") -> str:
        """An element with HTML that is ready in place of the children."""
        opened = self._element(tag, {name: props[name] for name in props if name != "children"}, class_name)
        return opened.removesuffix(f"</{tag}>") + f"{content}</{tag}>"

    # ---- Dash's and Mantine's components that pages begin with

    def _link(self, props: Props) -> str:
        if props.get("className") != "nav-link":
            return self._element("a", props)
        address = format_link(View(page_of(props["href"]) or "", self.dataset))
        here = {"aria-current": "page"} if props["href"] == f"/{self.page}" else {}
        return self._element("a", {**props, "href": address, **here})

    def _notification_container(self, props: Props) -> str:
        return '<div class="first-space"></div>'

    def _button(self, props: Props) -> str:
        content = self(props.get("leftSection")) + self(props.get("children")) + self(props.get("rightSection"))
        looks = ["first-button", f"first-{props.get('variant', 'filled')}"]
        looks += ["first-compact"] if "compact" in str(props.get("size")) else []
        looks += ["first-led"] if props.get("leftSection") else []
        return self._box(props, " ".join(looks), content, "button")

    def _action_icon(self, props: Props) -> str:
        return self._element("button", props, f"first-button first-icon first-{props.get('variant', 'filled')}")

    def _color_scheme_toggle(self, props: Props) -> str:
        return self._box(props, "first-button first-icon first-default", self(props.get("lightIcon")), "button")

    def _select(self, props: Props) -> str:
        value = props.get("value")
        labels = {one["value"]: one["label"] for one in props.get("data") or () if isinstance(one, dict)}
        shown = labels.get(value, value) or props.get("placeholder")
        return self._box(props, "first-select", self(props.get("leftSection")) + f"<span>{self(shown)}</span>")

    def _tabs(self, props: Props) -> str:
        outer, self.tab = self.tab, props.get("value") or ""
        drawn = self._element("div", props)
        self.tab = outer
        return drawn

    def _tabs_list(self, props: Props) -> str:
        return self._element("div", props, "first-tabs")

    def _tabs_tab(self, props: Props) -> str:
        chosen = " first-chosen" if props.get("value") == self.tab else ""
        content = self(props.get("children")) + self(props.get("rightSection"))
        return self._box(props, f"first-tab{chosen}", content, "span")

    def _tabs_panel(self, props: Props) -> str:
        return self._element("div", props, "mantine-Tabs-panel") if props.get("value") == self.tab else ""

    def _segmented_control(self, props: Props) -> str:
        choices = [one if isinstance(one, dict) else {"value": one, "label": one} for one in props.get("data") or ()]
        chosen = props.get("value") or (choices[0]["value"] if choices else None)
        marks = {True: ' class="first-chosen"', False: ""}
        content = "".join(f"<span{marks[one['value'] == chosen]}>{self(one['label'])}</span>" for one in choices)
        return self._box(props, "first-segments", content)

    def _accordion_item(self, props: Props) -> str:
        return self._element("div", props, "first-fold card")

    def _accordion_control(self, props: Props) -> str:
        return self._element("div", props, "first-fold-head")

    def _accordion_panel(self, props: Props) -> str:
        return ""

    def _group(self, props: Props) -> str:
        return self._element("div", props, "first-group")

    def _badge(self, props: Props) -> str:
        return self._element("span", props, "first-badge")

    def _text(self, props: Props) -> str:
        return self._element("p", props, "first-text")

    def _text_input(self, props: Props) -> str:
        return self._box(props, "first-select", f"<span>{self(props.get('value') or props.get('placeholder'))}</span>")

    _input = _number_input = _text_input


def _snake(kind: str) -> str:
    return re.sub(r"(?<!^)(?=[A-Z])", "_", kind).lower()


def _style(props: Props) -> str:
    """The inline style of a component, and what of Mantine's short properties moves others."""
    styles = {_snake(name).replace("_", "-"): value for name, value in (props.get("style") or {}).items()}
    styles |= {css: _SPACES.get(props[name], props[name]) for name, css in _SPACED.items() if name in props}
    styles |= {"width": props["w"]} if "w" in props else {}
    if props.get("className") and "icon-" in props["className"]:
        styles = {name: styles[name] for name in ("width", "height") if name in styles}
    return ";".join(
        f"{name}:{value}{'px' if isinstance(value, (int, float)) else ''}" for name, value in styles.items()
    )
