"""The door to search by words: a text and a data set in, clips or stretches out, with where each word was seen.

What people wrote counts beside what is seen in the motion. Words that only labels know, such as the name of an
exercise, are spread to stretches that move as the labelled ones do, with the chance that they are the same.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace

from core.errors import ParameterError
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.retrieval.queries import whole_query
from core.retrieval.search import INTERVALS, SearchIndex
from core.retrieval.words.finding import Place, Seen, WordHit, find_clips, find_stretches, see, unknown_terms
from core.retrieval.words.language import Sentence, parse
from core.retrieval.words.texts import Written, alike, words_of, written_in

WRITTEN = 0.9  # how sure what was written is
LEAST = 0.01  # score below which a stretch is no hit
_EXAMPLES = 3  # labelled stretches that unlabelled ones are compared with
LEVELS = ("clip", "interval")


@dataclass(frozen=True)
class Answer:
    """Hits of a text, best first.

    unknown: words that nothing is known of -> words like them. unseen: words that these bodies cannot show.
    """

    sentence: Sentence
    hits: tuple[WordHit, ...]
    unknown: Mapping[str, tuple[str, ...]]
    unseen: tuple[str, ...] = ()


class WordSearch:
    """Search by words in one data set; what is seen in its clips is kept between searches.

    index: makes the search index that labels are spread with, None for no spreading. names: whether what people wrote
    counts. notes: clip -> text.
    """

    def __init__(
        self,
        dataset: Dataset,
        *,
        index: Callable[[], SearchIndex] | None = None,
        names: bool = True,
        notes: Mapping[str, str] | None = None,
    ):
        self.dataset, self.index = dataset, index
        self.seen: list[Seen] = see(dataset.clips)
        self.written: list[Written] = written_in(dataset, notes) if names else []

    def search(
        self, text: str, *, level: str = "clip", top: int | None = None, only: Collection[str] | None = None
    ) -> Answer:
        """Clips or stretches, best first: all clips, or 20 stretches, unless ``top`` says otherwise.

        Raises ParameterError for an empty text or another level.
        """
        if level not in LEVELS:
            raise ParameterError(f"level must be clip or interval, not {level!r}")
        sentence = parse(text)
        seen = [one for one in self.seen if only is None or one.clip in only]
        written = [one for one in self.written if only is None or one.segment.clip in only]
        shares = alike(text, written).tolist()
        found = [(one, share) for one, share in zip(written, shares, strict=True) if share > 0]
        hits = find_clips(sentence, seen) if level == "clip" else find_stretches(sentence, seen)
        hits = _with_written(hits, found, level) if found else hits
        if level == "interval" or not any(hit.score for hit in hits):
            hits = hits + self._spread(sentence, found, hits, level, only)
        hits = sorted(hits, key=lambda h: (-h.score, h.segment.clip, h.segment.start))
        if level == "interval":
            hits = [hit for hit in _apart(hits) if hit.score >= LEAST][: top or INTERVALS]
        spoken = {token for one, _ in found for token in words_of(one.text)}
        pairs = zip(sentence.unknown, sentence.near, strict=True)
        unknown = {w: near for w, near in pairs if not set(words_of(w)) & spoken}
        if not sentence.terms and not found:
            hits = []
        return Answer(sentence, tuple(hits[:top]), unknown, unknown_terms(sentence, seen))

    def _spread(
        self,
        sentence: Sentence,
        found: Sequence[tuple[Written, float]],
        hits: Sequence[WordHit],
        level: str,
        only: Collection[str] | None,
    ) -> list[WordHit]:
        """Stretches that move as labelled ones of a word do that is not seen in the motion itself."""
        examples = [one for one, share in found if not one.clip and share > 0.99]
        if self.index is None or not examples or not sentence.unknown:
            return []
        index, more = self.index(), []
        for one in examples[:: max(1, len(examples) // _EXAMPLES)][:_EXAMPLES]:
            query = whole_query(self.dataset.clip(one.segment.clip), one.segment.start, one.segment.end)
            for hit in index.search(query, level=level, only=only):
                place = Place(f"like {one.text}", hit.segment.start, hit.segment.end, round(hit.score, 3))
                more.append(WordHit(hit.segment, WRITTEN * hit.score, (place,)))
        return more


def _with_written(hits: list[WordHit], found: Sequence[tuple[Written, float]], level: str) -> list[WordHit]:
    """Hits that know of what was written: clips gain by it, stretches come from labels as well."""
    if level == "interval":
        labels = [(one, share) for one, share in found if not one.clip]
        return hits + [_of_written(one, share) for one, share in labels if share > 0.6]
    best: dict[str, tuple[Written, float]] = {}
    for one, share in found:
        if share > best.get(one.segment.clip, (None, 0.0))[1]:
            best[one.segment.clip] = (one, share)
    more = []
    for hit in hits:
        if hit.segment.clip in best:
            one, share = best[hit.segment.clip]
            written = _of_written(one, share)
            score = 1 - (1 - hit.score) * (1 - written.score)
            hit = replace(hit, score=score, places=(*hit.places, *written.places))
        more.append(hit)
    return more


def _of_written(one: Written, share: float) -> WordHit:
    text = f"{'name' if one.clip else 'label'}: {one.text.strip()}"
    place = Place(text, one.segment.start, one.segment.end, round(WRITTEN * share, 3))
    return WordHit(one.segment, WRITTEN * share, (place,))


def _apart(hits: Sequence[WordHit]) -> list[WordHit]:
    """Hits of which none shares more than half of the shorter one with a better one."""
    kept: dict[str, list[Segment]] = {}
    found = []
    for hit in hits:
        mine = hit.segment
        if not any(
            min(mine.end, s.end) - max(mine.start, s.start) > 0.5 * min(mine.n_frames, s.n_frames)
            for s in kept.get(mine.clip, [])
        ):
            kept.setdefault(mine.clip, []).append(mine)
            found.append(hit)
    return found
