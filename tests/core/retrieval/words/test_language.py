"""What people type, read as words with sides, numbers and an order."""

import pytest

from core.errors import ParameterError
from core.retrieval.words.language import parse
from core.retrieval.words.vocabulary import SAME, WORDS


def said(text):
    """Moments of a text: words, words alongside, words that must not be seen."""
    moments = parse(text).moments
    return [
        ([t.text for t in m.terms], [t.text for a in m.alongside for t in a.all], [t.text for t in m.without])
        for m in moments
    ]


@pytest.mark.parametrize(
    ("text", "moments"),
    [
        ("walk then turn left", [(["walk"], [], []), (["turn left"], [], [])]),
        ("wave-both-hands", [(["wave both"], [], [])]),
        ("walking slowly and waving the right hand", [(["walk", "slow"], ["wave right"], [])]),
        ("turn left while walking", [(["turn left", "walk"], [], [])]),
        ("kick without walking", [(["kick"], [], ["walk"])]),
        ("jumps three times", [(["jump 3 times"], [], [])]),
        ("two punches, then he strolled", [(["punch twice"], [], []), (["walk"], [], [])]),
        ("both hands raised", [(["raised both"], [], [])]),
        ("raises the left leg", [(["raise leg left"], [], [])]),
        ("stand up and run", [(["get up"], ["run"], [])]),
        ("standUp", [(["get up"], [], [])]),
        ("run/jog", [(["run or jog"], [], [])]),
        ("was lying down before crawling", [(["lie down"], [], []), (["crawl"], [], [])]),
        ("walk to the left", [(["walk", "sideways left"], [], [])]),
    ],
)
def test_texts_are_read(text, moments):
    assert said(text) == moments


@pytest.mark.parametrize("form", ["walk", "walks", "walked", "walking", "strolls", "Strolling", "ambled"])
def test_all_forms_of_a_verb_are_one_word(form):
    assert said(form) == [(["walk"], [], [])]


def test_unknown_words_come_with_known_ones_like_them():
    sentence = parse("somersalt over the fence")
    assert sentence.unknown[0] == "somersalt" and "somersault" in sentence.near[0]
    assert "fence" in sentence.unknown


@pytest.mark.parametrize("text", ["", "  ", "walk " * 200])
def test_texts_without_words_are_refused(text):
    with pytest.raises(ParameterError, match="words"):
        parse(text)


def test_the_vocabulary_is_large_and_each_word_is_explained():
    assert len({word.name for word in WORDS}) == len(WORDS) >= 60
    names = {word.name for word in WORDS}
    for word in WORDS:
        assert len(word.help) > 15 and set(word.implies) <= names
        assert SAME[word.name] == word.name, f"{word.name} is another word for {SAME[word.name]}"
