-- | What a path segment must have in common with the photon whose path it is a part of.
module Support.Segments (belongsTo) where

import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Types
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Test.QuickCheck

-- | @belongsTo limit space photon segment@: the segment has the angular momentum and the
-- energy of a photon of unit energy, which is followed backwards around a hole without
-- spin or through flat space, and its steps, its length and its momentum agree.
belongsTo :: Double -> Spacetime -> Photon -> PathSegment -> Property
belongsTo limit space photon segment =
  counterexample (show segment) $
    conjoin
      [ closeTo 1e-12 1 (segmentRadius segment / XYZ.norm (segmentMiddle segment)),
        closeTo (limit * size) (negate hy) lambda,
        closeTo (limit * size * size) 1 (radial * radial + lapse2 * h2 / (r * r)),
        closeTo (limit * size * size) (radial * radial + h2 / (r * r)) (speed * speed),
        closeTo (limit * size * size) (h2 / (r * r)) (polar * polar + lambda * lambda / rho2),
        closeTo (limit * size) (negate radial) (kr * (1 - 1 / r))
      ]
  where
    Momentum kr lambda = segmentMomentum segment
    XYZ x y z = segmentMiddle segment
    r = segmentRadius segment
    rho2 = x * x + z * z
    h@(XYZ _ hy _) = angularMomentum photon
    h2 = XYZ.normSquared h
    size = 1 + XYZ.norm h
    lapse2 = if space == Flat then 1 else 1 - 1 / r
    radial = segmentRadialStep segment / segmentAffineLength segment
    vertical = segmentVerticalStep segment / segmentAffineLength segment
    speed = segmentLength segment / segmentAffineLength segment
    -- What is left of the vertical speed on the sphere.
    polar = (vertical - radial * y / r) * r / sqrt rho2
