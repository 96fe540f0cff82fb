"""Claims: what a description says, as predicates on what moves.

``claims_of`` derives them from the functional and the logical scenario alone, so that they can
disagree with whatever was made from these; ``view_of`` prepares movements to be judged, our own
or a player's recording.
"""

from scegen.claims.claim import Claim, ClaimKind, Judged
from scegen.claims.deriving import claims_of
from scegen.claims.numbers import described_by
from scegen.claims.proving import prove
from scegen.claims.view import View, view_of

__all__ = ["Claim", "ClaimKind", "Judged", "View", "claims_of", "described_by", "prove", "view_of"]
