"""Measures at every step, computed plainly: what batches keep the worst of."""

from __future__ import annotations

import numpy as np

from scegen.measures.bodies import body_of
from scegen.measures.drac import deceleration_to_avoid
from scegen.measures.following import gaps_behind
from scegen.measures.headway import time_headway
from scegen.measures.post_encroachment import post_encroachment_time
from scegen.measures.required_braking import before_area, behind_leader
from scegen.motion.batch.arrays import COS, SIN, SPEED, S

each = np.vectorize


def gap_series(traces, scene):
    """Gap from follower to leader (c, t, p), m, and who follows: 0, 1, or -1 where neither does."""
    gaps, who = [], []
    for p, pair in enumerate(scene.pairs):
        ways = []
        for way in range(2):
            front = body_of(scene.bodies, pair[way]).front_m
            first = scene.following.first[p, way]
            rear = scene.following.rear_m
            ways.append(
                gaps_behind(traces.tracks, pair[way], pair[1 - way], front, rear, first)
                if first >= 0
                else np.full(traces.tracks[:, 0, S].shape, np.nan)
            )
        later = ~np.isnan(ways[1])
        gaps.append(np.where(later, ways[1], ways[0]))
        who.append(np.where(later, 1, np.where(np.isnan(ways[0]), -1, 0)))
    return np.stack(gaps, axis=2), np.stack(who, axis=2)


def following_series(traces, scene):
    """Headway (s) and DRAC (m/s²) of whoever follows (c, t, p)."""
    gaps, who = gap_series(traces, scene)
    speeds = traces.tracks[:, scene.pairs][:, :, :, SPEED]
    own = np.where(who == 1, speeds[:, :, 1].swapaxes(1, 2), speeds[:, :, 0].swapaxes(1, 2))
    others = np.where(who == 1, speeds[:, :, 0].swapaxes(1, 2), speeds[:, :, 1].swapaxes(1, 2))
    return each(time_headway)(gaps, own), each(deceleration_to_avoid)(gaps, own, others)


def required_series(traces, scene, way):
    """Deceleration that the first (way 0) or second (1) of each pair needs, m/s² (c, t, p)."""
    tracks, rows = traces.tracks, []
    for p, pair in enumerate(scene.pairs):
        own, other = tracks[:, pair[way]], tracks[:, pair[1 - way]]
        front, first = body_of(scene.bodies, pair[way]).front_m, scene.following.first[p, way]
        worst = np.zeros(own[:, S].shape)
        if first >= 0:
            rear = scene.following.rear_m
            gaps = gaps_behind(tracks, pair[way], pair[1 - way], front, rear, first)
            slower = -np.diff(other[:, SPEED], prepend=other[:, SPEED, :1], axis=1) / traces.dt_s
            slower = np.where(other[:, SPEED] >= 0.0, np.maximum(slower, 0.0), 0.0)
            worst = each(behind_leader)(gaps, own[:, SPEED], other[:, SPEED], slower)
        for n in range(scene.areas.first[p], scene.areas.first[p + 1]):
            enter, leave = scene.areas.enter_m[n], scene.areas.leave_m[n]
            needed = each(before_area)(
                enter[way] - own[:, S],
                np.abs(own[:, SPEED]),
                leave[way] - enter[way],
                enter[1 - way] - other[:, S],
                np.abs(other[:, SPEED]),
                leave[1 - way] - other[:, S],
            )
            worst = np.maximum(worst, needed)
        rows.append(worst)
    return np.stack(rows, axis=2)


def encroachments(traces, scene):
    """PET of every pair, s (c, p): the smallest of its areas."""
    out = np.full((len(traces.tracks), len(scene.pairs)), np.nan)
    for c, tracks in enumerate(traces.tracks):
        for p, (a, b) in enumerate(scene.pairs):
            for n in range(scene.areas.first[p], scene.areas.first[p + 1]):
                enter, leave = scene.areas.enter_m[n], scene.areas.leave_m[n]
                pet = post_encroachment_time(tracks[a], tracks[b], enter, leave, traces.dt_s)
                out[c, p] = np.fmin(out[c, p], pet)
    return out


def impact_speeds(traces, scene, contact):
    """Relative speed at the first contact, m/s; nan without one (c, p)."""
    speed = traces.tracks[:, :, SPEED]
    velocity = np.stack([speed * traces.tracks[:, :, COS], speed * traces.tracks[:, :, SIN]])
    apart = np.hypot(*(velocity[:, :, scene.pairs[:, 0]] - velocity[:, :, scene.pairs[:, 1]]))
    first = np.take_along_axis(apart, contact.argmax(axis=1)[:, :, None], axis=2)[:, :, 0]
    return np.where(contact.any(axis=1), first, np.nan)
