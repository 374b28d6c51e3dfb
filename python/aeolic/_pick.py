"""What a picture shows at a pixel."""
from typing import NamedTuple, Optional, Tuple

Vector = Tuple[float, float, float]


class PickedPlace(NamedTuple):
    """The nearest place of the surface on the line of sight through a pixel's middle."""
    position: Vector  #: World units.
    depth: float  #: World units from the eye along the direction of view.
    normal: Vector  #: Of the triangle, towards the viewer; unit length.
    triangle: int  #: Which of the surface as it is drawn, from 0.
    surface: str  #: Which of several; else the only one's name.
    vector: Optional[Vector]  #: As the data have it; None where there is none.
    tangential: Optional[Vector]  #: Its part along the surface.
    scalar: Optional[float]  #: Of color_by; None where there is none.
    scalar_name: Optional[str]  #: None without color_by.
