"""Colours and control styles, in one place. CSS (assets/shell/frame.css) names the same colours for everything else."""

from __future__ import annotations

ACCENT = [  # a calm blue, light to dark: Mantine wants ten shades
    "#eef3fc", "#dbe5f7", "#b5caee", "#8dade5", "#6b94de", "#5684d9", "#4a7cd8", "#3b6abf", "#315eac", "#235199",
]  # fmt: skip

SLATE = [  # Mantine's "dark" shades: text first, page last
    "#e7ebf1", "#c5cdd8", "#a0abba", "#77849a", "#3a4554", "#2f3846", "#202732", "#1a2029", "#12161c", "#0d1015",
]  # fmt: skip

MANTINE = {
    "primaryColor": "accent",
    "primaryShade": {"light": 7, "dark": 7},
    "colors": {"accent": ACCENT, "dark": SLATE},
    "fontFamily": "var(--font)",
    "fontFamilyMonospace": "ui-monospace, 'SF Mono', Menlo, Consolas, 'DejaVu Sans Mono', monospace",
    "headings": {"fontFamily": "var(--font)", "fontWeight": 600},
    "defaultRadius": "md",
    "cursorType": "pointer",
    "components": {
        "Tooltip": {"defaultProps": {"openDelay": 350, "withArrow": True, "multiline": True, "maw": 320}},
        "Button": {"defaultProps": {"size": "sm"}},
        "Select": {"defaultProps": {"size": "sm"}},
        "NumberInput": {"defaultProps": {"size": "sm"}},
    },
}

# for what is drawn on a canvas, where CSS does not apply
CANVAS = {
    "light": {
        "surface": "#ffffff", "page": "#f6f7f9", "text": "#1f2733", "muted": "#66707f", "line": "#a9b4c2",
        "accent": "#2f62b8", "soft": "#dfe4ea",
    },
    "dark": {
        "surface": "#232a34", "page": "#161b22", "text": "#e7ebf1", "muted": "#9aa5b4", "line": "#66748a",
        "accent": "#7ea6ee", "soft": "#333c49",
    },
}  # fmt: skip

# borders of the graph's connected parts: distinct, and readable on both themes; the first serves when there is one
COMPONENTS = ("#4a7cd8", "#d2762b", "#3a9b7a", "#a45fc0", "#c2486a", "#7f8a2e", "#2f95b0", "#8c6d53")

ALONE = "#8793a3"
DEAD_END = "#d04a4a"

# rings of unstable and of stable motifs: apart for the colour-blind, and readable on both themes
STABILITY = ("#e08a2e", "#1f9c86")

# ag-grid's own theme, made to follow the page through CSS variables
GRID_THEME = {
    "function": "themeQuartz.withParams({"
    "backgroundColor: 'var(--surface)', foregroundColor: 'var(--text)', borderColor: 'var(--line)',"
    "headerBackgroundColor: 'var(--surface-2)', headerTextColor: 'var(--muted)', headerFontWeight: 600,"
    "accentColor: 'var(--accent)', rowHoverColor: 'var(--hover)', selectedRowBackgroundColor: 'var(--selected)',"
    "fontFamily: 'inherit', fontSize: 13, headerFontSize: 12, spacing: 7, wrapperBorderRadius: 8,"
    "browserColorScheme: 'inherit', oddRowBackgroundColor: 'var(--surface)', columnBorder: false})"
}
