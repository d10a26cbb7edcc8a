"""Search by words in the demo, whose labels say what is there, and without any labels."""

from dataclasses import replace

import pytest

from core.demo import make_demo
from core.mocap.clip import Label
from core.retrieval.search import build_search_index
from core.retrieval.words.finding import find_stretches, see
from core.retrieval.words.language import parse
from core.retrieval.words.search import WordSearch


@pytest.fixture(scope="module")
def demo():
    return make_demo(minutes=4)


@pytest.fixture(scope="module")
def words(demo):
    return WordSearch(replace(demo, labels=()))


def share_of(demo, segment, action):
    inside = [x for x in demo.labels if x.clip == segment.clip and x.action.endswith(action)]
    shared = sum(max(0, min(x.end, segment.end) - max(x.start, segment.start)) for x in inside)
    return shared / segment.n_frames


@pytest.mark.parametrize(
    ("text", "action"),
    [("walk", "walk"), ("running", "run"), ("jump", "jump"), ("kick", "kick"), ("punching", "punch"),
     ("squat", "squat"), ("cartwheel", "cartwheel"), ("lie down", "lie down"), ("stand still", "idle")],
)  # fmt: skip
def test_stretches_show_what_was_asked_for(demo, words, text, action):
    hits = words.search(text, level="interval", top=3).hits
    assert hits and all(share_of(demo, hit.segment, action) > 0.6 for hit in hits[:2])


def test_one_after_another(demo, words):
    hits = words.search("punch then kick", level="interval").hits
    assert hits
    for hit in hits:
        first = min(p.start for p in hit.places if p.text == "punch")
        last = max(p.end for p in hit.places if p.text == "kick")
        assert hit.segment.start <= first < last <= hit.segment.end


def test_without_leaves_out(words):
    kicks = words.search("kick", level="interval").hits
    fewer = words.search("kick without turning", level="interval").hits
    assert len(fewer) < len(kicks) or sum(h.score for h in fewer) < sum(h.score for h in kicks)


def test_numbers_are_counted(words):
    twice = words.search("jump twice", level="interval").hits
    assert twice and all(sum(p.text == "jump twice" for p in hit.places) >= 2 for hit in twice)
    assert all(0 <= hit.score <= 1 for hit in twice)


def test_clips_come_all_and_the_best_first(demo, words):
    hits = words.search("cartwheel", level="clip").hits
    assert sorted(hit.segment.clip for hit in hits) == sorted(demo.names)
    assert any(label.action.startswith("cartwheel") for label in demo.labels if label.clip == hits[0].segment.clip)
    assert [hit.score for hit in hits] == sorted((hit.score for hit in hits), reverse=True)


def test_what_was_written_counts(demo):
    named = replace(demo, labels=(Label(demo.names[2], 10, 90, "juggling clubs"),))
    found = WordSearch(named).search("juggle the clubs", level="interval")
    assert found.hits[0].segment.clip == demo.names[2] and (found.hits[0].segment.start, found.hits[0].segment.end) == (
        10,
        90,
    )
    assert not found.unknown
    assert WordSearch(named, names=False).search("juggle the clubs").unknown


def test_labels_are_spread_to_what_moves_alike(demo):
    wheels = [label for label in demo.labels if label.action.startswith("cartwheel")]
    one = replace(demo, labels=(wheels[0]._replace(action="flourish"),))
    hits = WordSearch(one, index=lambda: build_search_index(demo)).search("flourish", level="interval").hits
    others = [hit for hit in hits if hit.places[0].text == "like flourish"]
    assert len(others) >= 2 and all(share_of(demo, hit.segment, "cartwheel") > 0.6 for hit in others[:2])
    assert all(hit.score <= hits[0].score for hit in others)


def test_a_body_without_legs_is_said_to_show_no_steps(demo):
    clip = demo.clips[0]
    seen = see([clip])
    arms = {name: at for name, at in seen[0].signals.joints.items() if "ankle" not in name and "toe" not in name}
    seen[0].signals = replace(seen[0].signals, joints=arms, parts=seen[0].signals.parts - {"legs", "knees"})
    seen[0]._tracks.clear()
    assert find_stretches(parse("walk"), seen) == []


def test_the_rate_hardly_matters(demo):
    from core.mocap.kinematics import resample

    clip = demo.clips[1]
    text = parse("kick")
    fast, slow = (find_stretches(text, see([resample(clip, fps)])) for fps in (60, 30))
    assert len(fast) == len(slow)
    for a, b in zip(fast, slow, strict=True):
        assert abs(a.segment.start / 60 - b.segment.start / 30) < 0.1 and abs(a.score - b.score) < 0.1
