"""A bearing by itself."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ._jeffcott import catalogue as _catalogue
from ._results import Statics
from ._scenario import Scenario, warned_before
from ._table import Array

MODEL = ("contact", "film", "race_control")
FREEDOMS = {"x": "0 m", "y": "0 m", "z": "0 m", "tilt_x": "0 rad", "tilt_y": "0 rad"}


def catalogue() -> dict[str, str]:
    """Designations of the ball and roller bearings that are known, each with the source of its dimensions."""
    return dict(_catalogue())


class Bearing:
    """A ball or roller bearing: one of the catalogue by its designation, one of given dimensions, or one by its printed
    ratings.

    Keys are those of `[[bearing]]` in a scenario, and `contact`, `film` and `race_control` of `[model]`:

        >>> Bearing("7205C").stiffness(preload="200 N")
        >>> Bearing("6205", clearance_class="C3").answer(load={"y": "-500 N"}).balls
        >>> Bearing(geometry={"balls": 12, "ball_diameter": "7.938 mm", "pitch_diameter": "38.5 mm",
        ...                   "contact_angle": "15 deg", "groove_factor_inner": 0.52, "groove_factor_outer": 0.53})

    Its frame is that of the shaft: z along it, loaded along +z.
    """

    def __init__(self, designation: str | None = None, **keys: Any) -> None:
        self.keys = {**({} if designation is None else {"catalogue": designation}), **keys}
        self._warned: frozenset[str] = frozenset()
        self._warned = self.scenario()._warned

    @classmethod
    def from_ratings(
        cls,
        *,
        bore: str,
        outside_diameter: str,
        dynamic: str,
        static: str,
        contact_angle: str = "0 deg",
        balls: int | None = None,
        ball_diameter: str | None = None,
        pitch_diameter: str | None = None,
        f0: float | None = None,
        kind: str | None = None,
        width: str | None = None,
        **keys: Any,
    ) -> Bearing:
        """A bearing by the ratings C and C0 that its maker prints: balls and grooves are estimated from them.

            >>> Bearing.from_ratings(bore="40 mm", outside_diameter="80 mm", dynamic="29.1 kN", static="17.9 kN")

        What is known of the balls, and the factor f0 beside the ratings, settle which ones they are where several would do.
        With a `kind` of rollers, "cylindrical", "tapered" or "spherical", and the `width` of the inner ring it is a roller
        bearing.
        Further keys are those of a `Bearing`.
        """
        printed = {
            "bore": bore,
            "outside_diameter": outside_diameter,
            "contact_angle": contact_angle,
            "dynamic": dynamic,
            "static": static,
            "balls": balls,
            "ball_diameter": ball_diameter,
            "pitch_diameter": pitch_diameter,
            "f0": f0,
            "kind": kind,
            "width": width,
        }
        return cls(ratings={key: value for key, value in printed.items() if value is not None}, **keys)

    def scenario(
        self,
        load: Mapping[str, str] | None = None,
        *,
        displacement: Mapping[str, str] | None = None,
        speed: str = "0 rad/s",
        **keys: Any,
    ) -> Scenario:
        """The static question about it, as a scenario: under a load, or else held at a displacement."""
        own = {**self.keys, **keys}
        model = {key: own.pop(key) for key in MODEL if key in own}
        question: dict[str, Any] = {
            "title": str(own.get("catalogue", "bearing")),
            # the mass plays no part: nothing moves, and there is no weight
            "shaft": {"mass": "1 kg", "freedoms": "all"},
            "speed": {"constant": speed},
            "bearing": [own],
            "model": model,
        }
        if load is None:
            question["static"] = {"displacement": {**FREEDOMS, **(displacement or {})}}
        else:
            question["load"] = [{"constant": dict(load)}]
            if displacement:
                question["static"] = {"displacement": dict(displacement)}
        return warned_before(question, "scenario.dict", self._warned)

    def answer(
        self,
        load: Mapping[str, str] | None = None,
        *,
        displacement: Mapping[str, str] | None = None,
        speed: str = "0 rad/s",
        **keys: Any,
    ) -> Statics:
        """Equilibrium, stiffness and every ball.

        Under a load, as {"y": "-300 N", "z": "1 kN", "tilt_x": "2 N m"}, all freedoms find their place but those that a
        displacement holds; without one the inner ring is held where it is mounted, or at a displacement, as
        {"z": "10 um"}. Further keys, as `preload="200 N"`, hold for this answer.
        """
        return self.scenario(load, displacement=displacement, speed=speed, **keys).bearing()

    def stiffness(
        self,
        load: Mapping[str, str] | None = None,
        *,
        displacement: Mapping[str, str] | None = None,
        speed: str = "0 rad/s",
        **keys: Any,
    ) -> Array:
        """K = ∂F/∂q there, rows and columns x, y, z, tilt x, tilt y: N/m, N/rad, N m/m, N m/rad."""
        return self.answer(load, displacement=displacement, speed=speed, **keys).stiffness

    def __repr__(self) -> str:
        return f"<Bearing {', '.join(f'{key}={value!r}' for key, value in self.keys.items())}>"
