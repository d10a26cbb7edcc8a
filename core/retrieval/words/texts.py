"""Words in what people wrote: names of clips, labels and notes, whatever form of a word they used."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from sklearn.feature_extraction.text import TfidfVectorizer

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.retrieval.words.language import base_form
from core.retrieval.words.vocabulary import SAME

_LEAST = 0.35  # similarity of a text and what was written from which it counts
_ORDINARY = frozenset(
    ("a", "an", "and", "the", "of", "on", "in", "to", "with", "then", "while", "without", "or", "at", "it", "is")
)


class Written(NamedTuple):
    """A stretch and what was written of it; ``clip``: whether it is the whole clip's name or note."""

    segment: Segment
    text: str
    clip: bool


def written_in(dataset: Dataset, notes: Mapping[str, str] | None = None) -> list[Written]:
    """Names of clips with their notes (clip -> text), and labels."""
    found = [
        Written(Segment(c.name, 0, c.n_frames), f"{c.name} {(notes or {}).get(c.name, '')}", True)
        for c in dataset.clips
    ]
    return found + [
        Written(Segment(label.clip, label.start, label.end), label.action, False) for label in dataset.labels
    ]


def words_of(text: str) -> list[str]:
    """The words of a text in their plain forms, other words for the same as one: "Strolling_02" -> ["walk"]."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text)
    plain = [base_form(token) for token in re.findall(r"[^\W\d_]+", spaced.lower())]
    return [SAME.get(token) or _stem(token) for token in plain if token not in _ORDINARY]


def _stem(token: str) -> str:
    """A word that the vocabulary does not have, without its ending: "juggling", "juggles" and "juggle" -> "juggl"."""
    ending = next((e for e in ("ing", "ed", "es", "s", "e") if token.endswith(e) and len(token) - len(e) > 2), "")
    return token.removesuffix(ending)


def alike(text: str, written: Sequence[Written]) -> np.ndarray:
    """How much of what a text asks for was written of each stretch: ``(n,)``, 0 to 1; rare words count more."""
    asked = words_of(text)
    if not asked or not written:
        return np.zeros(len(written))
    texts = [one.text for one in written]
    try:
        weigher = TfidfVectorizer(analyzer=words_of, binary=True, norm=None).fit(texts)
    except ValueError:  # nothing but numbers was written
        return np.zeros(len(written))
    known = weigher.vocabulary_
    rare = float(weigher.idf_.max())
    weight = {token: weigher.idf_[known[token]] if token in known else rare for token in asked}
    held = (weigher.transform(texts) > 0).astype(float)
    share = sum(w * held[:, known[t]].toarray()[:, 0] for t, w in weight.items() if t in known)
    found = np.asarray(share) / sum(weight.values()) * np.ones(len(written))
    return np.where(found >= _LEAST, found, 0.0)
