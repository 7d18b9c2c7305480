"""Dynamics of open trees of rigid bodies, on plain floats, arrays or tracked numbers alike.

A `Tree` is a list of `Link`s, each after the link that carries it; `parent` is the place of that link in the list, −1
for the ground. A link's frame sits at its joint and turns (or slides) with the link:

- `position` and `rotation` place the joint's frame in the parent's frame (`rotation` takes vectors of the joint's axes
  to the parent's); at coordinate 0 the link's frame is the joint's.
- joint `REVOLUTE` (one coordinate, the angle about `axis`), `PRISMATIC` (one, the way along `axis`), `BALL` (four, a
  unit quaternion, scalar first; three speeds, the angular velocity against the parent in the link's own axes), `FIXED`
  (none). Cylindrical, universal, planar and free joints are rows of these, with links without mass between.
- `mass`, `centroid` and `tensor` (about the centroid) are in the link's axes.

Speeds, accelerations and efforts are flat lists in the order of the links. Everything about a link, loads too, is in
its own axes and about its own origin, unless a name says ground. Gravity enters as an acceleration of the ground:
`ground` is −g, (0, 0, 9.81) where weight is along −z; accelerations of links contain it.

`poses` gives the local frames for a state, once; then `inverse` (efforts and joint forces from accelerations, by
recursive Newton–Euler), `forward` (accelerations from efforts, by articulated bodies), `mass_matrix`, and `sweep`
(velocities and accelerations alone). `placed` gives frames in ground axes, `partial` the partial velocities of a point.
"""
