"""The cache that threads share."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from core.caching import RecentCache


def test_the_value_used_longest_ago_goes_first():
    cache: RecentCache[str, int] = RecentCache(2)
    cache.put("a", 1)
    cache.put("b", 2)
    assert cache.get("a") == 1
    cache.put("c", 3)
    assert ("a" in cache, "b" in cache, "c" in cache, len(cache)) == (True, False, True, 2)
    assert cache.get("b") is None and sorted(cache.values()) == [1, 3]


def test_a_value_is_computed_once_until_it_is_forgotten():
    cache: RecentCache[str, int] = RecentCache(2)
    computed = []

    def compute() -> int:
        computed.append(1)
        return len(computed)

    assert [cache.get_or_compute("a", compute) for _ in range(3)] == [1, 1, 1]
    cache.discard("a")
    cache.discard("never there")
    assert cache.get_or_compute("a", compute) == 2
    cache.clear()
    assert len(cache) == 0 and cache.get_or_compute("a", compute) == 3


def test_none_and_zero_are_values_too():
    cache: RecentCache[str, int | None] = RecentCache(2)
    assert cache.get_or_compute("a", lambda: None) is None
    assert cache.get_or_compute("a", lambda: 1) is None


def test_an_error_passes_through_and_nothing_is_kept():
    cache: RecentCache[str, int] = RecentCache(2)
    with pytest.raises(KeyError):
        cache.get_or_compute("a", lambda: {}["missing"])
    assert "a" not in cache and cache.get_or_compute("a", lambda: 1) == 1


def test_threads_that_want_the_same_value_wait_for_one_computation():
    cache: RecentCache[str, int] = RecentCache(2)
    started, go_on = threading.Event(), threading.Event()
    computed = []

    def compute() -> int:
        started.set()
        assert go_on.wait(60)
        computed.append(1)
        return len(computed)

    with ThreadPoolExecutor(4) as threads:
        same = [threads.submit(cache.get_or_compute, "a", compute) for _ in range(3)]
        assert started.wait(60)
        assert threads.submit(cache.get_or_compute, "b", lambda: 7).result(60) == 7  # another key does not wait
        go_on.set()
        assert [future.result(60) for future in same] == [1, 1, 1]


def test_who_waits_for_a_computation_that_fails_computes_itself():
    cache: RecentCache[str, int] = RecentCache(2)
    started, go_on = threading.Event(), threading.Event()

    def fail() -> int:
        started.set()
        assert go_on.wait(60)
        raise ValueError("no")

    with ThreadPoolExecutor(2) as threads:
        first = threads.submit(cache.get_or_compute, "a", fail)
        assert started.wait(60)
        second = threads.submit(cache.get_or_compute, "a", lambda: 5)
        go_on.set()
        with pytest.raises(ValueError, match="no"):
            first.result(60)
        assert second.result(60) == 5


def test_a_computation_may_use_the_cache_for_other_keys():
    cache: RecentCache[str, int] = RecentCache(2)
    assert cache.get_or_compute("a", lambda: cache.get_or_compute("b", lambda: 1) + 1) == 2


def test_many_threads_never_see_more_values_than_fit():
    cache: RecentCache[int, int] = RecentCache(3)

    def work(seed: int) -> bool:
        return all(cache.get_or_compute(k, lambda k=k: k * k) == k * k and len(cache) <= 3 for k in range(seed, 200))

    with ThreadPoolExecutor(8) as threads:
        assert all(threads.map(work, range(16)))


def test_a_size_below_one_is_refused():
    with pytest.raises(ValueError, match="at least one"):
        RecentCache(0)
