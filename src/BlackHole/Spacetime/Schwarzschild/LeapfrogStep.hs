-- | One step of the leapfrog integration of light in pseudo-space.
--
-- A step is drift–kick–drift: half a step straight on, the whole kick at the middle,
-- half a step straight on. The method is second order (halving the step divides the
-- error by four) and, for steps of equal length, reversible. Drift and kick in whole
-- steps would be first order. The gas is sampled at the middle of the step, where the
-- acceleration is evaluated.
module BlackHole.Spacetime.Schwarzschild.LeapfrogStep
  ( leapfrogStep,
  )
where

import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Types (Spacetime, pullOfGravity)
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | @leapfrogStep spacetime h2 dt photon@ is the photon after one step of the
-- pseudo-time @dt@. @h2@ is its squared angular momentum, which the caller knows
-- because it never changes.
leapfrogStep :: Spacetime -> Double -> Double -> Photon -> Photon
leapfrogStep spacetime h2 dt photon =
  Photon (middle ^+^ (0.5 * dt) *^ v) v
  where
    (middle, v) = driftAndKick (pullOfGravity spacetime * h2) dt photon
{-# INLINE leapfrogStep #-}

-- | The first half of a step: the middle point, and the velocity after the kick.
driftAndKick :: Double -> Double -> Photon -> (XYZ, XYZ)
driftAndKick pull dt (Photon x v) = (middle, v ^+^ kick *^ middle)
  where
    middle = x ^+^ (0.5 * dt) *^ v
    r2 = XYZ.normSquared middle
    kick = negate (pull * dt) / (r2 * r2 * sqrt r2)
{-# INLINE driftAndKick #-}
