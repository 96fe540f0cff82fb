"""Simulator files: OpenDRIVE and OpenSCENARIO, the only place that speaks their XML."""
