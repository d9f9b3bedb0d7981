-- | How the gas of a disk moves in each of the spacetimes, and the frequency of light in
-- its frame: right-handed circular geodesics down to the innermost stable orbit, and
-- free fall from there. In flat space the gas moves as around a hole without spin.
module BlackHole.Matter.GasFlow
  ( GasFlow,
    gasFlow,
    patternRate,
    Frequencies (..),
    gasFrequencies,
    crossingFrequencies,
  )
where

import BlackHole.Matter.GasMotion
import BlackHole.Matter.KerrFlow
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.Observer (SightLine (..))
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Types

-- | The gas of one spacetime.
data GasFlow
  = WithoutSpin
  | AroundKerr !KerrFlow

-- | The gas in a spacetime.
gasFlow :: Spacetime -> GasFlow
gasFlow space = case space of
  Kerr hole -> AroundKerr (kerrFlow hole)
  _ -> WithoutSpin

-- | dφ/dt at which a pattern in the gas turns: that of the circular orbit at this radius,
-- and inside the innermost stable one that of the latter.
patternRate :: Spacetime -> Double -> Double
patternRate space = rate . max (spacetimeIsco space)
  where
    rate = case space of
      Kerr hole -> kerrOrbitalRate (kerrFlow hole)
      _ -> keplerianRate

-- | @gasFrequencies flow r y momentum@ are the frequencies of light at a place outside the
-- horizon, at the distance @r@ from the hole and the height @y@ above the plane.
gasFrequencies :: GasFlow -> Double -> Double -> Momentum -> Frequencies
gasFrequencies flow r y momentum = case flow of
  WithoutSpin -> Frequencies (motionFrequency r y momentum) (sqrt (r / (r - 1)))
  AroundKerr around -> kerrFrequencies around r (y / r) momentum
{-# INLINE gasFrequencies #-}

-- | The frequencies of the light of a line of sight where it crosses the plane. 'Nothing'
-- at and inside the horizon.
crossingFrequencies :: GasFlow -> SightLine -> PlaneCrossing (Maybe Momentum) -> Maybe Frequencies
crossingFrequencies flow sight (PlaneCrossing r _ light) = do
  momentum <- light
  let found = gasFrequencies flow r 0 momentum
  pure $ case (flow, sight) of
    -- Close to the horizon this keeps more digits.
    (AroundKerr around, RotatingSight _ _ ray) ->
      found {frequencyInGas = kerrPlaneFrequency around ray r momentum}
    _ -> found
