"""Asking again after faults that may pass: with waits that double, follow the server, and end."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import TypeVar

from scegen.llm.settings import Limits
from scegen.llm.troubles import Trouble, trouble_of

T = TypeVar("T")


async def ask_until(
    send: Callable[[], Awaitable[T]], limits: Limits, deadline: float, key: str
) -> tuple[T | Trouble, int]:
    """The answer or the last trouble, and after how many attempts.

    Nothing is awaited after the loop's time ``deadline``; ``key`` is blotted out of every message.
    """
    clock = asyncio.get_running_loop().time
    pause = limits.first_wait_s
    attempt = 0
    while True:
        attempt += 1
        try:
            async with asyncio.timeout(min(limits.request_s, deadline - clock())):
                return await send(), attempt
        except Exception as error:  # noqa: BLE001 - whatever a server provokes is a fault
            trouble = trouble_of(error, key)
        wait = pause if trouble.wait_s is None else trouble.wait_s
        hopeless = not trouble.passing or attempt >= limits.attempts
        if hopeless or wait > limits.longest_wait_s or clock() + wait >= deadline:
            return trouble, attempt
        await asyncio.sleep(wait)
        pause = min(pause * 2, limits.longest_wait_s)
