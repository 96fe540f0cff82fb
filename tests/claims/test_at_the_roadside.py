"""Who is parked ahead is beside the lane at first, and pulls out where the text says."""

from told import raised

from scegen.understanding import read

TEXT = "A parked car pulls out 20 m in front of the ego, which drives 50 km/h."


def test_who_is_parked_ahead_is_beside_the_lane_and_pulls_out_so_far_ahead():
    claims = {claim.statement: claim for claim in raised(read(TEXT)).proof.claims}
    assert all(claim.holds for claim in claims.values())
    assert "parked_car_1 is ahead of the ego at the start" in claims
    (gap,) = (claim for words, claim in claims.items() if "begins to set off" in words)
    assert abs(gap.measured - 20.0) < 0.5
