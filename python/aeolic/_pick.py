"""What a picture shows, as numbers: at a pixel, and at all of them."""
from typing import Any, NamedTuple, Optional, Tuple

Vector = Tuple[float, float, float]


class PickedPlace(NamedTuple):
    """The nearest place of the surface on the line of sight through a pixel's middle."""
    position: Vector  #: World units.
    depth: float  #: World units from the eye along the direction of view.
    normal: Vector  #: Of the triangle, towards the viewer; unit length.
    triangle: int  #: Which of the surface as it is drawn, from 0.
    surface: str  #: Which of several; else the only one's name.
    vector_name: Optional[str]  #: The array's that streaks follow; None where surfaces have several.
    vector: Optional[Vector]  #: As the data have it; None where there is none.
    tangential: Optional[Vector]  #: Its part along the surface.
    scalar: Optional[float]  #: Of color_by; None where there is none.
    scalar_name: Optional[str]  #: None without color_by.


class PictureBuffers(NamedTuple):
    """What all pixels of a picture show, as numpy arrays; NaN where there is nothing to tell."""
    depth: Any  #: (height, width): world units from the eye along the direction of view.
    normal: Any  #: (height, width, 3): of the facet seen, towards the viewer; unit length.
    flow: Any  #: (height, width, 2): the way of one integration step, pixels to the right and downwards.
    lic: Any  #: (height, width): the streaks before contrast and light, of mean 0 and a variance of about 1.
    scalar: Optional[Any]  #: (height, width): what color_by names; None without it.
    surface: Any  #: (height, width), whole numbers: which of the surfaces, from 0; -1 on the background.

    @property
    def covered(self):
        """(height, width): whether the pixel shows the surface."""
        return self.depth == self.depth
