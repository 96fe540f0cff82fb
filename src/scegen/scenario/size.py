"""How many participants a scenario may have, for everybody who reads or makes one."""

from scegen.errors import InfeasibleError

MAX_PARTICIPANTS = 24
"""With more than this it takes minutes to make the numbers of one scenario."""


def require_few_enough(count: int) -> None:
    """Refuse more participants than can be made.

    Raises:
        InfeasibleError: there are more.
    """
    if count > MAX_PARTICIPANTS:
        raise InfeasibleError(
            f"more than {MAX_PARTICIPANTS} participants",
            where="participants",
            hint=f"Describe a situation with at most {MAX_PARTICIPANTS} participants.",
        )
