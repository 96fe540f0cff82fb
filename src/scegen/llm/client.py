"""The HTTP client under every provider: bounded answers, no redirects, keys blotted out."""

import httpx2

from scegen.llm.keys import blot

_CONNECT_S = 10.0


class AnswerTooLargeError(httpx2.TransportError):
    """The server sends more than any answer needs."""


class GuardedTransport(httpx2.AsyncBaseTransport):
    """Reads every answer whole, up to a limit, through a client that knows the proxies.

    Redirects are not followed, since they would carry the key to another place.
    """

    def __init__(self, *, key: str, request_s: float, answer_bytes: int) -> None:
        self._key = key
        self._limit = answer_bytes
        timeout = httpx2.Timeout(request_s, connect=min(_CONNECT_S, request_s))
        self._client = httpx2.AsyncClient(timeout=timeout, follow_redirects=False)

    async def handle_async_request(self, request: httpx2.Request) -> httpx2.Response:
        """Send the request and give back its answer, read to the end."""
        response = await self._client.send(request, stream=True)
        try:
            content = bytearray()
            async for chunk in response.aiter_bytes():
                content += chunk
                if len(content) > self._limit:
                    raise AnswerTooLargeError(f"the answer is longer than {self._limit} bytes")
        finally:
            await response.aclose()
        kept = ("content-type", "retry-after", "retry-after-ms")
        headers = {name: response.headers[name] for name in kept if name in response.headers}
        text = content.decode(response.encoding or "utf-8", errors="replace")
        return httpx2.Response(
            response.status_code, headers=headers, content=blot(text, self._key).encode()
        )

    async def aclose(self) -> None:
        """Close the connections."""
        await self._client.aclose()


class ClosedTransport(httpx2.AsyncBaseTransport):
    """Lets nothing out: a replayed run asks nobody."""

    async def handle_async_request(self, request: httpx2.Request) -> httpx2.Response:
        """Refuse the request."""
        raise httpx2.ConnectError("a replayed run has no network", request=request)
